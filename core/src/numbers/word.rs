//! Fixed-point words for depth planes: 32.32 in a `u64`, 16.16 in a `u32`.

use core::{fmt::Debug, hash::Hash};

/// A fixed-point number with H integer and H fractional bits, used modulo 2^H: `u64` or `u32`.
///
/// A covered sample's depth lies inside the vertices' range, so arithmetic modulo 2^H lands on it
/// however steep the plane; elsewhere it may wrap.
pub trait Word: arithmetic::WordArithmetic + Copy + Debug + Default + Eq + Hash + 'static {
    /// H: the integer bits, and the fractional bits.
    const HALF_BITS: u32;
    /// Largest doubled area that a gradient is divided by.
    const MAX_DIVISOR: i128;
    /// Largest magnitude of a gradient's numerator.
    const MAX_NUMERATOR: i128;
}

impl Word for u64 {
    const HALF_BITS: u32 = 32;
    // A remainder below this times 2^16 fits.
    const MAX_DIVISOR: i128 = 1 << 48;
    const MAX_NUMERATOR: i128 = i64::MAX as i128;
}

impl Word for u32 {
    const HALF_BITS: u32 = 16;
    // Twice a remainder below this fits.
    const MAX_DIVISOR: i128 = 1 << 31;
    const MAX_NUMERATOR: i128 = u32::MAX as i128;
}

/// Operations with preconditions that only the crate's bounds meet; private, which also seals
/// [`Word`].
pub(crate) mod arithmetic {
    use core::num::NonZero;

    pub trait WordArithmetic {
        /// The whole number `depth`, below 2^H.
        fn from_depth(depth: u32) -> Self;

        /// The word nearest to N / `area`, ties upwards: floor(2^H N / `area` + 1/2) modulo 2^2H with
        /// N = (z1 - z0) d1 - (z2 - z0) d2, depths below 2^H. 0 where `area` is 0.
        fn gradient(depths: [u32; 3], d1: i32, d2: i32, area: i64) -> Self;

        /// `self + gradient * steps`, modulo 2^2H.
        fn step(self, gradient: Self, steps: i32) -> Self;

        /// The sum, modulo 2^2H.
        fn plus(self, other: Self) -> Self;

        /// The nearest number with `bits` leading bits, ties upwards, as an integer modulo 2^`bits`;
        /// 1 <= `bits` <= min(32, 2H - 1).
        fn rounded(self, bits: u32) -> u32;
    }

    impl WordArithmetic for u64 {
        #[inline]
        fn from_depth(depth: u32) -> Self {
            Self::from(depth) << 32
        }

        #[inline]
        fn gradient(depths: [u32; 3], d1: i32, d2: i32, area: i64) -> Self {
            let Some(divisor) = NonZero::new(area.unsigned_abs()) else { return 0 };
            let numerator = numerator64(depths, d1, d2);
            let (quotient, remainder) = floor_division64(numerator < 0, numerator.unsigned_abs(), divisor);
            (quotient << 32).wrapping_add(fraction64(remainder, divisor))
        }

        #[inline]
        fn step(self, gradient: Self, steps: i32) -> Self {
            self.wrapping_add(gradient.wrapping_mul(i64::from(steps) as Self))
        }

        #[inline]
        fn plus(self, other: Self) -> Self {
            self.wrapping_add(other)
        }

        #[inline]
        fn rounded(self, bits: u32) -> u32 {
            let dropped = 64 - bits;
            (self.wrapping_add(1 << (dropped - 1)) >> dropped) as u32
        }
    }

    impl WordArithmetic for u32 {
        #[inline]
        fn from_depth(depth: u32) -> Self {
            depth << 16
        }

        #[inline]
        fn gradient(depths: [u32; 3], d1: i32, d2: i32, area: i64) -> Self {
            let Some(divisor) = NonZero::new(area.unsigned_abs() as u32) else { return 0 };
            let (negative, magnitude) = numerator32(depths, d1, d2);
            let (quotient, remainder) = floor_division32(negative, magnitude, divisor);
            (quotient << 16).wrapping_add(fraction32(remainder, divisor))
        }

        #[inline]
        fn step(self, gradient: Self, steps: i32) -> Self {
            self.wrapping_add(gradient.wrapping_mul(steps as Self))
        }

        #[inline]
        fn plus(self, other: Self) -> Self {
            self.wrapping_add(other)
        }

        #[inline]
        fn rounded(self, bits: u32) -> u32 {
            let dropped = 32 - bits;
            self.wrapping_add(1 << (dropped - 1)) >> dropped
        }
    }

    /// (z1 - z0) d1 - (z2 - z0) d2; it fits.
    #[inline]
    pub(in crate::numbers) fn numerator64(depths: [u32; 3], d1: i32, d2: i32) -> i64 {
        let [z0, z1, z2] = depths.map(i64::from);
        (z1 - z0) * i64::from(d1) - (z2 - z0) * i64::from(d2)
    }

    /// The same for depths of 16 bits: whether it is negative, and its magnitude, which fits 32 bits.
    #[inline]
    pub(in crate::numbers) fn numerator32(depths: [u32; 3], d1: i32, d2: i32) -> (bool, u32) {
        let [z0, z1, z2] = depths.map(|z| z as i32);
        let (plus, minus) = ((z1 - z0) * d1, (z2 - z0) * d2);
        (plus < minus, plus.abs_diff(minus))
    }

    /// `remainder` / `divisor` as a fraction of 32 bits, to the nearest, ties upwards; for a remainder below
    /// the divisor, below 2^48.
    #[inline]
    pub(in crate::numbers) fn fraction64(remainder: u64, divisor: NonZero<u64>) -> u64 {
        // At once where a remainder is below 2^32, else 16 bits at a time, as it is below 2^48.
        let (fraction, remainder) = if divisor.get() >> 32 == 0 {
            digit(remainder, divisor, 32)
        } else {
            let (high, remainder) = digit(remainder, divisor, 16);
            let (low, remainder) = digit(remainder, divisor, 16);
            ((high << 16) + low, remainder)
        };
        fraction + u64::from(remainder >= divisor.get() - remainder)
    }

    /// The first `bits` bits of `remainder` / `divisor`, and the remainder of the rest.
    #[inline]
    pub(in crate::numbers) fn digit(remainder: u64, divisor: NonZero<u64>, bits: u32) -> (u64, u64) {
        let shifted = remainder << bits;
        (shifted / divisor, shifted % divisor)
    }

    /// The same of 16 bits, one at a time: a remainder is below 2^31.
    #[inline]
    pub(in crate::numbers) fn fraction32(mut remainder: u32, divisor: NonZero<u32>) -> u32 {
        let mut fraction = 0;
        for _ in 0..16 {
            let (bit, rest) = binary_digit(remainder, divisor);
            (fraction, remainder) = (fraction << 1 | u32::from(bit), rest);
        }
        fraction + u32::from(remainder >= divisor.get() - remainder)
    }

    /// The first binary digit of `remainder` / `divisor`, and the remainder of the rest.
    #[inline]
    pub(in crate::numbers) fn binary_digit(remainder: u32, divisor: NonZero<u32>) -> (bool, u32) {
        let twice = remainder << 1;
        let bit = twice >= divisor.get();
        (bit, twice - if bit { divisor.get() } else { 0 })
    }

    /// Defines `$name`: quotient (modulo the type's range) and remainder of ±`magnitude` / `divisor`,
    /// rounded down. One for each width: a 64-bit division is a library call on small processors.
    macro_rules! floor_division {
        ($name:ident, $int:ty) => {
            #[inline]
            pub(in crate::numbers) fn $name(
                negative: bool,
                magnitude: $int,
                divisor: NonZero<$int>,
            ) -> ($int, $int) {
                let (quotient, remainder) = (magnitude / divisor, magnitude % divisor);
                match (negative, remainder) {
                    (false, _) => (quotient, remainder),
                    (true, 0) => (quotient.wrapping_neg(), 0),
                    // -(q + r/d) = -(q + 1) + (d - r)/d, and -(q + 1) is !q.
                    (true, _) => (!quotient, divisor.get() - remainder),
                }
            }
        };
    }

    floor_division!(floor_division64, u64);
    floor_division!(floor_division32, u32);
}
