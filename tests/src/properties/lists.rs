//! Triangle lists: what is said to be out of sight changes nothing, and a list is out of sight where its box is.

use super::simd::{Storage, levels};
use crate::{Failure, case::Case, ensure, ensure_eq, failure::Verdict, shapes::Random};
use halfplane::{
    Compare, Count, D16, D32, DepthFormat, DepthRange, DepthTest, DrawError, HierarchicalDepth, Region,
    Standard, Vertex, depth_ranges, draw,
    simd::{Level, Occluder, Visibility, ask, ask_triangles},
};

/// What was said of lists, and of the boxes round them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Said {
    /// Lists outside, hidden, visible.
    pub lists: [u32; 3],
    /// Boxes outside, hidden, visible.
    pub boxes: [u32; 3],
}

/// The place of an answer in [`Said`].
fn place(answer: Visibility) -> usize {
    match answer {
        Visibility::Outside => 0,
        Visibility::Hidden => 1,
        Visibility::Visible => 2,
    }
}

/// After some of a case's triangles, asks about lists of the others: the same at every level, never visible where the
/// box is not, and no sample of a list outside, no pixel of a hidden one.
pub fn lists_out_of_sight_change_nothing(case: &Case) -> Result<Said, Failure> {
    if case.attachments.is_multiple_of(4) {
        out_of_sight::<D16>(case, |storage| &mut storage.depths16)
    } else {
        out_of_sight::<D32>(case, |storage| &mut storage.depths)
    }
}

fn out_of_sight<D: DepthFormat<Standard>>(
    case: &Case,
    memory: impl Fn(&mut Storage) -> &mut Vec<D::Texel>,
) -> Result<Said, Failure>
where
    for<'a> HierarchicalDepth<'a, Standard, D>: Occluder,
{
    let (positions, state, region) = (case.positions()?, case.state()?, case.frame.core_region()?);
    let mut random = Random(u64::from(case.contents) << 20 | u64::from(case.first_id));
    let test = match case.test.compare {
        Compare::Always => DepthTest::LESS,
        _ => case.test,
    };
    let (mut storage, mut ranges) =
        (Storage::new(region, case.contents), vec![DepthRange::UNKNOWN; ranges_of(region)]);
    let mut depth = HierarchicalDepth::<Standard, D>::new(region, memory(&mut storage), &mut ranges, test)?;
    let triangles = case.indices.as_chunks::<3>().0;
    let (drawn, mut rest) = triangles.split_at(triangles.len() / 2);
    draw(&positions, drawn.as_flattened(), 0, &state, &mut depth)?;
    let mut before = vec![D::FAR; (region.width() * region.height()) as usize];
    let mut after = before.clone();
    let mut said = Said::default();
    while !rest.is_empty() {
        let (list, next) = rest.split_at(rest.len().min(1 + random.below(3)));
        let indices = list.as_flattened();
        rest = next;
        let mut answers = levels()
            .map(|level| ask_triangles(level, &positions, indices, &state, &mut depth))
            .collect::<Result<Vec<_>, _>>()?;
        answers.dedup();
        ensure_eq!(answers.len(), 1, "levels say {answers:?} of {list:?}");
        let corners = box_round(case, indices);
        let mut of_box = [Visibility::Visible];
        let (matrix, viewport) = (&case.model.matrix, case.core_viewport()?);
        ask(Level::FALLBACK, &[corners], matrix, &viewport, &state, &mut depth, &mut of_box)?;
        let (answer, [of_box]) = (answers[0], of_box);
        ensure!(place(answer) <= place(of_box), "{answer:?}, and the box round it is {of_box:?}");
        said.lists[place(answer)] += 1;
        said.boxes[place(of_box)] += 1;
        if answer == Visibility::Visible {
            continue;
        }
        let mut count = Count::default();
        draw(&positions, indices, 0, &state, &mut count)?;
        ensure!(answer != Visibility::Outside || count.samples == 0, "{} samples outside", count.samples);
        depth.depth().to_linear(&mut before)?;
        draw(&positions, indices, 0, &state, &mut depth)?;
        depth.depth().to_linear(&mut after)?;
        ensure!(after == before, "what is {answer:?} is seen: {list:?}");
    }
    Ok(said)
}

fn ranges_of(region: Region<Standard>) -> usize {
    depth_ranges(region.width(), region.height())
}

/// Not finite where a vertex is not.
fn box_round(case: &Case, indices: &[u32]) -> [[f32; 3]; 2] {
    let mut corners = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for position in indices.iter().map(|&index| case.model.vertices[index as usize]) {
        let finite = position.iter().all(|v| v.is_finite());
        for (axis, v) in position.into_iter().enumerate() {
            corners[0][axis] = corners[0][axis].min(if finite { v } else { f32::NEG_INFINITY });
            corners[1][axis] = corners[1][axis].max(if finite { v } else { f32::INFINITY });
        }
    }
    corners
}

/// Lists that could not be drawn are refused; of none, nothing is seen.
pub fn wrong_lists_are_refused(case: &Case) -> Verdict {
    let (positions, state, region) = (case.positions()?, case.state()?, case.frame.core_region()?);
    let (mut storage, mut ranges) = (Storage::new(region, 0), vec![DepthRange::UNKNOWN; ranges_of(region)]);
    let vertices = case.model.vertices.len();
    let mut more = case.indices.clone();
    more.push(0);
    let mut beyond = case.indices.clone();
    beyond.extend([0, vertices as u32, 0]);
    for level in levels() {
        let mut depth =
            HierarchicalDepth::<Standard>::new(region, &mut storage.depths, &mut ranges, DepthTest::LESS)?;
        let mut ask = |indices: &[u32]| ask_triangles(level, &positions, indices, &state, &mut depth);
        ensure_eq!(ask(&[]), Ok(Visibility::Outside), "nothing");
        ensure_eq!(ask(&more), Err(DrawError::IndexCount { count: more.len() }), "one index more");
        let index = if vertices == 0 { 0 } else { vertices as u32 };
        let at = beyond.len() - if vertices == 0 { 3 } else { 2 };
        ensure_eq!(
            ask(&beyond),
            Err(DrawError::IndexOutOfRange { at, index, vertices }),
            "an index too large"
        );
    }
    Ok(())
}

/// Window triangles are asked about as they are: those of a case, hidden behind something near, and not behind nothing.
pub fn lists_of_window_triangles_are_asked_about(case: &Case) -> Verdict {
    let (state, region) = (case.state()?, case.frame.core_region()?);
    let corners = case.wanted.as_flattened();
    let vertices = corners
        .iter()
        .map(|&[x, y]| Vertex::<Standard>::new(x, y, 1 << 31))
        .collect::<Result<Vec<_>, _>>()?;
    let indices: Vec<u32> = (0..vertices.len() as u32).collect();
    let mut count = Count::default();
    draw(&vertices[..], &indices, 0, &state, &mut count)?;
    let (mut storage, mut ranges) = (Storage::new(region, 0), vec![DepthRange::UNKNOWN; ranges_of(region)]);
    for level in levels() {
        let mut depth =
            HierarchicalDepth::<Standard>::new(region, &mut storage.depths, &mut ranges, DepthTest::LESS)?;
        for clear in [0, u32::MAX] {
            depth.clear(clear);
            let said = ask_triangles(level, &vertices[..], &indices, &state, &mut depth)?;
            let seen = clear > 0 && count.samples > 0;
            ensure!(!seen || said == Visibility::Visible, "{} samples are {said:?}", count.samples);
            ensure!(clear > 0 || said != Visibility::Visible, "visible behind the near plane");
        }
    }
    Ok(())
}
