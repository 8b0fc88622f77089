//! A whole draw: vertices, culling, set-up, rows.

use super::{
    attachment::RowAttachment,
    blocks::{draw_medium, draw_small},
    cull::{Culling, Verdict, padded},
    fetch::Records,
    level::Level,
    ops::bits,
    queue::Queue,
    rows::{Solved, draw_double, draw_single},
    setup::{Batch, DepthSetup, set_up},
    vertex::{Snapped, split, stage},
    windows::Windows,
};
use crate::{
    attachments::{D16, D32, DepthFormat},
    draw::{self, DrawError, Index, State, Statistics},
    geometry::{Culled, Positions, Region, Vertex},
    numbers::Standard,
    transform::ModelPositions,
};
use fearless_simd::{Simd, dispatch, mask32x16, prelude::*, u32x16};

/// A triangle list whose indices have been checked, once for many draws.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a, I> {
    triangles: &'a [[I; 3]],
    vertices: usize,
}

impl<'a, I: Index> Triangles<'a, I> {
    /// Triangles of three indices each into `vertices` vertices.
    ///
    /// # Errors
    ///
    /// [`DrawError::IndexCount`] and [`DrawError::IndexOutOfRange`].
    pub fn new(indices: &'a [I], vertices: usize) -> Result<Self, DrawError> {
        let triangles = draw::check_indices(indices, vertices)?;
        Ok(Self { triangles, vertices })
    }
}

/// [`draw`](crate::draw()) of object-space vertices in vector registers of `level`: the same picture,
/// the same statistics.
///
/// `records` is scratch memory, at least as long as there are vertices.
///
/// # Errors
///
/// [`DrawError`], before anything is written: as [`draw`](crate::draw()), and
/// [`DrawError::ScratchTooSmall`]; [`DrawError::IndexOutOfRange`] where `triangles` was checked for more
/// vertices than there are.
pub fn draw<I: Index, A: RowAttachment>(
    level: Level,
    positions: &ModelPositions<'_, Standard>,
    records: &mut [Snapped],
    triangles: Triangles<'_, I>,
    first_id: u32,
    state: &State<Standard>,
    attachments: &mut A,
) -> Result<Statistics, DrawError> {
    let vertices = positions.count();
    let indices = triangles.triangles.as_flattened();
    if triangles.vertices > vertices {
        draw::check_indices(indices, vertices)?;
    }
    let given = records.len();
    let Some(records) = records.get_mut(..vertices) else {
        return Err(DrawError::ScratchTooSmall { needed: vertices, given });
    };
    let triangles = triangles.triangles;
    let (submitted, area) = draw::check_draw(positions, triangles.len(), first_id, state, attachments)?;
    let (Some(level), Some(area), true) = (level.0, area, attachments.fast()) else {
        return draw::draw(positions, indices, first_id, state, attachments);
    };
    let mut statistics = Statistics { submitted, ..Statistics::default() };
    dispatch!(level, simd => {
        simd.vectorize(
            #[inline(always)]
            || {
                let (places, depths) = split(records);
                stage(simd, positions, places, depths);
                let drawing = Drawing { simd, positions, records: Records { places, depths }, area, state };
                drawing.run(triangles, first_id, attachments, &mut statistics);
            },
        );
    });
    Ok(statistics)
}

/// What stays the same in a draw.
#[derive(Clone, Copy)]
struct Drawing<'a, S> {
    simd: S,
    positions: &'a ModelPositions<'a, Standard>,
    records: Records<'a>,
    area: Region<Standard>,
    state: &'a State<Standard>,
}

/// Scratch memory of a draw: survivors by how they are drawn, and what is set up of them.
struct Scratch {
    small: Queue,
    medium: Queue,
    others: Queue,
    batch: Batch,
    windows: Windows,
}

impl<S: Simd> Drawing<'_, S> {
    #[inline(always)]
    fn run<I: Index, A: RowAttachment>(
        &self,
        triangles: &[[I; 3]],
        first_id: u32,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let culling = Culling::new(self.simd, self.area, self.state);
        let none = Queue::EMPTY;
        let mut scratch =
            Scratch { small: none, medium: none, others: none, batch: Batch::EMPTY, windows: Windows::EMPTY };
        let numbers = u32x16::simd_from(self.simd, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]);
        let list = List { triangles, first_id };
        let mut last;
        let mut done = 0;
        while let Some(rest) = triangles.get(done..).filter(|rest| !rest.is_empty()) {
            let (sixteen, present) = match rest.first_chunk::<16>() {
                Some(sixteen) => (sixteen, 0xFFFF),
                None => {
                    last = padded(rest);
                    (&last, (1 << rest.len()) - 1)
                }
            };
            let verdict = culling.sixteen(self.records, sixteen, present);
            let culled = &mut statistics.culled;
            culled.outside += verdict.outside.count_ones();
            culled.zero_area += verdict.zero_area.count_ones();
            culled.facing += verdict.facing.count_ones();
            culled.no_sample += verdict.no_sample.count_ones();
            let numbers = numbers + u32x16::splat(self.simd, done as u32);
            if A::ORDERED {
                self.in_order(&verdict, numbers, done as u32, list, &mut scratch, attachments, statistics);
            } else {
                scratch.small.push(numbers, verdict.small);
                scratch.medium.push(numbers, verdict.medium);
                scratch.others.push(numbers, verdict.fast & !verdict.small & !verdict.medium);
                let Scratch { small, medium, others, batch, windows } = &mut scratch;
                for queue in [small, medium, others] {
                    if !queue.has_room() {
                        self.draw_full(queue, list, batch, windows, attachments, statistics);
                    }
                }
                let mut slow = verdict.slow;
                while slow != 0 {
                    self.one(list, done as u32 + slow.trailing_zeros(), attachments, statistics);
                    slow &= slow - 1;
                }
            }
            done += rest.len().min(16);
        }
        let Scratch { small, medium, others, batch, windows } = &mut scratch;
        for queue in [small, medium, others] {
            self.draw_all(queue, list, batch, windows, attachments, statistics);
        }
    }

    /// Queues the survivors of sixteen triangles for drawing in submitted order.
    #[inline(always)]
    fn in_order<I: Index, A: RowAttachment>(
        &self,
        verdict: &Verdict<S>,
        numbers: u32x16<S>,
        first: u32,
        list: List<'_, I>,
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
            others.push(numbers, mask32x16::from_bitmask(self.simd, u64::from(before)));
            fast &= !before;
            self.draw_all(others, list, batch, windows, attachments, statistics);
            self.one(list, first + lane, attachments, statistics);
        }
        others.push(numbers, mask32x16::from_bitmask(self.simd, u64::from(fast)));
        if !others.has_room() {
            self.draw_full(others, list, batch, windows, attachments, statistics);
        }
    }

    /// Draws the queued triangles in order, all but fewer than sixteen.
    #[inline(always)]
    fn draw_full<I: Index, A: RowAttachment>(
        &self,
        queue: &mut Queue,
        list: List<'_, I>,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let full = queue.len() & !15;
        self.draw_first(queue, full, list, batch, windows, attachments, statistics);
        queue.forget(full);
    }

    /// Draws all queued triangles in order.
    #[inline(always)]
    fn draw_all<I: Index, A: RowAttachment>(
        &self,
        queue: &mut Queue,
        list: List<'_, I>,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let count = queue.len();
        self.draw_first(queue, count, list, batch, windows, attachments, statistics);
        queue.forget(count);
    }

    #[inline(never)]
    fn draw_first<I: Index, A: RowAttachment>(
        &self,
        queue: &Queue,
        count: usize,
        list: List<'_, I>,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        self.simd.vectorize(
            #[inline(always)]
            || {
                for at in (0..count).step_by(16) {
                    self.draw_batch(queue.batch(at), list, batch, windows, attachments, statistics);
                }
            },
        );
    }

    /// Sets up sixteen triangles and draws them.
    #[inline(always)]
    fn draw_batch<I: Index, A: RowAttachment>(
        &self,
        (numbers, count): (&[u32; 16], usize),
        list: List<'_, I>,
        batch: &mut Batch,
        windows: &mut Windows,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let present = 0xFFFF >> (16 - count.min(16));
        let triangles = list.sixteen(numbers);
        let known = set_up(self.simd, self.records, &triangles, self.area, self.state, A::DEPTH, batch);
        // Indices were checked before.
        let Some(()) = known else { return };
        let sampled = windows.fill(self.simd, batch, present);
        let (small, medium) = (batch.small, batch.medium);
        let mut left = present & (sampled | !(small | medium));
        let mut drawn = left.count_ones();
        while left != 0 {
            let lane = left.trailing_zeros() as usize;
            left &= left - 1;
            let id = list.first_id.wrapping_add(numbers[lane & 15]);
            if small >> lane & 1 != 0 {
                draw_small(self.simd, batch, windows, lane, id, attachments);
            } else if medium >> lane & 1 != 0 {
                draw_medium(self.simd, batch, windows, lane, id, attachments);
            } else {
                let solved = Solved::from_batch(batch, lane);
                drawn -= u32::from(!draw_single(self.simd, &solved, self.area, id, attachments));
            }
        }
        statistics.drawn += drawn;
        statistics.culled.no_sample += count as u32 - drawn;
    }

    /// Draws one triangle by way of the scalar clip and set-up.
    #[inline(never)]
    fn one<I: Index, A: RowAttachment>(
        &self,
        list: List<'_, I>,
        number: u32,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let Some(corners) = list.triangles.get(number as usize) else { return };
        let id = list.first_id.wrapping_add(number);
        let mut outcome = None;
        let assembly = self.positions.assemble(corners.map(Index::to_usize), |vertices| {
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
}

/// Triangles and their ids.
#[derive(Clone, Copy)]
struct List<'a, I> {
    triangles: &'a [[I; 3]],
    first_id: u32,
}

impl<I: Index> List<'_, I> {
    #[inline(always)]
    fn sixteen(&self, numbers: &[u32; 16]) -> [[I; 3]; 16] {
        let mut sixteen = [[I::ZERO; 3]; 16];
        for (to, &number) in sixteen.iter_mut().zip(numbers) {
            if let Some(triangle) = self.triangles.get(number as usize) {
                *to = *triangle;
            }
        }
        sixteen
    }
}
