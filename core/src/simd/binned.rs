//! Bins drawn by lanes in vector registers.

use super::level::Level;
use crate::{
    attachments::{Attachment, OutsideAttachment},
    bins::{self, BinnedDraw, Bins, TileOrder},
    draw::{DrawError, Index, State},
    geometry::{Positions, Region},
    lanes::VectorLanes,
    numbers::Format,
};
use fearless_simd::dispatch;

/// [`bins::draw_binned`] with lanes in vector registers of `level`: the same picture, the same statistics.
///
/// # Errors
///
/// [`DrawError`], before anything is written: as [`bins::draw_binned`].
#[expect(clippy::too_many_arguments, reason = "as many as there are things to say")]
pub fn draw_binned<F, P, I, A>(
    level: Level,
    bins: &mut Bins<'_, F>,
    positions: &P,
    indices: &[I],
    first_id: u32,
    state: &State<F>,
    order: TileOrder,
    attachments: &mut A,
) -> Result<BinnedDraw, DrawError>
where
    F: Format,
    P: Positions<F> + ?Sized,
    I: Index,
    A: Attachment<F>,
{
    let Some(level) = level.0 else {
        return bins::draw_binned(bins, positions, indices, first_id, state, order, attachments);
    };
    dispatch!(level, simd => {
        bins::draw_binned_with::<VectorLanes<_>, F, P, I, A>(
            simd, bins, positions, indices, first_id, state, order, attachments,
        )
    })
}

/// [`Bins::draw`] with lanes in vector registers of `level`: the same pixels.
///
/// # Errors
///
/// [`OutsideAttachment`], before anything is written: as [`Bins::draw`].
pub fn draw_bins<F: Format, A: Attachment<F>>(
    level: Level,
    bins: &Bins<'_, F>,
    part: Region<F>,
    order: TileOrder,
    attachments: &mut A,
) -> Result<(), OutsideAttachment> {
    let Some(level) = level.0 else { return bins.draw(part, order, attachments) };
    dispatch!(level, simd => bins.draw_with::<VectorLanes<_>, A>(simd, part, order, attachments))
}
