//! The exact area that a triangle shares with a pixel: the truth that sample patterns approximate.

use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::{Point, Rational};

/// The area of triangle and pixel in common, in square pixels: 0 to 1, exact.
///
/// `corners` in pixels; `pixel` is (i, j), the square `[i, i+1] x [j, j+1]`. The outline has no area,
/// so no fill rule is needed: the areas of a watertight mesh sum to 1 in every pixel it covers.
pub fn covered_area(corners: &[Point; 3], pixel: (i64, i64)) -> Rational {
    let (left, top) = (integer(pixel.0), integer(pixel.1));
    let (right, bottom) = (&left + Rational::one(), &top + Rational::one());
    let mut polygon = corners.to_vec();
    polygon = cut(polygon, |p| &p.x - &left);
    polygon = cut(polygon, |p| &right - &p.x);
    polygon = cut(polygon, |p| &p.y - &top);
    polygon = cut(polygon, |p| &bottom - &p.y);
    area(&polygon)
}

pub(crate) fn integer(value: i64) -> Rational {
    Rational::from_integer(BigInt::from(value))
}

/// One step of Sutherland and Hodgman's clipping (1974): keeps where `inside`, a linear function, is
/// at least 0.
pub(crate) fn cut(polygon: Vec<Point>, inside: impl Fn(&Point) -> Rational) -> Vec<Point> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        let (at_a, at_b) = (inside(a), inside(b));
        if !at_a.is_negative() {
            kept.push(a.clone());
        }
        if at_a.is_negative() != at_b.is_negative() {
            let along = &at_a / (&at_a - &at_b);
            kept.push(Point { x: &a.x + (&b.x - &a.x) * &along, y: &a.y + (&b.y - &a.y) * &along });
        }
    }
    kept
}

fn area(polygon: &[Point]) -> Rational {
    let mut doubled = Rational::zero();
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        doubled += &a.x * &b.y - &b.x * &a.y;
    }
    doubled.abs() / integer(2)
}
