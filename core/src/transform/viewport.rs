//! The viewport: from normalised device coordinates to snapped window vertices.

use crate::{
    geometry::{Region, Vertex},
    numbers::{Bounds, Coordinate, Format, unorm32},
};

/// Maps x/w and y/w from [-1, 1] to a region of the target, y turned downwards. No pixel outside the
/// region is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport<F> {
    region: Region<F>,
    half_width: f32,
    half_height: f32,
    center_x: f32,
    center_y: f32,
}

impl<F: Format> Viewport<F> {
    /// The viewport that fills `region`.
    #[must_use]
    pub fn new(region: Region<F>) -> Self {
        // Whole and half pixels below 2^14: exact.
        let half = |v: u32| v as f32 * 0.5;
        Self {
            region,
            half_width: half(region.width()),
            half_height: half(region.height()),
            center_x: half(region.x0() + region.x1()),
            center_y: half(region.y0() + region.y1()),
        }
    }

    /// The pixels it maps to.
    #[must_use]
    pub const fn region(&self) -> Region<F> {
        self.region
    }

    /// The window vertex of a clip-space vertex: X = center_x + (x/w) W/2, Y = center_y - (y/w) H/2,
    /// snapped to the nearest step with ties to even; depth z/w as the nearest unorm32 (Direct3D
    /// 11.3, 15.6 and 3.2.4.1). `None` where a quotient is NaN.
    ///
    /// Vertices beyond the guard band end on it: clip those first, as
    /// [`ClipPositions`](super::ClipPositions) does.
    #[inline(always)]
    #[must_use]
    pub fn project(&self, [x, y, z, w]: [f32; 4]) -> Option<Vertex<F>> {
        let window_x = self.center_x + x / w * self.half_width;
        let window_y = self.center_y - y / w * self.half_height;
        let depth = z / w;
        if depth.is_nan() {
            return None;
        }
        let (x, y) = (Coordinate::snap(window_x)?, Coordinate::snap(window_y)?);
        Some(Vertex::at(x, y, unorm32(depth)))
    }

    /// Half the width and the height, in pixels.
    pub(crate) const fn half_size(&self) -> [f32; 2] {
        [self.half_width, self.half_height]
    }

    /// The centre, in pixels from the target's origin.
    pub(crate) const fn center(&self) -> [f32; 2] {
        [self.center_x, self.center_y]
    }

    /// The guard band in clip space: `[left, right, top, bottom]` such that `left w <= x <= right w`
    /// and `bottom w <= y <= top w` keep a vertex within [`Bounds::CLIP_PIXELS`] of the target's
    /// origin, but for rounding.
    pub(crate) fn guard_band(&self) -> [f32; 4] {
        let limit = Bounds::<F>::CLIP_PIXELS as f32;
        [
            (-limit - self.center_x) / self.half_width,
            (limit - self.center_x) / self.half_width,
            (self.center_y + limit) / self.half_height,
            (self.center_y - limit) / self.half_height,
        ]
    }
}
