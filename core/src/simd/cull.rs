//! Culling, sixteen triangles at a time, from snapped vertices and indices.

use super::{
    extent::{Extent, SMALL_EXTENT},
    fetch::Records,
    ops::{bits, greatest, least, splat},
    vertex::{PLANES, SPECIAL},
};
use crate::{
    draw::{Index, State},
    geometry::{Region, Winding},
    numbers::Standard,
};
use fearless_simd::{Simd, i32x16, mask32x16, prelude::*};

/// What sixteen triangles are, one bit each; each triangle has one.
#[derive(Clone, Copy)]
pub(super) struct Verdict<S: Simd> {
    /// Drawn by the fast path: of small extent, with a sample in the bounds.
    pub(super) fast: mask32x16<S>,
    /// Of these, the small ones and the medium ones.
    pub(super) small: mask32x16<S>,
    pub(super) medium: mask32x16<S>,
    /// Left to the scalar path: to be clipped, not finite, or of large extent.
    pub(super) slow: u32,
    /// Outside the frustum or the region.
    pub(super) outside: u32,
    /// Without area.
    pub(super) zero_area: u32,
    /// Facing the culled way.
    pub(super) facing: u32,
    /// Between the samples, by the bounds alone.
    pub(super) no_sample: u32,
}

impl<S: Simd> Verdict<S> {
    /// All of them outside.
    #[inline(always)]
    fn outside(simd: S, present: u32) -> Self {
        let none = mask32x16::splat(simd, false);
        Self {
            fast: none,
            small: none,
            medium: none,
            slow: 0,
            outside: present,
            zero_area: 0,
            facing: 0,
            no_sample: 0,
        }
    }
}

/// The constants of a draw's culling.
#[derive(Clone, Copy)]
pub(super) struct Culling<S: Simd> {
    simd: S,
    /// The region's ends in steps.
    left: i32x16<S>,
    right: i32x16<S>,
    top: i32x16<S>,
    bottom: i32x16<S>,
    extent: Extent<S>,
    /// All bits where clockwise triangles are culled.
    clockwise: u32,
    /// All bits where counter-clockwise triangles are culled.
    counter_clockwise: u32,
}

impl<S: Simd> Culling<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, region: Region<Standard>, state: &State<Standard>) -> Self {
        let culled = |winding| if state.cull.culls(winding, state.front) { u32::MAX } else { 0 };
        Self {
            simd,
            left: splat(simd, (region.x0() as i32) << 8),
            right: splat(simd, (region.x1() as i32) << 8),
            top: splat(simd, (region.y0() as i32) << 8),
            bottom: splat(simd, (region.y1() as i32) << 8),
            extent: Extent::new(simd, region, state),
            clockwise: culled(Winding::Clockwise),
            counter_clockwise: culled(Winding::CounterClockwise),
        }
    }

    /// Decides on sixteen triangles, of which the first `present` bits are there, in the order that a
    /// scalar draw does: outside, clipping, area, facing, samples.
    #[inline(always)]
    pub(super) fn sixteen<I: Index>(
        &self,
        records: Records<'_>,
        triangles: &[[I; 3]; 16],
        present: u32,
    ) -> Verdict<S> {
        let simd = self.simd;
        let Some([a, b, c]) = records.corners(simd, triangles) else {
            // Indices were checked before.
            return Verdict::outside(simd, present);
        };
        let (left, right) = (least(a.x, b.x, c.x), greatest(a.x, b.x, c.x));
        let (top, bottom) = (least(a.y, b.y, c.y), greatest(a.y, b.y, c.y));
        let zero = splat(simd, 0);
        let last_special = splat(simd, SPECIAL + PLANES);
        let special = left.simd_le(last_special);
        let beyond = right.simd_le(self.left)
            | left.simd_ge(self.right)
            | bottom.simd_le(self.top)
            | top.simd_ge(self.bottom);
        let excluded = (a.x & b.x & c.x & splat(simd, PLANES)).simd_gt(zero) & right.simd_le(last_special);
        let outside = bits((special & excluded) | (!special & beyond)) & present;
        if outside == present {
            return Verdict::outside(simd, present);
        }

        let large = (right - left).max(bottom - top).simd_ge(splat(simd, SMALL_EXTENT));
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        let extent = self.extent;
        let bounds = extent.bounds([left, right, top, bottom]);
        let slow = bits(special | large) & present & !outside;
        let rest = present & !outside & !slow;
        let positive = bits(area.simd_gt(zero));
        let negative = bits(area.simd_lt(zero));
        let zero_area = rest & !positive & !negative;
        let facing = rest & ((positive & self.clockwise) | (negative & self.counter_clockwise));
        let rest = rest & !zero_area & !facing;
        let no_sample = rest & bits(bounds.empty());
        let fast = mask32x16::from_bitmask(simd, u64::from(rest & !no_sample));
        let small = fast & bounds.small();
        let medium = fast & bounds.medium() & !small;
        Verdict { fast, small, medium, slow, outside, zero_area, facing, no_sample }
    }
}

/// The last triangles, fewer than sixteen, with others after them that do not matter.
#[inline(always)]
pub(super) fn padded<I: Index>(rest: &[[I; 3]]) -> [[I; 3]; 16] {
    let mut sixteen = [[I::ZERO; 3]; 16];
    for (to, from) in sixteen.iter_mut().zip(rest) {
        *to = *from;
    }
    sixteen
}
