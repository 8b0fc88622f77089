//! The same picture with one shortcut left out at a time.

use halfplane::{
    Coverage, Depth, DepthTest, Format, ModelPositions, Small, Standard, Viewport, blocks, draw, simd, texels,
};
use halfplane_measure::clip;
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Prepared, Target};

use super::repeated;
use crate::error::ReportError;
use crate::plain::Plain;
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::truth::Truth;

/// Ablation.
pub const QUESTION: Question = Question {
    id: "ablation",
    title: "Shortcuts left out",
    about: "The same depth picture with one shortcut left out after the other, checked pixel by pixel; then coverage \
            in the small format at 320x240, with 32-bit and with 64-bit set-up. What has no time cannot be left out by a \
            caller; how often it is used stands in the table of what the scene does not need.",
    error: Column::new("pixels not as specified", "px"),
    details: &[],
};

/// 12.4 coordinates as [`Small`] has them, with 64-bit integers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Small64;

impl Format for Small64 {
    const SUBPIXEL_BITS: u32 = Small::SUBPIXEL_BITS;
    const GUARD_BAND_BITS: u32 = Small::GUARD_BAND_BITS;
    const MAX_TARGET: u32 = Small::MAX_TARGET;
    type Wide = i64;
    type Word = u64;
}

/// Shortcuts that a caller cannot leave out, and why. A second build of the rasterizer could not be timed in turns with the
/// first.
const INSIDE: [(&str, &str); 3] = [
    (
        "no way past small triangles (tiles for all)",
        "the choice is a constant of `traversal::walk`, so leaving it out takes another build; its instructions are those \
         of the program depth_tiles beside depth",
    ),
    (
        "no hierarchy of tiles (blocks for all)",
        "edge values fit 32 bits within a tile of 64x64 px only (`Bounds::MAX_TILE_VALUE`): block by block, larger \
         triangles would need other, 64-bit, loops, which there are not",
    ),
    (
        "meshlets without rejection by the frustum",
        "`draw_meshlets` makes it, and the boxes are its own; \"no meshlets\" leaves it out together with the meshlets",
    ),
];

/// A row for each shortcut that can be left out; `small` is the scene at 320x240.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn ablation<'a>(
    scene: &'a Scene,
    small: &'a Scene,
    truth: &Truth,
    prepared: &'a Prepared,
) -> Result<Vec<Entry<'a>>, ReportError> {
    let best = Level::detect();
    let mut entries = Vec::new();
    if !level::is_fallback(best) {
        entries.push(target(scene, truth, best, Some(prepared), "everything: meshlets, vector registers")?);
        entries.push(target(scene, truth, best, None, "no meshlets")?);
        entries.push(any(scene, truth, best)?);
    }
    entries.push(target(scene, truth, Level::FALLBACK, None, "and plain arrays for lanes")?);
    entries.push(corners(scene, truth)?);
    let (first, covered) = coverage::<Small>(small, "small format, 32-bit set-up", None)?;
    let (second, _) = coverage::<Small64>(small, "small format, 64-bit set-up", Some(&covered))?;
    entries.extend([first, second]);
    entries.extend(INSIDE.map(|(name, why)| {
        Row { note: format!("not measured: {why}"), ..Row::new(name, Whose::Ours) }.into()
    }));
    Ok(entries)
}

fn differing<T: PartialEq>(given: &[T], expected: &[T]) -> u64 {
    given.iter().zip(expected).filter(|(given, expected)| given != expected).count() as u64
}

fn row(name: &str, wrong: u64) -> Row {
    Row { error: Some(wrong as f64), ..Row::new(name, Whose::Ours) }
}

fn target<'a>(
    scene: &'a Scene,
    truth: &Truth,
    level: Level,
    prepared: Option<&'a Prepared>,
    name: &str,
) -> Result<Entry<'a>, ReportError> {
    let attachments = Attachments::Depth32;
    let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
    target.set_meshlets(prepared.map(Prepared::meshlets));
    target.frame(level, attachments, &scene.matrix)?;
    let row = row(name, differing(&target.depth_rows(attachments)?, &truth.specified.depth));
    Ok(Entry::new(row, move |_| repeated(target.frame(level, attachments, &scene.matrix))))
}

/// The walk of one triangle after the other, in vector registers.
fn any<'a>(scene: &'a Scene, truth: &Truth, level: Level) -> Result<Entry<'a>, ReportError> {
    let state = scene.state::<Standard>()?;
    let region = state.scissor;
    let mut vertices = vec![[0.0; 4]; scene.positions.len()];
    let mut storage = vec![u32::MAX; texels(region.width(), region.height())];
    let frame = move |storage: &mut Vec<u32>, vertices: &mut Vec<[f32; 4]>| -> Result<(), ReportError> {
        for (vertex, &position) in vertices.iter_mut().zip(&scene.positions) {
            *vertex = clip(position, &scene.matrix);
        }
        let positions = halfplane::ClipPositions::new(vertices, Viewport::new(region));
        let mut depth = Depth::<Standard>::new(region, storage, DepthTest::LESS)?;
        depth.clear(u32::MAX);
        simd::draw_any(level, &positions, &scene.indices, 0, &state, &mut depth)?;
        Ok(())
    };
    frame(&mut storage, &mut vertices)?;
    let row =
        row("and one triangle at a time", differing(&rows(&state, &mut storage)?, &truth.specified.depth));
    Ok(Entry::new(row, move |_| repeated(frame(&mut storage, &mut vertices))))
}

fn rows(state: &halfplane::State<Standard>, storage: &mut [u32]) -> Result<Vec<u32>, ReportError> {
    let region = state.scissor;
    let mut rows = vec![0; region.width() as usize * region.height() as usize];
    Depth::<Standard>::new(region, storage, DepthTest::LESS)?.to_linear(&mut rows)?;
    Ok(rows)
}

/// Vertices transformed for every corner that names them.
fn corners<'a>(scene: &'a Scene, truth: &Truth) -> Result<Entry<'a>, ReportError> {
    let state = scene.state::<Standard>()?;
    let region = state.scissor;
    let mut storage = vec![u32::MAX; texels(region.width(), region.height())];
    let frame = move |storage: &mut Vec<u32>| -> Result<(), ReportError> {
        let m = &scene.matrix;
        let matrix = [0, 4, 8, 12].map(|row| [m[row], m[row + 1], m[row + 2], m[row + 3]]);
        let positions = ModelPositions::new(&scene.positions, matrix, Viewport::new(region));
        let mut depth = Depth::<Standard>::new(region, storage, DepthTest::LESS)?;
        depth.clear(u32::MAX);
        draw(&positions, &scene.indices, 0, &state, &mut depth)?;
        Ok(())
    };
    frame(&mut storage)?;
    let wrong = differing(&rows(&state, &mut storage)?, &truth.specified.depth);
    let row = row("and vertices transformed for each corner", wrong);
    Ok(Entry::new(row, move |_| repeated(frame(&mut storage))))
}

fn coverage<'a, F: Format>(
    scene: &'a Scene,
    name: &str,
    expected: Option<&[u16]>,
) -> Result<(Entry<'a>, Vec<u16>), ReportError> {
    let mut plain = Plain::<F>::new(scene)?;
    let region = plain.state().scissor;
    let mut masks = vec![0u16; blocks(region.width(), region.height())];
    let frame = move |plain: &mut Plain<'_, F>, masks: &mut [u16]| -> Result<(), ReportError> {
        let mut coverage = Coverage::<F>::new(region, masks)?;
        coverage.clear();
        plain.draw(&mut coverage)?;
        Ok(())
    };
    frame(&mut plain, &mut masks)?;
    let wrong = expected.map_or(0, |expected| differing(&masks, expected));
    let drawn = masks.clone();
    Ok((Entry::new(row(name, wrong), move |_| repeated(frame(&mut plain, &mut masks))), drawn))
}
