//! One triangle, row of blocks by row of blocks: the crossings of its edges are solved for x.
//!
//! Eight rows of samples at a time in `f32` where that is exact (triangles set up by
//! [`set_up`](super::setup::set_up)), four at a time in `f64` for any other.

use super::{
    attachment::{DepthPlane, RowAttachment},
    setup::Batch,
};
use crate::{
    geometry::{Plane, Region, Triangle},
    numbers::{Standard, WordArithmetic},
};
use fearless_simd::{Simd, f32x8, f64x4, i32x4, i32x8, i32x16, prelude::*};

/// An edge's crossings, as in [`Crossing`](super::setup::Crossing).
#[derive(Clone, Copy, Debug)]
struct Line<T> {
    value: T,
    step: T,
    factor: T,
}

/// One triangle ready for its rows, its numbers in `f32` or `f64`. The origin is the first sample of
/// the block that holds the first pixel of the bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solved<T> {
    lines: [Line<T>; 3],
    third: T,
    bounds: [u32; 4],
    /// Depth at the origin, and what a pixel adds to it.
    depth: DepthPlane,
}

impl Solved<f32> {
    /// Triangle `lane` of a batch, sampled at (`sample_x`, `sample_y`) steps in each pixel.
    #[inline(always)]
    pub(super) fn from_batch(batch: &Batch, lane: usize, (sample_x, sample_y): (i32, i32)) -> Self {
        let lane = lane & 7;
        let [left, right, third] = &batch.crossings;
        let [x0, x1, y0, y1] = &batch.bounds;
        let [anchor_x, anchor_y, anchor_z] = &batch.anchor;
        let [gradient_x, gradient_y] = &batch.gradients;
        let bounds = [x0[lane] as u32, x1[lane] as u32, y0[lane] as u32, y1[lane] as u32];
        let (x, y) = (x0[lane] & !3, y0[lane] & !3);
        let dx = (x << 8) + sample_x - anchor_x[lane] as i32;
        let dy = (y << 8) + sample_y - anchor_y[lane] as i32;
        let origin = u64::from(anchor_z[lane]) << 32;
        let lines = [
            Line { value: left.value[lane], step: left.step[lane], factor: left.factor[lane] },
            Line { value: right.value[lane], step: right.step[lane], factor: right.factor[lane] },
            Line { value: third.value[lane], step: third.step[lane], factor: third.factor[lane] },
        ];
        Self {
            lines,
            third: batch.third[lane],
            bounds,
            depth: DepthPlane {
                origin: origin.step(gradient_x[lane], dx).step(gradient_y[lane], dy),
                x: gradient_x[lane] << 8,
                y: gradient_y[lane] << 8,
            },
        }
    }
}

impl Solved<f64> {
    /// Any triangle with pixels in `bounds`, set up in integers; `vertex` rounds its depths, where
    /// there are any.
    pub(super) fn from_triangle(
        triangle: &Triangle<Standard>,
        bounds: Region<Standard>,
        vertex: Option<fn(u32) -> u32>,
    ) -> Self {
        let (x, y) = (bounds.x0() & !3, bounds.y0() & !3);
        let mut lines = [None; 3];
        for edge in triangle.edges() {
            let value = edge.reduced(triangle.sample(), x, y) as f64 + 0.5;
            let line = Line { value, step: f64::from(edge.b()), factor: -1.0 / f64::from(edge.a()) };
            let place = match (edge.a().signum(), lines) {
                (1, [None, ..]) => 0,
                (-1, [_, None, _]) => 1,
                _ => 2,
            };
            if let Some(slot) = lines.get_mut(place) {
                *slot = Some((line, edge.a()));
            }
        }
        let none = Line { value: 0.5, step: 0.0, factor: f64::NEG_INFINITY };
        let [left, right, third] = lines.map(|slot| slot.unwrap_or((none, 0)));
        let depth = vertex.map_or(DepthPlane { origin: 0, x: 0, y: 0 }, |vertex| {
            let plane = Plane::new(triangle, vertex);
            let (gradient_x, gradient_y) = plane.gradients();
            DepthPlane { origin: plane.at(x, y), x: gradient_x << 8, y: gradient_y << 8 }
        });
        Self {
            lines: [left.0, right.0, third.0],
            third: if third.1 >= 0 { f64::INFINITY } else { f64::NEG_INFINITY },
            bounds: [bounds.x0(), bounds.x1(), bounds.y0(), bounds.y1()],
            depth,
        }
    }
}

/// Far to the right of any sample: where an empty row begins.
const NOWHERE: i32 = 1 << 20;

/// The rows of a triangle, some at a time.
trait Rows<S: Simd>: Sized {
    /// The samples of the next eight rows: where they begin, in pixels from the origin, and how many
    /// there are, maybe less than none.
    fn eight(&mut self, simd: S) -> (i32x8<S>, i32x8<S>);

    /// Goes on to the eight rows after those.
    fn advance(&mut self, simd: S);
}

/// Eight rows in `f32`.
struct Single<'a, S: Simd> {
    lines: &'a [Line<f32>; 3],
    values: [f32x8<S>; 3],
    third: f32x8<S>,
    first: f32x8<S>,
    end: f32x8<S>,
}

impl<'a, S: Simd> Single<'a, S> {
    #[inline(always)]
    fn new(simd: S, solved: &'a Solved<f32>) -> Self {
        let [x0, x1, ..] = solved.bounds;
        let [left, right, third] = &solved.lines;
        let rows = f32x8::simd_from(simd, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
        Self {
            values: [
                rows * left.step + left.value,
                rows * right.step + right.value,
                rows * third.step + third.value,
            ],
            lines: &solved.lines,
            third: f32x8::splat(simd, solved.third),
            first: f32x8::splat(simd, (x0 & 3) as f32),
            end: f32x8::splat(simd, (x1 - (x0 & !3)) as f32),
        }
    }
}

impl<S: Simd> Rows<S> for Single<'_, S> {
    #[inline(always)]
    fn eight(&mut self, _simd: S) -> (i32x8<S>, i32x8<S>) {
        let ([left, right, third], [left_line, right_line, third_line]) = (self.values, self.lines);
        let crossing = third * third_line.factor;
        let begin =
            (left * left_line.factor).max(crossing.min(self.third)).max(self.first).min(self.end).ceil();
        let close =
            (right * right_line.factor).min(crossing.max(self.third)).max(self.first).min(self.end).ceil();
        let (begin, close) = (i32x8::truncate_from(begin), i32x8::truncate_from(close));
        (begin, close - begin)
    }

    #[inline(always)]
    fn advance(&mut self, _simd: S) {
        let ([left, right, third], [left_line, right_line, third_line]) = (self.values, self.lines);
        self.values =
            [left + 8.0 * left_line.step, right + 8.0 * right_line.step, third + 8.0 * third_line.step];
    }
}

/// Eight rows in `f64`, four at a time.
struct Double<S: Simd> {
    values: [f64x4<S>; 3],
    steps: [f64; 3],
    factors: [f64; 3],
    third: f64x4<S>,
    first: f64x4<S>,
    end: f64x4<S>,
}

impl<S: Simd> Double<S> {
    #[inline(always)]
    fn new(simd: S, solved: &Solved<f64>) -> Self {
        let [x0, x1, ..] = solved.bounds;
        let [left, right, third] = solved.lines;
        let rows = f64x4::simd_from(simd, [0.0, 1.0, 2.0, 3.0]);
        Self {
            values: [
                rows * left.step + left.value,
                rows * right.step + right.value,
                rows * third.step + third.value,
            ],
            steps: [4.0 * left.step, 4.0 * right.step, 4.0 * third.step],
            factors: [left.factor, right.factor, third.factor],
            third: f64x4::splat(simd, solved.third),
            first: f64x4::splat(simd, f64::from(x0 & 3)),
            end: f64x4::splat(simd, f64::from(x1 - (x0 & !3))),
        }
    }

    /// Where the samples of the next four rows begin and end.
    #[inline(always)]
    fn four(&mut self) -> (f64x4<S>, f64x4<S>) {
        let ([left, right, third], [left_factor, right_factor, third_factor]) = (self.values, self.factors);
        let [left_step, right_step, third_step] = self.steps;
        self.values = [left + left_step, right + right_step, third + third_step];
        let crossing = third * third_factor;
        let begin = (left * left_factor).max(crossing.min(self.third)).max(self.first).min(self.end).ceil();
        let close = (right * right_factor).min(crossing.max(self.third)).max(self.first).min(self.end).ceil();
        (begin, close)
    }
}

impl<S: Simd> Rows<S> for Double<S> {
    #[inline(always)]
    fn eight(&mut self, simd: S) -> (i32x8<S>, i32x8<S>) {
        let ((begin0, close0), (begin1, close1)) = (self.four(), self.four());
        // Whole numbers of at most 15 bits.
        let begin = i32x8::truncate_from(simd.narrow_f64x4(begin0, begin1));
        let close = i32x8::truncate_from(simd.narrow_f64x4(close0, close1));
        (begin, close - begin)
    }

    #[inline(always)]
    fn advance(&mut self, _simd: S) {}
}

/// Draws a triangle of small extent. Whether it covers a sample.
#[inline(always)]
pub(super) fn draw_small<S: Simd, A: RowAttachment>(
    simd: S,
    solved: &Solved<f32>,
    region: Region<Standard>,
    id: u32,
    attachments: &mut A,
) -> bool {
    simd.vectorize(
        #[inline(always)]
        || {
            let span = Span { plane: &solved.depth, bounds: solved.bounds, region, id };
            let rows = Single::new(simd, solved);
            let [x0, x1, ..] = solved.bounds;
            if (x1 - (x0 & !3)).div_ceil(4) <= NARROW {
                draw_rows::<true, _, _, _>(simd, rows, &span, attachments)
            } else {
                draw_rows::<false, _, _, _>(simd, rows, &span, attachments)
            }
        },
    )
}

/// Draws any triangle. Whether it covers a sample.
#[inline(always)]
pub(super) fn draw_any<S: Simd, A: RowAttachment>(
    simd: S,
    solved: &Solved<f64>,
    region: Region<Standard>,
    id: u32,
    attachments: &mut A,
) -> bool {
    simd.vectorize(
        #[inline(always)]
        || {
            let span = Span { plane: &solved.depth, bounds: solved.bounds, region, id };
            draw_rows::<false, _, _, _>(simd, Double::new(simd, solved), &span, attachments)
        },
    )
}

/// Rows of at most this many blocks are drawn whole: finding their ends costs more.
const NARROW: u32 = 4;

/// What does not depend on how rows are solved.
struct Span<'a> {
    plane: &'a DepthPlane,
    bounds: [u32; 4],
    region: Region<Standard>,
    id: u32,
}

/// Draws eight rows at a time; all blocks of the bounds where `WHOLE`, else those from the first sample
/// to the last of each four rows.
#[inline(always)]
fn draw_rows<const WHOLE: bool, S: Simd, R: Rows<S>, A: RowAttachment>(
    simd: S,
    mut rows: R,
    span: &Span<'_>,
    attachments: &mut A,
) -> bool {
    let Span { plane, bounds: [x0, x1, y0, y1], region, id } = *span;
    let (x, mut y) = (x0 & !3, y0 & !3);
    let blocks = (x1 - x).div_ceil(4);
    let mut lanes = attachments.prepare(simd, plane, id);
    let mut cursor = attachments.cursor(x, y);
    let mut depth = plane.origin;
    let mut any = false;
    let (zero, one) = (i32x8::splat(simd, 0), i32x8::splat(simd, 1));
    loop {
        let (begin, mut count) = rows.eight(simd);
        if y < region.y0() || y + 8 > region.y1() {
            let mut counts = [0; 8];
            count.store_slice(&mut counts);
            clip_rows(&mut counts, y, region);
            count = i32x8::simd_from(simd, counts);
        }
        let covered = count.simd_gt(zero);
        any |= covered.any_true();
        let mut begins = [0; 8];
        let mut lasts = [0; 8];
        covered.select(begin, i32x8::splat(simd, NOWHERE)).store_slice(&mut begins);
        (count.max(one) + i32x8::splat(simd, i32::MAX)).store_slice(&mut lasts);
        let ([begin0, begin1], [last0, last1]) = (halves(&begins), halves(&lasts));
        for (begins, lasts) in [(begin0, last0), (begin1, last1)] {
            let (from, until) = if WHOLE { (0, blocks) } else { range(begins, lasts, blocks) };
            let mut position = columns(simd, from) - by_row(simd, begins);
            let last = by_row(simd, lasts);
            let base = if WHOLE { depth } else { depth.step(plane.x, (from * 4) as i32) };
            A::begin_row(simd, &mut lanes, base);
            for block in attachments.row(cursor, from, until.saturating_sub(from)) {
                A::write(simd, &mut lanes, block, position.simd_gt(last));
                position += i32x16::splat(simd, 4);
            }
            y += 4;
            if y >= y1 {
                return any;
            }
            depth = depth.step(plane.y, 4);
            cursor = attachments.next_row(cursor);
        }
        rows.advance(simd);
    }
}

/// The blocks that hold the samples of four rows, as a range; maybe none.
#[inline(always)]
fn range([b0, b1, b2, b3]: &[i32; 4], [l0, l1, l2, l3]: &[i32; 4], blocks: u32) -> (u32, u32) {
    let first = *b0.min(b1).min(b2.min(b3)) as u32 >> 2;
    // One past the last sample of a row; an empty row ends far to the right.
    let end = |begin: &i32, last: &i32| {
        if *begin == NOWHERE { 0 } else { begin.wrapping_add(last.wrapping_sub(i32::MIN)) + 1 }
    };
    let last = end(b0, l0).max(end(b1, l1)).max(end(b2, l2).max(end(b3, l3)));
    (first, (last as u32).div_ceil(4).min(blocks))
}

/// No samples in the rows outside the region.
#[cold]
fn clip_rows(counts: &mut [i32; 8], y: u32, region: Region<Standard>) {
    for (row, count) in (y..).zip(counts) {
        if row < region.y0() || row >= region.y1() {
            *count = 0;
        }
    }
}

/// Each lane's column, from block `from` on, shifted by -2^31 so that signed comparisons order it as
/// unsigned.
#[inline(always)]
fn columns<S: Simd>(simd: S, from: u32) -> i32x16<S> {
    i32x16::simd_from(simd, [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3])
        + i32x16::splat(simd, (4 * from) as i32 + i32::MIN)
}

/// The first four and the last four.
#[inline(always)]
fn halves(eight: &[i32; 8]) -> [&[i32; 4]; 2] {
    match eight.as_chunks::<4>().0 {
        [low, high] => [low, high],
        _ => [&[0; 4]; 2],
    }
}

/// Each of four numbers four times.
#[inline(always)]
fn by_row<S: Simd>(simd: S, [a, b, c, d]: &[i32; 4]) -> i32x16<S> {
    simd.combine_i32x8(
        simd.combine_i32x4(i32x4::splat(simd, *a), i32x4::splat(simd, *b)),
        simd.combine_i32x4(i32x4::splat(simd, *c), i32x4::splat(simd, *d)),
    )
}
