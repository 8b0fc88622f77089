//! Signed integers wide enough for edge values.

use core::{
    fmt::Debug,
    hash::Hash,
    ops::{Add, Shr, Sub},
};

mod sealed {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for i64 {}
}

/// The integer type of edge values and doubled areas: `i32` or `i64`.
///
/// The arithmetic is the type's own, overflow-checked where the profile checks;
/// [`Bounds`](super::Bounds) says why it cannot overflow.
pub trait Wide:
    sealed::Sealed
    + Copy
    + Debug
    + Default
    + Eq
    + Hash
    + Ord
    + Add<Output = Self>
    + Sub<Output = Self>
    + Shr<u32, Output = Self>
    + From<i32>
    + Into<i64>
    + 'static
{
    /// The largest value.
    const MAX: i128;
    /// The product of two 32-bit factors whose product fits.
    fn product(a: i32, b: i32) -> Self;
    /// The low 32 bits: the value itself where it fits, as bounds of the caller show.
    fn low32(self) -> i32;
}

impl Wide for i32 {
    const MAX: i128 = i32::MAX as i128;

    #[inline]
    fn product(a: i32, b: i32) -> Self {
        a * b
    }

    #[inline]
    fn low32(self) -> i32 {
        self
    }
}

impl Wide for i64 {
    const MAX: i128 = i64::MAX as i128;

    #[inline]
    fn product(a: i32, b: i32) -> Self {
        Self::from(a) * Self::from(b)
    }

    #[inline]
    fn low32(self) -> i32 {
        self as i32
    }
}
