//! Boxes against the view frustum, never wrong about one that is left out.
//!
//! A vertex is outside a plane of the frustum where a . (x, y, z, 1) < 0, the plane's a being sums of two
//! columns of the matrix. Over a box that is largest where each of x, y and z is at one of its ends. What
//! rounding can change, there and in the vertices' own clip coordinates (products and sums of four terms
//! each, so less than 2^-21 of the sum of magnitudes), is far below the margin of 2^-19 of that sum.

use super::meshlet::Meshlet;
use fearless_simd::{Simd, f32x8, prelude::*};

/// The planes of a frustum, one in each lane: x >= -w, x <= w, y >= -w, y <= w, z >= 0, z <= w, w >= 0.
#[derive(Clone, Copy)]
pub(super) struct Frustum<S: Simd> {
    simd: S,
    /// The planes' coefficients of x, y, z and 1.
    rows: [f32x8<S>; 4],
    /// Sums of magnitudes that these are sums of.
    sizes: [f32x8<S>; 4],
}

/// Of magnitudes: more than all rounding.
const MARGIN: f32 = 1.0 / 524_288.0;

impl<S: Simd> Frustum<S> {
    /// Of a matrix in rows.
    #[inline(always)]
    pub(super) fn new(simd: S, matrix: &[[f32; 4]; 4]) -> Self {
        let [r0, r1, r2, r3] = matrix;
        Self {
            simd,
            rows: [row(simd, r0), row(simd, r1), row(simd, r2), row(simd, r3)],
            sizes: [size(simd, r0), size(simd, r1), size(simd, r2), size(simd, r3)],
        }
    }

    /// Whether all of a meshlet's triangles are outside one of the planes, so that every draw would say
    /// so of each. `false` where that is not certain.
    #[inline(always)]
    pub(super) fn excludes(&self, meshlet: &Meshlet) -> bool {
        let ([a, b, c, d], [sa, sb, sc, sd]) = (self.rows, self.sizes);
        let ([x0, y0, z0], [x1, y1, z1]) = (meshlet.low, meshlet.high);
        let zero = f32x8::splat(self.simd, 0.0);
        // Where the coefficient is positive, the upper end is further inside.
        let value = (a * x1).max(a * x0) + (b * y1).max(b * y0) + (c * z1).max(c * z0) + d;
        let [x, y, z] = [x0.abs().max(x1.abs()), y0.abs().max(y1.abs()), z0.abs().max(z1.abs())];
        let magnitude = sa * x + sb * y + sc * z + sd;
        let margin = magnitude * f32x8::splat(self.simd, MARGIN) + f32x8::splat(self.simd, f32::MIN_POSITIVE);
        // NaN and infinities compare to false, or make the sum positive.
        (value + margin).simd_lt(zero).any_true() && magnitude.is_finite().all_true()
    }
}

/// The planes' coefficients of one row of the matrix; 0 in a lane without a plane.
#[inline(always)]
fn row<S: Simd>(simd: S, &[x, y, z, w]: &[f32; 4]) -> f32x8<S> {
    f32x8::simd_from(simd, [w + x, w - x, w + y, w - y, z, w - z, w, 0.0])
}

#[inline(always)]
fn size<S: Simd>(simd: S, row: &[f32; 4]) -> f32x8<S> {
    let [x, y, z, w] = row.map(f32::abs);
    f32x8::simd_from(simd, [w + x, w + x, w + y, w + y, z, w + z, w, 0.0])
}
