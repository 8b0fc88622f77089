//! Lanes in vector registers: AVX-512, AVX2, SSE4.2, SSE2, NEON, wasm128.
//!
//! Every function is always inlined, so that it is compiled for the processor features of the
//! [`vectorize`](Lanes::vectorize) around it.

use super::Lanes;
use fearless_simd::{Simd, i32x16, mask32x16, prelude::*, u32x4, u32x16};

/// [`Lanes`] as sixteen lanes of the vector level `S`, in as many registers as they need.
#[derive(Clone, Copy, Debug)]
pub struct VectorLanes<S: Simd>(u32x16<S>);

impl<S: Simd> Lanes for VectorLanes<S> {
    type Token = S;
    type Mask = mask32x16<S>;

    #[inline(always)]
    fn vectorize<R>(token: S, f: impl FnOnce() -> R) -> R {
        token.vectorize(f)
    }

    #[inline(always)]
    fn splat(token: S, value: u32) -> Self {
        Self(u32x16::splat(token, value))
    }

    #[inline(always)]
    fn ramp(token: S, origin: i32, a: i32, b: i32) -> Self {
        let (second, twice) = (origin.wrapping_add(a), a.wrapping_add(a));
        let [v0, v1, v2, v3] = [origin, second, origin.wrapping_add(twice), second.wrapping_add(twice)];
        let row0 = u32x4::simd_from(token, [v0 as u32, v1 as u32, v2 as u32, v3 as u32]);
        let down = u32x4::splat(token, b as u32);
        let row1 = row0 + down;
        let row2 = row1 + down;
        let row3 = row2 + down;
        let (upper, lower) = (token.combine_u32x4(row0, row1), token.combine_u32x4(row2, row3));
        Self(token.combine_u32x8(upper, lower))
    }

    #[inline(always)]
    fn load(token: S, values: &[u32; 16]) -> Self {
        Self(u32x16::simd_from(token, *values))
    }

    #[inline(always)]
    fn store(self, values: &mut [u32; 16]) {
        self.0.store_array(values);
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    #[inline(always)]
    fn signs(self) -> u16 {
        let signed: i32x16<S> = self.0.bitcast();
        signed.simd_lt(i32x16::splat(self.0.simd, 0)).to_bitmask() as u16
    }

    #[inline(always)]
    fn less(self, other: Self) -> mask32x16<S> {
        self.0.simd_lt(other.0)
    }

    #[inline(always)]
    fn select(self, other: Self, mask: mask32x16<S>) -> Self {
        Self(mask.select(self.0, other.0))
    }

    #[inline(always)]
    fn mask(token: S, bits: u16) -> mask32x16<S> {
        mask32x16::from_bitmask(token, u64::from(bits))
    }

    #[inline(always)]
    fn bits(mask: mask32x16<S>) -> u16 {
        mask.to_bitmask() as u16
    }

    #[inline(always)]
    fn both(mask: mask32x16<S>, other: mask32x16<S>) -> mask32x16<S> {
        mask & other
    }

    #[inline(always)]
    fn not(mask: mask32x16<S>) -> mask32x16<S> {
        !mask
    }
}
