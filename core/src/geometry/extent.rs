//! How far a triangle reaches, and the pixels that follow from it.

use super::{facing::Culled, region::Region, sample::Sample, vertex::Vertex};
use crate::numbers::Format;

/// The smallest and the largest coordinates of three vertices, in steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    left: i32,
    right: i32,
    top: i32,
    bottom: i32,
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
}
