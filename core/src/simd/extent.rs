//! How far triangles reach: the pixels inside their bounds, and which way of drawing they are small
//! enough for.

use super::ops::splat;
use crate::{draw::State, geometry::Region, numbers::Standard};
use fearless_simd::{Simd, i32x16, mask32x16, prelude::*};

/// Extents of triangles that the fast path draws are below this, in steps: 120 pixels.
pub(super) const SMALL_EXTENT: i32 = 120 << 8;

/// Small triangles lie within a window of this many blocks each way.
pub(super) const SMALL: i32 = 2;

/// Medium ones lie within a window of this many columns and rows of blocks: at most 30 pixels wide, so
/// that a row is a mask of 32 bits.
pub(super) const MEDIUM: [i32; 2] = [7, 16];

/// Extents of small and medium triangles are below this, in steps: what of them lies outside the
/// region is not far away either, so edge values of all rows of the window are exact in `f32`.
const MEDIUM_EXTENT: i32 = 72 << 8;
// From a vertex to a sample of the window: the extent, up to 3 pixels of rounding, the window's rows.
const _: () = assert!({
    let reach = MEDIUM_EXTENT as i64 + ((8 + 4 * MEDIUM[1] as i64) << 8);
    (2 * MEDIUM_EXTENT as i64 * reach) >> 8 < 1 << 23
});

/// The constants of a draw's bounds.
#[derive(Clone, Copy)]
pub(super) struct Extent<S: Simd> {
    simd: S,
    /// Added to a coordinate before the shift to the first pixel whose sample is not before it.
    up: [i32x16<S>; 2],
    /// x0, x1, y0, y1 in pixels.
    region: [i32x16<S>; 4],
}

/// The bounds of sixteen triangles in pixels.
#[derive(Clone, Copy)]
pub(super) struct PixelBounds<S: Simd> {
    simd: S,
    /// x0, x1, y0, y1 inside the region, half-open.
    pub(super) inside: [i32x16<S>; 4],
    /// Columns and rows of blocks that hold them.
    pub(super) blocks: [i32x16<S>; 2],
    /// Of medium extent, and no row outside the region.
    compact: mask32x16<S>,
}

impl<S: Simd> Extent<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, region: Region<Standard>, state: &State<Standard>) -> Self {
        let (sample_x, sample_y) = state.sample.of_pixel(0, 0);
        Self {
            simd,
            up: [splat(simd, 255 - sample_x), splat(simd, 255 - sample_y)],
            region: [
                splat(simd, region.x0() as i32),
                splat(simd, region.x1() as i32),
                splat(simd, region.y0() as i32),
                splat(simd, region.y1() as i32),
            ],
        }
    }

    /// The pixels of triangles with these extremes: as `Triangle::bounds`.
    #[inline(always)]
    pub(super) fn bounds(&self, [left, right, top, bottom]: [i32x16<S>; 4]) -> PixelBounds<S> {
        let ([up_x, up_y], [x0, x1, y0, y1]) = (self.up, self.region);
        let (first_row, end_row) = ((top + up_y) >> 8, (bottom + up_y) >> 8);
        let inside =
            [((left + up_x) >> 8).max(x0), ((right + up_x) >> 8).min(x1), first_row.max(y0), end_row.min(y1)];
        let extent = (right - left).max(bottom - top);
        let compact =
            extent.simd_lt(splat(self.simd, MEDIUM_EXTENT)) & first_row.simd_ge(y0) & end_row.simd_le(y1);
        let [x0, x1, y0, y1] = inside;
        let three = splat(self.simd, 3);
        let blocks = [((x1 + three) >> 2) - (x0 >> 2), ((y1 + three) >> 2) - (y0 >> 2)];
        PixelBounds { simd: self.simd, inside, blocks, compact }
    }
}

impl<S: Simd> PixelBounds<S> {
    /// Those without a pixel.
    #[inline(always)]
    pub(super) fn empty(&self) -> mask32x16<S> {
        let [x0, x1, y0, y1] = self.inside;
        x0.simd_ge(x1) | y0.simd_ge(y1)
    }

    /// Those that are [`SMALL`].
    #[inline(always)]
    pub(super) fn small(&self) -> mask32x16<S> {
        self.within([SMALL; 2])
    }

    /// Those that are [`MEDIUM`] at most.
    #[inline(always)]
    pub(super) fn medium(&self) -> mask32x16<S> {
        self.within(MEDIUM)
    }

    #[inline(always)]
    fn within(&self, [columns, rows]: [i32; 2]) -> mask32x16<S> {
        let [wide, high] = self.blocks;
        self.compact & wide.simd_le(splat(self.simd, columns)) & high.simd_le(splat(self.simd, rows))
    }
}
