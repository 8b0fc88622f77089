//! Edge functions of window triangles as textbooks have them: the right rule, in floats.

use super::Corners;

/// What an edge function needs of a number.
pub trait Float: Copy + PartialOrd {
    /// From steps of 1/256 px, in pixels.
    fn of(steps: i32) -> Self;
    /// (b - a) x (p - a).
    fn side(a: [Self; 2], b: [Self; 2], p: [Self; 2]) -> Self;
    /// 0.
    const ZERO: Self;
}

macro_rules! float {
    ($($float:ident $from:expr),+) => {
        $(impl Float for $float {
            const ZERO: Self = 0.0;

            fn of(steps: i32) -> Self {
                $from(steps) / 256.0
            }

            fn side(a: [Self; 2], b: [Self; 2], p: [Self; 2]) -> Self {
                (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            }
        })+
    };
}

// Steps are below 2^24: exact.
float!(f32 (|steps| steps as f32), f64 f64::from);

/// Whether a triangle covers the centre of a pixel, by the top-left rule.
pub fn covers<T: Float>((xy, _): &Corners, (x, y): (u32, u32)) -> bool {
    let p = [x, y].map(|at| T::of(at as i32 * 256 + 128));
    let [a, mut b, mut c] = xy.map(|corner| corner.map(T::of));
    let area = T::side(a, b, c);
    if area == T::ZERO {
        return false;
    }
    if area < T::ZERO {
        (b, c) = (c, b);
    }
    // Clockwise on the screen: an edge is a left one where it goes up, a top one where it goes right and is level.
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let value = T::side(from, to, p);
        let counts = to[1] < from[1] || to[1] == from[1] && to[0] > from[0];
        value > T::ZERO || counts && value == T::ZERO
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_is_the_references() {
        use halfplane_reference::{Grid, Rect, cover_rows};
        let grid = Grid::new(8, (128, 128)).unwrap();
        let rect = Rect { x0: 0, y0: 0, x1: 8, y1: 8 };
        // Corners on samples, both windings.
        let xy = [[128, 128], [1664, 640], [640, 1664]];
        for corners in [xy, [xy[0], xy[2], xy[1]], [[128, 128], [1664, 128], [128, 1664]]] {
            let mut exact = Vec::new();
            cover_rows(&corners, grid, rect, |y, columns| exact.extend(columns.map(|x| (x, y))));
            let of = |covers: fn(&Corners, (u32, u32)) -> bool| -> Vec<(u32, u32)> {
                let pixels = (0..8).flat_map(|y| (0..8).map(move |x| (x, y)));
                pixels.filter(|&pixel| covers(&(corners, [0; 3]), pixel)).collect()
            };
            assert_eq!(of(covers::<f32>), exact);
            assert_eq!(of(covers::<f64>), exact);
        }
    }
}
