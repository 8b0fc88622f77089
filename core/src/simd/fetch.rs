//! The snapped corners of eight triangles, from records to lanes.

use super::vertex::{MISSING, Snapped};
use crate::draw::Index;
use fearless_simd::{Simd, i32x8, mask32x8, prelude::*, u32x4, u32x8, u64x2};

/// One corner of eight triangles: x and y in steps, z as unorm32.
#[derive(Clone, Copy)]
pub(super) struct Corner<S: Simd> {
    pub(super) x: i32x8<S>,
    pub(super) y: i32x8<S>,
    pub(super) z: u32x8<S>,
}

impl<S: Simd> Corner<S> {
    #[inline(always)]
    pub(super) fn select(mask: mask32x8<S>, yes: Self, no: Self) -> Self {
        Self { x: mask.select(yes.x, no.x), y: mask.select(yes.y, no.y), z: mask.select(yes.z, no.z) }
    }
}

/// The corners of eight triangles. What of them is not used costs nothing.
#[inline(always)]
pub(super) fn fetch<S: Simd, I: Index>(
    simd: S,
    records: &[Snapped],
    triangles: &[[I; 3]; 8],
) -> [Corner<S>; 3] {
    let [t0, t1, t2, t3, t4, t5, t6, t7] = *triangles;
    let low = [t0, t1, t2, t3];
    let high = [t4, t5, t6, t7];
    [
        corner(simd, records, low.map(first), high.map(first)),
        corner(simd, records, low.map(second), high.map(second)),
        corner(simd, records, low.map(third), high.map(third)),
    ]
}

#[inline(always)]
fn first<I: Index>([index, _, _]: [I; 3]) -> usize {
    index.to_usize()
}

#[inline(always)]
fn second<I: Index>([_, index, _]: [I; 3]) -> usize {
    index.to_usize()
}

#[inline(always)]
fn third<I: Index>([_, _, index]: [I; 3]) -> usize {
    index.to_usize()
}

#[inline(always)]
fn corner<S: Simd>(simd: S, records: &[Snapped], low: [usize; 4], high: [usize; 4]) -> Corner<S> {
    let (x0, y0, z0) = four(simd, records, low);
    let (x1, y1, z1) = four(simd, records, high);
    Corner {
        x: simd.combine_u32x4(x0, x1).bitcast(),
        y: simd.combine_u32x4(y0, y1).bitcast(),
        z: simd.combine_u32x4(z0, z1),
    }
}

/// x, y and z of four records.
#[inline(always)]
fn four<S: Simd>(simd: S, records: &[Snapped], at: [usize; 4]) -> (u32x4<S>, u32x4<S>, u32x4<S>) {
    let [a, b, c, d] = at;
    let (a, b) = (record(simd, records, a), record(simd, records, b));
    let (c, d) = (record(simd, records, c), record(simd, records, d));
    // a0 b0 a1 b1 and c0 d0 c1 d1; then pairs of them, 64 bits at a time.
    let ab: u64x2<S> = a.zip_low(b).bitcast();
    let cd: u64x2<S> = c.zip_low(d).bitcast();
    let ab_high: u64x2<S> = a.zip_high(b).bitcast();
    let cd_high: u64x2<S> = c.zip_high(d).bitcast();
    (ab.zip_low(cd).bitcast(), ab.zip_high(cd).bitcast(), ab_high.zip_low(cd_high).bitcast())
}

#[inline(always)]
fn record<S: Simd>(simd: S, records: &[Snapped], at: usize) -> u32x4<S> {
    let Snapped(record) = match records.get(at) {
        Some(record) => record,
        None => &MISSING,
    };
    u32x4::simd_from(simd, *record)
}
