//! Culling, eight triangles at a time, from snapped vertices and indices.

use super::{
    fetch::fetch,
    ops::splat,
    queue::Queue,
    setup::SMALL_EXTENT,
    vertex::{PLANES, SPECIAL, Snapped},
};
use crate::{
    draw::{Index, State, Statistics},
    geometry::{Region, Winding},
    numbers::Standard,
};
use fearless_simd::{Simd, i32x8, prelude::*};

/// What eight triangles are, one bit each; each triangle has one.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Verdict {
    /// Drawn by the fast path: of small extent, with a sample in the bounds.
    pub(super) fast: u32,
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

/// The constants of a draw's culling.
#[derive(Clone, Copy)]
pub(super) struct Culling<S: Simd> {
    simd: S,
    /// The region's ends in steps.
    left: i32x8<S>,
    right: i32x8<S>,
    top: i32x8<S>,
    bottom: i32x8<S>,
    /// Added to a coordinate before the shift to the first pixel whose sample is not before it.
    up_x: i32x8<S>,
    up_y: i32x8<S>,
    /// All bits where clockwise triangles are culled.
    clockwise: u32,
    /// All bits where counter-clockwise triangles are culled.
    counter_clockwise: u32,
}

impl<S: Simd> Culling<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, region: Region<Standard>, state: &State<Standard>) -> Self {
        let (sample_x, sample_y) = state.sample.of_pixel(0, 0);
        let bits = |culled| if culled { u32::MAX } else { 0 };
        Self {
            simd,
            left: splat(simd, (region.x0() as i32) << 8),
            right: splat(simd, (region.x1() as i32) << 8),
            top: splat(simd, (region.y0() as i32) << 8),
            bottom: splat(simd, (region.y1() as i32) << 8),
            up_x: splat(simd, 255 - sample_x),
            up_y: splat(simd, 255 - sample_y),
            clockwise: bits(state.cull.culls(Winding::Clockwise, state.front)),
            counter_clockwise: bits(state.cull.culls(Winding::CounterClockwise, state.front)),
        }
    }

    /// Culls triangles from place `from` on until the queue is full or none are left; how many.
    #[inline(always)]
    pub(super) fn fill<I: Index>(
        &self,
        records: &[Snapped],
        triangles: &[[I; 3]],
        from: usize,
        first_id: u32,
        queue: &mut Queue,
        statistics: &mut Statistics,
    ) -> usize {
        self.simd.vectorize(
            #[inline(always)]
            || {
                self.fill_inline(
                    records,
                    triangles.get(from..).unwrap_or(&[]),
                    first_id.wrapping_add(from as u32),
                    queue,
                    statistics,
                )
            },
        )
    }

    #[inline(always)]
    fn fill_inline<I: Index>(
        &self,
        records: &[Snapped],
        triangles: &[[I; 3]],
        first_id: u32,
        queue: &mut Queue,
        statistics: &mut Statistics,
    ) -> usize {
        let mut done = 0;
        let mut last;
        while done < triangles.len() && queue.has_room() {
            let rest = triangles.get(done..).unwrap_or(&[]);
            let (eight, present) = match rest.first_chunk::<8>() {
                Some(eight) => (eight, 0xFF),
                None => {
                    last = padded(rest);
                    (&last, (1 << rest.len()) - 1)
                }
            };
            let verdict = self.eight(records, eight);
            let culled = &mut statistics.culled;
            culled.outside += (verdict.outside & present).count_ones();
            culled.zero_area += (verdict.zero_area & present).count_ones();
            culled.facing += (verdict.facing & present).count_ones();
            culled.no_sample += (verdict.no_sample & present).count_ones();
            let mut left = (verdict.fast | verdict.slow) & present;
            while left != 0 {
                let lane = left.trailing_zeros();
                left &= left - 1;
                let [a, b, c] = eight[lane as usize & 7];
                let id = first_id.wrapping_add(done as u32).wrapping_add(lane);
                queue.push([a.to_u32(), b.to_u32(), c.to_u32()], id, verdict.slow >> lane & 1 != 0);
            }
            done += rest.len().min(8);
        }
        done
    }

    /// Decides on eight triangles, in the order that a scalar draw does: outside, clipping, area,
    /// facing, samples.
    #[inline(always)]
    pub(super) fn eight<I: Index>(&self, records: &[Snapped], triangles: &[[I; 3]; 8]) -> Verdict {
        let simd = self.simd;
        let [a, b, c] = fetch(simd, records, triangles);
        let (left, right) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
        let (top, bottom) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        let zero = splat(simd, 0);
        let last_special = splat(simd, SPECIAL + PLANES);
        let special = left.simd_le(last_special);
        let beyond = right.simd_le(self.left)
            | left.simd_ge(self.right)
            | bottom.simd_le(self.top)
            | top.simd_ge(self.bottom);
        let excluded = (a.x & b.x & c.x & splat(simd, PLANES)).simd_gt(zero) & right.simd_le(last_special);
        let outside = (special & excluded) | (!special & beyond);

        let large = (right - left).max(bottom - top).simd_ge(splat(simd, SMALL_EXTENT));
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        let empty = ((left + self.up_x) >> 8).simd_eq((right + self.up_x) >> 8)
            | ((top + self.up_y) >> 8).simd_eq((bottom + self.up_y) >> 8);

        let outside = outside.to_bitmask() as u32;
        let slow = (special | large).to_bitmask() as u32 & !outside;
        let rest = 0xFF & !outside & !slow;
        let positive = area.simd_gt(zero).to_bitmask() as u32;
        let negative = area.simd_lt(zero).to_bitmask() as u32;
        let zero_area = rest & !positive & !negative;
        let facing = rest & ((positive & self.clockwise) | (negative & self.counter_clockwise));
        let rest = rest & !zero_area & !facing;
        let no_sample = rest & empty.to_bitmask() as u32;
        Verdict { fast: rest & !no_sample, slow, outside, zero_area, facing, no_sample }
    }
}

/// The last triangles, fewer than eight, with triangles without area after them.
#[inline(always)]
fn padded<I: Index>(rest: &[[I; 3]]) -> [[I; 3]; 8] {
    let mut eight = [[I::ZERO; 3]; 8];
    for (to, from) in eight.iter_mut().zip(rest) {
        *to = *from;
    }
    eight
}
