//! Unbounded rationals: how they are made from numbers and rounded to integers.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// An exact fraction of unbounded integers, always in lowest terms.
pub type Rational = num_rational::BigRational;

/// The exact value of a float; `None` for NaN and the infinities.
///
/// Every finite float is a fraction with a power of two below, so nothing is rounded.
pub fn from_f32(value: f32) -> Option<Rational> {
    Rational::from_float(value)
}

/// A window coordinate in pixels from sub-pixel steps: `steps / 2^subpixel_bits`.
pub fn from_steps(steps: i64, subpixel_bits: u32) -> Rational {
    Rational::new(BigInt::from(steps), BigInt::from(1) << subpixel_bits)
}

/// The nearest integer; of two equally near ones the larger: `floor(value + 1/2)`.
pub fn nearest_ties_up(value: &Rational) -> BigInt {
    let twice: BigInt = value.numer() * 2 + value.denom();
    twice.div_floor(&(value.denom() * 2))
}

/// The nearest integer; of two equally near ones the even one.
pub fn nearest_ties_even(value: &Rational) -> BigInt {
    let (below, rest) = value.numer().div_mod_floor(value.denom());
    match BigInt::cmp(&(rest * 2), value.denom()) {
        std::cmp::Ordering::Less => below,
        std::cmp::Ordering::Greater => below + 1,
        std::cmp::Ordering::Equal if below.is_even() => below,
        std::cmp::Ordering::Equal => below + 1,
    }
}

/// The value in decimal with a fixed number of digits after the point, nearest, ties away from zero.
///
/// For people only; [`Rational`] itself prints as `numerator/denominator`.
pub fn decimal(value: &Rational, digits: u32) -> String {
    let scale = BigInt::from(10).pow(digits);
    let scaled = nearest_ties_up(&(value.abs() * Rational::from_integer(scale.clone())));
    let (whole, rest) = scaled.div_rem(&scale);
    let sign = if value.is_negative() && !scaled.is_zero() { "-" } else { "" };
    if digits == 0 {
        return format!("{sign}{whole}");
    }
    format!("{sign}{whole}.{:0>width$}", rest.to_string(), width = digits as usize)
}
