//! Fractions of 128-bit integers that are compared exactly.

use std::cmp::Ordering;
use std::fmt;

use num_bigint::BigInt;

use crate::Rational;

/// An exact fraction with a positive denominator, not necessarily in lowest terms.
///
/// Equality and order are those of the value: 1/2 equals 2/4.
#[derive(Clone, Copy, Debug)]
pub struct Fraction {
    numerator: i128,
    denominator: i128,
}

impl Fraction {
    pub(crate) const ZERO: Fraction = Fraction { numerator: 0, denominator: 1 };

    /// `numerator / denominator`; `None` unless the denominator is positive.
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        (denominator > 0).then_some(Fraction { numerator, denominator })
    }

    /// The part above the line.
    pub fn numerator(self) -> i128 {
        self.numerator
    }

    /// The part below the line, positive.
    pub fn denominator(self) -> i128 {
        self.denominator
    }

    /// The largest integer not above the value.
    pub fn floor(self) -> i128 {
        self.numerator.div_euclid(self.denominator)
    }

    /// The same value in unbounded integers and lowest terms.
    pub fn to_rational(self) -> Rational {
        Rational::new(BigInt::from(self.numerator), BigInt::from(self.denominator))
    }

    /// A nearby float, for statistics and people: integer part and remainder rounded separately, so the
    /// relative error is a few units of 2^-53.
    pub fn approximate(self) -> f64 {
        let rest = self.numerator.rem_euclid(self.denominator);
        self.floor() as f64 + rest as f64 / self.denominator as f64
    }

    /// The distance to an integer, exact; `None` where it does not fit 128 bits.
    pub fn distance_to(self, integer: i128) -> Option<Fraction> {
        let numerator = integer.checked_mul(self.denominator)?.checked_sub(self.numerator)?.checked_abs()?;
        Some(Fraction { numerator, denominator: self.denominator })
    }
}

impl Ord for Fraction {
    /// Exact: integer parts first, then the remainders multiplied across, in unbounded integers where
    /// the products do not fit.
    fn cmp(&self, other: &Self) -> Ordering {
        self.floor().cmp(&other.floor()).then_with(|| {
            let (a, b) =
                (self.numerator.rem_euclid(self.denominator), other.numerator.rem_euclid(other.denominator));
            match (a.checked_mul(other.denominator), b.checked_mul(self.denominator)) {
                (Some(left), Some(right)) => left.cmp(&right),
                _ => (BigInt::from(a) * other.denominator).cmp(&(BigInt::from(b) * self.denominator)),
            }
        })
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Fraction {}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.numerator, self.denominator)
    }
}
