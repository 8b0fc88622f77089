//! Signed integers wide enough for edge values.

use core::{
    fmt::Debug,
    hash::Hash,
    ops::{Add, Shr, Sub},
};

/// The integer type of edge values and doubled areas: `i32` or `i64`.
///
/// The arithmetic is the type's own, overflow-checked where the profile checks;
/// [`Bounds`](super::Bounds) says why it cannot overflow.
pub trait Wide:
    arithmetic::WideArithmetic
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
}

impl Wide for i32 {
    const MAX: i128 = i32::MAX as i128;
}

impl Wide for i64 {
    const MAX: i128 = i64::MAX as i128;
}

/// Operations with preconditions that only the crate's bounds meet; private, which also seals
/// [`Wide`].
pub(crate) mod arithmetic {
    pub trait WideArithmetic {
        /// The product of two 32-bit factors; it fits.
        fn product(a: i32, b: i32) -> Self;
        /// The low 32 bits: the value itself where it fits, as the caller's bounds show.
        fn low32(self) -> i32;
    }

    impl WideArithmetic for i32 {
        #[inline]
        fn product(a: i32, b: i32) -> Self {
            a * b
        }

        #[inline]
        fn low32(self) -> i32 {
            self
        }
    }

    impl WideArithmetic for i64 {
        #[inline]
        fn product(a: i32, b: i32) -> Self {
            Self::from(a) * Self::from(b)
        }

        #[inline]
        fn low32(self) -> i32 {
            self as i32
        }
    }
}
