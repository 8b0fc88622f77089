//! Boxes: what is said of them is never wrong, and not loose.

use crate::{Failure, case::Case, ensure, failure::Verdict, shapes::Random};
use halfplane::{
    Bound, Compare, Depth, DepthTest, Region, Standard, State, Viewport, draw,
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
    match viewport.bound_box(&identity, [point; 2], state.sample) {
        Bound::Within { area, depths: [least, most] } => {
            ensure!(area.width() <= 1 && area.height() <= 1, "{area:?} for {point:?} at {vertex:?}");
            ensure!(least <= vertex.z() + 2 && vertex.z() <= most + 2, "{vertex:?} outside {least}..={most}");
            ensure!(most - least < 1 << 18, "depths {least}..={most} for {vertex:?}");
        }
        Bound::Nothing => (),
        Bound::Anything => return Err(Failure::new(format_args!("anything for {point:?}"))),
    }
    Ok(())
}
