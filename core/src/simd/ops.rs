//! Small lane operations. All are functions that are always inlined: a closure would not inherit the
//! vector features of the code around it.

use fearless_simd::{Simd, f32x8, f64x4, f64x8, i32x8, prelude::*, u32x8, u64x4};

/// The same value in eight lanes.
#[inline(always)]
pub(super) fn splat<S: Simd>(simd: S, value: i32) -> i32x8<S> {
    i32x8::splat(simd, value)
}

/// Integers below 2^24 in magnitude as doubles, exactly.
#[inline(always)]
pub(super) fn i32_to_f64<S: Simd>(simd: S, value: i32x8<S>) -> f64x8<S> {
    let (low, high) = simd.widen_f32x8(f32x8::float_from(value));
    simd.combine_f64x4(low, high)
}

/// Unsigned integers as doubles, exactly: as the low bits of 2^52 + value.
#[inline(always)]
pub(super) fn u32_to_f64<S: Simd>(simd: S, value: u32x8<S>) -> f64x8<S> {
    let (low, high) = simd.widen_u32x8(value);
    let magic = 4_503_599_627_370_496.0_f64;
    let bits = u64x4::splat(simd, magic.to_bits());
    let low: f64x4<S> = (low | bits).bitcast();
    let high: f64x4<S> = (high | bits).bitcast();
    simd.combine_f64x4(low, high) - f64x8::splat(simd, magic)
}
