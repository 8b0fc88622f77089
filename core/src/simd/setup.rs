//! Set-up of sixteen triangles of small extent: 32-bit integers, and doubles that are exact.
//!
//! With an extent below [`SMALL_EXTENT`], bounds rounded out to whole blocks span less than 2^15 steps, so
//! edge values are sums of two products below 2^30, and reduced ones have 23 bits: F = e + 1/2 is an exact
//! `f32`. A crossing -F / A is computed as F times the rounded -1 / A. Its relative error is below
//! 2^-23, so below 128 pixels it is off by less than 2^-16 = 1.526e-5; but F is an odd number of halves,
//! so the exact crossing is at least 1 / (2 |A|) > 1.627e-5 away from every integer. Comparing it with
//! integers is exact.

use super::{
    extent::{Extent, SMALL_EXTENT},
    fetch::{Corner, Records},
    ops::{Doubles, bits, greatest, i32_to_f64, least, sign_extend, splat, u32_to_f64},
};
use crate::{
    draw::{Index, State},
    geometry::Region,
    numbers::{DEPTH16_MAX, DEPTH16_MIN, Standard},
};
use fearless_simd::{Simd, f32x16, f64x8, i32x16, mask32x16, prelude::*, u32x16, u64x8};

/// Bounds rounded out to whole blocks: up to 3 pixels at each end.
const MAX_SPAN: i32 = SMALL_EXTENT / 256 + 2 * 4;
const _: () = assert!(MAX_SPAN <= 128);
// Edge values, two products of a difference within the extent and one within the rounded bounds.
const _: () = assert!(2 * (SMALL_EXTENT as i64) * (128 << 8) < 1 << 31);
// 128 * 2^-23 (1 + 2^-24) < 1 / (2 |A|), with A < SMALL_EXTENT.
const _: () = assert!(128 * 2 * (SMALL_EXTENT as i64) * ((1 << 24) + 1) < 1 << 47);

/// The crossings of an edge with the rows of samples, for one or more triangles.
///
/// With F = e + 1/2 the reduced edge value at a row's first sample plus a half that keeps it from being
/// 0, the edge crosses the row at x = -F / A pixels from there, and a sample is inside iff it is to the
/// right (A > 0), or to the left (A < 0), of that. B is what F grows by from row to row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing<T> {
    /// F in the first row.
    pub(super) value: T,
    /// B.
    pub(super) step: T,
    /// -1 / A, rounded; -∞ where A is 0.
    pub(super) factor: T,
}

/// The edges of one or more triangles, in the order that [`place_edges`] gives them. The origin is the
/// first sample of the block that holds the first pixel of the bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossings<T> {
    /// A left edge (A > 0), a right one (A < 0), and the third, which is either.
    pub(super) edges: [Crossing<T>; 3],
    /// +∞ where the third edge is a left one or level (A >= 0), else -∞.
    pub(super) third: T,
    /// The first pixel inside the bounds, and the one after the last, from the origin.
    pub(super) first: T,
    pub(super) end: T,
}

/// Sixteen triangles, set up.
#[derive(Clone, Copy, Debug)]
pub(super) struct Batch {
    pub(super) crossings: Crossings<[f32; 16]>,
    /// x0, x1, y0, y1 of the pixels with samples inside the bounds and the region.
    pub(super) bounds: [[i32; 16]; 4],
    /// The depth plane's value at the origin, rounding included: 32.32 fixed point modulo 2^64.
    pub(super) origin: [u64; 16],
    /// What depth grows by from pixel to pixel, to the right and down.
    pub(super) gradients: [[u64; 16]; 2],
    /// One bit for each small triangle, for each medium one.
    pub(super) small: u32,
    pub(super) medium: u32,
}

impl Batch {
    pub(super) const EMPTY: Self = {
        let none = Crossing { value: [0.0; 16], step: [0.0; 16], factor: [0.0; 16] };
        let (third, first, end) = ([0.0; 16], [0.0; 16], [0.0; 16]);
        Self {
            crossings: Crossings { edges: [none; 3], third, first, end },
            bounds: [[0; 16]; 4],
            origin: [0; 16],
            gradients: [[0; 16]; 2],
            small: 0,
            medium: 0,
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

impl DepthSetup {
    /// Half a unit, which makes rounding down rounding to nearest.
    pub(super) const fn half(self) -> u64 {
        match self {
            Self::D16 => 1 << 47,
            _ => 1 << 31,
        }
    }
}

/// Sets up sixteen triangles of small extent and some area; `None` where an index names no vertex.
#[inline(never)]
pub(super) fn set_up<S: Simd, I: Index>(
    simd: S,
    records: Records<'_>,
    triangles: &[[I; 3]; 16],
    region: Region<Standard>,
    state: &State<Standard>,
    depth: DepthSetup,
    batch: &mut Batch,
) -> Option<()> {
    simd.vectorize(
        #[inline(always)]
        || set_up_inline(simd, records, triangles, region, state, depth, batch),
    )
}

#[inline(always)]
fn set_up_inline<S: Simd, I: Index>(
    simd: S,
    records: Records<'_>,
    triangles: &[[I; 3]; 16],
    region: Region<Standard>,
    state: &State<Standard>,
    depth: DepthSetup,
    batch: &mut Batch,
) -> Option<()> {
    let [a, b, c] = records.corners(simd, triangles)?;
    let extremes =
        [least(a.x, b.x, c.x), greatest(a.x, b.x, c.x), least(a.y, b.y, c.y), greatest(a.y, b.y, c.y)];
    let bounds = Extent::new(simd, region, state).bounds(extremes);
    let [x0, x1, y0, y1] = bounds.inside;
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
    let (sample_x, sample_y) = state.sample.of_pixel(0, 0);
    let (column, row) = (x0 & splat(simd, !3), y0 & splat(simd, !3));
    let origin_x = (column << 8) + splat(simd, sample_x);
    let origin_y = (row << 8) + splat(simd, sample_y);
    let edges = [
        Edge::new(simd, b, c, origin_x, origin_y),
        Edge::new(simd, c, a, origin_x, origin_y),
        Edge::new(simd, a, b, origin_x, origin_y),
    ];
    let crossings =
        place_edges(simd, edges, f32x16::float_from(x0 - column), f32x16::float_from(x1 - column));
    store(&crossings, &mut batch.crossings);
    if depth != DepthSetup::None {
        let [az, bz, cz] = records.corner_depths(simd, triangles)?;
        let (az, bz, cz) = if depth == DepthSetup::D16 {
            (unorm16(simd, az), unorm16(simd, bz), unorm16(simd, cz))
        } else {
            (az, bz, cz)
        };
        let (bz, cz) = (turned.select(cz, bz), turned.select(bz, cz));
        let plane = Plane::new(simd, [a, b, c], [az, bz, cz], area);
        plane.store(simd, origin_x, origin_y, depth, batch);
    }
    batch.small = bits(bounds.small());
    batch.medium = bits(bounds.medium()) & !batch.small;
    Some(())
}

#[inline(always)]
fn store<S: Simd>(from: &Crossings<f32x16<S>>, to: &mut Crossings<[f32; 16]>) {
    let ([left, right, third], [to_left, to_right, to_third]) = (&from.edges, &mut to.edges);
    store_edge(left, to_left);
    store_edge(right, to_right);
    store_edge(third, to_third);
    from.third.store_slice(&mut to.third);
    from.first.store_slice(&mut to.first);
    from.end.store_slice(&mut to.end);
}

#[inline(always)]
fn store_edge<S: Simd>(from: &Crossing<f32x16<S>>, to: &mut Crossing<[f32; 16]>) {
    from.value.store_slice(&mut to.value);
    from.step.store_slice(&mut to.step);
    from.factor.store_slice(&mut to.factor);
}

/// One edge of sixteen triangles.
#[derive(Clone, Copy)]
pub(super) struct Edge<S: Simd> {
    /// The reduced edge value at the first sample.
    pub(super) value: i32x16<S>,
    pub(super) a: i32x16<S>,
    pub(super) b: i32x16<S>,
}

impl<S: Simd> Edge<S> {
    /// A, B, and e at the sample (`x`, `y`).
    #[inline(always)]
    pub(super) fn new(simd: S, start: Corner<S>, end: Corner<S>, x: i32x16<S>, y: i32x16<S>) -> Self {
        let (a, b) = (start.y - end.y, end.x - start.x);
        let zero = splat(simd, 0);
        let value = a * (x - start.x) + b * (y - start.y);
        // Subtract 1 but for top and left edges.
        let inner = a.simd_gt(zero) | (a.simd_eq(zero) & b.simd_gt(zero));
        let bias = inner.select(zero, splat(simd, 1));
        Self { value: (value - bias) >> 8, a, b }
    }

    #[inline(always)]
    fn select(mask: mask32x16<S>, yes: Self, no: Self) -> Self {
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
    pub(super) fn crossing(self, simd: S) -> Crossing<f32x16<S>> {
        Crossing {
            value: f32x16::float_from(self.value) + f32x16::splat(simd, 0.5),
            step: f32x16::float_from(self.b),
            // -1 / +0 is -∞.
            factor: f32x16::splat(simd, -1.0) / f32x16::float_from(self.a),
        }
    }
}

/// Orders the edges: a left one, a right one, the third. A triangle with an area has both.
#[inline(always)]
pub(super) fn place_edges<S: Simd>(
    simd: S,
    [e0, e1, e2]: [Edge<S>; 3],
    first: f32x16<S>,
    end: f32x16<S>,
) -> Crossings<f32x16<S>> {
    let zero = splat(simd, 0);
    let left = Edge::select(e0.a.simd_gt(zero), e0, Edge::select(e1.a.simd_gt(zero), e1, e2));
    let right = Edge::select(e0.a.simd_lt(zero), e0, Edge::select(e1.a.simd_lt(zero), e1, e2));
    let third = e0.plus(e1).plus(e2).minus(left).minus(right);
    let (above, below) = (f32x16::splat(simd, f32::INFINITY), f32x16::splat(simd, f32::NEG_INFINITY));
    Crossings {
        edges: [left.crossing(simd), right.crossing(simd), third.crossing(simd)],
        third: third.a.simd_ge(zero).select(above, below),
        first,
        end,
    }
}

/// The depth planes of sixteen triangles.
#[derive(Clone, Copy)]
pub(super) struct Plane<S: Simd> {
    pub(super) anchor: Corner<S>,
    pub(super) depth: u32x16<S>,
    /// Gradients per step to the right and per step down: 32.32 fixed point modulo 2^64.
    pub(super) x: [u64x8<S>; 2],
    pub(super) y: [u64x8<S>; 2],
}

impl<S: Simd> Plane<S> {
    /// Through three corners, clockwise; `area` is the doubled area before they were made so.
    #[inline(always)]
    pub(super) fn new(
        simd: S,
        [a, b, c]: [Corner<S>; 3],
        [az, bz, cz]: [u32x16<S>; 3],
        area: i32x16<S>,
    ) -> Self {
        // The anchor is the topmost, then leftmost corner: as `Triangle::new`.
        let before = b.y.simd_lt(a.y) | (b.y.simd_eq(a.y) & b.x.simd_lt(a.x));
        let (anchor, depth) = (Corner::select(before, b, a), before.select(bz, az));
        let before = c.y.simd_lt(anchor.y) | (c.y.simd_eq(anchor.y) & c.x.simd_lt(anchor.x));
        let (anchor, depth) = (Corner::select(before, c, anchor), before.select(cz, depth));

        let [za, zb, zc] = [u32_to_f64(simd, az), u32_to_f64(simd, bz), u32_to_f64(simd, cz)];
        let [dx1, dy1] = [i32_to_f64(simd, b.x - a.x), i32_to_f64(simd, b.y - a.y)];
        let [dx2, dy2] = [i32_to_f64(simd, c.x - a.x), i32_to_f64(simd, c.y - a.y)];
        let area = u32_to_f64(simd, area.max(splat(simd, 0) - area).bitcast());
        let (x0, y0) = gradients(simd, half(0, [za, zb, zc, dx1, dy1, dx2, dy2, area]));
        let (x1, y1) = gradients(simd, half(1, [za, zb, zc, dx1, dy1, dx2, dy2, area]));
        Self { anchor, depth, x: [x0, x1], y: [y0, y1] }
    }

    /// The value at the origin, and what pixels add.
    #[inline(always)]
    pub(super) fn store(&self, simd: S, x: i32x16<S>, y: i32x16<S>, depth: DepthSetup, batch: &mut Batch) {
        let (depth0, depth1) = simd.widen_u32x16(self.depth);
        let [dx0, dx1] = sign_extend(simd, x - self.anchor.x);
        let [dy0, dy1] = sign_extend(simd, y - self.anchor.y);
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        let half = u64x8::splat(simd, depth.half());
        let [out_x, out_y] = &mut batch.gradients;
        store_words(
            &mut batch.origin,
            (depth0 << 32) + half + x0 * dx0 + y0 * dy0,
            (depth1 << 32) + half + x1 * dx1 + y1 * dy1,
        );
        store_words(out_x, x0 << 8, x1 << 8);
        store_words(out_y, y0 << 8, y1 << 8);
    }
}

/// Sixteen words to memory.
#[inline(always)]
fn store_words<S: Simd>(to: &mut [u64; 16], low: u64x8<S>, high: u64x8<S>) {
    if let [to_low, to_high] = to.as_chunks_mut::<8>().0 {
        low.store_slice(to_low);
        high.store_slice(to_high);
    }
}

/// One half of each.
#[inline(always)]
pub(super) fn half<S: Simd>(k: usize, all: [Doubles<S>; 8]) -> [f64x8<S>; 8] {
    let [a, b, c, d, e, f, g, h] = all;
    let k = k & 1;
    [a[k], b[k], c[k], d[k], e[k], f[k], g[k], h[k]]
}

/// Both gradients of eight planes.
#[inline(always)]
pub(super) fn gradients<S: Simd>(simd: S, plane: [f64x8<S>; 8]) -> (u64x8<S>, u64x8<S>) {
    let [za, zb, zc, dx1, dy1, dx2, dy2, area] = plane;
    let (dz1, dz2) = (zb - za, zc - za);
    let inverse = f64x8::splat(simd, 1.0) / area;
    (
        gradient(simd, dz1 * dy2 - dz2 * dy1, area, inverse),
        gradient(simd, dz2 * dx1 - dz1 * dx2, area, inverse),
    )
}

/// floor(2^32 N / D + 1/2) modulo 2^64 for |N| <= 2^48 and 0 < D < 2^31: three digits, each the
/// rounded quotient of an exact remainder.
///
/// `inverse` is 1 / D, so a proposed digit is off by less than 1/2 + 1/8 and the next remainder is below
/// D: whole numbers of less than 53 bits, exact. The last digit is below 2^17, so the estimate before its
/// rounding is off by less than 2^-35. The exact quotient is a multiple of 1 / D > 2^-31 and no odd number
/// of halves (D is no multiple of 2^33), so it is at least 1 / (2 D) > 2^-32 away from those, and rounding
/// the estimate rounds it.
#[inline(always)]
pub(super) fn gradient<S: Simd>(simd: S, numerator: f64x8<S>, area: f64x8<S>, inverse: f64x8<S>) -> u64x8<S> {
    let digit = f64x8::splat(simd, 65536.0);
    // Adding 1.5 * 2^52 rounds to the nearest integer and leaves it in the low bits, in two's complement.
    let magic = f64x8::splat(simd, 6_755_399_441_055_744.0);
    let rounded = numerator * inverse + magic;
    let rest = (numerator - (rounded - magic) * area) * digit;
    let high = rest * inverse + magic - magic;
    let rest = (rest - high * area) * digit;
    let low = rest * inverse + magic - magic;
    let fraction = high * digit + low + magic;
    (rounded.to_bits() << 32) + (fraction.to_bits() - magic.to_bits())
}

/// `crate::unorm16` of sixteen depths, kept in the vertices' range, in the upper half.
#[inline(always)]
pub(super) fn unorm16<S: Simd>(simd: S, depth: u32x16<S>) -> u32x16<S> {
    let (one, zero) = (u32x16::splat(simd, 1), u32x16::splat(simd, 0));
    let (high, low) = (depth >> 16, depth & u32x16::splat(simd, 0xFFFF));
    let borrow = low.simd_lt(high);
    let remainder = low - high + borrow.select(u32x16::splat(simd, 65537), zero);
    let quotient = high - borrow.select(one, zero);
    let rounded = quotient + remainder.simd_gt(u32x16::splat(simd, 65537 / 2)).select(one, zero);
    rounded.max(u32x16::splat(simd, DEPTH16_MIN)).min(u32x16::splat(simd, DEPTH16_MAX)) << 16
}
