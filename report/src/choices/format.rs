//! The small format beside the standard one.

use halfplane::{D16, D32, Depth, DepthFormat, DepthTest, Format, Ids, NO_ID, Small, Standard, texels};

use super::repeated;
use crate::error::ReportError;
use crate::plain::{Plain, rows};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::differences;

/// The format.
pub const QUESTION: Question = Question {
    id: "format",
    title: "Standard and small format",
    about: "The same scene on a small display: 16.8 coordinates with 64-bit set-up beside 12.4 coordinates with \
            32-bit arithmetic throughout, which is what microcontrollers multiply and divide fast. A pixel is wrong \
            where another triangle, or none, is seen than in the picture that has no rounding at all. Depth only is \
            timed, plain arrays for lanes, on this machine, whose 64-bit arithmetic costs nothing extra.",
    error: Column::new("wrong pixels", "px"),
    details: &[Column::new("of those: silhouette", "px")],
};

/// The small display.
pub const SIZE: (u32, u32) = (320, 240);

/// A row for each format and depth, for a scene of [`SIZE`] and its unsnapped ids.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn format<'a>(scene: &'a Scene, unsnapped: &[u32]) -> Result<Vec<Entry<'a>>, ReportError> {
    Ok(vec![
        at::<Standard, D32>("Standard 16.8, D32", scene, unsnapped)?,
        at::<Standard, D16>("Standard 16.8, D16", scene, unsnapped)?,
        at::<Small, D16>("Small 12.4, D16", scene, unsnapped)?,
    ])
}

fn at<'a, F: Format, D: DepthFormat<F>>(
    name: &str,
    scene: &'a Scene,
    unsnapped: &[u32],
) -> Result<Entry<'a>, ReportError> {
    let mut plain = Plain::<F>::new(scene)?;
    let state = *plain.state();
    let region = state.scissor;
    let texels = texels(region.width(), region.height());
    let mut storage = vec![D::FAR; texels];
    let ids = {
        let mut storage = storage.clone();
        let mut depth = Depth::<F, D>::new(region, &mut storage, DepthTest::LESS)?;
        let mut id_storage = vec![NO_ID; texels];
        let mut ids = Ids::<F>::new(region, &mut id_storage)?;
        plain.draw(&mut (&mut depth, &mut ids))?;
        rows(&state, &mut id_storage)?
    };
    let (wrong, silhouette) = differences(&ids, unsnapped, NO_ID);
    let bytes = size_of_val(storage.as_slice());
    let row = Row {
        error: Some(wrong as f64),
        details: vec![Some(silhouette as f64)],
        bytes: Some(bytes),
        ..Row::new(name, Whose::Ours)
    };
    let mut frame = move || -> Result<(), ReportError> {
        let mut depth = Depth::<F, D>::new(region, &mut storage, DepthTest::LESS)?;
        depth.clear(D::FAR);
        plain.draw(&mut depth)?;
        Ok(())
    };
    frame()?;
    Ok(Entry::new(row, move |_| repeated(frame())))
}
