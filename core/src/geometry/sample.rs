//! Where in a pixel coverage and depth are evaluated.

use super::{edge::Edge, rule::Rule};
use crate::numbers::{Bounds, Format};
use core::marker::PhantomData;

/// A sample position: steps of 2^-S px from the pixel's top-left corner, less than a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sample<F> {
    x: i32,
    y: i32,
    format: PhantomData<F>,
}

impl<F: Format> Sample<F> {
    /// The pixel's centre.
    pub const CENTER: Self = {
        let half = Bounds::<F>::STEPS_PER_PIXEL / 2;
        Self { x: half, y: half, format: PhantomData }
    };

    /// The position (`x`, `y`) steps from the pixel's top-left corner; `None` outside `[0, 2^S)`.
    #[must_use]
    pub const fn new(x: i32, y: i32) -> Option<Self> {
        let pixel = Bounds::<F>::STEPS_PER_PIXEL;
        if x < 0 || y < 0 || x >= pixel || y >= pixel {
            return None;
        }
        Some(Self { x, y, format: PhantomData })
    }

    /// The window position, in steps, of the sample of pixel (`column`, `row`), both within the
    /// largest target.
    #[inline]
    pub(crate) const fn of_pixel(self, column: u32, row: u32) -> (i32, i32) {
        (((column as i32) << F::SUBPIXEL_BITS) + self.x, ((row as i32) << F::SUBPIXEL_BITS) + self.y)
    }

    /// The pixels whose samples have an x within `first <= x < end` steps: `(first, end)` columns.
    #[inline]
    pub(crate) const fn columns(self, first: i32, end: i32) -> (i32, i32) {
        Self::pixels(first, end, self.x)
    }

    /// [`columns`](Self::columns) for rows and y.
    #[inline]
    pub(crate) const fn rows(self, first: i32, end: i32) -> (i32, i32) {
        Self::pixels(first, end, self.y)
    }

    const fn pixels(first: i32, end: i32, offset: i32) -> (i32, i32) {
        let up = Bounds::<F>::STEPS_PER_PIXEL - 1 - offset;
        ((first + up) >> F::SUBPIXEL_BITS, (end + up) >> F::SUBPIXEL_BITS)
    }
}

impl<F: Format> Default for Sample<F> {
    fn default() -> Self {
        Self::CENTER
    }
}

/// The top-left rule at the sample.
impl<F: Format> Rule<F> for Sample<F> {
    #[inline]
    fn point(self, _: Edge<F>, column: u32, row: u32) -> (i32, i32) {
        self.of_pixel(column, row)
    }

    #[inline]
    fn bias(self, edge: Edge<F>) -> i32 {
        i32::from(!edge.is_top_left())
    }
}
