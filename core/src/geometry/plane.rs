//! The depth plane of a triangle, in fixed point modulo the depth's range.

use super::{sample::Sample, triangle::Triangle};
use crate::numbers::{Bounds, Format, WordArithmetic};

/// The depth of a triangle as a plane over the window: a word of H.H fixed point
/// ([`Word::HALF_BITS`](crate::numbers::Word::HALF_BITS)), modulo 2^H.
///
/// With D the doubled area, (dx, dy, dz)k from the triangle's first vertex, the exact gradients are
/// Nx / D and Ny / D for Nx = dz1 dy2 - dz2 dy1 and Ny = dz2 dx1 - dz1 dx2. Each is kept as the word
/// nearest to it, so a covered sample's value is exact but for half a unit of the last place for each
/// step from the first vertex: at most 2^-8 of a depth unit for [`Standard`](crate::Standard). No
/// bit is lost to the steepness, as the arithmetic is modular.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Plane<F: Format> {
    origin: F::Word,
    x: F::Word,
    y: F::Word,
    anchor: (i32, i32),
    sample: Sample<F>,
}

impl<F: Format> Plane<F> {
    /// The plane through the triangle's vertices, `depth` giving each one's depth from its unorm32
    /// in units of 2^-H.
    #[inline]
    pub(crate) fn new(triangle: &Triangle<F>, depth: impl Fn(u32) -> u32) -> Self {
        let [a, b, c] = triangle.vertices();
        let depths = [depth(a.z()), depth(b.z()), depth(c.z())];
        let area = triangle.doubled_area().into();
        let [origin, ..] = depths;
        Self {
            origin: F::Word::from_depth(origin),
            x: F::Word::gradient(depths, c.y() - a.y(), b.y() - a.y(), area),
            y: F::Word::gradient(depths, a.x() - c.x(), a.x() - b.x(), area),
            anchor: (a.x(), a.y()),
            sample: triangle.sample(),
        }
    }

    /// The value at the sample of pixel (`column`, `row`) within the largest target.
    #[inline]
    pub(crate) fn at(&self, column: u32, row: u32) -> F::Word {
        let (x, y) = self.sample.of_pixel(column, row);
        self.origin.step(self.x, x - self.anchor.0).step(self.y, y - self.anchor.1)
    }

    /// The gradients per step to the right and per step down.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) fn gradients(&self) -> (F::Word, F::Word) {
        (self.x, self.y)
    }

    /// The rounded depths, of `bits` bits, that the sixteen samples of a 4x4 block have above its
    /// first one, row by row.
    #[inline]
    pub(crate) fn offsets(&self, bits: u32) -> [u32; 16] {
        let mut offsets = [0; 16];
        let mut row = F::Word::default();
        let (right, down) =
            (row.step(self.x, Bounds::<F>::STEPS_PER_PIXEL), row.step(self.y, Bounds::<F>::STEPS_PER_PIXEL));
        for lanes in offsets.as_chunks_mut::<4>().0 {
            let second = row.plus(right);
            let third = second.plus(right);
            *lanes = [
                row.rounded(bits),
                second.rounded(bits),
                third.rounded(bits),
                third.plus(right).rounded(bits),
            ];
            row = row.plus(down);
        }
        offsets
    }
}
