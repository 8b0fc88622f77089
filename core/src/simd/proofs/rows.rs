//! Shuffles of a triangle's rows.

use super::{
    super::rows::{clip_rows, columns, greatest_of_four, least_of_four, quarters, spread},
    Ints, ints, simd,
};
use crate::proof::{cover, prove};
use fearless_simd::prelude::*;

prove! {
    /// The first lane of each four has the least and the greatest of them.
    [least_of_four, greatest_of_four]
    fn fours_have_extremes(lanes: [i32; 16], four: usize = 0..=3) {
        let vector = Ints::simd_from(simd(), lanes);
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| lanes[4 * four + k]);
        assert!(ints(least_of_four(vector))[4 * four] == a.min(b).min(c.min(d)));
        assert!(ints(greatest_of_four(vector))[4 * four] == a.max(b).max(c.max(d)));
    }

    /// Lane 4 j + k of sixteen is number k of quarter j.
    [quarters]
    fn quarters_are_in_order(lanes: [i32; 16], at: usize = 0..=15) {
        assert!(quarters(&lanes)[at / 4][at % 4] == lanes[at]);
    }

    /// Lane 4 j + k, four times in row j of memory: for samples of one row of a block.
    [spread]
    fn lanes_are_spread(lanes: [i32; 16], at: usize = 0..=15, copy: usize = 0..=3) {
        let mut rows = [[0; 16]; 4];
        spread(simd(), Ints::simd_from(simd(), lanes), &mut rows);
        assert!(rows[at / 4][4 * (at % 4) + copy] == lanes[at]);
    }

    /// Columns from a block on: their order as signed integers is the unsigned one of what is above the
    /// first. Blocks of the largest target.
    [columns]
    fn columns_are_shifted(from: u32 = 0..=4096) {
        for (lane, column) in ints(columns(simd(), from)).into_iter().enumerate() {
            assert!(i64::from(column) == i64::from(4 * from) + lane as i64 % 4 - (1 << 31));
        }
    }

    /// Rows outside y0..y1 have no samples. Rows of the largest target, and sixteen more.
    [clip_rows]
    fn rows_outside_have_no_samples(
        count: i32,
        y: u32 = 0..=16384,
        y0: u32 = 0..=16384,
        y1: u32 = 0..=16384,
    ) {
        let clipped = ints(clip_rows(simd(), Ints::splat(simd(), count), y, y0, y1));
        for (row, clipped) in (y..).zip(clipped) {
            assert!(clipped == if y0 <= row && row < y1 { count } else { 0 });
        }
        cover!(clipped[0] == 0 && clipped[15] == 7);
    }
}
