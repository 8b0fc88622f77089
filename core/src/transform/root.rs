//! Square roots, as `core` has none.

/// A little more than the root of a number that is not negative: by a factor of less than 1 + 2^-38, where the number
/// is not below the smallest normal one. Infinity and NaN give NaN.
///
/// Half the exponent is a first estimate, at most 6.1 per cent too large and never too small. Each of Heron's steps,
/// y to (y + x / y) / 2, leaves half the square of the relative error and, apart from rounding, nothing below the root.
#[inline(always)]
pub(crate) fn root_above(number: f64) -> f64 {
    let mut root = f64::from_bits((number.to_bits() >> 1) + (0x3FF << 51));
    for _ in 0..3 {
        root = 0.5 * (root + number / root);
    }
    root * (1.0 + 1.0 / (1u64 << 40) as f64)
}
