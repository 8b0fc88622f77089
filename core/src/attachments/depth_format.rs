//! The stored formats of depth.

use crate::{
    lanes::Lanes,
    numbers::{DEPTH16_MAX, DEPTH16_MIN, Format, Word, unorm16},
};
use core::fmt::Debug;

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::D16 {}
    impl Sealed for super::D32 {}
}

/// A stored depth format: [`D32`] or [`D16`].
pub trait DepthFormat<F: Format>: sealed::Sealed + Copy + Debug + Default + 'static {
    /// What one pixel stores.
    type Texel: Copy + Debug + Eq + Ord + Into<u32> + 'static;
    /// Bits of a texel.
    const BITS: u32;
    /// The largest value, the clear value of `Less`; no covered sample has it.
    const FAR: Self::Texel;
    /// The smallest value, the clear value of `Greater`; no covered sample has it.
    const NEAR: Self::Texel;

    /// A vertex's depth in units of 2^-H ([`Word::HALF_BITS`]) from its unorm32.
    fn vertex(depth: u32) -> u32;

    /// A block's texels.
    fn load<L: Lanes>(token: L::Token, texels: &[Self::Texel; 16]) -> L;

    /// Writes a block's texels.
    fn store<L: Lanes>(lanes: L, texels: &mut [Self::Texel; 16]);
}

/// 32-bit depth, unorm32. Only for formats whose planes have 32 integer bits, such as
/// [`Standard`](crate::Standard).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct D32;

impl<F: Format<Word = u64>> DepthFormat<F> for D32 {
    type Texel = u32;
    const BITS: u32 = 32;
    const FAR: u32 = u32::MAX;
    const NEAR: u32 = 0;

    #[inline]
    fn vertex(depth: u32) -> u32 {
        depth
    }

    #[inline(always)]
    fn load<L: Lanes>(token: L::Token, texels: &[u32; 16]) -> L {
        L::load(token, texels)
    }

    #[inline(always)]
    fn store<L: Lanes>(lanes: L, texels: &mut [u32; 16]) {
        lanes.store(texels);
    }
}

/// 16-bit depth: vertices are rounded to unorm16, kept in `[2, 2^16 - 3]`, and interpolated from
/// there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct D16;

impl<F: Format> DepthFormat<F> for D16 {
    type Texel = u16;
    const BITS: u32 = 16;
    const FAR: u16 = u16::MAX;
    const NEAR: u16 = 0;

    #[inline]
    fn vertex(depth: u32) -> u32 {
        unorm16(depth).clamp(DEPTH16_MIN, DEPTH16_MAX) << (F::Word::HALF_BITS - 16)
    }

    #[inline(always)]
    fn load<L: Lanes>(token: L::Token, texels: &[u16; 16]) -> L {
        let mut values = [0; 16];
        for (value, texel) in values.iter_mut().zip(texels) {
            *value = u32::from(*texel);
        }
        L::load(token, &values)
    }

    #[inline(always)]
    fn store<L: Lanes>(lanes: L, texels: &mut [u16; 16]) {
        let mut values = [0; 16];
        lanes.store(&mut values);
        for (texel, value) in texels.iter_mut().zip(&values) {
            *texel = *value as u16;
        }
    }
}
