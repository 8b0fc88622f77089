//! In what floats vertices are transformed.

use halfplane::{NO_ID, Standard, Vertex, draw};
use halfplane_measure::clip;
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Target};

use super::repeated;
use crate::doubles::{self, Doubles};
use crate::error::ReportError;
use crate::plain::{DepthIds, Plain};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::{Errors, differences};
use crate::truth::Truth;

/// The transform.
pub const QUESTION: Question = Question {
    id: "transform",
    title: "Transform in f32 or f64",
    about: "The product with the matrix, the division and the viewport in f32, as this crate does them, against \
            the same in f64 before snapping to 1/256 px. A pixel is wrong where another triangle, or none, is \
            seen than in the picture that has no rounding at all; a vertex differs where it is snapped to another \
            place than the exact one is. Depth and ids, plain arrays for lanes; the last row where vector registers \
            may be used.",
    error: Column::new("wrong pixels", "px"),
    details: &[
        Column::new("vertices snapped elsewhere", "of 1000"),
        Column::new("largest vertex displacement", "px"),
    ],
};

/// A row for each kind of float.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn transform<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let mut entries = vec![single(scene, truth)?, double(scene, truth)?];
    let best = Level::detect();
    if !level::is_fallback(best) {
        let attachments = Attachments::DepthIds32;
        let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
        target.frame(best, attachments, &scene.matrix)?;
        let wrong = differences(&target.id_rows(attachments)?, &truth.unsnapped.ids, NO_ID).0;
        let Row { details, .. } = &entries[0].row;
        let name = format!("f32, {}", best.name());
        let row = Row { error: Some(wrong as f64), details: details.clone(), ..Row::new(name, Whose::Ours) };
        entries.push(Entry::new(row, move |_| repeated(target.frame(best, attachments, &scene.matrix))));
    }
    Ok(entries)
}

fn row(
    name: &str,
    whose: Whose,
    wrong: u64,
    truth: &Truth,
    vertex: impl Fn(usize) -> Option<Vertex<Standard>>,
) -> Row {
    let (mut elsewhere, mut moved) = (0u64, Errors::default());
    for place in &truth.places {
        let given = vertex(place.vertex).map(|v| [v.x(), v.y()]);
        elsewhere += u64::from(given.map(|given| given.map(i64::from)) != Some(place.snapped));
        let at = given.map_or([f64::NAN; 2], |given| given.map(|v| f64::from(v) / 256.0));
        (0..2).for_each(|axis| moved.add(at[axis] - place.exact[axis]));
    }
    let part = (!truth.places.is_empty()).then(|| 1000.0 * elsewhere as f64 / truth.places.len() as f64);
    Row { error: Some(wrong as f64), details: vec![part, Some(moved.largest)], ..Row::new(name, whose) }
}

fn single<'a>(scene: &'a Scene, truth: &Truth) -> Result<Entry<'a>, ReportError> {
    let mut plain = Plain::<Standard>::new(scene)?;
    let mut memory = DepthIds::<Standard>::new(plain.state());
    let viewport = *plain.viewport();
    type Memory = DepthIds<Standard>;
    let frame = |plain: &mut Plain<'_, Standard>, memory: &mut Memory| -> Result<(), ReportError> {
        let (mut depth, mut ids) = memory.clear()?;
        plain.draw(&mut (&mut depth, &mut ids))?;
        Ok(())
    };
    frame(&mut plain, &mut memory)?;
    let wrong = differences(&memory.id_rows()?, &truth.unsnapped.ids, NO_ID).0;
    let row = row("f32, plain arrays", Whose::Ours, wrong, truth, |vertex| {
        viewport.project(clip(scene.positions[vertex], &scene.matrix))
    });
    Ok(Entry::new(row, move |_| repeated(frame(&mut plain, &mut memory))))
}

fn double<'a>(scene: &'a Scene, truth: &Truth) -> Result<Entry<'a>, ReportError> {
    let plain = Plain::<Standard>::new(scene)?;
    let state = *plain.state();
    let mut memory = DepthIds::<Standard>::new(&state);
    let mut positions = Doubles::new(scene.positions.len(), *plain.viewport());
    type Memory = DepthIds<Standard>;
    let frame = move |positions: &mut Doubles, memory: &mut Memory| -> Result<(), ReportError> {
        let (mut depth, mut ids) = memory.clear()?;
        positions.transform(&scene.positions, &scene.matrix);
        draw(&*positions, &scene.indices, 0, &state, &mut (&mut depth, &mut ids))?;
        Ok(())
    };
    frame(&mut positions, &mut memory)?;
    let wrong = differences(&memory.id_rows()?, &truth.unsnapped.ids, NO_ID).0;
    let row = row("f64, plain arrays", Whose::Textbook, wrong, truth, |vertex| {
        positions.project(doubles::clip(scene.positions[vertex], &scene.matrix))
    });
    Ok(Entry::new(row, move |_| repeated(frame(&mut positions, &mut memory))))
}
