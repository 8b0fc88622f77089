//! What waits in bins, drawn tile by tile.

use super::{Bins, MAX_TRIANGLES, TileOrder, columns, rows};
use crate::{
    attachments::{Attachment, Block, OutsideAttachment},
    draw::{self, DrawError, Index, State, Statistics},
    geometry::{Assembly, Positions, Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
    traversal::{Mask, TILE, fill, walk},
};
use core::sync::atomic::Ordering;

/// What a draw through bins did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BinnedDraw {
    /// As those of [`draw`](crate::draw()).
    pub statistics: Statistics,
    /// How often bins were drawn: once, or more often where their memory was full.
    pub rounds: u32,
    /// Triangles that did not fit into empty bins, and were drawn without.
    pub unbinned: u32,
}

/// [`draw`](crate::draw()) through bins: the same picture, the same statistics. What waited in the bins is drawn
/// before, and is not counted.
///
/// # Errors
///
/// [`DrawError`], before anything is written: as [`draw`](crate::draw()), and
/// [`DrawError::OutsideAttachment`] also where scissor and viewport reach beyond the bins' region.
pub fn draw_binned<F, P, I, A>(
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
    draw_binned_with::<ArrayLanes, F, P, I, A>(
        (),
        bins,
        positions,
        indices,
        first_id,
        state,
        order,
        attachments,
    )
}

/// [`draw_binned`] with other lanes; the same pixels and statistics.
#[expect(clippy::too_many_arguments, reason = "those of draw_binned, and where lanes come from")]
pub(crate) fn draw_binned_with<L, F, P, I, A>(
    token: L::Token,
    bins: &mut Bins<'_, F>,
    positions: &P,
    indices: &[I],
    first_id: u32,
    state: &State<F>,
    order: TileOrder,
    attachments: &mut A,
) -> Result<BinnedDraw, DrawError>
where
    L: Lanes,
    F: Format,
    P: Positions<F> + ?Sized,
    I: Index,
    A: Attachment<F>,
{
    let mut triangles = draw::check_indices(indices, positions.count())?;
    let area = bins.check(positions, triangles.len(), first_id, state)?;
    draw::check_draw(positions, triangles.len(), first_id, state, attachments)?;
    let mut drawn = BinnedDraw::default();
    if !bins.is_empty() {
        bins.draw_with::<L, A>(token, bins.region(), order, attachments)?;
        bins.finish();
    }
    let mut id = first_id;
    while !triangles.is_empty() {
        let added = bins.add_checked(positions, triangles, id, state, area);
        drawn.statistics += added.statistics;
        let (taken, rest) = triangles.split_at_checked(added.taken).unwrap_or_default();
        id = id.saturating_add(taken.len() as u32);
        triangles = rest;
        if bins.is_empty() {
            // Culled to the last, or too large for the memory.
            if let Some((first, rest)) = triangles.split_first() {
                drawn.statistics +=
                    draw::draw_with::<L, F, P, I, A>(token, positions, first, id, state, attachments)?;
                drawn.unbinned += 1;
                id = id.saturating_add(1);
                triangles = rest;
            }
            continue;
        }
        // There is an area, as something is in the bins.
        let area = area.unwrap_or(bins.region());
        bins.draw_with::<L, A>(token, area, order, attachments)?;
        drawn.statistics += bins.finish();
        drawn.rounds += 1;
    }
    Ok(drawn)
}

impl<F: Format> Bins<'_, F> {
    /// Draws what waits for the pixels of `part`, in each tile in the order in which it was added. Parts that share no
    /// pixel can be drawn at the same time.
    ///
    /// # Errors
    ///
    /// [`OutsideAttachment`] where an attachment does not have the pixels of `part` that are in the bins' region,
    /// before anything is written.
    pub fn draw<A: Attachment<F>>(
        &self,
        part: Region<F>,
        order: TileOrder,
        attachments: &mut A,
    ) -> Result<(), OutsideAttachment> {
        self.draw_with::<ArrayLanes, A>((), part, order, attachments)
    }

    /// [`draw`](Self::draw) with other lanes; the same pixels.
    pub(crate) fn draw_with<L: Lanes, A: Attachment<F>>(
        &self,
        token: L::Token,
        part: Region<F>,
        order: TileOrder,
        attachments: &mut A,
    ) -> Result<(), OutsideAttachment> {
        let Some(part) = part.intersect(self.region) else { return Ok(()) };
        attachments.check(part)?;
        let (left, top) = (part.x0() / TILE, part.y0() / TILE);
        for (column, row) in order.tiles(columns(part), rows(part)) {
            L::vectorize(
                token,
                #[inline(always)]
                || self.draw_tile::<L, A>(token, [left + column, top + row], part, attachments),
            );
        }
        Ok(())
    }

    #[inline(always)]
    fn draw_tile<L: Lanes, A: Attachment<F>>(
        &self,
        token: L::Token,
        [column, row]: [u32; 2],
        part: Region<F>,
        attachments: &mut A,
    ) {
        let (x, y) = (TILE * column, TILE * row);
        let Some(tile) = part.cut(x, y, x + TILE, y + TILE) else { return };
        for entry in self.lists.entries(self.place(column, row)) {
            let Some(waiting) = self.triangles.get(entry as usize & (MAX_TRIANGLES - 1)) else { continue };
            let [x0, y0, x1, y1] = waiting.bounds;
            let Some(bounds) = tile.cut(x0, y0, x1, y1) else { continue };
            let Some(triangle) = Triangle::new(waiting.vertices, self.sample) else { continue };
            let mut begun = false;
            let drawn = blocks_of::<L, F>(
                token,
                &triangle,
                bounds,
                entry as usize >= MAX_TRIANGLES,
                #[inline(always)]
                |x, y, mask| {
                    if !begun {
                        begun = true;
                        attachments.begin(&triangle);
                    }
                    let block = Block { x, y, mask, triangle: &triangle, id: waiting.id };
                    attachments.block_with::<L>(token, &block);
                },
            );
            if drawn {
                waiting.drawn.store(true, Ordering::Relaxed);
            }
        }
    }

    /// Empties the bins, and counts what waited: triangles that have covered a sample of what was drawn, and others.
    pub fn finish(&mut self) -> Statistics {
        let mut statistics = Statistics::default();
        let waiting = self.triangles.get_mut(..self.count).unwrap_or_default();
        let mut drawn = false;
        let mut rest = waiting.iter_mut().peekable();
        while let Some(triangle) = rest.next() {
            drawn |= *triangle.drawn.get_mut();
            if !rest.peek().is_some_and(|next| next.continued) {
                let outcome = if drawn { Ok(()) } else { Err(triangle.otherwise) };
                statistics.count(Assembly::Whole, Some(outcome));
                drawn = false;
            }
        }
        self.lists.clear();
        self.count = 0;
        statistics
    }
}

/// Visits a triangle's blocks in `bounds`, which it covers as a whole, or maybe not. Whether there are any.
#[inline(always)]
fn blocks_of<L: Lanes, F: Format>(
    token: L::Token,
    triangle: &Triangle<F>,
    bounds: Region<F>,
    covers: bool,
    visit: impl FnMut(u32, u32, Mask),
) -> bool {
    if covers {
        fill(bounds, visit);
        return true;
    }
    // The bounds end at a scissor, maybe, in the midst of a block.
    walk::<L, F>(token, triangle, bounds, bounds, visit)
}
