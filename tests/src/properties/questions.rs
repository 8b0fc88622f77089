//! Questions about boxes and spheres: what is said to be out of sight is.

use super::{
    simd::{Storage, levels},
    spheres::sphere_round,
};
use crate::{Failure, case::Case, ensure, ensure_eq, failure::Verdict};
use halfplane::{
    Compare, DepthRange, DepthTest, DrawError, Frustum, HierarchicalDepth, Ids, OutsideAttachment, Region,
    Standard, State, Viewport, depth_ranges, draw,
    simd::{Level, Occluder, Visibility, Volume, ask},
};

/// The box round each triangle.
fn boxes_round(case: &Case) -> Vec<[[f32; 3]; 2]> {
    let triangles = case.indices.as_chunks::<3>().0;
    triangles
        .iter()
        .map(|corners| {
            let corners = corners.map(|corner| case.model.vertices[corner as usize]);
            let axis = |pick: fn(f32, f32) -> f32| {
                [0, 1, 2].map(|k| corners.map(|c| c[k]).into_iter().fold(corners[0][k], pick))
            };
            [axis(f32::min), axis(f32::max)]
        })
        .collect()
}

/// What can be seen in what is drawn to; where that is nothing, in all of the viewport.
fn frustum(case: &Case) -> Result<Frustum, Failure> {
    let (viewport, state) = (case.core_viewport()?, case.state()?);
    let area = viewport.region().intersect(state.scissor).unwrap_or(viewport.region());
    Ok(Frustum::of_area(&case.model.matrix, &viewport, area))
}

/// After a frame, whatever is said of boxes round some triangles is the same at every level, and drawing what is said to
/// be out of sight changes no pixel. How often each answer was given: outside, hidden, visible.
pub fn answers_are_certain(case: &Case) -> Result<[u32; 3], Failure> {
    let frustum = frustum(case)?;
    are_certain(case, &boxes_round(case), |&corners| frustum.excludes_box(corners))
}

/// After a frame, what is said of spheres round its triangles is the same at every level, and drawing what is said to be
/// out of sight changes no pixel. How often each answer was given: outside, hidden, visible.
pub fn answers_about_spheres_are_certain(case: &Case) -> Result<[u32; 3], Failure> {
    let spheres: Vec<_> = case
        .indices
        .as_chunks::<3>()
        .0
        .iter()
        .map(|corners| sphere_round(corners.map(|corner| case.model.vertices[corner as usize])))
        .collect();
    let frustum = frustum(case)?;
    are_certain(case, &spheres, |&(center, radius)| frustum.excludes_sphere(center, radius))
}

/// The same for volumes, each round the triangle of its number; what the frustum excludes is outside.
fn are_certain<V: Volume>(
    case: &Case,
    volumes: &[V],
    excluded: impl Fn(&V) -> bool,
) -> Result<[u32; 3], Failure> {
    let (state, region) = (case.state()?, case.frame.core_region()?);
    let triangles = case.indices.as_chunks::<3>().0;
    let half = triangles.len() / 2;
    let test = match case.test.compare {
        Compare::Always => DepthTest::LESS,
        _ => case.test,
    };
    let mut storage = Storage::new(region, case.contents);
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(region.width(), region.height())];
    let mut depth = HierarchicalDepth::<Standard>::new(region, &mut storage.depths, &mut ranges, test)?;
    draw(&case.positions()?, triangles[..half].as_flattened(), 0, &state, &mut depth)?;
    let mut said = None;
    for level in levels() {
        let mut answers = vec![Visibility::default(); volumes.len()];
        ask(level, volumes, &case.model.matrix, &case.core_viewport()?, &state, &mut depth, &mut answers)?;
        ensure_eq!(*said.get_or_insert_with(|| answers.clone()), answers, "{}", level.name());
    }
    let said = said.ok_or_else(|| Failure::new("no level"))?;
    for (at, (volume, &said)) in volumes.iter().zip(&said).enumerate() {
        ensure!(
            !excluded(volume) || said == Visibility::Outside,
            "volume {at}, outside the frustum, is {said:?}"
        );
    }
    let mut few = vec![Visibility::default(); volumes.len().saturating_sub(1)];
    if !volumes.is_empty() {
        let error = ask(
            Level::FALLBACK,
            volumes,
            &case.model.matrix,
            &case.core_viewport()?,
            &state,
            &mut depth,
            &mut few,
        );
        let expected = DrawError::ScratchTooSmall { needed: volumes.len(), given: volumes.len() - 1 };
        ensure_eq!(error, Err(expected), "too few answers");
    }
    let mut before = vec![0; (region.width() * region.height()) as usize];
    depth.depth().to_linear(&mut before)?;
    let gone: Vec<u32> = triangles
        .iter()
        .zip(&said)
        .filter(|(_, said)| **said != Visibility::Visible)
        .flat_map(|(corners, _)| *corners)
        .collect();
    draw(&case.positions()?, &gone, 0, &state, &mut depth)?;
    let mut after = before.clone();
    depth.depth().to_linear(&mut after)?;
    ensure!(after == before, "what was out of sight is seen");
    let count = |what| said.iter().filter(|&&said| said == what).count() as u32;
    Ok([Visibility::Outside, Visibility::Hidden, Visibility::Visible].map(count))
}

/// An occluder by reference, and in a pair with another attachment: the same answers, and where the scissor reaches beyond
/// it, it refuses to be asked.
pub fn occluders_by_any_name_are_the_same(case: &Case) -> Verdict {
    let (state, region, viewport) = (case.state()?, case.frame.core_region()?, case.core_viewport()?);
    let (matrix, triangles) = (&case.model.matrix, case.indices.as_chunks::<3>().0);
    let boxes = boxes_round(case);
    let mut storage = Storage::new(region, 0);
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(region.width(), region.height())];
    let mut depth =
        HierarchicalDepth::<Standard>::new(region, &mut storage.depths, &mut ranges, DepthTest::LESS)?;
    draw(&case.positions()?, triangles[..triangles.len() / 2].as_flattened(), 0, &state, &mut depth)?;
    let mut expected = vec![Visibility::default(); boxes.len()];
    ask(Level::FALLBACK, &boxes, matrix, &viewport, &state, &mut depth, &mut expected)?;

    fn answers<A: Occluder>(
        (case, boxes, state): (&Case, &[[[f32; 3]; 2]], &State<Standard>),
        occluder: &mut A,
    ) -> Result<Result<Vec<Visibility>, DrawError>, Failure> {
        let mut answers = vec![Visibility::default(); boxes.len()];
        let level = Level::detect();
        let asked =
            ask(level, boxes, &case.model.matrix, &case.core_viewport()?, state, occluder, &mut answers);
        Ok(asked.map(|()| answers))
    }
    let mut ids = Ids::new(region, &mut storage.ids)?;
    let questions = (case, &boxes[..], &state);
    ensure_eq!(answers(questions, &mut &mut depth)?.as_ref(), Ok(&expected), "by reference");
    ensure_eq!(answers(questions, &mut (&mut depth, &mut ids))?.as_ref(), Ok(&expected), "in a pair");
    let Ok(large) = Region::new(region.x0(), region.y0(), region.x1(), region.y1() + 1) else {
        return Ok(());
    };
    // The viewport is drawn to where both are.
    let [x0, y0, x1, y1] = [large.x0(), large.y0(), large.x1(), large.y1()];
    let wide = Case { viewport: [x0, y0, x1, y1], ..case.clone() };
    let wide_state = State { scissor: large, ..state };
    let questions = (&wide, &boxes[..], &wide_state);
    let outside = OutsideAttachment {
        area: [x0, y0, x1, y1],
        attachment: [region.x0(), region.y0(), region.x1(), region.y1()],
    };
    let refused = Err(DrawError::OutsideAttachment(outside));
    ensure_eq!(answers(questions, &mut depth)?, refused, "itself");
    ensure_eq!(answers(questions, &mut &mut depth)?, refused, "by reference");
    ensure_eq!(answers(questions, &mut (&mut depth, &mut ids))?, refused, "in a pair");
    Ok(())
}

/// A box and a sphere that reach behind the eye, where nothing bounds what they cover, and are beside the view frustum.
pub fn beside_the_eye_is_outside() -> Verdict {
    let region = Region::<Standard>::of_size(64, 64)?;
    let (viewport, state) = (Viewport::new(region), State::new(region));
    // w is z.
    let matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 1.], [0., 0., -0.5, 0.]];
    let mut storage = Storage::new(region, 0);
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(64, 64)];
    let mut depth =
        HierarchicalDepth::<Standard>::new(region, &mut storage.depths, &mut ranges, DepthTest::LESS)?;
    let ([x, y, z], radius) = ([-9.0, 1.0, 0.5], 1.0);
    let (boxes, spheres) =
        ([[[x - 1.0, y - 1.0, z - 1.0], [x + 1.0, y + 1.0, z + 1.0]]], [([x, y, z], radius)]);
    for level in levels() {
        let mut answers = [Visibility::Visible; 2];
        let [of_box, of_sphere] = &mut answers;
        ask(level, &boxes, &matrix, &viewport, &state, &mut depth, std::slice::from_mut(of_box))?;
        ask(level, &spheres, &matrix, &viewport, &state, &mut depth, std::slice::from_mut(of_sphere))?;
        ensure_eq!(answers, [Visibility::Outside; 2], "{}", level.name());
    }
    Ok(())
}
