//! Coverage in clip space as textbooks have it (Olano and Greer, 1997), in floats throughout.

use halfplane_measure::Matrix;

/// Floats of one width.
pub trait Float:
    Copy
    + PartialOrd
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Neg<Output = Self>
{
    /// The nearest one.
    fn of(value: f32) -> Self;
    /// 0.
    const ZERO: Self;
}

impl Float for f32 {
    const ZERO: Self = 0.0;
    fn of(value: f32) -> Self {
        value
    }
}

impl Float for f64 {
    const ZERO: Self = 0.0;
    fn of(value: f32) -> Self {
        value.into()
    }
}

/// A triangle set up for its samples.
#[derive(Clone, Copy, Debug)]
pub struct Homogeneous<T> {
    edges: [[T; 3]; 3],
    depth: [T; 3],
    determinant: T,
    size: [T; 2],
}

impl<T: Float> Homogeneous<T> {
    /// Of three positions through a matrix, on a target of that size.
    #[must_use]
    pub fn new(corners: [[f32; 3]; 3], matrix: &Matrix, (width, height): (u32, u32)) -> Self {
        let m = matrix.map(T::of);
        let clip = |corner: [f32; 3]| {
            let [x, y, z] = corner.map(T::of);
            [0, 1, 2, 3].map(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k])
        };
        let [a, b, c] = corners.map(clip);
        let cross = |[ax, ay, _, aw]: [T; 4], [bx, by, _, bw]: [T; 4]| {
            [ay * bw - aw * by, aw * bx - ax * bw, ax * by - ay * bx]
        };
        let mut edges = [cross(b, c), cross(c, a), cross(a, b)];
        let mut determinant = edges[0][0] * a[0] + edges[0][1] * a[1] + edges[0][2] * a[3];
        if determinant < T::ZERO {
            edges = edges.map(|edge| edge.map(|v| -v));
            determinant = -determinant;
        }
        let depth = [0, 1, 2].map(|k| edges[0][k] * a[2] + edges[1][k] * b[2] + edges[2][k] * c[2]);
        Self { edges, depth, determinant, size: [width as f32, height as f32].map(T::of) }
    }

    /// Whether it covers the centre of a pixel, by the top-left rule, between near and far.
    #[must_use]
    pub fn covers(&self, (x, y): (u32, u32)) -> bool {
        let [width, height] = self.size;
        let [column, row] = [2 * x + 1, 2 * y + 1].map(|v| T::of(v as f32));
        let sample = [(column - width) * height, (height - row) * width, width * height];
        let at = |plane: [T; 3]| plane[0] * sample[0] + plane[1] * sample[1] + plane[2] * sample[2];
        let inside = self.edges.iter().all(|&edge| {
            let value = at(edge);
            let counts = edge[0] > T::ZERO || edge[0] == T::ZERO && edge[1] < T::ZERO;
            value > T::ZERO || counts && value == T::ZERO
        });
        let depth = at(self.depth);
        self.determinant > T::ZERO && inside && depth >= T::ZERO && depth <= self.determinant * sample[2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_a_square_is_covered() {
        let mut identity = [0.0; 16];
        (0..4).for_each(|k| identity[5 * k] = 1.0);
        let corners = [[-1.0, 1.0, 0.5], [1.0, 1.0, 0.5], [-1.0, -1.0, 0.5]];
        let covered = |of: &dyn Fn((u32, u32)) -> bool| {
            (0..8).flat_map(|y| (0..8).map(move |x| (x, y))).filter(|&pixel| of(pixel)).count()
        };
        let single = Homogeneous::<f32>::new(corners, &identity, (8, 8));
        let double = Homogeneous::<f64>::new(corners, &identity, (8, 8));
        // The diagonal through samples is its right edge.
        assert_eq!(covered(&|pixel| single.covers(pixel)), 28);
        assert_eq!(covered(&|pixel| double.covers(pixel)), 28);
    }
}
