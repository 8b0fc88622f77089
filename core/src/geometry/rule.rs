//! What it is to be inside an edge, for a pixel: at its sample, in any of its points, or in all of them.

use super::edge::Edge;
use crate::numbers::Format;

/// One test of a pixel against an edge: the edge function at one point of the pixel, less a constant, is
/// not negative. The point may depend on the edge but not on the pixel, so the edge value steps by A and B.
pub(crate) trait Rule<F: Format>: Copy {
    /// The point of pixel (`column`, `row`) within the largest target, in steps: in the closed pixel, and
    /// so in the guard band.
    fn point(self, edge: Edge<F>, column: u32, row: u32) -> (i32, i32);

    /// What is taken off there, in steps²: at most [`MAX_BIAS`](crate::Bounds::MAX_BIAS) in magnitude.
    fn bias(self, edge: Edge<F>) -> i32;
}

/// Three edges and the rule for all of them: what is inside of all is inside.
#[derive(Clone, Copy)]
pub(crate) struct HalfPlanes<F, R> {
    pub(crate) edges: [Edge<F>; 3],
    pub(crate) rule: R,
}

/// How far the vertices may be from where they were before they were snapped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Uncertainty {
    /// Not at all: answers are those of the snapped triangle.
    #[default]
    None,
    /// Half a step in x and in y, which is what snapping to the nearest step can move them: 1/512 px for
    /// [`Standard`](crate::Standard), the smallest uncertainty region of Direct3D ("Conservative Rasterization").
    HalfStep,
}

impl Uncertainty {
    /// In half steps.
    #[inline]
    pub(crate) const fn doubled(self) -> i32 {
        match self {
            Self::None => 0,
            Self::HalfStep => 1,
        }
    }
}

/// Some point of a pixel, the half-open square, is inside the edge, which the uncertainty moves outwards.
///
/// # Why this is exact
///
/// Let T be the closed triangle, a segment or a point if it is degenerate; Q the closed square of half-size
/// h, the uncertainty: 0 or half a step; T + Q the triangle grown by it; and P the pixel, without its right
/// and its bottom border. P is the union of the closed squares P(t) that end t before those borders, for
/// t > 0, larger ones for smaller t. So T + Q meets P if and only if it meets P(t) for some t > 0.
///
/// Two compact convex polygons are disjoint if and only if the normal of a side of one of them is an axis on
/// which their projections are disjoint (separating axes; the Minkowski difference is a polygon whose sides
/// have these normals, and 0 is not in it). Here those are the two axes, and for each edge its normal (A, B);
/// a segment has both orientations of one, which the edges of a degenerate triangle are; a point has none,
/// and its edges, of no length, separate nothing. Each of these finitely many tests holds for all smaller t
/// once it holds for one, so T + Q meets P exactly where each test by itself holds for some t:
///
/// * the axes: `left - h < i + 1` and `right + h >= i` (in pixels), likewise for rows:
///   [`Extent::touched`](super::Extent::touched);
/// * an edge: E over T + Q is at least -h (|A| + |B|), its least on T, 0, and what Q adds. The largest E over
///   P(t) is M - t (max(A, 0) + max(B, 0)), M being E at the corner where it is largest: right if A > 0,
///   bottom if B > 0. It is at least -h (|A| + |B|) for some t > 0 exactly where
///   M + h (|A| + |B|) > 0 if A > 0 or B > 0 (the corner is on a border that the pixel has not), and where it
///   is >= 0 otherwise.
///
/// M is an integer. With h a half and D = |A| + |B|, M + D / 2 > 0 is M - 1 + floor((D + 1) / 2) >= 0, and
/// M + D / 2 >= 0 is M + floor(D / 2) >= 0. Nothing is doubled, so everything fits where E does.
#[derive(Clone, Copy)]
pub(crate) struct Touched(pub(crate) Uncertainty);

impl<F: Format> Rule<F> for Touched {
    #[inline]
    fn point(self, edge: Edge<F>, column: u32, row: u32) -> (i32, i32) {
        corner::<F>(column, row, edge.a() > 0, edge.b() > 0)
    }

    #[inline]
    fn bias(self, edge: Edge<F>) -> i32 {
        let open = i32::from((edge.a() > 0) | (edge.b() > 0));
        match self.0 {
            Uncertainty::None => open,
            Uncertainty::HalfStep => open - ((steepness(edge) + open) >> 1),
        }
    }
}

/// The whole closed pixel is inside the edge, which the uncertainty moves inwards.
///
/// A convex set contains a square if it contains its corners; E is smallest at the left one if A >= 0, at the
/// top one if B >= 0. A point p is in the triangle for all vertices that are within h if p + Q is in T: else a
/// direction n has n p > n (v + d) for each vertex v and its displacement d, hence n p + h (|nx| + |ny|) > n v
/// for all three, and the corner p + h (sign nx, sign ny) of p + Q is not in T. And p + Q is in T where
/// E(p) >= h (|A| + |B|) for each edge: with h a half, where E(p) - floor((|A| + |B| + 1) / 2) >= 0.
#[derive(Clone, Copy)]
pub(crate) struct Inside(pub(crate) Uncertainty);

impl<F: Format> Rule<F> for Inside {
    #[inline]
    fn point(self, edge: Edge<F>, column: u32, row: u32) -> (i32, i32) {
        corner::<F>(column, row, edge.a() < 0, edge.b() < 0)
    }

    #[inline]
    fn bias(self, edge: Edge<F>) -> i32 {
        match self.0 {
            Uncertainty::None => 0,
            Uncertainty::HalfStep => (steepness(edge) + 1) >> 1,
        }
    }
}

/// |A| + |B|: by how much E changes at most over a square of one step.
#[inline]
fn steepness<F: Format>(edge: Edge<F>) -> i32 {
    edge.a().abs() + edge.b().abs()
}

/// A corner of a pixel within the largest target, in steps: its right ones, its bottom ones, or others.
#[inline]
const fn corner<F: Format>(column: u32, row: u32, right: bool, bottom: bool) -> (i32, i32) {
    (((column + right as u32) << F::SUBPIXEL_BITS) as i32, ((row + bottom as u32) << F::SUBPIXEL_BITS) as i32)
}
