//! Spheres: what is said of them is never wrong, and not loose.

use super::boxes::{bounds_all, has_vertices};
use crate::{
    Failure,
    case::Case,
    ensure,
    failure::Verdict,
    shapes::{Projection, Random},
};
use halfplane::{Bound, Frustum, ModelPositions, Region, Sample, Standard, Viewport};

/// The distance of two points; more than enough for them to be this far apart.
pub(super) fn distance(a: [f32; 3], b: [f32; 3]) -> f64 {
    let square = |axis: usize| (f64::from(a[axis]) - f64::from(b[axis])).powi(2);
    (square(0) + square(1) + square(2)).sqrt() * (1.0 + 1e-14)
}

/// A float that is not less.
pub(super) fn float_above(value: f64) -> f32 {
    let float = value as f32;
    if f64::from(float) < value { float.next_up() } else { float }
}

/// Center and radius of a sphere that has a triangle in it. The radius is not a number where a corner is none.
#[cfg(feature = "simd")]
pub(super) fn sphere_round(corners: [[f32; 3]; 3]) -> ([f32; 3], f32) {
    let center = [0, 1, 2].map(|axis| corners.iter().map(|p| p[axis] / 3.0).fold(0.0, |a, b| a + b));
    let distances = corners.map(|corner| distance(corner, center));
    let radius = if distances.iter().any(|v| v.is_nan()) {
        f32::NAN
    } else {
        float_above(distances.into_iter().fold(0.0, f64::max))
    };
    (center, radius)
}

/// Triangles inside a sphere cover no pixel outside its bound, at no depth outside, for spheres round some of the
/// triangles. Whether the bound said anything of use.
pub fn spheres_bound_what_they_hold(case: &Case) -> Result<bool, Failure> {
    let mut random = Random(u64::from(case.first_id) << 8);
    let triangles = case.indices.as_chunks::<3>().0;
    if triangles.is_empty() {
        return Ok(false);
    }
    let position = |corner: u32| case.model.vertices[corner as usize];
    let first = random.below(triangles.len());
    let last = (first + random.below(3)).min(triangles.len() - 1);
    let some: Vec<[f32; 3]> = triangles[first..=last].iter().flatten().map(|&c| position(c)).collect();
    if some.as_flattened().iter().any(|v| !v.is_finite()) {
        return Ok(false);
    }
    let center =
        [0, 1, 2].map(|axis| some.iter().map(|p| p[axis] / some.len() as f32).fold(0.0, |a, b| a + b));
    let radius = float_above(some.iter().map(|&p| distance(p, center)).fold(0.0, f64::max));
    let inside = |corner: u32| distance(position(corner), center) <= f64::from(radius);
    let held: Vec<u32> =
        triangles.iter().filter(|t| t.iter().all(|&corner| inside(corner))).flatten().copied().collect();
    let bound = case.core_viewport()?.bound_sphere(&case.model.matrix, center, radius, case.state()?.sample);
    bounds_all(case, bound, &held)
}

/// Triangles of any points of a sphere and in it are in its bound, whatever the matrix. Whether the bound said anything
/// of use.
pub fn points_of_spheres_are_in_their_bound(
    case: &Case,
    center: [f32; 3],
    radius: f32,
    seed: u64,
) -> Result<bool, Failure> {
    let mut random = Random(seed);
    let vertices: Vec<[f32; 3]> = (0..36)
        .map(|at| {
            let direction = direction(&mut random);
            let length = if at % 5 == 4 { random.below(1000) as f32 / 1000.0 } else { 1.0 };
            [0, 1, 2].map(|axis| center[axis] + direction[axis] * radius * length)
        })
        .collect();
    // The points are rounded: the sphere is the one that has them.
    let radius = float_above(vertices.iter().map(|&p| distance(p, center)).fold(f64::from(radius), f64::max));
    let mut case = case.clone();
    (case.model.vertices, case.indices) = (vertices, (0..36).collect());
    let bound = case.core_viewport()?.bound_sphere(&case.model.matrix, center, radius, case.state()?.sample);
    has_vertices(&case, bound)?;
    bounds_all(&case, bound, &case.indices)
}

/// A unit vector, or a hundred thousandth longer or shorter.
pub(super) fn direction(random: &mut Random) -> [f32; 3] {
    let direction = [0; 3].map(|_| random.below(2001) as f32 / 1000.0 - 1.0);
    let length = direction.iter().map(|v| v * v).sum::<f32>().sqrt().max(1e-3);
    direction.map(|v| v / length)
}

/// A point and a matrix in an object space that is turned by two angles, about x and then about z.
fn turn([x, y, z]: [f32; 3], matrix: [[f32; 4]; 4], turns: [f32; 2]) -> ([f32; 3], [[f32; 4]; 4]) {
    let [(s, c), (t, d)] = turns.map(|angle| f64::from(angle).sin_cos());
    let turned = |[x, y, z]: [f64; 3]| {
        let [y, z] = [c * y - s * z, s * y + c * z];
        [d * x - t * y, t * x + d * y, z]
    };
    let [mx, my, mz, last] = matrix;
    let mut rows = [[0.0; 4]; 3];
    for column in 0..4 {
        let found = turned([mx[column], my[column], mz[column]].map(f64::from));
        for (row, value) in rows.iter_mut().zip(found) {
            row[column] = value as f32;
        }
    }
    let [a, b, c] = rows;
    (turned([x, y, z].map(f64::from)).map(|v| v as f32), [a, b, c, last])
}

/// Before a camera, however object space is turned, a sphere is bound by little more than what its points cover, and
/// never by more than the box round it. How many pixels the bounds of the sphere and of the box have.
pub fn bounds_of_spheres_are_tight(
    center: [f32; 3],
    radius: f32,
    turns: [f32; 2],
) -> Result<[u64; 2], Failure> {
    let region = Region::<Standard>::of_size(1280, 720)?;
    let viewport = Viewport::new(region);
    // w is z; depth 1/4 at 1 and nearly 1 far away.
    let matrix = [[1.0, 0., 0., 0.], [0., 1.7, 0., 0.], [0., 0., 1.0, 1.0], [0., 0., -0.75, 0.]];
    let (turned, matrix) = turn(center, matrix, turns);
    let bound = viewport.bound_sphere(&matrix, turned, radius, Sample::CENTER);
    let ends = [-1.0, 1.0].map(|sign| turned.map(|v| v + sign * radius));
    let bound_of_box = viewport.bound_box(&matrix, ends, Sample::CENTER);
    let ([cx, cy, cz], r) = (center.map(f64::from), f64::from(radius));
    // The plane through the eye and an axis touches the circle in which the sphere cuts the other plane.
    let tangents = |c: f64| {
        let (square, root) = (cz * cz - r * r, r * (c * c + cz * cz - r * r).sqrt());
        [(c * cz - root) / square, (c * cz + root) / square]
    };
    let [[left, right], [down, up]] = [tangents(cx), tangents(cy)];
    let pixel = |v: f64, size: f64| v.clamp(0.0, size);
    let columns = [left, right].map(|x| pixel(640.0 + 640.0 * x, 1280.0));
    let rows = [up, down].map(|y| pixel(360.0 - 360.0 * 1.7 * y, 720.0));
    let depths = [cz - r, cz + r].map(|z| (z - 0.75) / z);
    match bound {
        Bound::Within { area, depths: found } => {
            let found = found.map(|depth| f64::from(depth) / f64::from(u32::MAX));
            let sides = [(area.x0(), area.x1(), columns), (area.y0(), area.y1(), rows)];
            for (first, end, [from, to]) in sides {
                let (first, end) = (f64::from(first), f64::from(end));
                // A pixel at most, as samples are in the middle, and rounding.
                ensure!(first >= from - 1.0 && end <= to + 1.0, "{bound:?}, not {columns:?}, {rows:?}");
            }
            for (found, depth) in found.into_iter().zip(depths) {
                let off = (found - depth.clamp(0.0, 1.0)).abs();
                // The margin of rounding grows with terms over the smallest w: turned, at most the centre's distance and
                // the square root of 3 times the radius.
                let away = (cx * cx + cy * cy + cz * cz).sqrt();
                let allowed = 1.2e-5 * (1.0 + (away + 1.74 * r) / (cz - r));
                ensure!(off.total_cmp(&allowed).is_lt(), "depths {found:?}, not {depths:?}");
            }
        }
        Bound::Nothing => {
            let seen = |[from, to]: [f64; 2]| to - from > 1.0;
            ensure!(!seen(columns) || !seen(rows), "nothing, not {columns:?}, {rows:?}");
        }
        Bound::Anything => return Err(Failure::new(format_args!("anything for {center:?}, {radius}"))),
    }
    let pixels = |bound: Bound<Standard>| match bound {
        Bound::Nothing => 0,
        Bound::Within { area, .. } => u64::from(area.width()) * u64::from(area.height()),
        Bound::Anything => u64::from(region.width()) * u64::from(region.height()),
    };
    ensure!(pixels(bound) <= pixels(bound_of_box), "{bound:?} is more than the box's {bound_of_box:?}");
    Ok([pixels(bound), pixels(bound_of_box)])
}

/// Products next to the smallest float lose their digits: a sphere of one point has the vertex in its bound all the same.
pub fn points_before_tiny_matrices_are_in_their_bound(z: f32) -> Verdict {
    let viewport = Viewport::new(Region::<Standard>::of_size(16384, 16384)?);
    let tiny = f32::MIN_POSITIVE;
    let matrix = [[tiny, 0., 0., 0.], [0., tiny, 0., 0.], [0., 0., tiny, 0.], [0., 0., 0., 2.0 * tiny]];
    // At a sample.
    let vertices = [[1.0 / 8192.0, -1.0 / 8192.0, z]];
    let clip = ModelPositions::new(&vertices, matrix, viewport).clip(0);
    let vertex = clip.and_then(|clip| viewport.project(clip)).ok_or_else(|| Failure::new("no vertex"))?;
    match viewport.bound_sphere(&matrix, vertices[0], 0.0, Sample::CENTER) {
        Bound::Within { depths: [least, most], .. } => {
            ensure!(least <= vertex.z() && vertex.z() <= most.max(2), "{vertex:?} outside {least}..={most}");
        }
        other => return Err(Failure::new(format_args!("{other:?} for {vertex:?}"))),
    }
    Ok(())
}

/// What is no sphere, or reaches the eye's plane, may be anywhere.
pub fn bounds_of_no_spheres_are_anything(center: [f32; 3], radius: f32) -> Verdict {
    let viewport = Viewport::new(Region::<Standard>::of_size(64, 48)?);
    let matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 1.], [0., 0., -0.5, 0.]];
    let bound = viewport.bound_sphere(&matrix, center, radius, Sample::CENTER);
    ensure!(bound == Bound::Anything, "{bound:?} for {center:?} and {radius}");
    Ok(())
}

/// No point of a sphere that is left out is inside the frustum; spheres far outside are left out.
pub fn spheres_left_out_are_outside(
    case: &Case,
    center: [f32; 3],
    radius: f32,
    seed: u64,
) -> Result<bool, Failure> {
    let frustum = Frustum::new(&case.model.matrix);
    let excluded = frustum.excludes_sphere(center, radius);
    // A box round it that is left out, and a little more, has the sphere in it; squares of ordinary numbers are
    // ordinary.
    let ends = [-1.0, 1.0].map(|sign| center.map(|v| v + sign * (radius * 1.01 + 0.01)));
    let ordinary = !matches!(case.projection, Projection::Bits | Projection::Scaled);
    ensure!(
        excluded || !ordinary || !frustum.excludes_box(ends),
        "the box of a sphere is outside, and the sphere not"
    );
    if !excluded {
        return Ok(false);
    }
    let mut random = Random(seed);
    for _ in 0..20 {
        let mut direction = [0; 3].map(|_| random.below(2001) as f32 / 1000.0 - 1.0);
        let length = direction.iter().map(|v| v * v).sum::<f32>().sqrt().max(1e-3) * 1.000_001;
        direction = direction.map(|v| v / length * radius);
        let [x, y, z] = [0, 1, 2].map(|axis| center[axis] + direction[axis]);
        let vertices = [[x, y, z]];
        let positions = ModelPositions::new(&vertices, case.model.matrix, case.core_viewport()?);
        let [x, y, z, w] = positions.clip(0).ok_or_else(|| Failure::new("no vertex"))?;
        let inside = x >= -w && x <= w && y >= -w && y <= w && z >= 0.0 && z <= w && w >= 0.0;
        ensure!(!inside, "a point of a sphere that was left out is inside: {:?}", [x, y, z, w]);
    }
    Ok(true)
}
