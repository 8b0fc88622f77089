//! One edge over a rectangle of pixels, in 32 bits.

use crate::{
    geometry::{Edge, Sample},
    numbers::{Format, WideArithmetic},
};

/// What a reduced edge value is at a rectangle's first pixel and how it steps, in 32 bits. An edge that
/// accepts the whole rectangle is dropped: it is the constant 0, which accepts everything.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) value: i32,
    pub(super) a: i32,
    pub(super) b: i32,
}

impl Step {
    pub(super) const DROPPED: Self = Self { value: 0, a: 0, b: 0 };

    /// The edge over the `width` x `height` pixels, at most 64 x 64, from (x, y) on: `None` where it
    /// rejects all of them.
    #[inline(always)]
    pub(super) fn over<F: Format>(
        edge: Edge<F>,
        sample: Sample<F>,
        [x, y]: [u32; 2],
        [width, height]: [i32; 2],
    ) -> Option<Self> {
        let value = edge.reduced(sample, x, y);
        let (a, b) = (edge.a(), edge.b());
        let (lowest, highest) = corner_steps(a, b, width, height);
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
