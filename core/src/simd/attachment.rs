//! What attachments do with a row of blocks.

use super::setup::DepthSetup;
use crate::{
    attachments::{Attachment, Compare, Coverage, D16, D32, Depth, Ids},
    numbers::Standard,
};
use core::{iter::Zip, slice::IterMut};
use fearless_simd::{Simd, mask16x16, mask32x16, prelude::*, u16x16, u32x16};

/// An attachment, or a tuple of them, that the fast path can write: coverage, depth, ids, depth with
/// ids. Others are drawn by [`draw_any`](super::draw_any).
pub trait RowAttachment: Attachment<Standard> + Rows {}

impl<A: Attachment<Standard> + Rows> RowAttachment for A {}

/// What depth grows by from pixel to pixel, to the right and down: 32.32 fixed point modulo 2^64.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    pub(super) x: u64,
    pub(super) y: u64,
}

/// The operations; private, as their arguments have preconditions.
pub(super) mod rows {
    use super::{DepthSetup, Gradients, Simd, mask32x16};

    pub trait Rows {
        /// The depth that set-up has to prepare.
        const DEPTH: DepthSetup;
        /// Whether the picture depends on the order of the triangles.
        const ORDERED: bool;
        /// What a triangle's blocks have in common.
        type Lanes<S: Simd>: Copy;
        /// The blocks of a row, from left to right.
        type Row<'r>: Iterator
        where
            Self: 'r;
        /// The place of a block in the storage.
        type Cursor: Copy;

        /// Whether this attachment's state is one that rows are written for.
        fn fast(&self) -> bool;

        /// Prepares a triangle.
        fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, id: u32) -> Self::Lanes<S>;

        /// The place of the block at pixel (`x`, `y`).
        fn cursor(&self, x: u32, y: u32) -> Self::Cursor;

        /// The place below.
        fn next_row(&self, cursor: Self::Cursor) -> Self::Cursor;

        /// `blocks` blocks from a place on, as far as there are any.
        fn row(&mut self, cursor: Self::Cursor, from: u32, blocks: u32) -> Self::Row<'_>;

        /// Writes one block, given the samples inside the triangle and the depth at its first sample in
        /// units of 2^-32, rounded to the format's units; returns the samples that later attachments are
        /// to see.
        fn write<'r, S: Simd>(
            simd: S,
            lanes: &Self::Lanes<S>,
            block: <Self::Row<'r> as Iterator>::Item,
            inside: mask32x16<S>,
            depth: u32,
        ) -> mask32x16<S>
        where
            Self: 'r;
    }
}
use rows::Rows;

/// The rows of an attachment whose blocks, of type `$block`, are tiled storage.
macro_rules! tiled_rows {
    ($block:ty) => {
        type Row<'r>
            = IterMut<'r, $block>
        where
            Self: 'r;
        type Cursor = usize;

        #[inline(always)]
        fn cursor(&self, x: u32, y: u32) -> usize {
            self.tiled().place(x, y)
        }

        #[inline(always)]
        fn next_row(&self, cursor: usize) -> usize {
            self.tiled().below(cursor)
        }

        #[inline(always)]
        fn row(&mut self, cursor: usize, from: u32, blocks: u32) -> Self::Row<'_> {
            self.tiled_mut().row_mut(cursor, from, blocks).iter_mut()
        }
    };
}

/// The depths of a block's sixteen samples above its first one in units of 2^-32, rounded down after
/// adding `half` units of 2^-56.
///
/// Gradients per pixel are multiples of 2^-56: their low 24 bits times at most 3 + 3 pixels, and a half,
/// fit 32 bits, so nothing is lost.
#[inline(always)]
pub(super) fn offsets<S: Simd>(simd: S, gradients: Gradients, half: u32) -> u32x16<S> {
    let columns = u32x16::simd_from(simd, [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]);
    let rows = u32x16::simd_from(simd, [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]);
    let high = columns * u32x16::splat(simd, (gradients.x >> 32) as u32)
        + rows * u32x16::splat(simd, (gradients.y >> 32) as u32);
    let low = columns * u32x16::splat(simd, gradients.x as u32 >> 8)
        + rows * u32x16::splat(simd, gradients.y as u32 >> 8)
        + u32x16::splat(simd, half);
    high + (low >> 24)
}

impl Rows for Depth<'_, Standard, D32> {
    const DEPTH: DepthSetup = DepthSetup::D32;
    const ORDERED: bool = false;
    type Lanes<S: Simd> = u32x16<S>;
    tiled_rows!([u32; 16]);

    #[inline]
    fn fast(&self) -> bool {
        self.test().compare == Compare::Less && self.test().write
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, _id: u32) -> Self::Lanes<S> {
        offsets(simd, gradients, 1 << 23)
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        block: &'r mut [u32; 16],
        inside: mask32x16<S>,
        depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let depths = *lanes + u32x16::splat(simd, depth);
        // Outside, the largest value, which wins nowhere. (A select here would become a masked store, which
        // is slow.)
        let stored = u32x16::simd_from(simd, *block);
        if <S::u32s as SimdBase<S>>::LEN >= 16 {
            let depths = inside.select(depths, u32x16::splat(simd, u32::MAX));
            stored.min(depths).store_slice(block);
            return depths.simd_lt(stored);
        }
        let never = inside.select(u32x16::splat(simd, 0), u32x16::splat(simd, u32::MAX));
        let depths = depths.max(never);
        stored.min(depths).store_slice(block);
        depths.simd_lt(stored)
    }
}

impl Rows for Depth<'_, Standard, D16> {
    const DEPTH: DepthSetup = DepthSetup::D16;
    const ORDERED: bool = false;
    type Lanes<S: Simd> = u16x16<S>;
    tiled_rows!([u16; 16]);

    #[inline]
    fn fast(&self) -> bool {
        self.test().compare == Compare::Less && self.test().write
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, _id: u32) -> Self::Lanes<S> {
        let offsets = (offsets(simd, gradients, 0) + u32x16::splat(simd, 1 << 15)) >> 16;
        let (low, high) = simd.split_u32x16(offsets);
        simd.narrow_u32x8(low, high)
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        block: &'r mut [u16; 16],
        inside: mask32x16<S>,
        depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let depths = *lanes + u16x16::splat(simd, (depth >> 16) as u16);
        let stored = u16x16::simd_from(simd, *block);
        if <S::u32s as SimdBase<S>>::LEN >= 16 {
            let depths = mask16(simd, inside).select(depths, u16x16::splat(simd, u16::MAX));
            stored.min(depths).store_slice(block);
            return mask32(simd, depths.simd_lt(stored));
        }
        let never = mask16(simd, inside).select(u16x16::splat(simd, 0), u16x16::splat(simd, u16::MAX));
        let depths = depths.max(never);
        stored.min(depths).store_slice(block);
        mask32(simd, depths.simd_lt(stored))
    }
}

/// The same lanes, half as wide.
#[inline(always)]
fn mask16<S: Simd>(simd: S, mask: mask32x16<S>) -> mask16x16<S> {
    let (low, high) = simd.split_mask32x16(mask);
    simd.narrow_mask32x8(low, high)
}

/// The same lanes, twice as wide.
#[inline(always)]
fn mask32<S: Simd>(simd: S, mask: mask16x16<S>) -> mask32x16<S> {
    let (low, high) = simd.widen_mask16x16(mask);
    simd.combine_mask32x8(low, high)
}

impl Rows for Ids<'_, Standard> {
    const DEPTH: DepthSetup = DepthSetup::None;
    const ORDERED: bool = true;
    type Lanes<S: Simd> = u32x16<S>;
    tiled_rows!([u32; 16]);

    #[inline]
    fn fast(&self) -> bool {
        true
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, _gradients: Gradients, id: u32) -> Self::Lanes<S> {
        u32x16::splat(simd, id)
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        block: &'r mut [u32; 16],
        inside: mask32x16<S>,
        _depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let stored = u32x16::simd_from(simd, *block);
        inside.select(*lanes, stored).store_slice(block);
        inside
    }
}

impl Rows for Coverage<'_, Standard> {
    const DEPTH: DepthSetup = DepthSetup::None;
    const ORDERED: bool = false;
    type Lanes<S: Simd> = ();
    tiled_rows!(u16);

    #[inline]
    fn fast(&self) -> bool {
        true
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, _simd: S, _gradients: Gradients, _id: u32) {}

    #[inline(always)]
    fn write<'r, S: Simd>(
        _simd: S,
        (): &(),
        block: &'r mut u16,
        inside: mask32x16<S>,
        _depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        *block |= inside.to_bitmask() as u16;
        inside
    }
}

impl<A: Rows, B: Rows> Rows for (A, B) {
    const DEPTH: DepthSetup = match (A::DEPTH, B::DEPTH) {
        (DepthSetup::None, depth) | (depth, DepthSetup::None) => depth,
        _ => panic!("two depth attachments in one draw"),
    };
    const ORDERED: bool = A::ORDERED || B::ORDERED;
    type Lanes<S: Simd> = (A::Lanes<S>, B::Lanes<S>);
    type Row<'r>
        = Zip<A::Row<'r>, B::Row<'r>>
    where
        Self: 'r;
    type Cursor = (A::Cursor, B::Cursor);

    #[inline]
    fn fast(&self) -> bool {
        self.0.fast() && self.1.fast()
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, id: u32) -> Self::Lanes<S> {
        (self.0.prepare(simd, gradients, id), self.1.prepare(simd, gradients, id))
    }

    #[inline(always)]
    fn cursor(&self, x: u32, y: u32) -> Self::Cursor {
        (self.0.cursor(x, y), self.1.cursor(x, y))
    }

    #[inline(always)]
    fn next_row(&self, (a, b): Self::Cursor) -> Self::Cursor {
        (self.0.next_row(a), self.1.next_row(b))
    }

    #[inline(always)]
    fn row(&mut self, (a, b): Self::Cursor, from: u32, blocks: u32) -> Self::Row<'_> {
        self.0.row(a, from, blocks).zip(self.1.row(b, from, blocks))
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        (a, b): <Self::Row<'r> as Iterator>::Item,
        inside: mask32x16<S>,
        depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let inside = A::write(simd, &lanes.0, a, inside, depth);
        B::write(simd, &lanes.1, b, inside, depth)
    }
}

impl<A: Rows> Rows for &mut A {
    const DEPTH: DepthSetup = A::DEPTH;
    const ORDERED: bool = A::ORDERED;
    type Lanes<S: Simd> = A::Lanes<S>;
    type Row<'r>
        = A::Row<'r>
    where
        Self: 'r;
    type Cursor = A::Cursor;

    #[inline]
    fn fast(&self) -> bool {
        (**self).fast()
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, id: u32) -> Self::Lanes<S> {
        (**self).prepare(simd, gradients, id)
    }

    #[inline(always)]
    fn cursor(&self, x: u32, y: u32) -> Self::Cursor {
        (**self).cursor(x, y)
    }

    #[inline(always)]
    fn next_row(&self, cursor: Self::Cursor) -> Self::Cursor {
        (**self).next_row(cursor)
    }

    #[inline(always)]
    fn row(&mut self, cursor: Self::Cursor, from: u32, blocks: u32) -> Self::Row<'_> {
        (**self).row(cursor, from, blocks)
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        block: <Self::Row<'r> as Iterator>::Item,
        inside: mask32x16<S>,
        depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        A::write(simd, lanes, block, inside, depth)
    }
}
