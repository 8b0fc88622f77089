//! What a box can cover at most, as seen through a viewport; how what is covered follows from the ends of quotients.

use super::viewport::Viewport;
use crate::{
    geometry::{Region, Sample},
    numbers::{Bounds, Format, unorm32},
};

/// What a box or a sphere can cover of a viewport at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound<F> {
    /// No sample.
    Nothing,
    /// Samples of the pixels of `area`, at depths from `depths[0]` to `depths[1]`, in units of 2^-32 as a
    /// [`Vertex`](crate::Vertex) has them.
    Within {
        /// The pixels.
        area: Region<F>,
        /// The smallest and the largest depth.
        depths: [u32; 2],
    },
    /// Any pixel: it reaches the eye's plane, or is not finite.
    Anything,
}

/// Of magnitudes: more than all rounding.
///
/// A clip coordinate is a sum of four terms, three of them products, each operation rounded once in f32: off by
/// at most 4.1 u of the sum of magnitudes S, u = 2^-24, for a vertex and for a box's corner alike; a cut at a
/// plane of the guard band or the frustum adds at most 2 u, and there are 7. A quotient q = x / w is then off by
/// (18.1 u Sx + abs q 18.1 u Sw) / w and its own rounding u q, and the difference of two by twice that:
/// less than 40 u ((Sx + abs q Sw) / w + q), 2.5 2^-20. Products that are no normal floats are off by up to 2^-150
/// each, whatever S: it counts as [`TINY`] more.
pub(super) const MARGIN: f32 = 1.0 / 262_144.0;
/// Times [`MARGIN`] it is 2^-144.
pub(super) const TINY: f32 = f32::MIN_POSITIVE;

/// The smallest and the largest x / w, y / w and z / w.
pub(crate) type Ends = [[f32; 2]; 3];

impl<F: Format> Viewport<F> {
    /// What the box between two corners of object space, and any triangles inside it, can cover at most where
    /// `matrix` takes object space to clip space as in [`ModelPositions`](super::ModelPositions), with samples
    /// at `sample` in each pixel. Rounding in the transform of vertices, here and there, is allowed for.
    ///
    /// Over a box, quotients of two clip coordinates are smallest and largest at corners, as long as w is
    /// positive.
    #[inline(always)]
    #[must_use]
    pub fn bound_box(&self, matrix: &[[f32; 4]; 4], corners: [[f32; 3]; 2], sample: Sample<F>) -> Bound<F> {
        match ends_of_box(matrix, corners) {
            Some(ends) => self.bound(ends, sample),
            None => Bound::Anything,
        }
    }

    /// What is covered at most where quotients have those ends.
    #[inline(always)]
    pub(super) fn bound(&self, ends: Ends, sample: Sample<F>) -> Bound<F> {
        let [[left, right], [bottom, top], [near, far]] = ends;
        if !(left <= right && bottom <= top && near <= far) {
            return Bound::Anything;
        }
        let region = self.region();
        let ([half_width, half_height], [center_x, center_y]) = (self.half_size(), self.center());
        let (offset_x, offset_y) = sample.offset();
        let columns = pixels::<F>([center_x + left * half_width, center_x + right * half_width], offset_x);
        let rows = pixels::<F>([center_y - top * half_height, center_y - bottom * half_height], offset_y);
        match region.cut(columns[0], rows[0], columns[1], rows[1]) {
            Some(area) => Bound::Within { area, depths: [unorm32(near), unorm32(far)] },
            None => Bound::Nothing,
        }
    }
}

/// The ends of quotients over a box and what is in it, rounding allowed for; `None` where w may not be positive, or
/// something is not finite.
#[inline(always)]
pub(super) fn ends_of_box(matrix: &[[f32; 4]; 4], [low, high]: [[f32; 3]; 2]) -> Option<Ends> {
    let [[ax, ay, az, aw], [bx, by, bz, bw], [cx, cy, cz, cw], [dx, dy, dz, dw]] = *matrix;
    let corners = |column| Corners::new(column, low, high);
    let (x, y) = (corners([ax, bx, cx, dx]), corners([ay, by, cy, dy]));
    let (z, w) = (corners([az, bz, cz, dz]), corners([aw, bw, cw, dw]));
    let nearest = least(w.values) - w.size * MARGIN;
    // NaN and infinities compare to false.
    if !(nearest >= f32::MIN_POSITIVE && x.size + y.size + z.size + w.size < f32::INFINITY) {
        return None;
    }
    Some([x.quotients(w, nearest), y.quotients(w, nearest), z.quotients(w, nearest)])
}

/// One clip coordinate at a box's corners.
#[derive(Clone, Copy)]
pub(super) struct Corners {
    pub(super) values: [f32; 8],
    /// The largest sum of the magnitudes of its terms.
    pub(super) size: f32,
}

impl Corners {
    #[inline(always)]
    pub(super) fn new([m0, m1, m2, m3]: [f32; 4], [x0, y0, z0]: [f32; 3], [x1, y1, z1]: [f32; 3]) -> Self {
        let (x0, x1, y0, y1, z0, z1) = (x0 * m0, x1 * m0, y0 * m1, y1 * m1, z0 * m2 + m3, z1 * m2 + m3);
        // NaN where one is.
        let size = |a: f32, b: f32| if a.abs() >= b.abs() || a.is_nan() { a.abs() } else { b.abs() };
        let (a, b, c, d) = (x0 + y0, x1 + y0, x0 + y1, x1 + y1);
        Self {
            values: [a + z0, b + z0, c + z0, d + z0, a + z1, b + z1, c + z1, d + z1],
            size: size(x0, x1) + size(y0, y1) + size(z0, z1) + m3.abs() + m3.abs(),
        }
    }

    /// The smallest and the largest quotient by w, whose least is `nearest`, and a margin.
    #[inline(always)]
    pub(super) fn quotients(self, w: Self, nearest: f32) -> [f32; 2] {
        let mut quotients = self.values;
        for (value, w) in quotients.iter_mut().zip(w.values) {
            *value /= w;
        }
        let (low, high) = (least(quotients), -least(quotients.map(|q| -q)));
        let most = if high > -low { high } else { -low };
        let margin = ((self.size + most * w.size + TINY) / nearest + most) * MARGIN;
        [low - margin, high + margin]
    }
}

#[inline(always)]
fn least(values: [f32; 8]) -> f32 {
    let less = |a: f32, b: f32| if a < b { a } else { b };
    let [a, b, c, d, e, f, g, h] = values;
    less(less(less(a, e), less(b, f)), less(less(c, g), less(d, h)))
}

/// The pixels whose samples, `offset` px from their left or top, are between two window coordinates or less than
/// a margin beside: that of rounding, in the viewport's transform and in snapping.
#[inline(always)]
pub(super) fn pixels<F: Format>([first, last]: [f32; 2], offset: f32) -> [u32; 2] {
    let margin = |v: f32| v.abs() * MARGIN + 1.0 / Bounds::<F>::STEPS_PER_PIXEL as f32;
    // Towards zero: -0.5 becomes pixel 0, as it should. Beyond the range, its ends.
    let (first, last) = (first - offset - margin(first), last - offset + margin(last));
    let whole = first as u32;
    let up = u32::from((whole as f32) < first);
    let end = if last < 0.0 { 0 } else { (last as u32).saturating_add(1) };
    [whole.saturating_add(up), end]
}
