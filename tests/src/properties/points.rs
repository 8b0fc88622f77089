//! Boxes and spheres of one point: what rounding does to the vertex there, their bounds allow for.

use super::{
    boxes::has_vertex,
    spheres::{direction, distance, float_above},
};
use crate::{ensure, failure::Verdict, shapes::Random};
use halfplane::{Bound, Frustum, ModelPositions, Region, Sample, Standard, Viewport};

/// A point, and a matrix that takes it near a given place in view, by sums of terms that may be much larger than what
/// they come to.
struct Point {
    place: [f32; 3],
    matrix: [[f32; 4]; 4],
    /// The plane of the frustum that it is on, or nearly: of -x, x, -y, y, -z and z.
    plane: usize,
}

impl Point {
    /// Terms of up to 2^12 times what they come to; w is a power of two from 2^-20 to 2^20.
    fn new(random: &mut Random) -> Self {
        let power = |random: &mut Random, from: i64, to: i64| (random.between(from, to) as f64).exp2();
        let unit = |random: &mut Random| random.between(-1 << 30, 1 << 30) as f64 / f64::from(1 << 30);
        let place = [0; 3].map(|_: u32| (unit(random) * power(random, 0, 10)) as f32);
        let w = power(random, -20, 20);
        let depth = (unit(random).abs() * power(random, -12, 0)).min(1.0);
        let mut wanted = [unit(random), unit(random), depth, 1.0];
        let plane = random.below(6);
        if random.below(2) == 0 {
            wanted[plane / 2] = [-1.0, 1.0, -1.0, 1.0, 0.0, 1.0][plane];
        }
        let wanted = wanted.map(|v| v * w);
        let mut matrix = [[0.0; 4]; 4];
        for column in 0..4 {
            // Some columns are sums of small terms, or of none.
            let size = w * [0.0, 1e-3, 1.0, 64.0][random.below(4)];
            let mut sum = 0.0;
            for (axis, row) in matrix.iter_mut().take(3).enumerate() {
                row[column] = (unit(random) * size) as f32;
                sum += f64::from(row[column]) * f64::from(place[axis]);
            }
            matrix[3][column] = (wanted[column] - sum) as f32;
        }
        Self { place, matrix, plane }
    }

    /// The sphere of about that radius outside the plane that touches it at the point.
    fn sphere(&self, radius: f64) -> ([f32; 3], f32) {
        let sign = [1.0, -1.0][self.plane % 2];
        let [x, y, z, _] = self.matrix;
        let normal = [x, y, z].map(|row| {
            let w = if self.plane == 4 { 0.0 } else { f64::from(row[3]) };
            w + sign * f64::from(row[self.plane / 2])
        });
        let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt().max(1e-30);
        let center = [0, 1, 2].map(|k| (f64::from(self.place[k]) - normal[k] / length * radius) as f32);
        (center, float_above(distance(center, self.place)))
    }
}

/// The vertex is where the bounds of the box and of the sphere say that it may be, and not where a frustum says that
/// they are not.
pub fn points_are_in_their_bounds(seed: u64) -> Verdict {
    let mut random = Random(seed);
    let region = Region::<Standard>::of_size(1280, 720)?;
    let viewport = Viewport::new(region);
    for _ in 0..20 {
        let point = Point::new(&mut random);
        let (place, matrix) = (point.place, point.matrix);
        let vertices = [place];
        let Some(clip) = ModelPositions::new(&vertices, matrix, viewport).clip(0) else { continue };
        let boxed = viewport.bound_box(&matrix, [place; 2], Sample::CENTER);
        let round = viewport.bound_sphere(&matrix, place, 0.0, Sample::CENTER);
        for bound in [boxed, round] {
            if let Bound::Within { area, depths } = bound {
                has_vertex(&viewport, area, depths, clip)?;
            }
        }
        let [x, y, z, w] = clip;
        let inside = x >= -w && x <= w && y >= -w && y <= w && z >= 0.0 && z <= w && w >= 0.0;
        let frustum = Frustum::new(&matrix);
        let (out, contained) = (frustum.excludes_box([place; 2]), frustum.contains_box([place; 2]));
        ensure!(!inside || !out, "{clip:?} is inside, and its box left out");
        ensure!(inside || !contained, "{clip:?} is outside, and its box contained");
        for radius in [0.0, 1.0 / 64.0, 1.0, 64.0] {
            let (center, radius) = point.sphere(radius);
            let mut on_it = vec![place];
            for _ in 0..8 {
                let direction = direction(&mut random);
                let near = [0, 1, 2].map(|axis| center[axis] + direction[axis] * radius);
                if distance(center, near) <= f64::from(radius) {
                    on_it.push(near);
                }
            }
            if let Bound::Within { area, depths } =
                viewport.bound_sphere(&matrix, center, radius, Sample::CENTER)
            {
                let positions = ModelPositions::new(&on_it, matrix, viewport);
                for clip in (0..on_it.len()).filter_map(|at| positions.clip(at)) {
                    has_vertex(&viewport, area, depths, clip)?;
                }
            }
            let out = frustum.excludes_sphere(center, radius);
            ensure!(!inside || !out, "{clip:?} is inside, and a sphere of {radius} that it is in left out");
        }
    }
    Ok(())
}
