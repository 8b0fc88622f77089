//! Small lane operations. All are functions that are always inlined: a closure would not inherit the
//! vector features of the code around it.

use fearless_simd::{Simd, f32x16, f64x8, i32x16, mask32x16, prelude::*, u32x16, u64x8};

/// The same integer in sixteen lanes.
#[inline(always)]
pub(super) fn splat<S: Simd>(simd: S, value: i32) -> i32x16<S> {
    i32x16::splat(simd, value)
}

/// The least of three.
#[inline(always)]
pub(super) fn least<S: Simd>(a: i32x16<S>, b: i32x16<S>, c: i32x16<S>) -> i32x16<S> {
    a.min(b).min(c)
}

/// The greatest of three.
#[inline(always)]
pub(super) fn greatest<S: Simd>(a: i32x16<S>, b: i32x16<S>, c: i32x16<S>) -> i32x16<S> {
    a.max(b).max(c)
}

/// The bits of `yes` where `mask` has ones, of `no` elsewhere.
#[inline(always)]
pub(super) fn merge<S: Simd>(mask: u32x16<S>, yes: u32x16<S>, no: u32x16<S>) -> u32x16<S> {
    (yes & mask) | (no & !mask)
}

/// One bit for each lane of a mask.
#[inline(always)]
pub(super) fn bits<S: Simd>(mask: mask32x16<S>) -> u32 {
    mask.to_bitmask() as u32
}

/// A bit for each of the first lanes, sixteen at most.
#[inline(always)]
pub(super) const fn first_lanes(count: usize) -> u32 {
    let count = if count < 16 { count } else { 16 };
    0xFFFF >> (16 - count)
}

/// Whether a lane's bit is set, of the first 32.
#[inline(always)]
pub(super) const fn has_lane(mask: u32, lane: usize) -> bool {
    mask >> (lane & 31) & 1 != 0
}

/// A mask without a lane, of the first 32.
#[inline(always)]
pub(super) const fn without_lane(mask: u32, lane: usize) -> u32 {
    mask & !(1 << (lane & 31))
}

/// The lanes whose bits are set, from the lowest.
#[inline(always)]
pub(super) fn lanes_of(mut mask: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(
        #[inline(always)]
        move || {
            let lane = mask.trailing_zeros();
            if mask == 0 {
                return None;
            }
            mask &= mask - 1;
            Some(lane as usize)
        },
    )
}

/// One of sixteen.
#[inline(always)]
pub(super) const fn of_lane(numbers: &[u32; 16], lane: usize) -> u32 {
    numbers[lane & 15]
}

/// The least integers not below floats from -2^30 to 2^30.
#[inline(always)]
pub(super) fn ceil<S: Simd>(simd: S, value: f32x16<S>) -> i32x16<S> {
    if <S::u32s as SimdBase<S>>::LEN >= 8 {
        return i32x16::truncate_from(value.ceil());
    }
    // SSE2 has no rounding.
    let whole = i32x16::truncate_from(value);
    f32x16::float_from(whole).simd_lt(value).select(whole + splat(simd, 1), whole)
}

/// 2^n for n from 0 to 30; anything for other n.
#[inline(always)]
pub(super) fn power_of_two<S: Simd>(simd: S, n: i32x16<S>) -> i32x16<S> {
    if <S::u32s as SimdBase<S>>::LEN >= 8 {
        return simd.shlv_u32x16(u32x16::splat(simd, 1), n.bitcast()).bitcast();
    }
    // Narrower registers have no shift by lane: a float with that exponent.
    i32x16::truncate_from(((n + splat(simd, 127)) << 23).bitcast::<f32x16<S>>())
}

/// Sixteen doubles.
pub(super) type Doubles<S> = [f64x8<S>; 2];

/// Integers below 2^24 in magnitude as doubles, exactly.
#[inline(always)]
pub(super) fn i32_to_f64<S: Simd>(simd: S, value: i32x16<S>) -> Doubles<S> {
    simd.widen_f32x16(f32x16::float_from(value)).into()
}

/// Unsigned integers as doubles, exactly: as the low bits of 2^52 + value.
#[inline(always)]
pub(super) fn u32_to_f64<S: Simd>(simd: S, value: u32x16<S>) -> Doubles<S> {
    let (low, high) = simd.widen_u32x16(value);
    let magic = 4_503_599_627_370_496.0_f64;
    let bits = u64x8::splat(simd, magic.to_bits());
    let (low, high): (f64x8<S>, f64x8<S>) = ((low | bits).bitcast(), (high | bits).bitcast());
    let magic = f64x8::splat(simd, magic);
    [low - magic, high - magic]
}

/// Signed integers as 64 bits, in two's complement.
#[inline(always)]
pub(super) fn sign_extend<S: Simd>(simd: S, value: i32x16<S>) -> [u64x8<S>; 2] {
    let (low, high) = simd.widen_i32x16(value);
    [low.bitcast(), high.bitcast()]
}
