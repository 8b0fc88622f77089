//! One triangle, set up: canonical order, area, bounds, edges.

use super::{
    edge::Edge,
    extent::Extent,
    facing::{Culled, Winding},
    region::Region,
    rule::HalfPlanes,
    sample::Sample,
    vertex::Vertex,
};
use crate::numbers::{Bounds, Format, WideArithmetic};
use core::cmp::Ordering;

/// Twice the signed area of the triangle (a, b, c), in steps²: positive where it is clockwise on the
/// screen.
#[inline]
#[must_use]
pub fn doubled_area<F: Format>([a, b, c]: [Vertex<F>; 3]) -> F::Wide {
    F::Wide::product(b.x() - a.x(), c.y() - a.y()) - F::Wide::product(c.x() - a.x(), b.y() - a.y())
}

/// The winding of three vertices as given; `None` where their area is 0.
#[inline]
#[must_use]
pub(crate) fn winding<F: Format>(vertices: [Vertex<F>; 3]) -> Option<Winding> {
    match doubled_area(vertices).cmp(&F::Wide::default()) {
        Ordering::Greater => Some(Winding::Clockwise),
        Ordering::Less => Some(Winding::CounterClockwise),
        Ordering::Equal => None,
    }
}

/// Whether the extent of three vertices does not reach into a region.
#[inline]
#[must_use]
pub fn is_outside<F: Format>(vertices: [Vertex<F>; 3], region: Region<F>) -> bool {
    Extent::of(vertices).is_outside(region)
}

/// A triangle with an area, set up for one sample position.
///
/// The vertices are kept in a canonical order: first the one with the smallest y, then the smallest
/// x, the other two so that the area is positive. So nothing drawn depends on the order they were
/// given in, not even by rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Triangle<F: Format> {
    vertices: [Vertex<F>; 3],
    /// `vertices[k]` was submitted as number `order[k]`.
    order: [u8; 3],
    winding: Winding,
    area: F::Wide,
    /// `edges[k]` lies opposite `vertices[k]`.
    edges: [Edge<F>; 3],
    sample: Sample<F>,
}

impl<F: Format> Triangle<F> {
    /// Sets up a triangle; `None` where its area is 0.
    #[inline]
    #[must_use]
    pub fn new(submitted: [Vertex<F>; 3], sample: Sample<F>) -> Option<Self> {
        let () = Bounds::<F>::CHECKED;
        let signed = doubled_area(submitted);
        let zero = F::Wide::default();
        if signed == zero {
            return None;
        }
        let winding = if signed > zero { Winding::Clockwise } else { Winding::CounterClockwise };
        let [a, b, c] = submitted;
        let key = |v: Vertex<F>| (v.y(), v.x());
        let (vertices, order) = if key(a) <= key(b) && key(a) <= key(c) {
            ([a, b, c], [0, 1, 2])
        } else if key(b) <= key(c) {
            ([b, c, a], [1, 2, 0])
        } else {
            ([c, a, b], [2, 0, 1])
        };
        let ([first, second, third], [i, j, k]) = (vertices, order);
        let (vertices, order, area) = match winding {
            Winding::Clockwise => (vertices, order, signed),
            Winding::CounterClockwise => ([first, third, second], [i, k, j], zero - signed),
        };
        let [first, second, third] = vertices;
        let edges = [Edge::new(second, third), Edge::new(third, first), Edge::new(first, second)];
        Some(Self { vertices, order, winding, area, edges, sample })
    }

    /// The vertices in canonical order.
    #[inline]
    #[must_use]
    pub const fn vertices(&self) -> [Vertex<F>; 3] {
        self.vertices
    }

    /// For each vertex of [`vertices`](Self::vertices), which of the submitted ones it was.
    #[inline]
    #[must_use]
    pub const fn order(&self) -> [u8; 3] {
        self.order
    }

    /// The winding as submitted.
    #[inline]
    #[must_use]
    pub const fn winding(&self) -> Winding {
        self.winding
    }

    /// Twice the area in steps², positive.
    #[inline]
    #[must_use]
    pub const fn doubled_area(&self) -> F::Wide {
        self.area
    }

    /// The edges, each opposite the vertex of the same place in [`vertices`](Self::vertices).
    #[inline]
    #[must_use]
    pub const fn edges(&self) -> [Edge<F>; 3] {
        self.edges
    }

    /// The sample position it was set up for.
    #[inline]
    #[must_use]
    pub const fn sample(&self) -> Sample<F> {
        self.sample
    }

    /// The edges with the rule of the sample.
    #[inline]
    pub(crate) const fn half_planes(&self) -> HalfPlanes<F, Sample<F>> {
        HalfPlanes { edges: self.edges, rule: self.sample }
    }

    /// The exact barycentric weights of the sample of pixel (`column`, `row`), in submitted order, as
    /// numerators over [`doubled_area`](Self::doubled_area): their sum is that area, and none is
    /// negative where the sample is covered. `None` beyond the largest target.
    #[must_use]
    pub fn weights(&self, column: u32, row: u32) -> Option<[F::Wide; 3]> {
        if column >= F::MAX_TARGET || row >= F::MAX_TARGET {
            return None;
        }
        let mut weights = [F::Wide::default(); 3];
        for (edge, place) in self.edges.into_iter().zip(self.order) {
            if let Some(weight) = weights.get_mut(usize::from(place)) {
                *weight = edge.value(self.sample, column, row);
            }
        }
        Some(weights)
    }

    /// The pixels of `region` whose samples can be covered.
    ///
    /// Samples on a triangle's right or bottom extreme belong to no left or top edge, so bounds are
    /// half-open: `min <= position < max`.
    ///
    /// # Errors
    ///
    /// [`Culled::Outside`] where the triangle's extent does not touch the region,
    /// [`Culled::NoSample`] where it lies between the samples.
    #[inline]
    pub fn bounds(&self, region: Region<F>) -> Result<Region<F>, Culled> {
        let extent = Extent::of(self.vertices);
        if extent.is_outside(region) {
            return Err(Culled::Outside);
        }
        extent.bounds(self.sample, region)
    }
}
