//! The vertex stage: object space to snapped window vertices, eight at a time.

use crate::{
    numbers::{DEPTH32_MAX, DEPTH32_MIN, Standard},
    transform::{ModelPositions, Plane, Viewport},
};
use fearless_simd::{Simd, f32x4, f32x8, i32x8, mask32x8, prelude::*, u32x4, u32x8};

/// One vertex after the vertex stage: scratch memory that a draw fills and reads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(align(16))]
pub struct Snapped(pub(super) [u32; 4]);

/// x of a vertex that has no window position of its own: it must be clipped, or is not finite. The
/// low bits tell the frustum planes that exclude it.
pub(super) const SPECIAL: i32 = i32::MIN;
/// The bits of a special x that hold planes.
pub(super) const PLANES: i32 = 0xFF;
/// Larger w are left to the scalar path: products with the guard band's factors stay finite.
const MAX_W: f32 = 1e30;

/// Stands for an index beyond the vertices, which a draw has refused: outside every plane.
pub(super) const MISSING: Snapped = Snapped([(SPECIAL | PLANES) as u32, 0, 0, 0]);

/// [`Snapped`] for one vertex, by the definitions.
fn snap_one(clip: [f32; 4], viewport: &Viewport<Standard>, planes: &[Plane; 7]) -> Snapped {
    let finite = clip.iter().all(|v| v.is_finite());
    let outside = planes.iter().any(|plane| plane.excludes(clip));
    let [.., w] = clip;
    match viewport.project(clip) {
        Some(vertex) if finite && !outside && w <= MAX_W => {
            Snapped([vertex.x() as u32, vertex.y() as u32, vertex.z(), 0])
        }
        _ => {
            let mut code = 0;
            if finite {
                for (bit, plane) in Plane::FRUSTUM.iter().enumerate() {
                    code |= i32::from(plane.excludes(clip)) << bit;
                }
            }
            Snapped([(SPECIAL | code) as u32, 0, 0, 0])
        }
    }
}

/// Fills `records` with the vertices of `source`, as many as both have.
#[inline(always)]
pub(super) fn stage<S: Simd>(simd: S, source: &ModelPositions<'_, Standard>, records: &mut [Snapped]) {
    simd.vectorize(
        #[inline(always)]
        || stage_inline(simd, source, records),
    );
}

#[inline(always)]
fn stage_inline<S: Simd>(simd: S, source: &ModelPositions<'_, Standard>, records: &mut [Snapped]) {
    let lanes = VertexLanes::new(simd, source);
    let (eights, rest) = source.vertices().as_chunks::<8>();
    for (eight, out) in eights.iter().zip(records.as_chunks_mut::<8>().0) {
        lanes.eight(simd, eight, out);
    }
    let done = source.vertices().len() - rest.len();
    for (at, out) in records.iter_mut().enumerate().skip(done) {
        if let Some(clip) = source.clip(at) {
            *out = snap_one(clip, source.viewport(), source.planes());
        }
    }
}

struct VertexLanes<S: Simd> {
    matrix: [[f32x8<S>; 4]; 4],
    half: [f32x8<S>; 2],
    center: [f32x8<S>; 2],
    guard: [f32x8<S>; 4],
}

impl<S: Simd> VertexLanes<S> {
    #[inline(always)]
    fn new(simd: S, source: &ModelPositions<'_, Standard>) -> Self {
        let splat = |v: f32| f32x8::splat(simd, v);
        let m = source.matrix();
        let row = |r: usize| [splat(m[r][0]), splat(m[r][1]), splat(m[r][2]), splat(m[r][3])];
        let v = source.viewport();
        let ([hw, hh], [cx, cy], [l, r, t, b]) = (v.half_size(), v.center(), v.guard_band());
        Self {
            matrix: [row(0), row(1), row(2), row(3)],
            half: [splat(hw), splat(hh)],
            center: [splat(cx), splat(cy)],
            guard: [splat(l), splat(r), splat(t), splat(b)],
        }
    }

    #[inline(always)]
    fn eight(&self, simd: S, positions: &[[f32; 3]; 8], out: &mut [Snapped; 8]) {
        let [px, py, pz] = transpose3(simd, positions);
        let [[m00, m01, m02, m03], [m10, m11, m12, m13], [m20, m21, m22, m23], [m30, m31, m32, m33]] =
            self.matrix;
        let x = px * m00 + py * m10 + pz * m20 + m30;
        let y = px * m01 + py * m11 + pz * m21 + m31;
        let z = px * m02 + py * m12 + pz * m22 + m32;
        let w = px * m03 + py * m13 + pz * m23 + m33;
        let zero = f32x8::splat(simd, 0.0);
        let [left, right, top, bottom] = self.guard;
        let inside = z.simd_ge(zero)
            & z.simd_le(w)
            & w.simd_ge(f32x8::splat(simd, f32::MIN_POSITIVE))
            & w.simd_le(f32x8::splat(simd, MAX_W))
            & x.simd_ge(left * w)
            & x.simd_le(right * w)
            & y.simd_le(top * w)
            & y.simd_ge(bottom * w);
        let ([half_width, half_height], [center_x, center_y]) = (self.half, self.center);
        let wx = snap(simd, center_x + x / w * half_width);
        let wy = snap(simd, center_y - y / w * half_height);
        let wz = unorm32(simd, z / w);
        let wx = if inside.all_true() {
            wx
        } else {
            let code = frustum_code(simd, [x, y, z, w]);
            inside.select(wx, code)
        };
        store4(simd, wx.bitcast(), wy.bitcast(), wz, out);
    }
}

/// Pixels to steps, to nearest with ties to even: exact below 2^23 steps.
#[inline(always)]
fn snap<S: Simd>(simd: S, pixels: f32x8<S>) -> i32x8<S> {
    i32x8::truncate_from((pixels * f32x8::splat(simd, 256.0)).round_ties_even())
}

/// `value` in the lanes of the mask, 0 elsewhere.
#[inline(always)]
fn bit<S: Simd>(simd: S, mask: mask32x8<S>, value: i32) -> i32x8<S> {
    mask.select(i32x8::splat(simd, value), i32x8::splat(simd, 0))
}

/// SPECIAL with a bit for each plane of `Plane::FRUSTUM` that excludes the vertex, in that order; no
/// bit where a component is not finite.
#[inline(always)]
fn frustum_code<S: Simd>(simd: S, [x, y, z, w]: [f32x8<S>; 4]) -> i32x8<S> {
    let zero = f32x8::splat(simd, 0.0);
    let code = bit(simd, z.simd_lt(zero), 1)
        | bit(simd, z.simd_gt(w), 2)
        | bit(simd, w.simd_lt(f32x8::splat(simd, f32::MIN_POSITIVE)), 4)
        | bit(simd, x.simd_lt(-w), 8)
        | bit(simd, x.simd_gt(w), 16)
        | bit(simd, y.simd_gt(w), 32)
        | bit(simd, y.simd_lt(-w), 64);
    let finite = x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite();
    finite.select(code, i32x8::splat(simd, 0)) | i32x8::splat(simd, SPECIAL)
}

/// `crate::unorm32` of depths in [0, 1], kept in the vertices' range.
///
/// z (2^32 - 1) + 1/2 = Z + f - z + 1/2 with Z + f = z 2^32, an integer and a fraction that are exact
/// floats in two halves of 16 bits. Floor adds 1 to Z where f - 1/2 >= z, which is exact as well, and
/// takes 1 away where z > 1/2 (f is 0 there).
#[inline(always)]
fn unorm32<S: Simd>(simd: S, z: f32x8<S>) -> u32x8<S> {
    let digit = f32x8::splat(simd, 65536.0);
    let half = f32x8::splat(simd, 0.5);
    let high = z * digit;
    let high_whole = high.trunc();
    let low = (high - high_whole) * digit;
    let low_whole = low.trunc();
    let fraction = low - low_whole;
    let one = u32x8::splat(simd, 1);
    let none = u32x8::splat(simd, 0);
    let up = (fraction - half).simd_ge(z).select(one, none);
    let down = z.simd_gt(half).select(one, none);
    let high: u32x8<S> = i32x8::truncate_from(high_whole).bitcast();
    let low: u32x8<S> = i32x8::truncate_from(low_whole).bitcast();
    let value = (high << 16) + low + up - down;
    value.max(u32x8::splat(simd, DEPTH32_MIN)).min(u32x8::splat(simd, DEPTH32_MAX))
}

/// x, y and z of eight positions.
#[inline(always)]
fn transpose3<S: Simd>(simd: S, positions: &[[f32; 3]; 8]) -> [f32x8<S>; 3] {
    let flat = positions.as_flattened();
    let (x0, y0, z0) = transpose4(simd, flat, 0);
    let (x1, y1, z1) = transpose4(simd, flat, 12);
    [simd.combine_f32x4(x0, x1), simd.combine_f32x4(y0, y1), simd.combine_f32x4(z0, z1)]
}

/// x, y and z of the four positions from `flat[at]` on.
#[inline(always)]
fn transpose4<S: Simd>(simd: S, flat: &[f32], at: usize) -> (f32x4<S>, f32x4<S>, f32x4<S>) {
    let (a, b) = (load(simd, flat, at), load(simd, flat, at + 3));
    let (c, d) = (load(simd, flat, at + 6), load(simd, flat, at + 9));
    // a0 c0 a1 c1 and b0 d0 b1 d1, and so on.
    let (ac, bd) = (a.zip_low(c), b.zip_low(d));
    (ac.zip_low(bd), ac.zip_high(bd), a.zip_high(c).zip_low(b.zip_high(d)))
}

/// Three floats, and a fourth lane that does not matter.
#[inline(always)]
fn load<S: Simd>(simd: S, flat: &[f32], at: usize) -> f32x4<S> {
    match (flat.get(at..at + 4), flat.get(at..at + 3)) {
        (Some(&[x, y, z, next]), _) => f32x4::simd_from(simd, [x, y, z, next]),
        (None, Some(&[x, y, z])) => f32x4::simd_from(simd, [x, y, z, 0.0]),
        _ => f32x4::splat(simd, 0.0),
    }
}

/// Eight records from their three components.
#[inline(always)]
fn store4<S: Simd>(simd: S, x: u32x8<S>, y: u32x8<S>, z: u32x8<S>, out: &mut [Snapped; 8]) {
    let ((x0, x1), (y0, y1), (z0, z1)) = (simd.split_u32x8(x), simd.split_u32x8(y), simd.split_u32x8(z));
    let zero = u32x4::splat(simd, 0);
    let [a, b, c, d, e, f, g, h] = out;
    store_pair(x0.zip_low(z0), y0.zip_low(zero), a, b);
    store_pair(x0.zip_high(z0), y0.zip_high(zero), c, d);
    store_pair(x1.zip_low(z1), y1.zip_low(zero), e, f);
    store_pair(x1.zip_high(z1), y1.zip_high(zero), g, h);
}

/// Two records from x z x z and y 0 y 0.
#[inline(always)]
fn store_pair<S: Simd>(xz: u32x4<S>, y: u32x4<S>, first: &mut Snapped, second: &mut Snapped) {
    xz.zip_low(y).store_slice(&mut first.0);
    xz.zip_high(y).store_slice(&mut second.0);
}
