//! How finely vertices are snapped.

use halfplane::{Bounds, Format, NO_ID, Standard};
use halfplane_measure::clip;

use super::repeated;
use crate::error::ReportError;
use crate::formats::{
    Bits0, Bits1, Bits2, Bits3, Bits4, Bits5, Bits6, Bits7, Bits12, Bits12Near, Grid, Own, WholePixels,
    broken,
};
use crate::plain::{DepthIds, Plain};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::{Errors, differences};
use crate::truth::Truth;

/// Sub-pixel bits.
pub const QUESTION: Question = Question {
    id: "subpixel-bits",
    title: "Sub-pixel bits",
    about: "How finely vertices are snapped. A pixel is wrong where another triangle, or none, is seen than in \
            the picture that has no rounding at all. Depth and ids are drawn with plain arrays for lanes at every \
            format, so only the grid differs.",
    error: Column::new("wrong pixels", "px"),
    details: &[Column::new("of those: silhouette", "px"), Column::new("largest vertex displacement", "px")],
};

/// A row for each number of bits.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn subpixel<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let mut entries = vec![
        at::<Standard, WholePixels>("0 bits", scene, truth)?,
        at::<Bits1, Own>("1 bit", scene, truth)?,
        at::<Bits2, Own>("2 bits", scene, truth)?,
        at::<Bits3, Own>("3 bits", scene, truth)?,
        at::<Bits4, Own>("4 bits", scene, truth)?,
        at::<Bits5, Own>("5 bits", scene, truth)?,
        at::<Bits6, Own>("6 bits", scene, truth)?,
        at::<Bits7, Own>("7 bits", scene, truth)?,
        at::<Standard, Own>("8 bits (Standard)", scene, truth)?,
    ];
    if let Some(first) = entries.first_mut() {
        first.row.note = format!(
            "corners at whole pixels, drawn on the grid of 8 bits; a format of 0 bits is refused ({}), as a pixel's centre \
             lies between its steps",
            broken::<Bits0>().join("; ")
        );
    }
    let note = format!(
        "no such format, so nothing to measure. With Standard's guard band of ±{} px it breaks {} bounds: {}. With a \
         guard band of ±{} px, for targets up to {} px, it breaks this: {}",
        Bounds::<Standard>::GUARD_BAND / Bounds::<Standard>::STEPS_PER_PIXEL,
        broken::<Bits12>().len(),
        broken::<Bits12>().join("; "),
        Bounds::<Bits12Near>::GUARD_BAND / Bounds::<Bits12Near>::STEPS_PER_PIXEL,
        Bits12Near::MAX_TARGET,
        broken::<Bits12Near>().join("; ")
    );
    entries.push(Row { note, ..Row::new("12 bits", Whose::Ours) }.into());
    Ok(entries)
}

fn at<'a, F, G>(name: &str, scene: &'a Scene, truth: &Truth) -> Result<Entry<'a>, ReportError>
where
    F: Format<Word = u64>,
    G: Grid<F>,
{
    let mut plain = Plain::<F>::new(scene)?;
    let mut memory = DepthIds::<F>::new(plain.state());
    let frame = |plain: &mut Plain<'_, F>, memory: &mut DepthIds<F>| -> Result<(), ReportError> {
        let (mut depth, mut ids) = memory.clear()?;
        plain.draw_on::<G, _>(&mut (&mut depth, &mut ids))?;
        Ok(())
    };
    frame(&mut plain, &mut memory)?;
    let (wrong, silhouette) = differences(&memory.id_rows()?, &truth.unsnapped.ids, NO_ID);
    let mut moved = Errors::default();
    for place in &truth.places {
        let vertex =
            plain.viewport().project(clip(scene.positions[place.vertex], &scene.matrix)).map(G::vertex);
        let steps = f64::from(1u32 << F::SUBPIXEL_BITS);
        let at = vertex.map_or([f64::NAN; 2], |v| [v.x(), v.y()].map(|v| f64::from(v) / steps));
        (0..2).for_each(|axis| moved.add(at[axis] - place.exact[axis]));
    }
    let row = Row {
        error: Some(wrong as f64),
        details: vec![Some(silhouette as f64), Some(moved.largest)],
        ..Row::new(name, Whose::Ours)
    };
    Ok(Entry::new(row, move |_| repeated(frame(&mut plain, &mut memory))))
}
