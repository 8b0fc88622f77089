//! The parameters that tell one sub-pixel format from another.

use super::{wide::Wide, word::Word};
use core::{fmt::Debug, hash::Hash};

/// A sub-pixel format: three numbers, and the two integer types wide enough for them.
///
/// Everything else follows from these in [`Bounds`](super::Bounds), whose assertions are evaluated
/// at compile time for each format that a program uses; a format of your own that does not hold
/// them does not compile.
pub trait Format: Copy + Debug + Default + Eq + Ord + Hash + 'static {
    /// Fractional bits S of a window coordinate: one step is 2^-S px.
    const SUBPIXEL_BITS: u32;
    /// Vertices lie within ±2^`GUARD_BAND_BITS` steps of the target's origin, both ends included.
    const GUARD_BAND_BITS: u32;
    /// Largest width and height of a target, in pixels; a multiple of 64.
    const MAX_TARGET: u32;
    /// Signed integer for edge values and doubled areas.
    type Wide: Wide;
    /// Unsigned integer for depth planes, used modulo its range.
    type Word: Word;
}

/// 16.8 fixed point, Direct3D's window coordinates: targets up to 16384 x 16384 px, guard band
/// ±32768 px, 64-bit set-up, 32-bit inner loops, depth in 32.32 fixed point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Standard;

impl Format for Standard {
    const SUBPIXEL_BITS: u32 = 8;
    const GUARD_BAND_BITS: u32 = 23;
    const MAX_TARGET: u32 = 16384;
    type Wide = i64;
    type Word = u64;
}

/// 12.4 fixed point for microcontroller displays: targets up to 960 x 960 px, guard band ±1024 px,
/// depth in 16.16 fixed point; no 64-bit multiplication or division per triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Small;

impl Format for Small {
    const SUBPIXEL_BITS: u32 = 4;
    const GUARD_BAND_BITS: u32 = 14;
    const MAX_TARGET: u32 = 960;
    type Wide = i32;
    type Word = u32;
}
