//! Conservative coverage by the definitions: what a closed triangle touches, and what lies wholly in it.
//!
//! Pixels are half-open squares, so that each point of the plane is in one. Touching is decided by clipping
//! and not by separating lines, containment by weights and not by signs of edge functions.

use num_traits::Signed;

use crate::area::{cut, integer};
use crate::{Point, Rational, weights_at};

/// The half-open rectangle `first.x <= x < end.x`, `first.y <= y < end.y`: a pixel, or many.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfOpen {
    /// The top-left corner, which belongs to it.
    pub first: Point,
    /// The bottom-right corner, which does not.
    pub end: Point,
}

impl HalfOpen {
    /// The pixels of columns `x0..x1` and rows `y0..y1`, in pixels.
    pub fn pixels([x0, y0, x1, y1]: [i64; 4]) -> Self {
        HalfOpen { first: Point::new(integer(x0), integer(y0)), end: Point::new(integer(x1), integer(y1)) }
    }

    /// With all sides moved outwards by so much, inwards if it is negative.
    ///
    /// The sum of a triangle and a closed square of half-size h meets this rectangle exactly where the triangle
    /// meets the rectangle grown by h, as t + q = p means t = p - q; and lies in it exactly where the triangle
    /// lies in the rectangle grown by -h.
    pub fn grown(&self, by: &Rational) -> Self {
        let moved = |point: &Point, by: &Rational| Point::new(&point.x + by, &point.y + by);
        HalfOpen { first: moved(&self.first, &-by), end: moved(&self.end, by) }
    }

    /// Whether it has a point of the closed triangle, which may be a segment or a point. Exact.
    ///
    /// What the closed rectangle has of the triangle is the convex hull of the clipped polygon's corners. If
    /// one of these is left of the right side and one is above the bottom side, the point half-way between the two
    /// is both; and if there is such a point, some corner is left of the right side, some above the bottom side.
    pub fn meets(&self, corners: &[Point; 3]) -> bool {
        let HalfOpen { first, end } = self;
        let mut polygon = corners.to_vec();
        polygon = cut(polygon, |p| &p.x - &first.x);
        polygon = cut(polygon, |p| &p.y - &first.y);
        polygon = cut(polygon, |p| &end.x - &p.x);
        polygon = cut(polygon, |p| &end.y - &p.y);
        polygon.iter().any(|p| p.x < end.x) && polygon.iter().any(|p| p.y < end.y)
    }

    /// Whether its closure lies in the closed triangle. Exact.
    ///
    /// A convex set has a rectangle if it has its corners, and a triangle has a point if no weight is negative.
    pub fn is_inside(&self, corners: &[Point; 3]) -> bool {
        let HalfOpen { first, end } = self;
        [(first, first), (end, first), (first, end), (end, end)].into_iter().all(|(x, y)| {
            let corner = Point::new(x.x.clone(), y.y.clone());
            weights_at(corners, &corner)
                .is_some_and(|weights| weights.iter().all(|weight| !weight.is_negative()))
        })
    }

    /// Whether the closed triangle lies in it. Exact.
    pub fn holds(&self, corners: &[Point; 3]) -> bool {
        let HalfOpen { first, end } = self;
        corners.iter().all(|p| first.x <= p.x && p.x < end.x && first.y <= p.y && p.y < end.y)
    }
}
