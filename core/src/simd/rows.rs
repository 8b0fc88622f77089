//! One triangle, row of blocks by row of blocks: the crossings of its edges are solved for x.
//!
//! Sixteen rows of samples at a time: in `f32` where that is exact (triangles set up by
//! [`set_up`](super::setup::set_up)), in `f64` for any other.

use super::{
    attachment::{Gradients, RowAttachment},
    blocks::{Placed, upper},
    ops::ceil,
    setup::{Batch, Crossing, Crossings, DepthSetup},
};
use crate::{
    geometry::{Plane, Region, Triangle},
    numbers::Standard,
};
use fearless_simd::{Simd, f32x16, f64x8, i32x16, prelude::*};

/// One triangle ready for its rows, its edges in `f32` or `f64`.
#[derive(Clone, Copy)]
pub(super) struct Solved<T> {
    crossings: Crossings<T>,
    /// The last row but one inside the bounds.
    y1: u32,
    placed: Placed,
}

impl Solved<f32> {
    /// Triangle `lane` of a batch.
    #[inline(always)]
    pub(super) fn from_batch(batch: &Batch, lane: usize) -> Self {
        let lane = lane & 15;
        let Crossings { edges: [left, right, third], third: bound, first, end } = &batch.crossings;
        let [.., y1] = &batch.bounds;
        let edge = |edge: &Crossing<[f32; 16]>| Crossing {
            value: edge.value[lane],
            step: edge.step[lane],
            factor: edge.factor[lane],
        };
        Self {
            crossings: Crossings {
                edges: [edge(left), edge(right), edge(third)],
                third: bound[lane],
                first: first[lane],
                end: end[lane],
            },
            y1: y1[lane] as u32,
            placed: Placed::from_batch(batch, lane),
        }
    }
}

impl Solved<f64> {
    /// Any triangle with pixels in `bounds`, set up in integers; `vertex` rounds its depths, where
    /// there are any.
    pub(super) fn from_triangle(
        triangle: &Triangle<Standard>,
        bounds: Region<Standard>,
        depth: DepthSetup,
        vertex: Option<fn(u32) -> u32>,
    ) -> Self {
        let (x, y) = (bounds.x0() & !3, bounds.y0() & !3);
        let mut edges = [None; 3];
        for edge in triangle.edges() {
            let value = edge.reduced(triangle.sample(), x, y) as f64 + 0.5;
            let crossing = Crossing { value, step: f64::from(edge.b()), factor: -1.0 / f64::from(edge.a()) };
            let place = match (edge.a().signum(), edges) {
                (1, [None, ..]) => 0,
                (-1, [_, None, _]) => 1,
                _ => 2,
            };
            if let Some(slot) = edges.get_mut(place) {
                *slot = Some((crossing, edge.a()));
            }
        }
        let none = Crossing { value: 0.5, step: 0.0, factor: f64::NEG_INFINITY };
        let [left, right, third] = edges.map(|slot| slot.unwrap_or((none, 0)));
        let (origin, gradients) = match vertex {
            None => (0, Gradients { x: 0, y: 0 }),
            Some(vertex) => {
                let plane = Plane::new(triangle, vertex);
                let (gradient_x, gradient_y) = plane.gradients();
                (
                    plane.at(x, y).wrapping_add(depth.half()),
                    Gradients { x: gradient_x << 8, y: gradient_y << 8 },
                )
            }
        };
        Self {
            crossings: Crossings {
                edges: [left.0, right.0, third.0],
                third: if third.1 >= 0 { f64::INFINITY } else { f64::NEG_INFINITY },
                first: f64::from(bounds.x0() - x),
                end: f64::from(bounds.x1() - x),
            },
            y1: bounds.y1(),
            placed: Placed {
                x,
                y,
                columns: (bounds.x1() - x).div_ceil(4),
                rows: (bounds.y1() - y).div_ceil(4),
                origin,
                gradients,
            },
        }
    }
}

/// Far to the right of any sample: where an empty row begins.
const NOWHERE: i32 = 1 << 20;

/// The rows of a triangle, some at a time.
trait Rows<S: Simd>: Sized {
    /// The samples of the next sixteen rows: where they begin, in pixels from the origin, and where they
    /// end, maybe before.
    fn sixteen(&mut self, simd: S) -> [i32x16<S>; 2];
}

/// Sixteen rows in `f32`.
struct Single<S: Simd> {
    crossings: Crossings<f32>,
    values: [f32x16<S>; 3],
}

impl<S: Simd> Single<S> {
    #[inline(always)]
    fn new(simd: S, crossings: Crossings<f32>) -> Self {
        let [left, right, third] = crossings.edges;
        let rows = f32x16::simd_from(
            simd,
            [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0],
        );
        Self {
            values: [
                rows * left.step + left.value,
                rows * right.step + right.value,
                rows * third.step + third.value,
            ],
            crossings,
        }
    }
}

impl<S: Simd> Rows<S> for Single<S> {
    #[inline(always)]
    fn sixteen(&mut self, simd: S) -> [i32x16<S>; 2] {
        let Crossings { edges: [left_edge, right_edge, third_edge], third: bound, first, end } =
            self.crossings;
        let [left, right, third] = self.values;
        let (bound, first, end) =
            (f32x16::splat(simd, bound), f32x16::splat(simd, first), f32x16::splat(simd, end));
        let crossing = third * third_edge.factor;
        let begin = (left * left_edge.factor).max(crossing.min(bound)).max(first).min(end);
        let close = (right * right_edge.factor).min(crossing.max(bound)).max(first).min(end);
        self.values =
            [left + 16.0 * left_edge.step, right + 16.0 * right_edge.step, third + 16.0 * third_edge.step];
        [ceil(simd, begin), ceil(simd, close)]
    }
}

/// Sixteen rows in `f64`, eight at a time.
struct Double<S: Simd> {
    crossings: Crossings<f64>,
    values: [f64x8<S>; 3],
}

impl<S: Simd> Double<S> {
    #[inline(always)]
    fn new(simd: S, crossings: Crossings<f64>) -> Self {
        let [left, right, third] = crossings.edges;
        let rows = f64x8::simd_from(simd, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        Self {
            values: [
                rows * left.step + left.value,
                rows * right.step + right.value,
                rows * third.step + third.value,
            ],
            crossings,
        }
    }

    /// Where the samples of the next eight rows begin and end.
    #[inline(always)]
    fn eight(&mut self, simd: S) -> [f64x8<S>; 2] {
        let Crossings { edges: [left_edge, right_edge, third_edge], third: bound, first, end } =
            self.crossings;
        let [left, right, third] = self.values;
        let (bound, first, end) =
            (f64x8::splat(simd, bound), f64x8::splat(simd, first), f64x8::splat(simd, end));
        let crossing = third * third_edge.factor;
        let begin = (left * left_edge.factor).max(crossing.min(bound)).max(first).min(end).ceil();
        let close = (right * right_edge.factor).min(crossing.max(bound)).max(first).min(end).ceil();
        self.values =
            [left + 8.0 * left_edge.step, right + 8.0 * right_edge.step, third + 8.0 * third_edge.step];
        [begin, close]
    }
}

impl<S: Simd> Rows<S> for Double<S> {
    #[inline(always)]
    fn sixteen(&mut self, simd: S) -> [i32x16<S>; 2] {
        let ([begin0, close0], [begin1, close1]) = (self.eight(simd), self.eight(simd));
        // Whole numbers of at most 15 bits.
        let begin = i32x16::truncate_from(simd.narrow_f64x8(begin0, begin1));
        let close = i32x16::truncate_from(simd.narrow_f64x8(close0, close1));
        [begin, close]
    }
}

/// Draws a triangle of small extent. Whether it covers a sample.
#[inline(always)]
pub(super) fn draw_single<S: Simd, A: RowAttachment>(
    simd: S,
    solved: &Solved<f32>,
    region: Region<Standard>,
    id: u32,
    attachments: &mut A,
) -> bool {
    let rows = Single::new(simd, solved.crossings);
    draw_rows(simd, rows, &solved.placed, solved.y1, region, id, attachments)
}

/// Draws any triangle. Whether it covers a sample.
#[inline(always)]
pub(super) fn draw_double<S: Simd, A: RowAttachment>(
    simd: S,
    solved: &Solved<f64>,
    region: Region<Standard>,
    id: u32,
    attachments: &mut A,
) -> bool {
    let rows = Double::new(simd, solved.crossings);
    draw_rows(simd, rows, &solved.placed, solved.y1, region, id, attachments)
}

/// Draws sixteen rows at a time, of each four the blocks from the first sample to the last.
#[inline(always)]
fn draw_rows<S: Simd, R: Rows<S>, A: RowAttachment>(
    simd: S,
    mut rows: R,
    placed: &Placed,
    y1: u32,
    region: Region<Standard>,
    id: u32,
    attachments: &mut A,
) -> bool {
    let lanes = attachments.prepare(simd, placed.gradients, id);
    let mut cursor = attachments.cursor(placed.x, placed.y);
    let [right, down] = placed.block_steps();
    let mut row_depth = placed.origin;
    let mut y = placed.y;
    let mut any = false;
    let zero = i32x16::splat(simd, 0);
    loop {
        let [begin, close] = rows.sixteen(simd);
        let mut count = close - begin;
        if y < region.y0() || y + 16 > y1 {
            count = clip_rows(simd, count, y, region.y0(), y1);
        }
        let covered = count.simd_gt(zero);
        any |= covered.any_true();
        let begin = covered.select(begin, i32x16::splat(simd, NOWHERE));
        let close = covered.select(close, zero);
        let last = count.max(i32x16::splat(simd, 1)) + i32x16::splat(simd, i32::MAX);
        let (mut begins, mut lasts) = ([[0; 16]; 4], [[0; 16]; 4]);
        let (mut firsts, mut ends) = ([0; 16], [0; 16]);
        spread(simd, begin, &mut begins);
        spread(simd, last, &mut lasts);
        (least_of_four(begin) >> 2).store_slice(&mut firsts);
        ((greatest_of_four(close) + i32x16::splat(simd, 3)) >> 2).store_slice(&mut ends);
        let [[from0, ..], [from1, ..], [from2, ..], [from3, ..]] = quarters(&firsts);
        let [[until0, ..], [until1, ..], [until2, ..], [until3, ..]] = quarters(&ends);
        let ranges = [(from0, until0), (from1, until1), (from2, until2), (from3, until3)];
        for (&(from, until), (begins, lasts)) in ranges.iter().zip(begins.iter().zip(&lasts)) {
            let (from, count) = (from as u32, until.wrapping_sub(from).max(0) as u32);
            let mut position = columns(simd, from) - i32x16::simd_from(simd, *begins);
            let last = i32x16::simd_from(simd, *lasts);
            let mut depth = row_depth.wrapping_add(right.wrapping_mul(u64::from(from)));
            // Where a block is one register, two a turn: the number of turns is easier to predict than it
            // costs to visit one more that has no sample.
            let pairs = <S::u32s as SimdBase<S>>::LEN >= 16;
            let mut row = attachments.row(cursor, from, if pairs { (count + 1) & !1 } else { count });
            loop {
                let Some(block) = row.next() else { break };
                A::write(simd, &lanes, block, position.simd_le(last), upper(depth));
                position += i32x16::splat(simd, 4);
                depth = depth.wrapping_add(right);
                if !pairs {
                    continue;
                }
                let Some(block) = row.next() else { break };
                A::write(simd, &lanes, block, position.simd_le(last), upper(depth));
                position += i32x16::splat(simd, 4);
                depth = depth.wrapping_add(right);
            }
            drop(row);
            y += 4;
            if y >= y1 {
                return any;
            }
            row_depth = row_depth.wrapping_add(down);
            cursor = attachments.next_row(cursor);
        }
    }
}

/// No samples in the rows outside y0..y1.
#[inline(always)]
pub(super) fn clip_rows<S: Simd>(simd: S, count: i32x16<S>, y: u32, y0: u32, y1: u32) -> i32x16<S> {
    let rows = i32x16::simd_from(simd, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15])
        + i32x16::splat(simd, y as i32);
    let there = rows.simd_ge(i32x16::splat(simd, y0 as i32)) & rows.simd_lt(i32x16::splat(simd, y1 as i32));
    there.select(count, i32x16::splat(simd, 0))
}

/// In each lane, the least of the four lanes that it stands among.
#[inline(always)]
pub(super) fn least_of_four<S: Simd>(lanes: i32x16<S>) -> i32x16<S> {
    let two = lanes.min(lanes.slide_within_blocks::<2>(lanes));
    two.min(two.slide_within_blocks::<1>(two))
}

/// In each lane, the greatest of the four lanes that it stands among.
#[inline(always)]
pub(super) fn greatest_of_four<S: Simd>(lanes: i32x16<S>) -> i32x16<S> {
    let two = lanes.max(lanes.slide_within_blocks::<2>(lanes));
    two.max(two.slide_within_blocks::<1>(two))
}

/// Each lane's column, from block `from` on, shifted by -2^31 so that signed comparisons order it as
/// unsigned.
#[inline(always)]
pub(super) fn columns<S: Simd>(simd: S, from: u32) -> i32x16<S> {
    i32x16::simd_from(simd, [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3])
        + i32x16::splat(simd, (4 * from) as i32 + i32::MIN)
}

/// Each lane four times, four lanes in each row of memory.
#[inline(always)]
pub(super) fn spread<S: Simd>(simd: S, lanes: i32x16<S>, out: &mut [[i32; 16]; 4]) {
    let (low, high) = simd.interleave_i32x16(lanes, lanes);
    let (first, second) = simd.interleave_i32x16(low, low);
    let (third, fourth) = simd.interleave_i32x16(high, high);
    let [out0, out1, out2, out3] = out;
    first.store_slice(out0);
    second.store_slice(out1);
    third.store_slice(out2);
    fourth.store_slice(out3);
}

/// Sixteen numbers as four times four.
#[inline(always)]
pub(super) fn quarters(sixteen: &[i32; 16]) -> [[i32; 4]; 4] {
    let [a0, a1, a2, a3, b0, b1, b2, b3, c0, c1, c2, c3, d0, d1, d2, d3] = *sixteen;
    [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3], [d0, d1, d2, d3]]
}
