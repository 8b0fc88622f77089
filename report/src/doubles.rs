//! The textbook's transform in `f64`: product, clipping, division, viewport, snapping. Written for the
//! comparison with the rasterizer's own, which is in `f32`.

use halfplane::{Assembly, Bounds, Positions, Region, Standard, Vertex, Viewport};
use halfplane_measure::Matrix;

type Point = [f64; 4];

/// Clip-space vertices in `f64`, seen through a viewport.
#[derive(Clone, Debug)]
pub struct Doubles {
    vertices: Vec<Point>,
    region: Region<Standard>,
    center: [f64; 2],
    half: [f64; 2],
}

/// The product of a position and a matrix.
#[must_use]
pub fn clip(position: [f32; 3], m: &Matrix) -> Point {
    let [x, y, z] = position.map(f64::from);
    let m = |k: usize| f64::from(m[k]);
    [0, 1, 2, 3].map(|k| x * m(k) + y * m(4 + k) + z * m(8 + k) + m(12 + k))
}

impl Doubles {
    /// Room for that many vertices.
    #[must_use]
    pub fn new(vertices: usize, viewport: Viewport<Standard>) -> Self {
        let region = viewport.region();
        let half = [region.width(), region.height()].map(|side| 0.5 * f64::from(side));
        let center = [region.x0() + region.x1(), region.y0() + region.y1()].map(|sum| 0.5 * f64::from(sum));
        Self { vertices: vec![[0.0; 4]; vertices], region, center, half }
    }

    /// Transforms all vertices.
    pub fn transform(&mut self, positions: &[[f32; 3]], matrix: &Matrix) {
        for (vertex, &position) in self.vertices.iter_mut().zip(positions) {
            *vertex = clip(position, matrix);
        }
    }

    /// The window vertex; `None` where a coordinate is none that a window has.
    #[must_use]
    pub fn project(&self, [x, y, z, w]: Point) -> Option<Vertex<Standard>> {
        let steps = f64::from(Bounds::<Standard>::STEPS_PER_PIXEL);
        let limit = f64::from(Bounds::<Standard>::GUARD_BAND);
        let snap = |pixels: f64| {
            let steps = (pixels * steps).round_ties_even();
            (steps.abs() <= limit).then_some(steps as i32)
        };
        let x = snap(self.center[0] + x / w * self.half[0])?;
        let y = snap(self.center[1] - y / w * self.half[1])?;
        // unorm32, nearest, ties up.
        let z = (z / w).clamp(0.0, 1.0) * f64::from(u32::MAX) + 0.5;
        Vertex::new(x, y, z as u32).ok()
    }

    /// What is at least 0 inside: the near and far planes, and the guard band's four sides.
    fn planes(&self) -> [Point; 6] {
        let limit = f64::from(Bounds::<Standard>::CLIP_PIXELS);
        let [left, right] = [-limit, limit].map(|at| (at - self.center[0]) / self.half[0]);
        let [top, bottom] = [-limit, limit].map(|at| (self.center[1] - at) / self.half[1]);
        [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, -1.0, 1.0],
            [1.0, 0.0, 0.0, -left],
            [-1.0, 0.0, 0.0, right],
            [0.0, -1.0, 0.0, top],
            [0.0, 1.0, 0.0, -bottom],
        ]
    }
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Sutherland and Hodgman's clipping (1974) at one plane.
fn cut(polygon: &[Point], plane: Point) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (place, &a) in polygon.iter().enumerate() {
        let b = polygon[(place + 1) % polygon.len()];
        let (at_a, at_b) = (dot(a, plane), dot(b, plane));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a >= 0.0) != (at_b >= 0.0) {
            let along = at_a / (at_a - at_b);
            kept.push([0, 1, 2, 3].map(|k| a[k] + (b[k] - a[k]) * along));
        }
    }
    kept
}

impl Positions<Standard> for Doubles {
    fn count(&self) -> usize {
        self.vertices.len()
    }

    fn window(&self) -> Option<Region<Standard>> {
        Some(self.region)
    }

    fn assemble<E: FnMut([Vertex<Standard>; 3])>(&self, corners: [usize; 3], mut emit: E) -> Assembly {
        let [Some(&a), Some(&b), Some(&c)] = corners.map(|corner| self.vertices.get(corner)) else {
            return Assembly::NoVertex;
        };
        let corners = [a, b, c];
        let beside = |[x, y, z, w]: Point| [x > w, x < -w, y > w, y < -w, z < 0.0, z > w];
        let [a, b, c] = corners.map(beside);
        if (0..6).any(|side| a[side] && b[side] && c[side]) {
            return Assembly::Outside;
        }
        let planes = self.planes();
        if !planes.iter().any(|&plane| corners.iter().any(|&corner| dot(corner, plane) < 0.0)) {
            let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.project(corner)) else {
                return Assembly::NonFinite;
            };
            emit([a, b, c]);
            return Assembly::Whole;
        }
        let polygon = planes.iter().fold(corners.to_vec(), |polygon, &plane| cut(&polygon, plane));
        let vertices: Option<Vec<_>> = polygon.into_iter().map(|corner| self.project(corner)).collect();
        let Some(vertices) = vertices else { return Assembly::NonFinite };
        if vertices.len() < 3 {
            return Assembly::Outside;
        }
        for pair in vertices[1..].windows(2) {
            emit([vertices[0], pair[0], pair[1]]);
        }
        Assembly::Clipped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

    fn assembled(positions: &[[f32; 3]; 3]) -> (Assembly, Vec<[Vertex<Standard>; 3]>) {
        let region = Region::<Standard>::of_size(16, 8).unwrap();
        let mut doubles = Doubles::new(3, Viewport::new(region));
        doubles.transform(positions, &IDENTITY);
        let mut pieces = Vec::new();
        let assembly = doubles.assemble([0, 1, 2], |piece| pieces.push(piece));
        (assembly, pieces)
    }

    #[test]
    fn window_places_of_known_vertices() {
        let (assembly, pieces) = assembled(&[[-1.0, 1.0, 0.0], [1.0, -1.0, 1.0], [0.0, 0.0, 0.5]]);
        assert_eq!(assembly, Assembly::Whole);
        let at = |k: usize| (pieces[0][k].x(), pieces[0][k].y(), pieces[0][k].z());
        // Depths are kept in 2..=2^32 - 3.
        assert_eq!([at(0), at(1), at(2)], [(0, 0, 2), (4096, 2048, u32::MAX - 2), (2048, 1024, 1 << 31)]);
    }

    #[test]
    fn the_near_plane_cuts() {
        let (assembly, pieces) = assembled(&[[-1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [-1.0, -1.0, 1.0]]);
        assert_eq!((assembly, pieces.len()), (Assembly::Clipped, 2));
        assert_eq!(assembled(&[[0.0, 0.0, -1.0], [0.5, 0.0, -1.0], [0.0, 0.5, -0.1]]).0, Assembly::Outside);
    }
}
