//! Edge functions in exact integers, with the top-left rule as a bias.

use super::{rule::Rule, sample::Sample, vertex::Vertex};
use crate::numbers::{Format, WideArithmetic};

/// The edge from one vertex to another of a triangle with positive doubled area: the edge function
/// E(p) = A (px - xa) + B (py - ya) with A = ya - yb, B = xb - xa, in steps².
///
/// E is positive inside, 0 on the line. A point on the line is inside where the edge is a left edge
/// (A > 0) or a top edge (A = 0 and B > 0): Direct3D 11.3, 3.4.2.1. `bias` is 0 for those and 1 for
/// the others, so that "inside" is E - bias >= 0 for all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Edge<F> {
    a: i32,
    b: i32,
    start: Vertex<F>,
}

impl<F: Format> Edge<F> {
    /// The edge from `start` to `end`.
    #[inline]
    #[must_use]
    pub const fn new(start: Vertex<F>, end: Vertex<F>) -> Self {
        Self { a: start.y() - end.y(), b: end.x() - start.x(), start }
    }

    /// A: what the edge value grows by for a step to the right; what a reduced one grows by for a
    /// pixel to the right.
    #[inline]
    #[must_use]
    pub const fn a(self) -> i32 {
        self.a
    }

    /// B: the same for a step, or a pixel, down.
    #[inline]
    #[must_use]
    pub const fn b(self) -> i32 {
        self.b
    }

    /// Whether a sample on the line belongs to this side.
    #[inline]
    #[must_use]
    pub const fn is_top_left(self) -> bool {
        // Without a branch: nothing foretells which edges are.
        (self.a > 0) | ((self.a == 0) & (self.b > 0))
    }

    /// E at a point of the guard band, in steps².
    #[inline]
    pub(crate) fn at(self, (x, y): (i32, i32)) -> F::Wide {
        F::Wide::product(self.a, x - self.start.x()) + F::Wide::product(self.b, y - self.start.y())
    }

    /// E at the sample of a pixel within the largest target, in steps².
    #[inline]
    pub(crate) fn value(self, sample: Sample<F>, column: u32, row: u32) -> F::Wide {
        self.at(sample.of_pixel(column, row))
    }

    /// The reduced edge value e = floor((E - bias) / 2^S), E at the rule's point of a pixel within the
    /// largest target: not negative exactly where the pixel is inside by that rule; a sample's is the
    /// top-left rule. One pixel to the right adds A, one pixel down adds B, without loss:
    /// a pixel changes E by a multiple of 2^S, and floor((E + 2^S k) / 2^S) = floor(E / 2^S) + k.
    #[inline]
    pub(crate) fn reduced(self, rule: impl Rule<F>, column: u32, row: u32) -> F::Wide {
        let bias = F::Wide::from(rule.bias(self));
        (self.at(rule.point(self, column, row)) - bias) >> F::SUBPIXEL_BITS
    }
}
