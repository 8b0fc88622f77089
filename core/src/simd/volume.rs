//! What questions can be about.

use crate::{
    geometry::Sample,
    numbers::Standard,
    transform::{Bound, Frustum, Viewport},
};

mod sealed {
    pub trait Sealed {}
}
use sealed::Sealed;

/// A volume of object space round what may be drawn: a box between two corners, the smallest x, y and z and the
/// largest, `[[f32; 3]; 2]`; or a sphere, its centre and its radius, `([f32; 3], f32)`.
pub trait Volume: Copy + Sealed {
    /// Whether it is all outside a frustum.
    #[doc(hidden)]
    fn is_outside(self, frustum: &Frustum) -> bool;

    /// What it can cover.
    #[doc(hidden)]
    fn bound(
        self,
        viewport: &Viewport<Standard>,
        matrix: &[[f32; 4]; 4],
        sample: Sample<Standard>,
    ) -> Bound<Standard>;
}

impl Sealed for [[f32; 3]; 2] {}

impl Volume for [[f32; 3]; 2] {
    #[inline(always)]
    fn is_outside(self, frustum: &Frustum) -> bool {
        frustum.excludes_box(self)
    }

    #[inline(always)]
    fn bound(
        self,
        viewport: &Viewport<Standard>,
        matrix: &[[f32; 4]; 4],
        sample: Sample<Standard>,
    ) -> Bound<Standard> {
        viewport.bound_box(matrix, self, sample)
    }
}

impl Sealed for ([f32; 3], f32) {}

impl Volume for ([f32; 3], f32) {
    #[inline(always)]
    fn is_outside(self, frustum: &Frustum) -> bool {
        let (center, radius) = self;
        frustum.excludes_sphere(center, radius)
    }

    #[inline(always)]
    fn bound(
        self,
        viewport: &Viewport<Standard>,
        matrix: &[[f32; 4]; 4],
        sample: Sample<Standard>,
    ) -> Bound<Standard> {
        let (center, radius) = self;
        viewport.bound_sphere(matrix, center, radius, sample)
    }
}
