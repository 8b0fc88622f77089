//! The definitions: which samples a triangle covers, and what a value given at its corners is there.
//!
//! Written as the rule reads (Direct3D 11.3 functional specification, 3.4.2.1; rules R9 to R13 of
//! the project's conformance page), without an order of the corners, a winding or a bias.

use num_traits::Zero;

use crate::Rational;

/// A point of the window plane, in pixels or in any other unit that all arguments share; y down.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// To the right.
    pub x: Rational,
    /// Downwards.
    pub y: Rational,
}

impl Point {
    /// The point with these coordinates.
    pub fn new(x: Rational, y: Rational) -> Self {
        Point { x, y }
    }

    /// The point with these whole-numbered coordinates, for instance in sub-pixel steps.
    pub fn from_integers(x: i64, y: i64) -> Self {
        Point { x: Rational::from_integer(x.into()), y: Rational::from_integer(y.into()) }
    }
}

/// Whether a triangle covers a sample. Exact.
///
/// A sample strictly inside is covered. A sample on the outline is covered only if every edge it
/// lies on (two, at a corner) is a top or a left edge:
/// * a top edge is exactly horizontal and above the other edges;
/// * a left edge is not horizontal and on the left side of the triangle.
///
/// A triangle without area covers nothing. The order of the corners does not matter.
pub fn covers(corners: &[Point; 3], sample: &Point) -> bool {
    (0..3).all(|i| {
        let (a, b, opposite) = (&corners[i], &corners[(i + 1) % 3], &corners[(i + 2) % 3]);
        let inner = side(a, b, opposite);
        let here = side(a, b, sample);
        if inner.is_zero() {
            false // all corners on one line
        } else if here.is_zero() {
            is_top(a, b, opposite) || is_left(a, b, opposite)
        } else {
            (here > Rational::zero()) == (inner > Rational::zero())
        }
    })
}

/// The weights of the three corners at a sample: they sum to 1, and the corners so weighted give the
/// sample. All are at least 0 exactly where the sample is in the closed triangle. `None` without area.
pub fn weights_at(corners: &[Point; 3], sample: &Point) -> Option<[Rational; 3]> {
    let [a, b, c] = corners;
    let area = side(a, b, c);
    if area.is_zero() {
        return None;
    }
    Some([side(b, c, sample) / &area, side(c, a, sample) / &area, side(a, b, sample) / &area])
}

/// The depth at a sample of a triangle with these depths at its corners: linear on the screen (rule
/// R28), in whatever unit the corners have. Exact, also outside the triangle. `None` without area.
pub fn depth_at(corners: &[Point; 3], z: &[Rational; 3], sample: &Point) -> Option<Rational> {
    let weights = weights_at(corners, sample)?;
    Some(weights.iter().zip(z).map(|(weight, z)| weight * z).sum())
}

/// Zero where `p` lies on the line through `a` and `b`, of opposite signs on its two sides: twice the
/// signed area of the triangle a, b, p.
fn side(a: &Point, b: &Point, p: &Point) -> Rational {
    (&b.x - &a.x) * (&p.y - &a.y) - (&b.y - &a.y) * (&p.x - &a.x)
}

/// Exactly horizontal, and the rest of the triangle is below it.
fn is_top(a: &Point, b: &Point, opposite: &Point) -> bool {
    a.y == b.y && opposite.y > a.y
}

/// Not horizontal, and the rest of the triangle is on its right: at the height of the opposite
/// corner, the edge's line passes to the left of that corner.
fn is_left(a: &Point, b: &Point, opposite: &Point) -> bool {
    if a.y == b.y {
        return false;
    }
    let along = (&opposite.y - &a.y) / (&b.y - &a.y);
    &a.x + (&b.x - &a.x) * along < opposite.x
}
