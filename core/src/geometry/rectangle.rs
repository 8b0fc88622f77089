//! Axis-aligned rectangles, and the pixels that they touch and contain.

use super::{extent::Extent, region::Region, rule::Uncertainty};
use crate::numbers::{Coordinate, Format};
use core::marker::PhantomData;

/// A closed axis-aligned rectangle between two corners, in steps of 2^-S px; a segment or a point where
/// coordinates are equal.
///
/// Its answers are exact, and those of the rectangle as two triangles, at a few additions: for scissors in
/// fractions of a pixel, glyphs, rectangles of user interfaces, bounds of objects.
///
/// ```
/// use halfplane::{Coordinate, Rectangle, Region, Small, Uncertainty};
///
/// // 1/16 px: from (1, 1) to (3 1/16, 3).
/// let at = |steps| Coordinate::<Small>::from_steps(steps).unwrap();
/// let rectangle = Rectangle::new([at(16), at(16)], [at(49), at(48)]);
/// let region = Region::of_size(64, 64)?;
/// // Row 3 begins at y = 3, where the rectangle's last points are.
/// assert_eq!(rectangle.touched(region, Uncertainty::None), Region::new(1, 1, 4, 4).ok());
/// assert_eq!(rectangle.inside(region, Uncertainty::None), Region::new(1, 1, 3, 3).ok());
/// // Before it was snapped its top may have been at 31/32, and its right end before 3 1/16.
/// assert_eq!(rectangle.touched(region, Uncertainty::HalfStep), Region::new(0, 0, 4, 4).ok());
/// assert_eq!(rectangle.inside(region, Uncertainty::HalfStep), None);
/// # Ok::<(), halfplane::RegionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rectangle<F> {
    extent: Extent,
    format: PhantomData<F>,
}

impl<F: Format> Rectangle<F> {
    /// The rectangle between two opposite corners (x, y), in any order.
    #[inline]
    #[must_use]
    pub fn new([x0, y0]: [Coordinate<F>; 2], [x1, y1]: [Coordinate<F>; 2]) -> Self {
        let extent = Extent {
            left: x0.min(x1).steps(),
            right: x0.max(x1).steps(),
            top: y0.min(y1).steps(),
            bottom: y0.max(y1).steps(),
        };
        Self { extent, format: PhantomData }
    }

    /// The pixels of `region` with a point of the rectangle, grown by the uncertainty; `None` where there
    /// are none. A pixel is the half-open square `[i, i + 1) x [j, j + 1)`.
    #[inline]
    #[must_use]
    pub fn touched(self, region: Region<F>, uncertainty: Uncertainty) -> Option<Region<F>> {
        self.extent.touched::<F>(uncertainty).within(region)
    }

    /// The pixels of `region` that lie wholly in the rectangle, their borders included, shrunk by the
    /// uncertainty; `None` where there are none.
    #[inline]
    #[must_use]
    pub fn inside(self, region: Region<F>, uncertainty: Uncertainty) -> Option<Region<F>> {
        self.extent.inside::<F>(uncertainty).within(region)
    }
}
