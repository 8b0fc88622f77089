//! One edge over a rectangle of pixels, in 32 bits.

use crate::{
    geometry::{Edge, HalfPlanes, Region, Rule},
    lanes::Lanes,
    numbers::{Format, WideArithmetic},
};

/// What a reduced edge value is at a rectangle's first pixel and how it steps, in 32 bits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) value: i32,
    pub(super) a: i32,
    pub(super) b: i32,
}

impl Step {
    /// An edge that accepts the whole rectangle. It does not step; its value is positive at every pixel
    /// of a block, whatever the edge's steps there
    /// ([`Bounds::MAX_BLOCK_STEPS`](crate::Bounds::MAX_BLOCK_STEPS)).
    pub(super) const DROPPED: Self = Self { value: 1 << 30, a: 0, b: 0 };

    /// The edge so many columns and rows on, at a pixel of the rectangle.
    #[inline(always)]
    pub(super) const fn after(self, [columns, rows]: [u32; 2]) -> Self {
        Self { value: self.value + columns as i32 * self.a + rows as i32 * self.b, ..self }
    }

    /// The edges over a rectangle of at most 64 x 64 pixels: `None` where one rejects it.
    #[inline(always)]
    pub(super) fn all<F: Format, R: Rule<F>>(
        HalfPlanes { edges: [e0, e1, e2], rule }: HalfPlanes<F, R>,
        rectangle: Region<F>,
    ) -> Option<[Self; 3]> {
        Some([
            Self::over(e0, rule, rectangle)?,
            Self::over(e1, rule, rectangle)?,
            Self::over(e2, rule, rectangle)?,
        ])
    }

    #[inline(always)]
    pub(super) fn over<F: Format>(edge: Edge<F>, rule: impl Rule<F>, rectangle: Region<F>) -> Option<Self> {
        let value = edge.reduced(rule, rectangle.x0(), rectangle.y0());
        let (a, b) = (edge.a(), edge.b());
        let (lowest, highest) = corner_steps(a, b, rectangle.width() as i32, rectangle.height() as i32);
        let zero = F::Wide::default();
        if value + F::Wide::from(highest) < zero {
            None
        } else if value + F::Wide::from(lowest) >= zero {
            Some(Self::DROPPED)
        } else {
            // The edge crosses the rectangle, which is no larger than a tile: `Bounds::MAX_TILE_VALUE`.
            Some(Self { value: value.low32(), a, b })
        }
    }
}

/// What the steps from a rectangle's first pixel to the pixel where an edge is smallest, and to the one
/// where it is largest, add to it: the trivial-accept and the trivial-reject corner.
#[inline(always)]
pub(super) fn corner_steps(a: i32, b: i32, width: i32, height: i32) -> (i32, i32) {
    let (right, down) = ((width - 1) * a, (height - 1) * b);
    (right.min(0) + down.min(0), right.max(0) + down.max(0))
}

/// What an edge is in every block of a triangle, relative to its value at the block's first pixel.
#[derive(Clone, Copy)]
pub(super) struct InBlock<L> {
    /// At each pixel.
    pub(super) lanes: L,
    /// At the trivial-reject corner.
    pub(super) highest: i32,
}

impl<L: Lanes> InBlock<L> {
    /// Three edges.
    #[inline(always)]
    pub(super) fn all<F: Format>(token: L::Token, [e0, e1, e2]: [Edge<F>; 3]) -> [Self; 3] {
        [Self::of(token, e0), Self::of(token, e1), Self::of(token, e2)]
    }

    #[inline(always)]
    pub(super) fn of<F: Format>(token: L::Token, edge: Edge<F>) -> Self {
        let (_, highest) = corner_steps(edge.a(), edge.b(), 4, 4);
        Self { lanes: L::ramp(token, 0, edge.a(), edge.b()), highest }
    }
}
