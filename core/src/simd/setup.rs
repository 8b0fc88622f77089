//! Set-up of eight triangles of small extent: 32-bit integers, and doubles that are exact.
//!
//! With an extent below [`SMALL_EXTENT`], bounds rounded out to whole blocks span less than 2^15 steps, so
//! edge values are sums of two products below 2^30, and reduced ones have 23 bits: F = e + 1/2 is an exact
//! `f32`. A crossing -F / A is computed as F times the rounded -1 / A. Its relative error is below
//! 2^-23, so below 128 pixels it is off by less than 2^-16 = 1.526e-5; but F is an odd number of halves,
//! so the exact crossing is at least 1 / (2 |A|) > 1.627e-5 away from every integer. Comparing it with
//! integers is exact.

use super::{
    fetch::{Corner, fetch},
    ops::{i32_to_f64, splat, u32_to_f64},
    vertex::Snapped,
};
use crate::{
    draw::State,
    geometry::Region,
    numbers::{DEPTH16_MAX, DEPTH16_MIN, Standard},
};
use fearless_simd::{Simd, f32x8, f64x8, i32x8, mask32x8, prelude::*, u32x8};

/// Extents of triangles set up here are below this, in steps: 120 pixels.
pub(super) const SMALL_EXTENT: i32 = 120 << 8;

/// Bounds rounded out to whole blocks: up to 3 pixels at each end.
const MAX_SPAN: i32 = SMALL_EXTENT / 256 + 2 * 4;
const _: () = assert!(MAX_SPAN <= 128);
// Edge values, two products of a difference within the extent and one within the rounded bounds.
const _: () = assert!(2 * (SMALL_EXTENT as i64) * (128 << 8) < 1 << 31);
// 128 * 2^-23 (1 + 2^-24) < 1 / (2 |A|), with A < SMALL_EXTENT.
const _: () = assert!(128 * 2 * (SMALL_EXTENT as i64) * ((1 << 24) + 1) < 1 << 47);

/// The crossings of an edge with the rows of samples, for eight triangles.
///
/// With F = e + 1/2 the reduced edge value at a row's first sample plus a half that keeps it from being
/// 0, the edge crosses the row at x = -F / A pixels from there, and a sample is inside iff it is to the
/// right (A > 0), or to the left (A < 0), of that. B is what F grows by from row to row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// F in the first row.
    pub(super) value: [f32; 8],
    /// B.
    pub(super) step: [f32; 8],
    /// -1 / A, rounded; -∞ where A is 0.
    pub(super) factor: [f32; 8],
}

/// Eight triangles, set up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Batch {
    /// A left edge (A > 0), a right one (A < 0), and the third, which is either.
    pub(super) crossings: [Crossing; 3],
    /// +∞ where the third edge is a left one or level (A >= 0), else -∞.
    pub(super) third: [f32; 8],
    /// x0, x1, y0, y1 of the pixels with samples inside the bounds and the region.
    pub(super) bounds: [[i32; 8]; 4],
    /// The depth plane's anchor: x and y in steps, and the depth.
    pub(super) anchor: [[u32; 8]; 3],
    /// The gradients of depth per step to the right and per step down: 32.32 fixed point modulo 2^64.
    pub(super) gradients: [[u64; 8]; 2],
}

impl Batch {
    pub(super) const EMPTY: Self = {
        let none = Crossing { value: [0.0; 8], step: [0.0; 8], factor: [0.0; 8] };
        Self {
            crossings: [none; 3],
            third: [0.0; 8],
            bounds: [[0; 8]; 4],
            anchor: [[0; 8]; 3],
            gradients: [[0; 8]; 2],
        }
    };
}

/// How depths are prepared for interpolation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthSetup {
    /// There is no depth.
    None,
    /// As unorm32.
    D32,
    /// As unorm16 in the upper half.
    D16,
}

/// Sets up eight triangles of small extent and some area.
#[inline(always)]
pub(super) fn set_up<S: Simd>(
    simd: S,
    records: &[Snapped],
    triangles: &[[u32; 3]; 8],
    region: Region<Standard>,
    state: &State<Standard>,
    depth: DepthSetup,
    batch: &mut Batch,
) {
    simd.vectorize(
        #[inline(always)]
        || set_up_eight(simd, records, triangles, region, state, depth, batch),
    );
}

#[inline(always)]
fn set_up_eight<S: Simd>(
    simd: S,
    records: &[Snapped],
    triangles: &[[u32; 3]; 8],
    region: Region<Standard>,
    state: &State<Standard>,
    depth: DepthSetup,
    batch: &mut Batch,
) {
    let [a, b, c] = fetch(simd, records, triangles);
    let (sample_x, sample_y) = state.sample.of_pixel(0, 0);
    // Bounds: as `Triangle::bounds`.
    let up = splat(simd, 255 - sample_x);
    let x0 = ((a.x.min(b.x).min(c.x) + up) >> 8).max(splat(simd, region.x0() as i32));
    let x1 = ((a.x.max(b.x).max(c.x) + up) >> 8).min(splat(simd, region.x1() as i32));
    let up = splat(simd, 255 - sample_y);
    let y0 = ((a.y.min(b.y).min(c.y) + up) >> 8).max(splat(simd, region.y0() as i32));
    let y1 = ((a.y.max(b.y).max(c.y) + up) >> 8).min(splat(simd, region.y1() as i32));
    let [out_x0, out_x1, out_y0, out_y1] = &mut batch.bounds;
    x0.store_slice(out_x0);
    x1.store_slice(out_x1);
    y0.store_slice(out_y0);
    y1.store_slice(out_y1);

    // Clockwise, by an exchange of the last two corners.
    let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    let turned = area.simd_lt(splat(simd, 0));
    let (b, c) = (Corner::select(turned, c, b), Corner::select(turned, b, c));
    // The first sample of the first block.
    let first_x = ((x0 & splat(simd, !3)) << 8) + splat(simd, sample_x);
    let first_y = ((y0 & splat(simd, !3)) << 8) + splat(simd, sample_y);
    let edges = [
        Edge::new(simd, b, c, first_x, first_y),
        Edge::new(simd, c, a, first_x, first_y),
        Edge::new(simd, a, b, first_x, first_y),
    ];
    place_edges(simd, edges, batch);
    if depth == DepthSetup::None {
        return;
    }
    let (az, bz, cz) = if depth == DepthSetup::D16 {
        (unorm16(simd, a.z), unorm16(simd, b.z), unorm16(simd, c.z))
    } else {
        (a.z, b.z, c.z)
    };
    // The anchor is the topmost, then leftmost corner: as `Triangle::new`.
    let first = b.y.simd_lt(a.y) | (b.y.simd_eq(a.y) & b.x.simd_lt(a.x));
    let (x, y, z) = (first.select(b.x, a.x), first.select(b.y, a.y), first.select(bz, az));
    let first = c.y.simd_lt(y) | (c.y.simd_eq(y) & c.x.simd_lt(x));
    let (x, y, z) = (first.select(c.x, x), first.select(c.y, y), first.select(cz, z));
    let [out_x, out_y, out_z] = &mut batch.anchor;
    x.bitcast::<u32x8<S>>().store_slice(out_x);
    y.bitcast::<u32x8<S>>().store_slice(out_y);
    z.store_slice(out_z);

    let (za, zb, zc) = (u32_to_f64(simd, az), u32_to_f64(simd, bz), u32_to_f64(simd, cz));
    let (dz1, dz2) = (zb - za, zc - za);
    let (dx1, dy1) = (i32_to_f64(simd, b.x - a.x), i32_to_f64(simd, b.y - a.y));
    let (dx2, dy2) = (i32_to_f64(simd, c.x - a.x), i32_to_f64(simd, c.y - a.y));
    let magnitude = area.max(splat(simd, 0) - area);
    let area = u32_to_f64(simd, magnitude.bitcast());
    let inverse = f64x8::splat(simd, 1.0) / area;
    let [out_x, out_y] = &mut batch.gradients;
    gradient(simd, dz1 * dy2 - dz2 * dy1, area, inverse, out_x);
    gradient(simd, dz2 * dx1 - dz1 * dx2, area, inverse, out_y);
}

/// One edge of eight triangles.
#[derive(Clone, Copy)]
struct Edge<S: Simd> {
    /// The reduced edge value at the first sample.
    value: i32x8<S>,
    a: i32x8<S>,
    b: i32x8<S>,
}

impl<S: Simd> Edge<S> {
    /// A, B, and e at the sample (`x`, `y`).
    #[inline(always)]
    fn new(simd: S, start: Corner<S>, end: Corner<S>, x: i32x8<S>, y: i32x8<S>) -> Self {
        let (a, b) = (start.y - end.y, end.x - start.x);
        let zero = splat(simd, 0);
        let value = a * (x - start.x) + b * (y - start.y);
        // A mask is -1 where it is set: subtract 1 but for top and left edges.
        let inner = a.simd_gt(zero) | (a.simd_eq(zero) & b.simd_gt(zero));
        let bias = inner.select(zero, splat(simd, 1));
        Self { value: (value - bias) >> 8, a, b }
    }

    #[inline(always)]
    fn select(mask: mask32x8<S>, yes: Self, no: Self) -> Self {
        Self {
            value: mask.select(yes.value, no.value),
            a: mask.select(yes.a, no.a),
            b: mask.select(yes.b, no.b),
        }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, a: self.a + other.a, b: self.b + other.b }
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self { value: self.value - other.value, a: self.a - other.a, b: self.b - other.b }
    }

    #[inline(always)]
    fn store(self, simd: S, out: &mut Crossing) {
        (f32x8::float_from(self.value) + f32x8::splat(simd, 0.5)).store_slice(&mut out.value);
        f32x8::float_from(self.b).store_slice(&mut out.step);
        (f32x8::splat(simd, -1.0) / f32x8::float_from(self.a)).store_slice(&mut out.factor);
    }
}

/// Orders the edges: a left one, a right one, the third. A triangle with an area has both.
#[inline(always)]
fn place_edges<S: Simd>(simd: S, [e0, e1, e2]: [Edge<S>; 3], batch: &mut Batch) {
    let zero = splat(simd, 0);
    let left = Edge::select(e0.a.simd_gt(zero), e0, Edge::select(e1.a.simd_gt(zero), e1, e2));
    let right = Edge::select(e0.a.simd_lt(zero), e0, Edge::select(e1.a.simd_lt(zero), e1, e2));
    let third = e0.plus(e1).plus(e2).minus(left).minus(right);
    let [out_left, out_right, out_third] = &mut batch.crossings;
    left.store(simd, out_left);
    right.store(simd, out_right);
    // -1 / +0 is -∞.
    third.store(simd, out_third);
    let (above, below) = (f32x8::splat(simd, f32::INFINITY), f32x8::splat(simd, f32::NEG_INFINITY));
    third.a.simd_ge(zero).select(above, below).store_slice(&mut batch.third);
}

/// floor(2^32 N / D + 1/2) modulo 2^64 for |N| <= 2^48 and 0 < D < 2^31: three digits, each the
/// rounded quotient of an exact remainder, and one exact correction.
///
/// `inverse` is 1 / D, so a proposed digit is off by less than 1/2 + 1/8 and the next remainder is below
/// D; the last digit is below 2^17, so its remainder exceeds D/2 by less than one.
#[inline(always)]
fn gradient<S: Simd>(simd: S, numerator: f64x8<S>, area: f64x8<S>, inverse: f64x8<S>, out: &mut [u64; 8]) {
    let digit = f64x8::splat(simd, 65536.0);
    let whole = (numerator * inverse).round_ties_even();
    let rest = (numerator - whole * area) * digit;
    let high = (rest * inverse).round_ties_even();
    let rest = (rest - high * area) * digit;
    let low = (rest * inverse).round_ties_even();
    let rest = rest - low * area;
    let (zero, one) = (f64x8::splat(simd, 0.0), f64x8::splat(simd, 1.0));
    let twice = rest + rest;
    let up = twice.simd_ge(area).select(one, zero);
    let down = twice.simd_lt(zero - area).select(one, zero);
    let fraction = high * digit + low + up - down;
    // Adding 1.5 * 2^52 leaves an integer in the low bits, in two's complement.
    let magic = f64x8::splat(simd, 6_755_399_441_055_744.0);
    let whole = (whole + magic).to_bits() << 32;
    let fraction = (fraction + magic).to_bits() - magic.to_bits();
    (whole + fraction).store_slice(out);
}

/// `crate::unorm16` of eight depths, kept in the vertices' range, in the upper half.
#[inline(always)]
fn unorm16<S: Simd>(simd: S, depth: u32x8<S>) -> u32x8<S> {
    let (one, zero) = (u32x8::splat(simd, 1), u32x8::splat(simd, 0));
    let (high, low) = (depth >> 16, depth & u32x8::splat(simd, 0xFFFF));
    let borrow = low.simd_lt(high);
    let remainder = low - high + borrow.select(u32x8::splat(simd, 65537), zero);
    let quotient = high - borrow.select(one, zero);
    let rounded = quotient + remainder.simd_gt(u32x8::splat(simd, 65537 / 2)).select(one, zero);
    rounded.max(u32x8::splat(simd, DEPTH16_MIN)).min(u32x8::splat(simd, DEPTH16_MAX)) << 16
}
