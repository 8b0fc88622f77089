//! What attachments do with a row of blocks.

use super::setup::DepthSetup;
use crate::{
    attachments::{Attachment, Compare, Coverage, D16, D32, Depth, Ids},
    numbers::Standard,
};
use core::{iter::Zip, slice::IterMut};
use fearless_simd::{Simd, i16x16, i32x16, mask32x16, prelude::*, u16x16, u32x8, u32x16, u64x4};

/// An attachment, or a tuple of them, that the fast path can write: coverage, depth, ids, depth with
/// ids. Others are drawn by [`draw`](crate::draw()).
pub trait RowAttachment: Attachment<Standard> + Rows {}

impl<A: Attachment<Standard> + Rows> RowAttachment for A {}

/// Depth as 32.32 fixed point modulo 2^64.
#[derive(Clone, Copy, Debug)]
pub struct DepthPlane {
    /// At the sample that offsets count from.
    pub(super) origin: u64,
    /// What a pixel to the right adds.
    pub(super) x: u64,
    /// What a pixel down adds.
    pub(super) y: u64,
}

/// The operations; private, as their arguments have preconditions.
pub(super) mod rows {
    use super::{DepthPlane, DepthSetup, Simd, mask32x16};

    pub trait Rows {
        /// The depth that set-up has to prepare.
        const DEPTH: DepthSetup;
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
        fn prepare<S: Simd>(&self, simd: S, depth: &DepthPlane, id: u32) -> Self::Lanes<S>;

        /// Begins a row, where the depth plane's value is `depth` at the first sample.
        fn begin_row<S: Simd>(simd: S, lanes: &mut Self::Lanes<S>, depth: u64);

        /// The place of the block at pixel (`x`, `y`).
        fn cursor(&self, x: u32, y: u32) -> Self::Cursor;

        /// The place below.
        fn next_row(&self, cursor: Self::Cursor) -> Self::Cursor;

        /// `blocks` blocks from the one `from` blocks to the right of a place.
        fn row(&mut self, cursor: Self::Cursor, from: u32, blocks: u32) -> Self::Row<'_>;

        /// Writes one block, given the samples outside the triangle; returns those that later
        /// attachments are not to see.
        fn write<'r, S: Simd>(
            simd: S,
            lanes: &mut Self::Lanes<S>,
            block: <Self::Row<'r> as Iterator>::Item,
            outside: mask32x16<S>,
        ) -> mask32x16<S>
        where
            Self: 'r;
    }
}
use rows::Rows;

/// The depths of a block: a base that steps from block to block, the same in every lane, and offsets
/// from there.
#[derive(Clone, Copy)]
pub struct DepthLanes<S: Simd, O> {
    offsets: O,
    base: u64x4<S>,
    step: u64x4<S>,
}

impl<S: Simd, O> DepthLanes<S, O> {
    #[inline(always)]
    fn new(simd: S, offsets: O, plane: &DepthPlane) -> Self {
        let step = u64x4::splat(simd, plane.x.wrapping_mul(4));
        Self { offsets, base: u64x4::splat(simd, 0), step }
    }

    /// The upper half of the base in each of eight lanes; then the next block's base.
    #[inline(always)]
    fn next(&mut self, simd: S) -> u32x8<S> {
        let upper = self.base >> 32;
        let even = u32x8::simd_from(simd, [1, 0, 1, 0, 1, 0, 1, 0]).simd_eq(u32x8::splat(simd, 1));
        let base = even.select(upper.bitcast::<u32x8<S>>(), self.base.bitcast());
        self.base += self.step;
        base
    }
}

/// The offsets of a block's sixteen samples from its first, rounded to 32 bits.
#[inline(always)]
fn offsets<S: Simd>(simd: S, plane: &DepthPlane, half: u64) -> u32x16<S> {
    let once = u64x4::splat(simd, plane.x);
    let columns = (once & u64x4::simd_from(simd, [0, u64::MAX, 0, u64::MAX]))
        + ((once + once) & u64x4::simd_from(simd, [0, 0, u64::MAX, u64::MAX]));
    let row0 = columns + u64x4::splat(simd, half);
    let row1 = row0 + u64x4::splat(simd, plane.y);
    let row2 = row1 + u64x4::splat(simd, plane.y);
    let row3 = row2 + u64x4::splat(simd, plane.y);
    // The upper halves.
    let (row0, row1): (u32x8<S>, u32x8<S>) = (row0.bitcast(), row1.bitcast());
    let (row2, row3): (u32x8<S>, u32x8<S>) = (row2.bitcast(), row3.bitcast());
    let (low, high) = (row0.unzip_high(row1), row2.unzip_high(row3));
    simd.combine_u32x8(low, high)
}

impl Rows for Depth<'_, Standard, D32> {
    const DEPTH: DepthSetup = DepthSetup::D32;
    type Lanes<S: Simd> = DepthLanes<S, u32x16<S>>;
    type Row<'r>
        = IterMut<'r, [u32; 16]>
    where
        Self: 'r;
    type Cursor = usize;

    #[inline]
    fn fast(&self) -> bool {
        self.test().compare == Compare::Less && self.test().write
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, depth: &DepthPlane, _id: u32) -> Self::Lanes<S> {
        DepthLanes::new(simd, offsets(simd, depth, 1 << 31), depth)
    }

    #[inline(always)]
    fn begin_row<S: Simd>(simd: S, lanes: &mut Self::Lanes<S>, depth: u64) {
        lanes.base = u64x4::splat(simd, depth.wrapping_add(1 << 31));
    }

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

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &mut Self::Lanes<S>,
        block: &'r mut [u32; 16],
        outside: mask32x16<S>,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let base = lanes.next(simd);
        let depths = lanes.offsets + simd.combine_u32x8(base, base);
        // Outside, the largest value, which wins nowhere.
        let never = outside.select(u32x16::splat(simd, u32::MAX), u32x16::splat(simd, 0));
        let stored = u32x16::simd_from(simd, *block);
        let nearest = stored.min(depths.max(never));
        nearest.store_slice(block);
        nearest.simd_eq(stored)
    }
}

impl Rows for Depth<'_, Standard, D16> {
    const DEPTH: DepthSetup = DepthSetup::D16;
    type Lanes<S: Simd> = DepthLanes<S, u16x16<S>>;
    type Row<'r>
        = IterMut<'r, [u16; 16]>
    where
        Self: 'r;
    type Cursor = usize;

    #[inline]
    fn fast(&self) -> bool {
        self.test().compare == Compare::Less && self.test().write
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, depth: &DepthPlane, _id: u32) -> Self::Lanes<S> {
        let mut wide = [0; 16];
        offsets(simd, depth, 1 << 47).store_slice(&mut wide);
        let offsets = u16x16::simd_from(simd, wide.map(upper_half));
        DepthLanes::new(simd, offsets, depth)
    }

    #[inline(always)]
    fn begin_row<S: Simd>(simd: S, lanes: &mut Self::Lanes<S>, depth: u64) {
        lanes.base = u64x4::splat(simd, depth.wrapping_add(1 << 47));
    }

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

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &mut Self::Lanes<S>,
        block: &'r mut [u16; 16],
        outside: mask32x16<S>,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let base = lanes.next(simd) >> 16;
        let base: u16x16<S> = (base | base << 16).bitcast();
        let depths = lanes.offsets + base;
        let never = outside.select(i32x16::splat(simd, -1), i32x16::splat(simd, 0));
        let (low, high) = simd.split_i32x16(never);
        let never: u16x16<S> = simd.saturating_narrow_i32x8(low, high).bitcast();
        let stored = u16x16::simd_from(simd, *block);
        let nearest = stored.min(depths.max(never));
        nearest.store_slice(block);
        let same: i16x16<S> = nearest.simd_eq(stored).select(i16x16::splat(simd, -1), i16x16::splat(simd, 0));
        let (low, high) = simd.widen_i16x16(same);
        simd.combine_i32x8(low, high).simd_lt(i32x16::splat(simd, 0))
    }
}

#[inline(always)]
fn upper_half(value: u32) -> u16 {
    (value >> 16) as u16
}

impl Rows for Ids<'_, Standard> {
    const DEPTH: DepthSetup = DepthSetup::None;
    type Lanes<S: Simd> = u32x16<S>;
    type Row<'r>
        = IterMut<'r, [u32; 16]>
    where
        Self: 'r;
    type Cursor = usize;

    #[inline]
    fn fast(&self) -> bool {
        true
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, _depth: &DepthPlane, id: u32) -> Self::Lanes<S> {
        u32x16::splat(simd, id)
    }

    #[inline(always)]
    fn begin_row<S: Simd>(_simd: S, _lanes: &mut Self::Lanes<S>, _depth: u64) {}

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

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &mut Self::Lanes<S>,
        block: &'r mut [u32; 16],
        outside: mask32x16<S>,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let stored = u32x16::simd_from(simd, *block);
        outside.select(stored, *lanes).store_slice(block);
        outside
    }
}

impl Rows for Coverage<'_, Standard> {
    const DEPTH: DepthSetup = DepthSetup::None;
    type Lanes<S: Simd> = ();
    type Row<'r>
        = IterMut<'r, u16>
    where
        Self: 'r;
    type Cursor = usize;

    #[inline]
    fn fast(&self) -> bool {
        true
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, _simd: S, _depth: &DepthPlane, _id: u32) {}

    #[inline(always)]
    fn begin_row<S: Simd>(_simd: S, (): &mut (), _depth: u64) {}

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

    #[inline(always)]
    fn write<'r, S: Simd>(_simd: S, (): &mut (), block: &'r mut u16, outside: mask32x16<S>) -> mask32x16<S>
    where
        Self: 'r,
    {
        *block |= !outside.to_bitmask() as u16;
        outside
    }
}

impl<A: Rows, B: Rows> Rows for (A, B) {
    const DEPTH: DepthSetup = match (A::DEPTH, B::DEPTH) {
        (DepthSetup::None, depth) | (depth, DepthSetup::None) => depth,
        _ => panic!("two depth attachments in one draw"),
    };
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
    fn prepare<S: Simd>(&self, simd: S, depth: &DepthPlane, id: u32) -> Self::Lanes<S> {
        (self.0.prepare(simd, depth, id), self.1.prepare(simd, depth, id))
    }

    #[inline(always)]
    fn begin_row<S: Simd>(simd: S, lanes: &mut Self::Lanes<S>, depth: u64) {
        A::begin_row(simd, &mut lanes.0, depth);
        B::begin_row(simd, &mut lanes.1, depth);
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
        lanes: &mut Self::Lanes<S>,
        (a, b): <Self::Row<'r> as Iterator>::Item,
        outside: mask32x16<S>,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        let outside = A::write(simd, &mut lanes.0, a, outside);
        B::write(simd, &mut lanes.1, b, outside)
    }
}

impl<A: Rows> Rows for &mut A {
    const DEPTH: DepthSetup = A::DEPTH;
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
    fn prepare<S: Simd>(&self, simd: S, depth: &DepthPlane, id: u32) -> Self::Lanes<S> {
        (**self).prepare(simd, depth, id)
    }

    #[inline(always)]
    fn begin_row<S: Simd>(simd: S, lanes: &mut Self::Lanes<S>, depth: u64) {
        A::begin_row(simd, lanes, depth);
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
        lanes: &mut Self::Lanes<S>,
        block: <Self::Row<'r> as Iterator>::Item,
        outside: mask32x16<S>,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        A::write(simd, lanes, block, outside)
    }
}
