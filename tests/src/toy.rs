//! Formats of the tests' own: the smallest that can be enumerated, and one between the ready ones.

use halfplane::Format;

/// 2 sub-pixel bits: targets up to 64 x 64 px, guard band ±128 px, sixteen sample positions. Small
/// enough that all triangles of a lattice are tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Toy;

impl Format for Toy {
    const SUBPIXEL_BITS: u32 = 2;
    const GUARD_BAND_BITS: u32 = 9;
    const MAX_TARGET: u32 = 64;
    type Wide = i32;
    type Word = u32;
}

/// 5 sub-pixel bits with the wide integers: parameters that neither ready format has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Middle;

impl Format for Middle {
    const SUBPIXEL_BITS: u32 = 5;
    const GUARD_BAND_BITS: u32 = 17;
    const MAX_TARGET: u32 = 2048;
    type Wide = i64;
    type Word = u64;
}
