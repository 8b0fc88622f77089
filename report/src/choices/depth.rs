//! How depth is interpolated and stored.

use halfplane::{Attachment, D16, D32, Depth, DepthFormat, DepthTest, Ids, NO_ID, Standard, texels};
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Target};

use super::repeated;
use crate::error::ReportError;
use crate::judge::Judge;
use crate::plain::{Plain, rows};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::{Errors, differences};
use crate::textbook::{Barycentric32, ExactRational, Gradient32, Gradient64, Plane, PlaneDepth};
use crate::truth::Truth;

/// Depth.
pub const QUESTION: Question = Question {
    id: "depth",
    title: "Depth",
    about: "The stored depth against the exact one of the snapped triangle, at every sample that a triangle \
            covers, hidden ones included. A wrong winner is a pixel whose depth test lets another triangle win \
            than exact depths do. Textbook planes are drawn by the same traversal, with the same coverage, into \
            buffers of the same layout. Depth only is timed, with plain arrays for lanes, but for the last two \
            rows: what this crate does where vector registers may be used.",
    error: Column::new("largest error", "2^-32"),
    details: &[Column::new("mean error", "2^-32"), Column::new("wrong winners", "px")],
};

/// A row for each plane.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn depth<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let mut judge = Judge::new(scene.state()?);
    Plain::<Standard>::new(scene)?.draw(&mut judge)?;
    let [ours32, ours16, bary, grad32, grad64, rational] = judge.errors();
    let names = ["D32, plain arrays", "D16, plain arrays"];
    let (e32, w32) = ours::<D32>(scene, truth, names[0], ours32)?;
    let (e16, w16) = ours::<D16>(scene, truth, names[1], ours16)?;
    let mut entries = vec![
        e32,
        e16,
        textbook::<Barycentric32>(scene, truth, bary)?,
        textbook::<Gradient32>(scene, truth, grad32)?,
        textbook::<Gradient64>(scene, truth, grad64)?,
        textbook::<ExactRational>(scene, truth, rational)?,
    ];
    let best = Level::detect();
    if !level::is_fallback(best) {
        let (name, attachments) = ("D32", Attachments::Depth32);
        entries.push(fast(scene, best, (name, attachments), ours32, w32)?);
        entries.push(fast(scene, best, ("D16", Attachments::Depth16), ours16, w16)?);
    }
    Ok(entries)
}

fn row(name: impl Into<String>, whose: Whose, errors: &Errors, winners: u64) -> Row {
    let details = vec![Some(errors.mean()), Some(winners as f64)];
    Row { error: Some(errors.largest), details, ..Row::new(name, whose) }
}

fn ours<'a, D: DepthFormat<Standard>>(
    scene: &'a Scene,
    truth: &Truth,
    name: &str,
    errors: Errors,
) -> Result<(Entry<'a>, u64), ReportError> {
    let mut plain = Plain::<Standard>::new(scene)?;
    let region = plain.state().scissor;
    let mut storage = vec![D::FAR; texels(region.width(), region.height())];
    let winners = {
        let mut storage = storage.clone();
        let mut depth = Depth::<Standard, D>::new(region, &mut storage, DepthTest::LESS)?;
        wrong_winners(&mut plain, truth, &mut depth)?
    };
    let row =
        Row { bytes: Some(size_of_val(storage.as_slice())), ..row(name, Whose::Ours, &errors, winners) };
    let mut frame = move || -> Result<(), ReportError> {
        let mut depth = Depth::<Standard, D>::new(region, &mut storage, DepthTest::LESS)?;
        depth.clear(D::FAR);
        plain.draw(&mut depth)?;
        Ok(())
    };
    frame()?;
    Ok((Entry::new(row, move |_| repeated(frame())), winners))
}

fn textbook<'a, P: Plane + 'a>(
    scene: &'a Scene,
    truth: &Truth,
    errors: Errors,
) -> Result<Entry<'a>, ReportError> {
    let mut plain = Plain::<Standard>::new(scene)?;
    let region = plain.state().scissor;
    let winners = wrong_winners(&mut plain, truth, &mut PlaneDepth::<P>::new(region))?;
    let bytes = texels(region.width(), region.height()) * size_of::<P::Depth>();
    let row = Row { bytes: Some(bytes), ..row(P::NAME, Whose::Textbook, &errors, winners) };
    let mut depth = PlaneDepth::<P>::new(region);
    let mut frame = move || {
        depth.clear();
        plain.draw(&mut depth)
    };
    frame()?;
    Ok(Entry::new(row, move |_| repeated(frame())))
}

/// Pixels where the depth test lets another triangle win than the exact depths do.
fn wrong_winners<A: Attachment<Standard>>(
    plain: &mut Plain<'_, Standard>,
    truth: &Truth,
    depth: &mut A,
) -> Result<u64, ReportError> {
    let state = *plain.state();
    let mut storage = vec![NO_ID; texels(state.scissor.width(), state.scissor.height())];
    let mut ids = Ids::new(state.scissor, &mut storage)?;
    plain.draw(&mut (depth, &mut ids))?;
    Ok(differences(&rows(&state, &mut storage)?, &truth.nearest, NO_ID).0)
}

fn fast<'a>(
    scene: &'a Scene,
    level: Level,
    (name, attachments): (&str, Attachments),
    errors: Errors,
    winners: u64,
) -> Result<Entry<'a>, ReportError> {
    let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
    target.frame(level, attachments, &scene.matrix)?;
    let row = row(format!("{name}, {}", level.name()), Whose::Ours, &errors, winners);
    Ok(Entry::new(row, move |_| repeated(target.frame(level, attachments, &scene.matrix))))
}
