//! Lane operations.

use super::{
    super::ops::{
        bits, ceil, first_lanes, greatest, has_lane, i32_to_f64, lanes_of, least, merge, of_lane,
        power_of_two, sign_extend, splat, u32_to_f64, without_lane,
    },
    Floats, Ints, LANES, Words, doubles, ints, longs, simd, words,
};
use crate::proof::{assume, cover, prove};
use fearless_simd::prelude::*;

prove! {
    /// The least whole number that is not below: for every float from -2^30 to 2^30.
    [ceil]
    fn ceil_is_the_least_not_below(bits: u32) {
        let value = f32::from_bits(bits);
        let in_range = value.abs() <= (1 << 30) as f32;
        assume!(in_range);
        let whole = ints(ceil(simd(), Floats::splat(simd(), value)))[LANES[0]];
        assert!(f64::from(whole) >= f64::from(value));
        assert!(f64::from(whole) - 1.0 < f64::from(value));
        cover!(f64::from(whole) > f64::from(value) && whole < 0);
    }

    /// 2^n.
    [power_of_two, splat]
    fn powers_of_two_are_shifts(n: i32 = 0..=30) {
        assert!(ints(power_of_two(simd(), splat(simd(), n)))[LANES[0]] == 1 << n);
    }

    /// The first lanes are as many as there are, sixteen at most, and a mask without a lane has all others.
    [first_lanes, has_lane, without_lane, of_lane]
    fn first_lanes_are_counted(count: usize, mask: u32, lane: usize = 0..=31, numbers: [u32; 16]) {
        assert!(first_lanes(count).count_ones() as usize == count.min(16));
        assert!(has_lane(first_lanes(count), lane) == (lane < count.min(16)));
        assert!(!has_lane(without_lane(mask, lane), lane));
        assert!(without_lane(mask, lane) | 1 << lane == mask | 1 << lane);
        assert!(of_lane(&numbers, lane) == numbers[lane % 16]);
        cover!(has_lane(mask, lane) && lane == 31);
    }

    /// The lanes of a mask come once each, from the lowest.
    #[kani::unwind(9)]
    [lanes_of]
    fn lanes_come_from_the_lowest(mask: u32 = 0..=0xFF, shift: u32 = 0..=24) {
        let mut seen = 0;
        for lane in lanes_of(mask << shift) {
            assert!(seen >> lane == 0);
            seen |= 1 << lane;
        }
        assert!(seen == mask << shift);
        cover!(mask == 0xFF && shift == 24);
    }

    /// Each bit is one of `yes` where the mask has it, one of `no` elsewhere.
    [merge]
    fn merge_takes_bits_from_both(mask: u32, yes: u32, no: u32, at: u32 = 0..=31) {
        let [mask_lanes, yes_lanes, no_lanes] = [mask, yes, no].map(|v| Words::splat(simd(), v));
        let merged = words(merge(mask_lanes, yes_lanes, no_lanes))[0];
        let expected = if mask >> at & 1 != 0 { yes } else { no };
        assert!(merged >> at & 1 == expected >> at & 1);
    }

    /// Unsigned integers are exact doubles.
    [u32_to_f64]
    fn unsigned_integers_are_exact(lanes: [u32; 16]) {
        let [low, high] = u32_to_f64(simd(), Words::simd_from(simd(), lanes)).map(doubles);
        let values = [low[1], low[6], high[7]];
        assert!(values == LANES.map(|at| f64::from(lanes[at])));
        cover!(values[1] == 4_294_967_295.0);
    }

    /// Signed integers of 25 bits are exact doubles.
    [i32_to_f64]
    fn signed_integers_are_exact(lanes: [i32; 16] = [-(1 << 24); 16]..=[1 << 24; 16]) {
        let [low, high] = i32_to_f64(simd(), Ints::simd_from(simd(), lanes)).map(doubles);
        let values = [low[1], low[6], high[7]];
        assert!(values == LANES.map(|at| f64::from(lanes[at])));
        cover!(values[1] == -16_777_216.0);
    }

    /// Two's complement of 64 bits.
    [sign_extend]
    fn signs_are_extended(lanes: [i32; 16]) {
        let [low, high] = sign_extend(simd(), Ints::simd_from(simd(), lanes)).map(longs);
        let words = [low[1], low[6], high[7]];
        assert!(words == LANES.map(|at| i64::from(lanes[at]) as u64));
        cover!(words[2] > 1 << 63);
    }

    /// The least and the greatest of three, and a bit for each lane of a comparison.
    [least, greatest, bits]
    fn extremes_are_extreme(a: [i32; 16], b: i32, c: i32) {
        let (x, y, z) = (Ints::simd_from(simd(), a), splat(simd(), b), splat(simd(), c));
        for at in LANES {
            assert!(ints(least(x, y, z))[at] == a[at].min(b.min(c)));
            assert!(ints(greatest(x, y, z))[at] == a[at].max(b.max(c)));
            assert!(bits(x.simd_lt(y)) >> at & 1 == u32::from(a[at] < b));
        }
        assert!(bits(x.simd_lt(y)) >> 16 == 0);
    }
}
