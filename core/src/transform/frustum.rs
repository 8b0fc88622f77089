//! Boxes and spheres against the view frustum, never wrong about one that is left out.

use super::viewport::Viewport;
use crate::{geometry::Region, numbers::Format};

/// The view frustum of a matrix: x >= -w, x <= w, y >= -w, y <= w, z >= 0, z <= w and w >= 0, as planes of object
/// space.
///
/// A vertex is outside a plane where a . (x, y, z, 1) < 0, the plane's a being sums of two columns of the matrix.
/// What rounding can change, there and in the vertices' own clip coordinates (products and sums of four terms
/// each, so less than 2^-21 of the sum of magnitudes), is far below the margin of 2^-19 of that sum.
#[derive(Clone, Copy, Debug)]
pub struct Frustum {
    /// The planes' coefficients of x, y, z and 1, one plane in each lane.
    rows: [[f32; 8]; 4],
    /// Sums of magnitudes that these are sums of.
    sizes: [[f32; 8]; 4],
}

/// Of magnitudes: more than all rounding.
const MARGIN: f32 = 1.0 / 524_288.0;

/// Pixels round an area that are taken for inside: more than snapping and rounding move a vertex.
const PIXELS: f32 = 0.25;

impl Frustum {
    /// Of a matrix in rows, as in [`ModelPositions`](super::ModelPositions).
    #[inline(always)]
    #[must_use]
    pub fn new(matrix: &[[f32; 4]; 4]) -> Self {
        Self::between(matrix, [-1.0, 1.0, -1.0, 1.0])
    }

    /// Of the part of a viewport that is in `area`: a scissor, or one thread's band. What it leaves out is outside
    /// the area in every draw.
    #[inline(always)]
    #[must_use]
    pub fn of_area<F: Format>(matrix: &[[f32; 4]; 4], viewport: &Viewport<F>, area: Region<F>) -> Self {
        let ([half_width, half_height], [center_x, center_y]) = (viewport.half_size(), viewport.center());
        let [x0, y0, x1, y1] = [area.x0(), area.y0(), area.x1(), area.y1()].map(|v| v as f32);
        let ends = [
            (x0 - PIXELS - center_x) / half_width,
            (x1 + PIXELS - center_x) / half_width,
            (center_y - y1 - PIXELS) / half_height,
            (center_y - y0 + PIXELS) / half_height,
        ];
        Self::between(matrix, ends.map(|end| end.clamp(-1.0, 1.0)))
    }

    /// Of what is drawn without being clipped: the near and the far plane, and the guard band.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(crate) fn unclipped<F: Format>(matrix: &[[f32; 4]; 4], viewport: &Viewport<F>) -> Self {
        let [left, right, top, bottom] = viewport.guard_band();
        Self::between(matrix, [left, right, bottom, top])
    }

    /// Of what has left w <= x <= right w and bottom w <= y <= top w.
    #[inline(always)]
    fn between(matrix: &[[f32; 4]; 4], [left, right, bottom, top]: [f32; 4]) -> Self {
        // 0 in a lane without a plane.
        let row = |[x, y, z, w]: [f32; 4]| {
            [x - left * w, right * w - x, y - bottom * w, top * w - y, z, w - z, w, 0.0]
        };
        let size = |row: [f32; 4]| {
            let [x, y, z, w] = row.map(f32::abs);
            let side = |end: f32, v: f32| end.abs().max(1.0) * w + v;
            [side(left, x), side(right, x), side(bottom, y), side(top, y), z, w + z, w, 0.0]
        };
        Self { rows: matrix.map(row), sizes: matrix.map(size) }
    }

    /// Whether everything in the box between two corners, the smallest x, y and z and the largest, is outside one
    /// of the planes, so that every draw would say so of each triangle there. `false` where that is not certain.
    #[inline(always)]
    #[must_use]
    pub fn excludes_box(&self, [[x0, y0, z0], [x1, y1, z1]]: [[f32; 3]; 2]) -> bool {
        let ([a, b, c, d], [sa, sb, sc, sd]) = (self.rows, self.sizes);
        let [x, y, z] =
            [greater(x0.abs(), x1.abs()), greater(y0.abs(), y1.abs()), greater(z0.abs(), z1.abs())];
        let (mut outside, mut finite) = (false, true);
        for k in 0..8 {
            // Where the coefficient is positive, the upper end is further inside.
            let value = greater(a[k] * x1, a[k] * x0)
                + greater(b[k] * y1, b[k] * y0)
                + greater(c[k] * z1, c[k] * z0)
                + d[k];
            let magnitude = sa[k] * x + sb[k] * y + sc[k] * z + sd[k];
            // NaN and infinities compare to false, or make the sum positive.
            outside |= value + (magnitude * MARGIN + f32::MIN_POSITIVE) < 0.0;
            finite &= magnitude < f32::INFINITY;
        }
        outside & finite
    }

    /// Whether every vertex in a box is inside all of the planes, rounding allowed for. `false` where that is not
    /// certain.
    #[inline(always)]
    #[must_use]
    pub fn contains_box(&self, [[x0, y0, z0], [x1, y1, z1]]: [[f32; 3]; 2]) -> bool {
        let ([a, b, c, d], [sa, sb, sc, sd]) = (self.rows, self.sizes);
        let [x, y, z] =
            [greater(x0.abs(), x1.abs()), greater(y0.abs(), y1.abs()), greater(z0.abs(), z1.abs())];
        let mut inside = true;
        // Not the last lane, which has no plane.
        for k in 0..7 {
            let value = -greater(-a[k] * x1, -a[k] * x0)
                - greater(-b[k] * y1, -b[k] * y0)
                - greater(-c[k] * z1, -c[k] * z0)
                + d[k];
            let magnitude = sa[k] * x + sb[k] * y + sc[k] * z + sd[k];
            inside &= value > magnitude * MARGIN + f32::MIN_POSITIVE && magnitude < f32::INFINITY;
        }
        inside
    }

    /// [`excludes_box`](Self::excludes_box) for the sphere of a radius, not negative, round a centre.
    #[inline(always)]
    #[must_use]
    pub fn excludes_sphere(&self, [x, y, z]: [f32; 3], radius: f32) -> bool {
        let ([a, b, c, d], [sa, sb, sc, sd]) = (self.rows, self.sizes);
        let (mut outside, mut finite) = (false, true);
        for k in 0..8 {
            let value = a[k] * x + b[k] * y + c[k] * z + d[k];
            let size = sa[k] + sb[k] + sc[k];
            let magnitude = sa[k] * x.abs() + sb[k] * y.abs() + sc[k] * z.abs() + sd[k] + size * radius;
            let value = value + (magnitude * MARGIN + f32::MIN_POSITIVE);
            // The distance is value / |(a, b, c)|; squares, as there is no root, and in `f64`, where none underflows.
            let square = |v: f32| f64::from(v) * f64::from(v);
            let reach = square(radius) * (square(a[k]) + square(b[k]) + square(c[k]));
            outside |= value < 0.0 && square(value) > reach * f64::from(1.0 + MARGIN);
            finite &= magnitude < f32::INFINITY;
        }
        outside & finite
    }
}

/// The greater one; the first where one is NaN.
#[inline(always)]
const fn greater(a: f32, b: f32) -> f32 {
    if b > a { b } else { a }
}
