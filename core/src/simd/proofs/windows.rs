//! Rows of bits, and the masks of blocks made of them.

use super::{
    super::{
        setup::{Batch, Crossing},
        windows::{Rows, Windows, narrow, wide},
    },
    LANES, Words, simd, words,
};
use crate::proof::{assume, cover, prove};
use fearless_simd::prelude::*;

/// Sixteen triangles with one edge A x + F >= 0, a left one or a right one, whose rows end at a column.
#[inline(always)]
fn one_edge(value: i32, a: i32, end: f32) -> Batch {
    let crossing = Crossing { value: value as f32 + 0.5, step: 0.0, factor: -1.0 / a as f32 };
    let far = |factor| Crossing { value: 1_000_000.0, step: 0.0, factor };
    let mut batch = Batch::EMPTY;
    let edges = if a > 0 { [crossing, far(1.0), far(1.0)] } else { [far(-1.0), crossing, far(1.0)] };
    for (to, from) in batch.crossings.edges.iter_mut().zip(edges) {
        *to = Crossing { value: [from.value; 16], step: [from.step; 16], factor: [from.factor; 16] };
    }
    batch.crossings.third = [f32::NEG_INFINITY; 16];
    batch.crossings.end = [end; 16];
    batch
}

/// The first row of such a triangle.
#[inline(always)]
fn first_row(value: i32, a: i32) -> u32 {
    words(Rows::new(simd(), &one_edge(value, a, 30.0)).next(simd()))[5]
}

#[inline(always)]
fn row_is_exact(value: i32, a: i32, x: u32) {
    let row = first_row(value, a);
    let inside = i64::from(value) + i64::from(a) * i64::from(x) >= 0;
    assert!(row >> x & 1 == u32::from(inside));
    cover!(inside && x == 29);
    cover!(!inside && x == 29);
}

/// Whether pairs of masks have the bits of four rows, in the first columns.
#[inline(always)]
fn are_of_rows<const COLUMNS: usize>(pairs: &[u32], rows: [u32; 4]) -> bool {
    let mut same = true;
    for column in 0..COLUMNS {
        let mask = pairs[column / 8] >> (column / 4 % 2 * 16) & 0xFFFF;
        for (row, bits) in rows.into_iter().enumerate() {
            same &= mask >> (4 * row + column % 4) & 1 == bits >> column & 1;
        }
    }
    same
}

/// Sixteen triangles of five rows whose right edge leaves the same pixels in each: their masks, and whether they have a
/// sample.
#[inline(always)]
fn windows_are_those_of_the_edge(value: i32, small: u32, medium: u32) {
    let mut batch = one_edge(value, -7, 8.0);
    batch.bounds = [[0; 16], [8; 16], [0; 16], [8; 16]];
    (batch.small, batch.medium) = (small, medium);
    let mut windows = Windows::EMPTY;
    let sampled = windows.fill(simd(), &batch, 0xFFFF);
    assert!(sampled >> 6 & 1 == u32::from(value >= 0));
    let mut rows = windows.rows(6);
    let (Some([first, ..]), Some([second, ..])) = (rows.next(), rows.next()) else {
        unreachable!("there are sixteen")
    };
    assert!(first == second);
    for x in 0..8 {
        let inside = value - 7 * x >= 0;
        let column = first >> (16 * (x / 4) + x % 4) & 0x1111;
        assert!(column == if inside { 0x1111 } else { 0 });
    }
    cover!(first == 0x1111_FFFF);
}

prove! {
    /// The windows of small triangles have the samples of their edges, and there is a bit for those with one.
    #[kani::unwind(17)]
    [Windows::fill, Windows::fill_rows]
    fn slow_small_windows_have_their_samples(value: i32 = 28..=43) {
        windows_are_those_of_the_edge(value, 0xFFFF, 0);
    }

    /// The same of medium ones.
    #[kani::unwind(17)]
    [Windows::fill, Windows::fill_rows]
    fn slow_medium_windows_have_their_samples(value: i32 = -64..=63) {
        windows_are_those_of_the_edge(value, 0, 0xFFFF);
    }

    /// Four rows of up to 30 bits, sorted into the masks of 4x4 blocks.
    #[kani::unwind(31)]
    [wide, merge]
    fn wide_rows_become_masks(rows: [u32; 4] = [0; 4]..=[(1 << 30) - 1; 4]) {
        let masks = wide(simd(), rows.map(|bits| Words::splat(simd(), bits))).map(|lanes| words(lanes)[5]);
        assert!(are_of_rows::<30>(&masks, rows));
    }

    /// Four rows of up to 8 bits.
    #[kani::unwind(17)]
    [narrow, merge]
    fn narrow_rows_become_masks(rows: [u32; 4] = [0; 4]..=[255; 4]) {
        let masks = words(narrow(simd(), rows.map(|bits| Words::splat(simd(), bits))))[5];
        assert!(are_of_rows::<8>(&[masks], rows));
    }

    /// Masks are found where they were put.
    #[kani::unwind(17)]
    [Windows::rows, Windows::small]
    fn masks_belong_to_lanes(first: u32, second: u32) {
        for lane in LANES {
            let mut windows = Windows::EMPTY;
            windows.0[0][0][lane] = first;
            windows.0[1][0][lane] = second;
            assert!(windows.small(lane) == [first, second]);
            let mut rows = windows.rows(lane);
            assert!(rows.next() == Some([first, 0, 0, 0]));
            assert!(rows.next() == Some([second, 0, 0, 0]));
        }
    }

    /// The crossing of a left edge falls on the right side of every pixel: A = 1.
    #[kani::unwind(17)]
    [Rows::new, Rows::next, ceil, power_of_two]
    fn left_crossings_of_slope_1_are_exact(value: i32 = -(1 << 20)..=1 << 20, x: u32 = 0..=29) {
        row_is_exact(value, 1, x);
    }

    /// A = 3.
    #[kani::unwind(17)]
    [Rows::new, Rows::next, ceil, power_of_two]
    fn left_crossings_of_slope_3_are_exact(value: i32 = -(1 << 20)..=1 << 20, x: u32 = 0..=29) {
        row_is_exact(value, 3, x);
    }

    /// The largest A, a right edge.
    #[kani::unwind(17)]
    [Rows::new, Rows::next, ceil, power_of_two]
    fn right_crossings_of_the_largest_slope_are_exact(value: i32 = -(1 << 20)..=1 << 20, x: u32 = 0..=29) {
        row_is_exact(value, -30719, x);
    }

    /// Small slopes.
    #[kani::unwind(17)]
    [Rows::new, Rows::next, ceil, power_of_two]
    fn crossings_of_small_slopes_are_exact(value: i32 = -512..=511, a: i32 = -15..=15, x: u32 = 0..=29) {
        assume!(a != 0);
        row_is_exact(value, a, x);
    }
}

/// What no prover finished: for tests alone.
#[cfg(test)]
mod tested {
    use super::*;

    prove! {
        /// The windows of a batch have its rows, as many as its tallest medium triangle has and two blocks of small
        /// ones, and there is a bit for each triangle with a sample: for an edge that leaves each row five
        /// pixels, and triangle k being k + 1 pixels high.
        []
        fn windows_have_the_rows(small: u16, medium: u16, present: u16) {
            let mut batch = one_edge(34, -7, 8.0);
            batch.bounds = [[0; 16], [8; 16], [0; 16], [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]];
            (batch.small, batch.medium) = (small.into(), medium.into());
            let (small, medium) = (small & present, medium & present);
            let mut windows = Windows::EMPTY;
            let sampled = windows.fill(simd(), &batch, present.into());
            assert!(sampled == if small | medium != 0 { 0xFFFF } else { 0 });
            for (row, blocks) in (0..5).zip(windows.rows(6)) {
                let filled = if row < 2 { small | medium != 0 } else { u32::from(medium) >> (4 * row) != 0 };
                assert!(blocks == if filled { [0x1111_FFFF, 0, 0, 0] } else { [0; 4] });
            }
            cover!(medium == 1 << 12);
        }
    }
}
