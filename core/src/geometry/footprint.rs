//! Closed triangles, degenerate ones included: what they touch and what they contain.

use super::{
    edge::Edge,
    extent::Extent,
    region::Region,
    rule::{HalfPlanes, Inside, Rule, Touched, Uncertainty},
    triangle::doubled_area,
    vertex::Vertex,
};
use crate::numbers::{Bounds, Format};

/// A closed triangle, which may be a segment or a point, set up for conservative questions: which pixels it
/// touches (over-estimated coverage), and which lie wholly in it (under-estimated coverage).
///
/// * A pixel (i, j) is the half-open square `[i, i + 1) x [j, j + 1)`, so each point of the plane is in
///   exactly one (Direct3D 11.3, 3.3.1). It is **touched** if it has a point of the closed triangle.
/// * A pixel is **inside** if its square, borders included, lies in the closed triangle. Nothing is inside
///   a triangle without area.
/// * With [`Uncertainty::HalfStep`] the triangle is grown by a square of half a step to each side for the
///   first, shrunk by it for the second: so a pixel that any triangle touches whose vertices
///   are within half a step of the given ones is touched, and a pixel that is inside is inside all of those.
///
/// All answers are exact. None depends on the order of the vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Footprint<F: Format> {
    edges: [Edge<F>; 3],
    extent: Extent,
    has_area: bool,
    uncertainty: Uncertainty,
}

/// How a triangle and a rectangle of pixels lie; see [`Footprint::overlap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Overlap {
    /// The triangle touches no pixel of the rectangle.
    Outside,
    /// All pixels of the rectangle are inside the triangle.
    Covers,
    /// All pixels that the triangle touches are in the rectangle.
    Within,
    /// None of these.
    Partial,
}

impl<F: Format> Footprint<F> {
    /// Sets up a triangle, whatever its winding and its area.
    #[inline]
    #[must_use]
    pub fn new(vertices: [Vertex<F>; 3], uncertainty: Uncertainty) -> Self {
        let () = Bounds::<F>::CHECKED;
        let (area, zero) = (doubled_area(vertices), F::Wide::default());
        let [a, b, c] = vertices;
        let (b, c) = if area < zero { (c, b) } else { (b, c) };
        Self {
            edges: [Edge::new(b, c), Edge::new(c, a), Edge::new(a, b)],
            extent: Extent::of(vertices),
            has_area: area != zero,
            uncertainty,
        }
    }

    /// The uncertainty it was set up with.
    #[inline]
    #[must_use]
    pub const fn uncertainty(&self) -> Uncertainty {
        self.uncertainty
    }

    /// The smallest rectangle that holds all pixels of `region` which can be touched: those that the
    /// triangle's bounding rectangle touches. `None` where there are none.
    #[inline]
    #[must_use]
    pub fn bounds(&self, region: Region<F>) -> Option<Region<F>> {
        self.extent.touched::<F>(self.uncertainty).within(region)
    }

    /// How the triangle and a rectangle of pixels lie: what binning asks of a triangle and a tile.
    ///
    /// Exact: [`Outside`](Overlap::Outside) if and only if no pixel of the region is touched,
    /// [`Covers`](Overlap::Covers) if and only if all its pixels are inside,
    /// [`Within`](Overlap::Within) if and only if all that is touched, in the region or anywhere, is in it.
    /// The first and the last are mostly told from the bounds, without a product; the others take one edge
    /// value for each edge, and for each edge that does not decide a second one.
    ///
    /// ```
    /// use halfplane::{Footprint, Overlap, Region, Standard, Uncertainty, Vertex};
    ///
    /// // 1/256 px: the corners (0, 0), (128, 0), (0, 128).
    /// let end = 128 * 256;
    /// let corners = [Vertex::<Standard>::new(0, 0, 2)?, Vertex::new(end, 0, 2)?, Vertex::new(0, end, 2)?];
    /// let triangle = Footprint::new(corners, Uncertainty::None);
    /// let tile = |x, y| Region::new(x, y, x + 64, y + 64);
    /// assert_eq!(triangle.overlap(tile(0, 0)?), Overlap::Covers);
    /// assert_eq!(triangle.overlap(tile(64, 0)?), Overlap::Partial);
    /// // Pixel (64, 64) has a point of the hypotenuse, its corner.
    /// assert_eq!(triangle.overlap(tile(64, 64)?), Overlap::Partial);
    /// assert_eq!(triangle.overlap(tile(65, 64)?), Overlap::Outside);
    /// // Pixel (128, 0) has the corner (128, 0).
    /// assert_eq!(triangle.overlap(Region::of_size(129, 129)?), Overlap::Within);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn overlap(&self, region: Region<F>) -> Overlap {
        let touched = self.extent.touched::<F>(self.uncertainty);
        if touched.within(region).is_none() {
            return Overlap::Outside;
        }
        if touched.are_all_in(region) {
            return Overlap::Within;
        }
        let [e0, e1, e2] = self.edges;
        let touched = Touched(self.uncertainty);
        if !(accepts(e0, touched, region, true)
            && accepts(e1, touched, region, true)
            && accepts(e2, touched, region, true))
        {
            return Overlap::Outside;
        }
        let inside = Inside(self.uncertainty);
        if self.has_area
            && accepts(e0, inside, region, false)
            && accepts(e1, inside, region, false)
            && accepts(e2, inside, region, false)
        {
            return Overlap::Covers;
        }
        Overlap::Partial
    }

    /// The edges with the rule for what is touched.
    #[inline]
    pub(crate) const fn touched(&self) -> HalfPlanes<F, Touched> {
        HalfPlanes { edges: self.edges, rule: Touched(self.uncertainty) }
    }

    /// The edges with the rule for what is inside; `None` without area.
    #[inline]
    pub(crate) fn inside(&self) -> Option<HalfPlanes<F, Inside>> {
        self.has_area.then_some(HalfPlanes { edges: self.edges, rule: Inside(self.uncertainty) })
    }
}

/// Whether an edge accepts a region's pixel where it is largest, or else the one where it is smallest. The
/// rule's corner of that pixel is the rectangle's, so this is the rule for the rectangle as one large pixel.
#[inline]
pub(super) fn accepts<F: Format>(
    edge: Edge<F>,
    rule: impl Rule<F>,
    region: Region<F>,
    largest: bool,
) -> bool {
    let column = if (edge.a() > 0) == largest { region.x1() - 1 } else { region.x0() };
    let row = if (edge.b() > 0) == largest { region.y1() - 1 } else { region.y0() };
    edge.reduced(rule, column, row) >= F::Wide::default()
}
