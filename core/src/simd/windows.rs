//! Coverage of small and medium triangles, sixteen at a time: row by row of their windows, a lane for
//! each triangle, and the rows' bits then sorted into the masks of 4x4 blocks.

use super::{
    extent::MEDIUM,
    ops::{bits, ceil, merge, power_of_two, splat},
    setup::{Batch, Crossings},
};
use fearless_simd::{Simd, f32x16, i32x16, prelude::*, u32x16};

const ROWS: usize = MEDIUM[1] as usize;
const PAIRS: usize = (MEDIUM[0] as usize).div_ceil(2);
// The masks of a row are made of powers of two up to this.
const _: () = assert!(MEDIUM[0] * 4 <= 30);

/// The masks of sixteen triangles' windows: for each row of blocks and each two columns, those of two
/// blocks, the left one in the low bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Windows(pub(super) [[[u32; 16]; PAIRS]; ROWS]);

impl Windows {
    pub(super) const EMPTY: Self = Self([[[0; 16]; PAIRS]; ROWS]);

    /// The masks of triangle `lane`: for each row of blocks, and in it for each two columns.
    #[inline(always)]
    pub(super) fn rows(&self, lane: usize) -> impl Iterator<Item = [u32; PAIRS]> {
        let lane = lane & 15;
        self.0.iter().map(
            #[inline(always)]
            move |[a, b, c, d]| [a[lane], b[lane], c[lane], d[lane]],
        )
    }

    /// The masks of the first two columns and rows.
    #[inline(always)]
    pub(super) fn small(&self, lane: usize) -> [u32; 2] {
        let lane = lane & 15;
        let [[first, ..], [second, ..], ..] = &self.0;
        [first[lane], second[lane]]
    }

    /// Fills in the masks of a batch's small and medium triangles, the first `present` of it; one bit for
    /// each that has a sample.
    #[inline(never)]
    pub(super) fn fill<S: Simd>(&mut self, simd: S, batch: &Batch, present: u32) -> u32 {
        simd.vectorize(
            #[inline(always)]
            || {
                let medium = batch.medium & present;
                if medium != 0 {
                    self.fill_rows(simd, batch, medium)
                } else if batch.small & present != 0 {
                    self.fill_rows(simd, batch, 0)
                } else {
                    0
                }
            },
        )
    }

    #[inline(always)]
    fn fill_rows<S: Simd>(&mut self, simd: S, batch: &Batch, medium: u32) -> u32 {
        let mut rows = Rows::new(simd, batch);
        let mut any = u32x16::splat(simd, 0);
        let [_, _, y0, y1] = batch.bounds;
        let (y0, y1) = (i32x16::simd_from(simd, y0), i32x16::simd_from(simd, y1));
        let height = y1 - (y0 & splat(simd, !3));
        for (row, out) in (0..).zip(&mut self.0) {
            if row >= 2 && (medium == 0 || bits(height.simd_gt(splat(simd, 4 * row))) & medium == 0) {
                break;
            }
            let row = [rows.next(simd), rows.next(simd), rows.next(simd), rows.next(simd)];
            let [m0, m1, m2, m3] = row;
            any |= (m0 | m1) | (m2 | m3);
            let [first, others @ ..] = out;
            if medium == 0 {
                narrow(simd, row).store_slice(first);
            } else {
                let [w0, w1, w2, w3] = wide(simd, row);
                let [second, third, fourth] = others;
                w0.store_slice(first);
                w1.store_slice(second);
                w2.store_slice(third);
                w3.store_slice(fourth);
            }
        }
        bits(any.simd_gt(u32x16::splat(simd, 0)))
    }
}

/// Rows of sixteen triangles.
pub(super) struct Rows<S: Simd> {
    values: [f32x16<S>; 3],
    steps: [f32x16<S>; 3],
    factors: [f32x16<S>; 3],
    bound: f32x16<S>,
    first: f32x16<S>,
    end: f32x16<S>,
}

impl<S: Simd> Rows<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, batch: &Batch) -> Self {
        let Crossings { edges: [left, right, third], third: bound, first, end } = &batch.crossings;
        Self {
            values: [load(simd, &left.value), load(simd, &right.value), load(simd, &third.value)],
            steps: [load(simd, &left.step), load(simd, &right.step), load(simd, &third.step)],
            factors: [load(simd, &left.factor), load(simd, &right.factor), load(simd, &third.factor)],
            bound: load(simd, bound),
            first: load(simd, first),
            end: load(simd, end),
        }
    }

    /// The next row of samples: a bit for each that is covered.
    #[inline(always)]
    pub(super) fn next(&mut self, simd: S) -> u32x16<S> {
        let ([left, right, third], [left_step, right_step, third_step]) = (self.values, self.steps);
        let [left_factor, right_factor, third_factor] = self.factors;
        let (bound, first, end) = (self.bound, self.first, self.end);
        let crossing = third * third_factor;
        let begin = (left * left_factor).max(crossing.min(bound)).max(first).min(end);
        let close = (right * right_factor).min(crossing.max(bound)).min(end).max(begin);
        self.values = [left + left_step, right + right_step, third + third_step];
        let (begin, close) = (ceil(simd, begin), ceil(simd, close));
        (power_of_two(simd, close) - power_of_two(simd, begin)).bitcast()
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, lanes: &[f32; 16]) -> f32x16<S> {
    f32x16::simd_from(simd, *lanes)
}

/// The first pair of masks where rows have at most 8 bits.
#[inline(always)]
pub(super) fn narrow<S: Simd>(simd: S, [m0, m1, m2, m3]: [u32x16<S>; 4]) -> u32x16<S> {
    let nibble = u32x16::splat(simd, 0xF);
    let left = merge(nibble, m0, m1 << 4) & u32x16::splat(simd, 0xFF)
        | (merge(nibble, m2, m3 << 4) & u32x16::splat(simd, 0xFF)) << 8;
    let right = merge(nibble, m0 >> 4, m1) | merge(nibble, m2 >> 4, m3) << 8;
    left | right << 16
}

/// All pairs of masks: nibble b of row j becomes nibble j of mask b.
#[inline(always)]
pub(super) fn wide<S: Simd>(simd: S, [m0, m1, m2, m3]: [u32x16<S>; 4]) -> [u32x16<S>; PAIRS] {
    // Byte p: nibbles 2 p of rows 0 and 1, of rows 2 and 3; nibbles 2 p + 1 of rows 0 and 1, of rows 2 and 3.
    let nibbles = u32x16::splat(simd, 0x0F0F_0F0F);
    let (a, b) = (merge(nibbles, m0, m1 << 4), merge(nibbles, m2, m3 << 4));
    let (c, d) = (merge(nibbles, m0 >> 4, m1), merge(nibbles, m2 >> 4, m3));
    // Of the four by four bytes, rows become columns.
    let bytes = u32x16::splat(simd, 0x00FF_00FF);
    let (ab_even, ab_odd) = (merge(bytes, a, b << 8), merge(bytes, a >> 8, b));
    let (cd_even, cd_odd) = (merge(bytes, c, d << 8), merge(bytes, c >> 8, d));
    let halves = u32x16::splat(simd, 0x0000_FFFF);
    [
        merge(halves, ab_even, cd_even << 16),
        merge(halves, ab_odd, cd_odd << 16),
        merge(halves, ab_even >> 16, cd_even),
        merge(halves, ab_odd >> 16, cd_odd),
    ]
}
