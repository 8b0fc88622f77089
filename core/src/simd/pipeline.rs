//! A whole draw: vertices, culling, set-up, rows.

use super::{
    any::draw_any,
    attachment::RowAttachment,
    cull::Culling,
    level::Level,
    queue::Queue,
    rows::{self, Solved, draw_small},
    setup::{Batch, DepthSetup, set_up},
    vertex::{Snapped, stage},
};
use crate::{
    attachments::{D16, D32, DepthFormat},
    draw::{self, DrawError, Index, State, Statistics},
    geometry::{Culled, Positions, Region, Vertex},
    numbers::Standard,
    transform::ModelPositions,
};
use fearless_simd::{Simd, dispatch};

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
        return draw_any(level, positions, indices, first_id, state, attachments);
    };
    let mut statistics = Statistics { submitted, ..Statistics::default() };
    dispatch!(level, simd => {
        stage(simd, positions, records);
        let drawing = Drawing { simd, positions, records, area, state };
        drawing.run(triangles, first_id, attachments, &mut statistics);
    });
    Ok(statistics)
}

/// What stays the same in a draw.
#[derive(Clone, Copy)]
struct Drawing<'a, S> {
    simd: S,
    positions: &'a ModelPositions<'a, Standard>,
    records: &'a [Snapped],
    area: Region<Standard>,
    state: &'a State<Standard>,
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
        let mut queue = Queue::EMPTY;
        let mut batch = Batch::EMPTY;
        let mut done = 0;
        while done < triangles.len() {
            done += culling.fill(self.records, triangles, done, first_id, &mut queue, statistics);
            self.draw_queue(&queue, &mut batch, attachments, statistics);
            queue.clear();
        }
    }

    /// Draws the queued triangles in order.
    #[inline(always)]
    fn draw_queue<A: RowAttachment>(
        &self,
        queue: &Queue,
        batch: &mut Batch,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        let sample = self.state.sample.of_pixel(0, 0);
        let mut at = 0;
        while at < queue.len() {
            let (eight, ids, count) = queue.run(at);
            if count == 0 {
                let (triangle, id) = queue.slow(at);
                self.one(triangle, id, attachments, statistics);
                at += 1;
                continue;
            }
            set_up(self.simd, self.records, eight, self.area, self.state, A::DEPTH, batch);
            for (lane, &id) in ids.iter().take(count).enumerate() {
                let solved = Solved::from_batch(batch, lane, sample);
                let drawn = draw_small(self.simd, &solved, self.area, id, attachments);
                statistics.drawn += u32::from(drawn);
                statistics.culled.no_sample += u32::from(!drawn);
            }
            at += count;
        }
    }

    /// Draws one triangle by way of the scalar clip and set-up.
    #[inline(never)]
    fn one<A: RowAttachment>(
        &self,
        corners: [u32; 3],
        id: u32,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
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
        let solved = Solved::from_triangle(&triangle, bounds, vertex);
        if rows::draw_any(self.simd, &solved, self.area, id, attachments) {
            Ok(())
        } else {
            Err(Culled::NoSample)
        }
    }
}
