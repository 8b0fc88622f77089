//! How far a triangle reaches, and the pixels that follow from it.

use super::{facing::Culled, region::Region, rule::Uncertainty, sample::Sample, vertex::Vertex};
use crate::numbers::{Bounds, Format};

/// The smallest and the largest coordinates of three vertices, or of two opposite corners of a rectangle, in
/// steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Extent {
    pub(super) left: i32,
    pub(super) right: i32,
    pub(super) top: i32,
    pub(super) bottom: i32,
}

impl Extent {
    /// The extent of a triangle.
    #[inline]
    pub(crate) fn of<F: Format>([a, b, c]: [Vertex<F>; 3]) -> Self {
        Self {
            left: a.x().min(b.x()).min(c.x()),
            right: a.x().max(b.x()).max(c.x()),
            top: a.y().min(b.y()).min(c.y()),
            bottom: a.y().max(b.y()).max(c.y()),
        }
    }

    /// Whether it does not reach into a region.
    #[inline]
    pub(crate) const fn is_outside<F: Format>(self, region: Region<F>) -> bool {
        let bits = F::SUBPIXEL_BITS;
        self.right <= (region.x0() as i32) << bits
            || self.left >= (region.x1() as i32) << bits
            || self.bottom <= (region.y0() as i32) << bits
            || self.top >= (region.y1() as i32) << bits
    }

    /// The pixels of `region` whose samples lie within the half-open extent, `min <= position < max`.
    ///
    /// # Errors
    ///
    /// [`Culled::NoSample`] where there are none.
    #[inline]
    pub(crate) fn bounds<F: Format>(self, sample: Sample<F>, region: Region<F>) -> Result<Region<F>, Culled> {
        let (x0, x1) = sample.columns(self.left, self.right);
        let (y0, y1) = sample.rows(self.top, self.bottom);
        let pixel = |v: i32| v.max(0) as u32;
        region.cut(pixel(x0), pixel(y0), pixel(x1), pixel(y1)).ok_or(Culled::NoSample)
    }

    /// The pixels that the closed rectangle, grown by the uncertainty, has a point of.
    ///
    /// Pixel i is `[i, i + 1)`: with h the uncertainty it is touched where `left - h < i + 1` and
    /// `right + h >= i`. In whole steps, h a half or 0: where `left - 2 h < i + 1` and `right >= i`.
    #[inline]
    pub(crate) const fn touched<F: Format>(self, uncertainty: Uncertainty) -> Pixels {
        let less = uncertainty.doubled();
        Pixels {
            x0: (self.left - less) >> F::SUBPIXEL_BITS,
            x1: (self.right >> F::SUBPIXEL_BITS) + 1,
            y0: (self.top - less) >> F::SUBPIXEL_BITS,
            y1: (self.bottom >> F::SUBPIXEL_BITS) + 1,
        }
    }

    /// The pixels whose closed squares lie in the closed rectangle, the uncertainty taken off its sides:
    /// `left + h <= i` and `i + 1 <= right - h`, which in whole steps is `left + 2 h <= i` and
    /// `i + 1 <= right - 2 h`.
    #[inline]
    pub(crate) const fn inside<F: Format>(self, uncertainty: Uncertainty) -> Pixels {
        let less = uncertainty.doubled();
        let up = Bounds::<F>::STEPS_PER_PIXEL - 1;
        Pixels {
            x0: (self.left + less + up) >> F::SUBPIXEL_BITS,
            x1: (self.right - less) >> F::SUBPIXEL_BITS,
            y0: (self.top + less + up) >> F::SUBPIXEL_BITS,
            y1: (self.bottom - less) >> F::SUBPIXEL_BITS,
        }
    }
}

/// Columns `x0..x1` and rows `y0..y1`, of any target or beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pixels {
    pub(super) x0: i32,
    pub(super) x1: i32,
    pub(super) y0: i32,
    pub(super) y1: i32,
}

impl Pixels {
    /// Those in a region; `None` where there are none.
    #[inline]
    pub(crate) fn within<F: Format>(self, region: Region<F>) -> Option<Region<F>> {
        let pixel = |v: i32| v.max(0) as u32;
        region.cut(pixel(self.x0), pixel(self.y0), pixel(self.x1), pixel(self.y1))
    }

    /// Whether there is none beside the region.
    #[inline]
    pub(crate) const fn are_all_in<F: Format>(self, region: Region<F>) -> bool {
        self.x0 >= region.x0() as i32
            && self.x1 <= region.x1() as i32
            && self.y0 >= region.y0() as i32
            && self.y1 <= region.y1() as i32
    }
}
