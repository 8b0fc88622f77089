//! Drawing from block masks: small and medium triangles.

use super::{
    attachment::{Gradients, RowAttachment},
    setup::Batch,
    windows::Windows,
};
use fearless_simd::{Simd, mask32x16, prelude::*};

/// One triangle's depth plane and place.
#[derive(Clone, Copy)]
pub(super) struct Placed {
    /// The first pixel of the first block.
    pub(super) x: u32,
    pub(super) y: u32,
    /// Columns and rows of blocks.
    pub(super) columns: u32,
    pub(super) rows: u32,
    /// Depth at the first sample, 32.32 fixed point modulo 2^64, and what pixels add to it.
    pub(super) origin: u64,
    pub(super) gradients: Gradients,
}

impl Placed {
    /// Triangle `lane` of a batch.
    #[inline(always)]
    pub(super) fn from_batch(batch: &Batch, lane: usize) -> Self {
        let lane = lane & 15;
        let [x0, x1, y0, y1] = &batch.bounds;
        let [gradient_x, gradient_y] = &batch.gradients;
        let (x, y) = (x0[lane] as u32 & !3, y0[lane] as u32 & !3);
        Self {
            x,
            y,
            columns: (x1[lane] as u32).wrapping_sub(x).wrapping_add(3) >> 2,
            rows: (y1[lane] as u32).wrapping_sub(y).wrapping_add(3) >> 2,
            origin: batch.origin[lane],
            gradients: Gradients { x: gradient_x[lane], y: gradient_y[lane] },
        }
    }

    /// What four pixels add, to the right and down.
    #[inline(always)]
    pub(super) fn block_steps(&self) -> [u64; 2] {
        [self.gradients.x << 2, self.gradients.y << 2]
    }
}

/// Draws the triangle `lane` of a batch, whose window is two blocks each way.
#[inline(always)]
pub(super) fn draw_small<S: Simd, A: RowAttachment>(
    simd: S,
    batch: &Batch,
    windows: &Windows,
    lane: usize,
    id: u32,
    attachments: &mut A,
) {
    let placed = Placed::from_batch(batch, lane);
    let lanes = attachments.prepare(simd, placed.gradients, id);
    let [right, down] = placed.block_steps();
    let mut cursor = attachments.cursor(placed.x, placed.y);
    let mut depth = placed.origin;
    for masks in windows.small(lane) {
        let mut row = attachments.row(cursor, 0, 2);
        if let Some(block) = row.next() {
            A::write(simd, &lanes, block, inside(simd, masks), upper(depth));
        }
        if let Some(block) = row.next() {
            A::write(simd, &lanes, block, inside(simd, masks >> 16), upper(depth.wrapping_add(right)));
        }
        drop(row);
        depth = depth.wrapping_add(down);
        cursor = attachments.next_row(cursor);
    }
}

/// Draws the triangle `lane` of a batch, whose window is a medium one.
#[inline(always)]
pub(super) fn draw_medium<S: Simd, A: RowAttachment>(
    simd: S,
    batch: &Batch,
    windows: &Windows,
    lane: usize,
    id: u32,
    attachments: &mut A,
) {
    let placed = Placed::from_batch(batch, lane);
    let lanes = attachments.prepare(simd, placed.gradients, id);
    let [right, down] = placed.block_steps();
    let mut cursor = attachments.cursor(placed.x, placed.y);
    let mut row_depth = placed.origin;
    for masks in windows.rows(lane).take(placed.rows as usize) {
        let mut depth = row_depth;
        let mut row = attachments.row(cursor, 0, placed.columns);
        for pair in masks {
            let Some(block) = row.next() else { break };
            A::write(simd, &lanes, block, inside(simd, pair), upper(depth));
            depth = depth.wrapping_add(right);
            let Some(block) = row.next() else { break };
            A::write(simd, &lanes, block, inside(simd, pair >> 16), upper(depth));
            depth = depth.wrapping_add(right);
        }
        drop(row);
        row_depth = row_depth.wrapping_add(down);
        cursor = attachments.next_row(cursor);
    }
}

/// The lanes of a mask's low sixteen bits.
#[inline(always)]
pub(super) fn inside<S: Simd>(simd: S, bits: u32) -> mask32x16<S> {
    mask32x16::from_bitmask(simd, u64::from(bits & 0xFFFF))
}

/// The upper half.
#[inline(always)]
pub(super) const fn upper(word: u64) -> u32 {
    (word >> 32) as u32
}
