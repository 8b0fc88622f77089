//! Boxes: what is said of them is never wrong, and not loose.

use crate::{
    Failure,
    case::Case,
    ensure,
    failure::Verdict,
    shapes::{Model, Projection, Random},
};
use halfplane::{
    Bound, Compare, Count, Coverage, Depth, DepthTest, Frustum, ModelPositions, Region, Sample, Standard,
    State, Viewport, blocks, draw,
    numbers::{DEPTH32_MAX, DEPTH32_MIN},
    texels,
};

/// What is in a box covers no pixel outside its bound, at no depth outside, for boxes round some of the triangles.
/// Whether the bound said anything of use.
pub fn boxes_bound_what_they_hold(case: &Case) -> Result<bool, Failure> {
    let state = case.state()?;
    let mut random = Random(case.first_id.into());
    let triangles = case.indices.as_chunks::<3>().0;
    if triangles.is_empty() {
        return Ok(false);
    }
    let first = random.below(triangles.len());
    let last = (first + random.below(4)).min(triangles.len() - 1);
    let mut corners = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    let position = |corner: u32| case.model.vertices[corner as usize];
    for corner in triangles[first..=last].as_flattened().iter().map(|&corner| position(corner)) {
        if corner.iter().all(|v| v.is_finite()) {
            for (axis, v) in corner.into_iter().enumerate() {
                corners[0][axis] = corners[0][axis].min(v);
                corners[1][axis] = corners[1][axis].max(v);
            }
        }
    }
    let [low, high] = corners;
    if low[0] > high[0] {
        return Ok(false);
    }
    let inside =
        |corner: u32| (0..3).all(|a| low[a] <= position(corner)[a] && position(corner)[a] <= high[a]);
    let held: Vec<u32> = triangles
        .iter()
        .filter(|corners| corners.iter().all(|&corner| inside(corner)))
        .flatten()
        .copied()
        .collect();
    bounds_all(case, case.core_viewport()?.bound_box(&case.model.matrix, corners, state.sample), &held)
}

/// Triangles of a case cover no pixel outside a bound, at no depth outside. Whether the bound said anything of use.
pub(super) fn bounds_all(case: &Case, bound: Bound<Standard>, held: &[u32]) -> Result<bool, Failure> {
    let (state, region) = (case.state()?, case.frame.core_region()?);
    let (area, [nearest, farthest]) = match bound {
        Bound::Anything => return Ok(false),
        Bound::Nothing => (None, [0, u32::MAX]),
        Bound::Within { area, depths } => (Some(area), depths),
    };
    let range = |depth: u32| depth.clamp(DEPTH32_MIN, DEPTH32_MAX);
    for (compare, clear) in [(Compare::Less, u32::MAX), (Compare::Greater, 0)] {
        let mut depths = vec![0; texels(region.width(), region.height())];
        let mut depth = Depth::<Standard>::new(region, &mut depths, DepthTest { compare, write: true })?;
        depth.clear(clear);
        draw(&case.positions()?, held, 0, &state, &mut depth)?;
        for (x, y) in case.frame.pixels() {
            let stored = depth.get(x, y).unwrap_or(clear);
            if stored == clear {
                continue;
            }
            let inside =
                area.is_some_and(|area| area.x0() <= x && x < area.x1() && area.y0() <= y && y < area.y1());
            ensure!(inside, "({x}, {y}) is covered, but not in {bound:?}");
            ensure!(
                stored >= range(nearest) - 1 && stored <= range(farthest) + 1,
                "({x}, {y}) has depth {stored}, outside {bound:?}"
            );
        }
    }
    Ok(true)
}

/// A box of one point is bound to the pixels next to it, and to depths next to its own: bounds are not loose.
pub fn bounds_of_points_are_tight(point: [f32; 3], size: [u32; 2]) -> Verdict {
    let region = Region::<Standard>::of_size(size[0], size[1])?;
    let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let state = State::new(region);
    let viewport = Viewport::new(region);
    let [x, y, z] = point;
    let vertex = viewport.project([x, y, z, 1.0]).ok_or_else(|| Failure::new("no vertex"))?;
    let beside = |v: i32, size: u32| v < -257 || v > 256 * size as i32 + 257;
    if beside(vertex.x(), size[0]) || beside(vertex.y(), size[1]) {
        let bound = viewport.bound_box(&identity, [point; 2], state.sample);
        ensure!(bound == Bound::Nothing, "{bound:?} for {point:?}, beside {size:?}");
        return Ok(());
    }
    match viewport.bound_box(&identity, [point; 2], state.sample) {
        Bound::Within { area, depths: [least, most] } => {
            ensure!(area.width() <= 1 && area.height() <= 1, "{area:?} for {point:?} at {vertex:?}");
            ensure!(
                least <= vertex.z() + 2 && vertex.z() <= most.saturating_add(2),
                "{vertex:?} outside {least}..={most}"
            );
            ensure!(most - least < 1 << 18, "depths {least}..={most} for {vertex:?}");
        }
        Bound::Nothing => (),
        Bound::Anything => return Err(Failure::new(format_args!("anything for {point:?}"))),
    }
    Ok(())
}

/// A case with triangles in a box, many of their corners at the box's, in place of its own, and the box. Most boxes
/// begin at one of the case's vertices. Often all of it is sheared and far from the origin, so that sums of several terms cancel, and the matrix is multiplied by a
/// power of two, which changes no quotient.
fn filled(case: &Case, low: [f32; 3], size: [f32; 3], seed: u64) -> (Case, [[f32; 3]; 2]) {
    let mut random = Random(seed);
    let away = (random.between(-40, 160) as f32 / 16.0).exp2();
    let moved = [0; 3].map(|_: u32| [0.0, 0.0, away, -away][random.below(4)]);
    let scale = (random.between(-12, 12) as f32).exp2();
    let [mut x, mut y, z, mut last] = case.model.matrix;
    let [shear_x, shear_y] = [0; 2].map(|_: u32| [0.0, 0.0, 0.75, -1.5][random.below(4)]);
    for column in 0..4 {
        x[column] += shear_x * z[column];
        y[column] += shear_y * z[column];
    }
    let low = match case.model.vertices.first() {
        Some(vertex) if !seed.is_multiple_of(4) && vertex.iter().all(|v| v.is_finite()) => *vertex,
        _ => low,
    };
    let low = [low[0], low[1], low[2] - shear_x * low[0] - shear_y * low[1]];
    for (column, to) in last.iter_mut().enumerate() {
        *to -= moved[0] * x[column] + moved[1] * y[column] + moved[2] * z[column];
    }
    let matrix = [x, y, z, last].map(|row| row.map(|v| v * scale));
    let low = [0, 1, 2].map(|axis| low[axis] + moved[axis]);
    let high = [0, 1, 2].map(|axis| low[axis] + size[axis]);
    let vertices = (0..36).map(|_| {
        [0, 1, 2].map(|axis| match random.below(4) {
            0 => low[axis],
            1 => high[axis],
            _ => {
                let part = random.below(1000) as f32 / 1000.0;
                (low[axis] + (high[axis] - low[axis]) * part).clamp(low[axis], high[axis])
            }
        })
    });
    let model = Model { vertices: vertices.collect(), matrix };
    (Case { model, indices: (0..36).collect(), ..case.clone() }, [low, high])
}

/// Vertices of a box, at its corners and in it, and triangles of them, are in its bound, whatever the matrix. Boxes of
/// one point show that rounding is allowed for. Whether the bound said anything of use.
pub fn points_of_boxes_are_in_their_bound(
    case: &Case,
    low: [f32; 3],
    size: [f32; 3],
    seed: u64,
) -> Result<bool, Failure> {
    let (case, corners) = filled(case, low, size, seed);
    let bound = case.core_viewport()?.bound_box(&case.model.matrix, corners, case.state()?.sample);
    has_vertices(&case, bound)?;
    bounds_all(&case, bound, &case.indices)
}

/// All vertices of a case that are in view are at one of a bound's depths, and in one of its pixels or less than a pixel
/// from their samples.
pub(super) fn has_vertices(case: &Case, bound: Bound<Standard>) -> Verdict {
    let Bound::Within { area, depths } = bound else { return Ok(()) };
    let (positions, viewport) = (case.positions()?, case.core_viewport()?);
    for clip in (0..case.model.vertices.len()).filter_map(|at| positions.clip(at)) {
        has_vertex(&viewport, area, depths, clip)?;
    }
    Ok(())
}

/// A vertex in view is at one of the depths, and in one of the pixels or less than a pixel from their samples.
pub(super) fn has_vertex(
    viewport: &Viewport<Standard>,
    area: Region<Standard>,
    [nearest, farthest]: [u32; 2],
    clip: [f32; 4],
) -> Verdict {
    let Some(vertex) = viewport.project(clip) else { return Ok(()) };
    let (z, range) = (vertex.z(), |depth: u32| depth.clamp(DEPTH32_MIN, DEPTH32_MAX));
    ensure!(range(nearest) <= z && z <= range(farthest), "depth {z}, not {nearest}..={farthest}");
    let region = viewport.region();
    let sides = [
        (vertex.x(), area.x0(), area.x1(), region.x0(), region.x1()),
        (vertex.y(), area.y0(), area.y1(), region.y0(), region.y1()),
    ];
    for (at, first, end, from, to) in sides {
        let [first, end, from, to] = [first, end, from, to].map(|pixel| 256 * pixel as i32);
        let beside = (from..to).contains(&at) && (at < first - 257 || at > end + 257);
        ensure!(!beside, "a vertex at {at}, beside {first}..{end}");
    }
    Ok(())
}

/// No vertex of a box that is left out is inside the frustum, and each of one that is contained is; nor is anything of one
/// that is left out for an area drawn there. With ordinary matrices, boxes that are so by more than rounding are said
/// to be. What was said: left out, contained, beside the area.
pub fn boxes_are_where_they_are_said_to_be(
    case: &Case,
    low: [f32; 3],
    size: [f32; 3],
    seed: u64,
) -> Result<[bool; 3], Failure> {
    let (case, corners) = filled(case, low, size, seed);
    let (state, viewport, positions) = (case.state()?, case.core_viewport()?, case.positions()?);
    let frustum = Frustum::new(&case.model.matrix);
    let (excluded, contained) = (frustum.excludes_box(corners), frustum.contains_box(corners));
    for clip in (0..36).filter_map(|at| positions.clip(at)) {
        let [x, y, z, w] = clip;
        let inside = x >= -w && x <= w && y >= -w && y <= w && z >= 0.0 && z <= w && w >= 0.0;
        ensure!(!excluded || !inside, "{clip:?} is inside, and its box left out");
        ensure!(!contained || inside, "{clip:?} is outside, and its box contained");
    }
    let beside = Frustum::of_area(&case.model.matrix, &viewport, state.scissor).excludes_box(corners);
    if beside {
        let mut count = Count::default();
        draw(&positions, &case.indices, 0, &state, &mut count)?;
        ensure!(count.samples == 0, "{} samples of a box that is left out for their area", count.samples);
    }
    if !matches!(case.projection, Projection::Bits | Projection::Scaled) {
        let [out, inside, out_of_area] = exactly(&case, corners, &state.scissor);
        ensure!(excluded || !out, "a box outside is not left out");
        ensure!(contained || !inside, "a box inside is not contained");
        ensure!(beside || !out_of_area, "a box beside the area is not left out for it");
    }
    Ok([excluded, contained, beside])
}

/// Whether a box is outside the frustum, inside, and beside an area in the viewport, by more than rounding.
fn exactly(case: &Case, [low, high]: [[f32; 3]; 2], area: &Region<Standard>) -> [bool; 3] {
    let [x0, y0, x1, y1] = case.viewport.map(f64::from);
    let [half_width, half_height] = [(x1 - x0) / 2.0, (y1 - y0) / 2.0];
    // The ends of the area, a pixel beyond them, from -1 to 1.
    let across = |pixel: f64| ((pixel - x0) / half_width - 1.0).clamp(-1.0, 1.0);
    let down = |pixel: f64| (1.0 - (pixel - y0) / half_height).clamp(-1.0, 1.0);
    let (left, right) = (across(f64::from(area.x0()) - 1.0), across(f64::from(area.x1()) + 1.0));
    let (top, bottom) = (down(f64::from(area.y0()) - 1.0), down(f64::from(area.y1()) + 1.0));
    let planes = |[left, right, bottom, top]: [f64; 4]| {
        let (x, y, z, w) = ([1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]);
        let sum = |a: [f64; 4], p: f64, b: [f64; 4], q: f64| [0, 1, 2, 3].map(|k| p * a[k] + q * b[k]);
        [
            sum(x, 1.0, w, -left),
            sum(x, -1.0, w, right),
            sum(y, 1.0, w, -bottom),
            sum(y, -1.0, w, top),
            z,
            sum(w, 1.0, z, -1.0),
            w,
        ]
    };
    // The least and the greatest value at corners, beyond the margin if they have the same sign.
    let ends = |plane: [f64; 4]| {
        let rows = case.model.matrix.map(|row| row.map(f64::from));
        let coefficient = rows.map(|row| row.iter().zip(plane).map(|(m, p)| m * p).sum::<f64>());
        let magnitude = rows.map(|row| row.iter().zip(plane).map(|(m, p)| (m * p).abs()).sum::<f64>());
        let (mut least, mut most, mut margin) = (coefficient[3], coefficient[3], magnitude[3]);
        for axis in 0..3 {
            let ends = [low[axis], high[axis]].map(f64::from);
            let values = ends.map(|v| v * coefficient[axis]);
            least += values[0].min(values[1]);
            most += values[0].max(values[1]);
            margin += magnitude[axis] * ends[0].abs().max(ends[1].abs());
        }
        [least - 1e-5 * margin, most + 1e-5 * margin]
    };
    let whole = planes([-1.0, 1.0, -1.0, 1.0]).map(ends);
    let part = planes([left, right, bottom, top]).map(ends);
    let beside = |plane: &[f64; 2]| plane[1] < 0.0;
    [whole.iter().any(beside), whole.iter().all(|plane| plane[0] > 0.0), part.iter().any(beside)]
}

/// A rectangle whose corners are less than a sub-pixel step beside samples covers nothing outside its bound: snapping
/// moves it by up to half a step. Distances from the samples are in 1/8 steps. It is not left out for the pixels that
/// it covers, and is for those that are two away.
pub fn rectangles_beside_samples_are_in_their_bound(
    samples: [u32; 4],
    beside: [i32; 4],
    sample: [u32; 2],
) -> Verdict {
    let region = Region::<Standard>::of_size(64, 64)?;
    let [sample_x, sample_y] = sample.map(|v| (v % 256) as i32);
    let sample = Sample::new(sample_x, sample_y).ok_or_else(|| Failure::new("no sample"))?;
    let state = State { sample, ..State::new(region) };
    let viewport = Viewport::new(region);
    let [left, top, right, bottom] = [0, 1, 2, 3].map(|at| {
        // 1/8 steps of 1/256 pixels: 2048 to a pixel.
        let offset = if at % 2 == 0 { sample_x } else { sample_y };
        let place = 2048 * (samples[at] % 64) as i32 + 8 * offset + beside[at];
        place as f32 / (32.0 * 2048.0) - 1.0
    });
    let (low, high) = ([left.min(right), -top.max(bottom), 0.5], [left.max(right), -top.min(bottom), 0.5]);
    let corner = |right: bool, top: bool| {
        [if right { high[0] } else { low[0] }, if top { high[1] } else { low[1] }, 0.5]
    };
    let vertices = [corner(false, true), corner(true, true), corner(true, false), corner(false, false)];
    let matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let positions = ModelPositions::new(&vertices, matrix, viewport);
    let mut masks = vec![0; blocks(64, 64)];
    let mut coverage = Coverage::new(region, &mut masks)?;
    draw(&positions, &[0u8, 1, 2, 0, 2, 3], 0, &state, &mut coverage)?;
    let bound = viewport.bound_box(&matrix, [low, high], state.sample);
    let area = match bound {
        Bound::Within { area, .. } => Some(area),
        Bound::Nothing => None,
        Bound::Anything => return Err(Failure::new("anything")),
    };
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
        let inside = area.is_some_and(|a| (a.x0()..a.x1()).contains(&x) && (a.y0()..a.y1()).contains(&y));
        let covered = coverage.get(x, y) == Some(true);
        ensure!(inside || !covered, "({x}, {y}) is covered, but not in {bound:?}");
        let pixel = Region::new(x, y, x + 1, y + 1)?;
        let left_out = Frustum::of_area(&matrix, &viewport, pixel).excludes_box([low, high]);
        ensure!(!covered || !left_out, "({x}, {y}) is covered, and the rectangle left out for it");
        let away = |from: f32, to: f32, pixel: u32| {
            let [from, to] = [from, to].map(|v| 32.0 * (v + 1.0));
            to < pixel as f32 - 1.0 || from > pixel as f32 + 2.0
        };
        let away = away(low[0], high[0], x) || away(-high[1], -low[1], y);
        ensure!(left_out || !away, "the rectangle is not left out for ({x}, {y})");
    }
    Ok(())
}

/// Where quotients of a box's clip coordinates are beyond every float, it may cover anything.
pub fn quotients_beyond_floats_are_anywhere() -> Verdict {
    let viewport = Viewport::new(Region::<Standard>::of_size(64, 64)?);
    for axis in 0..3 {
        let mut matrix = [[0.; 4]; 4];
        matrix[axis][axis] = 1e30;
        matrix[3][3] = 1e-20;
        let bound = viewport.bound_box(&matrix, [[1.0; 3], [2.0; 3]], Sample::CENTER);
        ensure!(bound == Bound::Anything, "axis {axis}: {bound:?}");
    }
    Ok(())
}
