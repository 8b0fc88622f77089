//! From records and triangles to attachments: culling, set-up, blocks.

#[cfg(any(kani, test))]
mod proofs;

use super::{
    attachment::RowAttachment,
    blocks::{draw_medium, draw_small},
    cull::{Culling, Verdict, padded},
    fetch::Records,
    ops::{bits, first_lanes, has_lane, lanes_of, of_lane, without_lane},
    queue::Queue,
    rows::{Solved, draw_double, draw_single},
    setup::{Batch, DepthSetup, set_up},
    source::Source,
    windows::Windows,
};
use crate::{
    attachments::{D16, D32, DepthFormat},
    draw::{self, Index, State, Statistics},
    geometry::{Assembly, Culled, Region, Vertex},
    numbers::Standard,
};
use fearless_simd::{Simd, mask32x16, prelude::*};

/// What stays the same in a draw.
#[derive(Clone, Copy)]
pub(super) struct Drawing<'a, S, L, P> {
    pub(super) simd: S,
    pub(super) records: Records<'a>,
    /// Corners as places among the records.
    pub(super) triangles: &'a [[L; 3]],
    pub(super) source: P,
    pub(super) area: Region<Standard>,
    pub(super) state: &'a State<Standard>,
}

/// Scratch memory of a draw: survivors by how they are drawn, and what is set up of them.
#[derive(Clone)]
pub(super) struct Scratch {
    small: Queue,
    medium: Queue,
    others: Queue,
    batch: Batch,
    windows: Windows,
}

impl Scratch {
    pub(super) const EMPTY: Self = Self {
        small: Queue::EMPTY,
        medium: Queue::EMPTY,
        others: Queue::EMPTY,
        batch: Batch::EMPTY,
        windows: Windows::EMPTY,
    };
}

impl<S: Simd, L: Index, P: Source> Drawing<'_, S, L, P> {
    /// Culls all triangles and draws those that are left.
    #[inline(always)]
    pub(super) fn run<A: RowAttachment>(
        &self,
        culling: &Culling<S>,
        scratch: &mut Scratch,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let triangles = self.triangles;
        let mut last;
        let mut done = 0;
        while let Some(rest) = triangles.get(done..).filter(|rest| !rest.is_empty()) {
            let (sixteen, present) = match rest.first_chunk::<16>() {
                Some(sixteen) => (sixteen, 0xFFFF),
                None => {
                    last = padded(rest);
                    (&last, first_lanes(rest.len()))
                }
            };
            let verdict = culling.sixteen(self.records, sixteen, present);
            let culled = &mut statistics.culled;
            culled.outside += verdict.outside.count_ones();
            culled.zero_area += verdict.zero_area.count_ones();
            culled.facing += verdict.facing.count_ones();
            culled.no_sample += verdict.no_sample.count_ones();
            let first = done as u32;
            if A::ORDERED {
                self.in_order(&verdict, first, scratch, attachments, statistics);
            } else {
                scratch.small.push(self.simd, first, verdict.small);
                scratch.medium.push(self.simd, first, verdict.medium);
                scratch.others.push(self.simd, first, verdict.fast & !verdict.small & !verdict.medium);
                let Scratch { small, medium, others, batch, windows } = &mut *scratch;
                for queue in [small, medium, others] {
                    if !queue.has_room() {
                        self.draw_full(queue, batch, windows, attachments, statistics);
                    }
                }
                let mut slow = verdict.slow;
                while slow != 0 {
                    self.one(first + slow.trailing_zeros(), attachments, statistics);
                    slow &= slow - 1;
                }
            }
            done += rest.len().min(16);
        }
        let Scratch { small, medium, others, batch, windows } = &mut *scratch;
        for queue in [small, medium, others] {
            self.draw_all(queue, batch, windows, attachments, statistics);
        }
    }

    /// Queues the survivors of sixteen triangles for drawing in submitted order.
    #[inline(always)]
    fn in_order<A: RowAttachment>(
        &self,
        verdict: &Verdict<S>,
        first: u32,
        scratch: &mut Scratch,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let Scratch { others, batch, windows, .. } = scratch;
        let mut fast = bits(verdict.fast);
        let mut slow = verdict.slow;
        while slow != 0 {
            let lane = slow.trailing_zeros();
            slow &= slow - 1;
            let before = fast & ((1 << lane) - 1);
            others.push(self.simd, first, mask32x16::from_bitmask(self.simd, u64::from(before)));
            fast &= !before;
            self.draw_all(others, batch, windows, attachments, statistics);
            self.one(first + lane, attachments, statistics);
        }
        others.push(self.simd, first, mask32x16::from_bitmask(self.simd, u64::from(fast)));
        if !others.has_room() {
            self.draw_full(others, batch, windows, attachments, statistics);
        }
    }

    /// Draws the queued triangles in order, all but fewer than sixteen.
    #[inline(always)]
    fn draw_full<A: RowAttachment>(
        &self,
        queue: &mut Queue,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let full = queue.len() & !15;
        self.draw_first(queue, full, batch, windows, attachments, statistics);
        queue.forget(full);
    }

    /// Draws all queued triangles in order.
    #[inline(always)]
    fn draw_all<A: RowAttachment>(
        &self,
        queue: &mut Queue,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let count = queue.len();
        self.draw_first(queue, count, batch, windows, attachments, statistics);
        queue.forget(count);
    }

    #[inline(never)]
    fn draw_first<A: RowAttachment>(
        &self,
        queue: &Queue,
        count: usize,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        self.simd.vectorize(
            #[inline(always)]
            || {
                for at in (0..count).step_by(16) {
                    self.draw_batch(queue.batch(at), batch, windows, attachments, statistics);
                }
            },
        );
    }

    /// Sets up sixteen triangles and draws them.
    #[inline(always)]
    fn draw_batch<A: RowAttachment>(
        &self,
        (numbers, count): (&[u32; 16], usize),
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let present = first_lanes(count);
        let triangles = self.sixteen(numbers);
        let known = set_up(self.simd, self.records, &triangles, self.area, self.state, A::DEPTH, batch);
        // Indices were checked before.
        let Some(()) = known else { return };
        let sampled = windows.fill(self.simd, batch, present);
        let (small, medium) = (batch.small, batch.medium);
        let mut drawn = present & (sampled | !(small | medium));
        for lane in lanes_of(drawn) {
            let id = self.source.id(of_lane(numbers, lane));
            if has_lane(small, lane) {
                draw_small(self.simd, batch, windows, lane, id, attachments);
            } else if has_lane(medium, lane) {
                draw_medium(self.simd, batch, windows, lane, id, attachments);
            } else {
                let solved = Solved::from_batch(batch, lane);
                if !draw_single(self.simd, &solved, self.area, id, attachments) {
                    drawn = without_lane(drawn, lane);
                }
            }
        }
        draw::add(&mut statistics.drawn, drawn.count_ones());
        draw::add(&mut statistics.culled.no_sample, (present & !drawn).count_ones());
    }

    /// Draws one triangle by way of the scalar clip and set-up.
    #[inline(never)]
    fn one<A: RowAttachment>(&self, number: u32, attachments: &mut A, statistics: &mut Statistics) {
        let Some(corners) = self.triangles.get(number as usize) else { return };
        let id = self.source.id(number);
        let corners = corners.map(Index::to_usize);
        // Large, but of snapped vertices: nothing to clip.
        if let Some(vertices) = self.records.vertices(corners) {
            statistics.count(Assembly::Whole, Some(self.piece(vertices, id, attachments)));
            return;
        }
        let mut outcome = None;
        let assembly = self.source.assemble(number, |vertices| {
            let piece = self.piece(vertices, id, attachments);
            if outcome.is_none_or(|known: Result<(), Culled>| known.is_err()) {
                outcome = Some(piece);
            }
        });
        statistics.count(assembly, outcome);
    }

    /// One window triangle, set up in integers.
    fn piece<A: RowAttachment>(
        &self,
        vertices: [Vertex<Standard>; 3],
        id: u32,
        attachments: &mut A,
    ) -> Result<(), Culled> {
        let (triangle, bounds) = draw::prepare(vertices, self.area, self.state)?;
        let vertex: Option<fn(u32) -> u32> = match A::DEPTH {
            DepthSetup::None => None,
            DepthSetup::D32 => Some(<D32 as DepthFormat<Standard>>::vertex),
            DepthSetup::D16 => Some(<D16 as DepthFormat<Standard>>::vertex),
        };
        let solved = Solved::from_triangle(&triangle, bounds, A::DEPTH, vertex);
        let drawn = self.simd.vectorize(
            #[inline(always)]
            || draw_double(self.simd, &solved, self.area, id, attachments),
        );
        if drawn { Ok(()) } else { Err(Culled::NoSample) }
    }

    /// The corners of sixteen triangles by their numbers.
    #[inline(always)]
    fn sixteen(&self, numbers: &[u32; 16]) -> [[L; 3]; 16] {
        let mut sixteen = [[L::ZERO; 3]; 16];
        for (to, &number) in sixteen.iter_mut().zip(numbers) {
            if let Some(triangle) = self.triangles.get(number as usize) {
                *to = *triangle;
            }
        }
        sixteen
    }
}
