//! The exact window outline of clipped triangles, and which samples are clearly inside or outside it.

use crate::Failure;
use halfplane::{Bounds, Format};
use halfplane_reference::{Planes, Viewport, clip, to_window};
use num_traits::ToPrimitive;

/// Where a sample is, seen from an outline that is known up to a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Inside by more than the distance.
    Inside,
    /// Outside by more than the distance.
    Outside,
    /// Too close to say.
    Close,
}

/// Convex polygons in pixels whose union is convex.
#[derive(Clone, Debug)]
pub struct Outline(Vec<Vec<[f64; 2]>>);

impl Outline {
    /// The exact outlines of triangles clipped at the near and the far plane.
    ///
    /// They are clipped and projected in rationals; only then rounded to 53 bits, which at 2^27 px is
    /// 2^-26 px, and that is within the room that [`tolerance`] leaves. `None` where a vertex ends at w = 0.
    pub fn of(triangles: &[[[f32; 4]; 3]], viewport: Viewport) -> Result<Option<Self>, Failure> {
        let mut polygons = Vec::new();
        for &triangle in triangles {
            let mut polygon = Vec::new();
            for vertex in clip(triangle, Planes::BOTH)? {
                let Some(point) = to_window(&vertex, viewport) else { return Ok(None) };
                let float = |v: &halfplane_reference::Rational| v.to_f64().unwrap_or(f64::NAN);
                polygon.push([float(&point.position.x), float(&point.position.y)]);
            }
            polygons.push(polygon);
        }
        Ok(Some(Self(polygons)))
    }

    /// Where a sample is: the square of so many pixels about it is wholly inside the union, wholly
    /// outside each polygon, or neither.
    pub fn side(&self, [x, y]: [f64; 2], tolerance: f64) -> Side {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(i, j)| [x + i * tolerance, y + j * tolerance]);
        // The union is convex: it has the square if it has the corners.
        if square.iter().all(|&corner| self.0.iter().any(|polygon| has(polygon, corner))) {
            Side::Inside
        } else if self.0.iter().all(|polygon| apart(polygon, &square)) {
            Side::Outside
        } else {
            Side::Close
        }
    }
}

/// How far a clipped, projected and snapped vertex can be from the exact one, in pixels, either axis.
///
/// Half a step for snapping, and the float errors, u = 2^-24: each cut rounds x and w once (the cut
/// itself is computed in 53 bits), and a vertex comes of at most three cuts: near or far, a side, a
/// horizontal; so x/w has relative error 6u, division and product add 2u, the sum u of the position. Vertices
/// are within the guard band, so all of it is below 9u times the guard band; the outline between two
/// vertices moves no farther than they do.
pub fn tolerance<F: Format>() -> f64 {
    let guard = f64::from(Bounds::<F>::GUARD_BAND) / f64::from(Bounds::<F>::STEPS_PER_PIXEL);
    0.5 / f64::from(Bounds::<F>::STEPS_PER_PIXEL) + 9.0 * 2f64.powi(-24) * guard
}

fn cross(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1])
}

/// 1 or -1, and 0 for a polygon without area.
fn orientation(polygon: &[[f64; 2]]) -> f64 {
    let sum: f64 = polygon.windows(2).map(|w| cross(polygon[0], w[0], w[1])).sum();
    if sum == 0.0 { 0.0 } else { sum.signum() }
}

fn edges(polygon: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(&a, &b)| (a, b))
}

fn has(polygon: &[[f64; 2]], point: [f64; 2]) -> bool {
    let sign = orientation(polygon);
    sign != 0.0 && edges(polygon).all(|(a, b)| sign * cross(a, b, point) >= 0.0)
}

/// Whether a line along a side of either separates the convex polygon from the square; the polygon may be a
/// line itself.
fn apart(polygon: &[[f64; 2]], square: &[[f64; 2]; 4]) -> bool {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
    };
    let disjoint = |at: &dyn Fn([f64; 2]) -> f64| {
        let [low, high] = range(&mut polygon.iter().map(|&p| at(p)));
        let [square_low, square_high] = range(&mut square.iter().map(|&p| at(p)));
        high < square_low || square_high < low
    };
    disjoint(&|[x, _]| x)
        || disjoint(&|[_, y]| y)
        || edges(polygon).any(|(a, b)| disjoint(&|point| cross(a, b, point)))
}
