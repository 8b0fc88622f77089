//! Any positions, any attachments: the walk of [`draw`](crate::draw()) itself, in vector registers.

use super::level::Level;
use crate::{
    attachments::Attachment,
    draw::{self, DrawError, Index, State, Statistics},
    geometry::Positions,
    lanes::VectorLanes,
    numbers::Format,
};
use fearless_simd::dispatch;

/// [`draw`](crate::draw()) with lanes in vector registers of `level`: the same picture, the same
/// statistics, the same calls of the attachments' methods, for whatever can be drawn at all.
///
/// Where [`simd::draw`](super::draw) can be called, it is faster.
///
/// # Errors
///
/// [`DrawError`], before anything is written: as [`draw`](crate::draw()).
pub fn draw_any<F, P, I, A>(
    level: Level,
    positions: &P,
    indices: &[I],
    first_id: u32,
    state: &State<F>,
    attachments: &mut A,
) -> Result<Statistics, DrawError>
where
    F: Format,
    P: Positions<F> + ?Sized,
    I: Index,
    A: Attachment<F>,
{
    let Some(level) = level.0 else { return draw::draw(positions, indices, first_id, state, attachments) };
    dispatch!(level, simd => {
        draw::draw_with::<VectorLanes<_>, F, P, I, A>(simd, positions, indices, first_id, state, attachments)
    })
}
