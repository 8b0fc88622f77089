//! The vertex stage: object space to snapped window vertices, sixteen at a time.

use crate::{
    numbers::{DEPTH32_MAX, DEPTH32_MIN, Standard},
    transform::{ModelPositions, Plane, Viewport},
};
use fearless_simd::{Simd, f32x4, f32x16, i32x16, mask32x16, prelude::*, u32x16};

/// What a draw keeps of one vertex in scratch memory: three words.
pub type Snapped = [u32; 3];

/// x of a vertex that has no window position of its own: it must be clipped, or is not finite. The
/// low bits tell the frustum planes that exclude it.
pub(super) const SPECIAL: i32 = i32::MIN;
/// The bits of a special x that hold planes.
pub(super) const PLANES: i32 = 0xFF;
/// Larger w are left to the scalar path: products with the guard band's factors stay finite.
const MAX_W: f32 = 1e30;

/// Memory for as many records as there are [`Snapped`]: places, and depths.
#[inline(always)]
pub(super) fn split(records: &mut [Snapped]) -> (&mut [[u32; 2]], &mut [u32]) {
    let count = records.len();
    match records.as_flattened_mut().split_at_mut_checked(2 * count) {
        Some((places, depths)) => (places.as_chunks_mut().0, depths),
        None => (&mut [], &mut []),
    }
}

/// Place and depth of one vertex, by the definitions.
pub(super) fn snap_one(
    clip: [f32; 4],
    viewport: &Viewport<Standard>,
    planes: &[Plane; 7],
) -> ([u32; 2], u32) {
    let finite = clip.iter().all(|v| v.is_finite());
    let outside = planes.iter().any(|plane| plane.excludes(clip));
    let [.., w] = clip;
    match viewport.project(clip) {
        Some(vertex) if finite && !outside && w <= MAX_W => {
            ([vertex.x() as u32, vertex.y() as u32], vertex.z())
        }
        _ => {
            let mut code = 0;
            if finite {
                for (bit, plane) in Plane::FRUSTUM.iter().enumerate() {
                    code |= i32::from(plane.excludes(clip)) << bit;
                }
            }
            ([(SPECIAL | code) as u32, 0], 0)
        }
    }
}

/// Fills places and depths with the vertices of `source`, as many as all have.
#[inline(always)]
pub(super) fn stage<S: Simd>(
    simd: S,
    source: &ModelPositions<'_, Standard>,
    places: &mut [[u32; 2]],
    depths: &mut [u32],
) {
    let lanes = VertexLanes::new(simd, source);
    let (chunks, rest) = source.vertices().as_chunks::<16>();
    let out = places.as_chunks_mut::<16>().0.iter_mut().zip(depths.as_chunks_mut::<16>().0);
    for (positions, (places, depths)) in chunks.iter().zip(out) {
        lanes.sixteen(simd, transpose3(simd, positions), places, depths);
    }
    let done = source.vertices().len() - rest.len();
    for (at, (place, depth)) in places.iter_mut().zip(depths).enumerate().skip(done) {
        if let Some(clip) = source.clip(at) {
            (*place, *depth) = snap_one(clip, source.viewport(), source.planes());
        }
    }
}

/// The constants of a draw's vertex stage.
pub(super) struct VertexLanes<S: Simd> {
    matrix: [[f32x16<S>; 4]; 4],
    half: [f32x16<S>; 2],
    center: [f32x16<S>; 2],
    guard: [f32x16<S>; 4],
}

impl<S: Simd> VertexLanes<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, source: &ModelPositions<'_, Standard>) -> Self {
        let splat = |v: f32| f32x16::splat(simd, v);
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

    /// The places and depths of sixteen vertices, given their x, y and z.
    #[inline(always)]
    pub(super) fn sixteen(
        &self,
        simd: S,
        [px, py, pz]: [f32x16<S>; 3],
        places: &mut [[u32; 2]; 16],
        depths: &mut [u32; 16],
    ) {
        let [[m00, m01, m02, m03], [m10, m11, m12, m13], [m20, m21, m22, m23], [m30, m31, m32, m33]] =
            self.matrix;
        let x = px * m00 + py * m10 + pz * m20 + m30;
        let y = px * m01 + py * m11 + pz * m21 + m31;
        let z = px * m02 + py * m12 + pz * m22 + m32;
        let w = px * m03 + py * m13 + pz * m23 + m33;
        let zero = f32x16::splat(simd, 0.0);
        let [left, right, top, bottom] = self.guard;
        let inside = z.simd_ge(zero)
            & z.simd_le(w)
            & w.simd_ge(f32x16::splat(simd, f32::MIN_POSITIVE))
            & w.simd_le(f32x16::splat(simd, MAX_W))
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
        let (first, second) = simd.interleave_u32x16(wx.bitcast(), wy.bitcast());
        if let [to_first, to_second] = places.as_flattened_mut().as_chunks_mut::<16>().0 {
            first.store_slice(to_first);
            second.store_slice(to_second);
        }
        wz.store_slice(depths);
    }
}

/// Pixels to steps, to nearest with ties to even: exact below 2^23 steps.
#[inline(always)]
pub(super) fn snap<S: Simd>(simd: S, pixels: f32x16<S>) -> i32x16<S> {
    i32x16::truncate_from((pixels * f32x16::splat(simd, 256.0)).round_ties_even())
}

/// `value` in the lanes of the mask, 0 elsewhere.
#[inline(always)]
fn bit<S: Simd>(simd: S, mask: mask32x16<S>, value: i32) -> i32x16<S> {
    mask.select(i32x16::splat(simd, value), i32x16::splat(simd, 0))
}

/// SPECIAL with a bit for each plane of `Plane::FRUSTUM` that excludes the vertex, in that order; no
/// bit where a component is not finite.
#[inline(always)]
pub(super) fn frustum_code<S: Simd>(simd: S, [x, y, z, w]: [f32x16<S>; 4]) -> i32x16<S> {
    let zero = f32x16::splat(simd, 0.0);
    let code = bit(simd, z.simd_lt(zero), 1)
        | bit(simd, z.simd_gt(w), 2)
        | bit(simd, w.simd_lt(f32x16::splat(simd, f32::MIN_POSITIVE)), 4)
        | bit(simd, x.simd_lt(-w), 8)
        | bit(simd, x.simd_gt(w), 16)
        | bit(simd, y.simd_gt(w), 32)
        | bit(simd, y.simd_lt(-w), 64);
    let finite = x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite();
    finite.select(code, i32x16::splat(simd, 0)) | i32x16::splat(simd, SPECIAL)
}

/// `crate::unorm32` of depths in [0, 1], kept in the vertices' range.
///
/// z (2^32 - 1) + 1/2 = Z + f - z + 1/2 with Z + f = z 2^32, an integer and a fraction that are exact
/// floats in two halves of 16 bits. Floor adds 1 to Z where f - 1/2 >= z, which is exact as well, and
/// takes 1 away where z > 1/2 (f is 0 there).
#[inline(always)]
pub(super) fn unorm32<S: Simd>(simd: S, z: f32x16<S>) -> u32x16<S> {
    let digit = f32x16::splat(simd, 65536.0);
    let half = f32x16::splat(simd, 0.5);
    let high = z * digit;
    let high_whole = i32x16::truncate_from(high);
    let low = (high - f32x16::float_from(high_whole)) * digit;
    let low_whole = i32x16::truncate_from(low);
    let fraction = low - f32x16::float_from(low_whole);
    let one = u32x16::splat(simd, 1);
    let none = u32x16::splat(simd, 0);
    let up = (fraction - half).simd_ge(z).select(one, none);
    let down = z.simd_gt(half).select(one, none);
    let (high, low): (u32x16<S>, u32x16<S>) = (high_whole.bitcast(), low_whole.bitcast());
    let value = (high << 16) + low + up - down;
    value.max(u32x16::splat(simd, DEPTH32_MIN)).min(u32x16::splat(simd, DEPTH32_MAX))
}

/// x, y and z of sixteen positions.
#[inline(always)]
pub(super) fn transpose3<S: Simd>(simd: S, positions: &[[f32; 3]; 16]) -> [f32x16<S>; 3] {
    let flat = positions.as_flattened();
    let (x0, y0, z0) = transpose4(simd, flat, 0);
    let (x1, y1, z1) = transpose4(simd, flat, 12);
    let (x2, y2, z2) = transpose4(simd, flat, 24);
    let (x3, y3, z3) = transpose4(simd, flat, 36);
    [join(simd, [x0, x1, x2, x3]), join(simd, [y0, y1, y2, y3]), join(simd, [z0, z1, z2, z3])]
}

#[inline(always)]
fn join<S: Simd>(simd: S, [a, b, c, d]: [f32x4<S>; 4]) -> f32x16<S> {
    simd.combine_f32x8(simd.combine_f32x4(a, b), simd.combine_f32x4(c, d))
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
