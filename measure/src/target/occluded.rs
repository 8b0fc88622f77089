//! Frames that ask what is hidden before they draw it.

use std::time::{Duration, Instant};

use halfplane::simd::{self, BatchOrder, MeshletScratch, Occlusion, RowAttachment, Visibility, draw_batches};
use halfplane::{
    D32, DepthFormat, DepthRange, DepthTest, HierarchicalDepth, Ids, NO_ID, Standard, State, Statistics,
    Viewport, depth_ranges, texels,
};

use super::buffers::{depth_rows, id_rows};
use super::{Clustered, TargetError, rows_of};
use crate::Matrix;
use crate::buffer::Buffer;
use crate::level::Level;

/// What such a frame needs beside the matrix: depth, and ids where they are asked for.
#[derive(Debug)]
pub struct Occluded<'m, D: DepthFormat<Standard> = D32> {
    clustered: &'m Clustered,
    state: State<Standard>,
    viewport: Viewport<Standard>,
    depths: Buffer<D::Texel>,
    ids: Option<Buffer<u32>>,
    ranges: Vec<DepthRange>,
    order: Vec<BatchOrder>,
    scratch: Box<MeshletScratch>,
}

impl<'m, D: DepthFormat<Standard>> Occluded<'m, D>
where
    for<'a> HierarchicalDepth<'a, Standard, D>: RowAttachment,
{
    /// For a clustered mesh; the picture is the state's scissor.
    #[must_use]
    pub fn new(clustered: &'m Clustered, state: &State<Standard>, with_ids: bool) -> Self {
        let (width, height) = (state.scissor.width(), state.scissor.height());
        Self {
            clustered,
            state: *state,
            viewport: Viewport::new(state.scissor),
            depths: Buffer::new(texels(width, height), D::FAR),
            ids: with_ids.then(|| Buffer::new(texels(width, height), NO_ID)),
            ranges: vec![DepthRange::UNKNOWN; depth_ranges(width, height)],
            order: vec![BatchOrder::default(); clustered.batches().len()],
            scratch: Box::default(),
        }
    }

    /// Everything from positions and a matrix to finished buffers: clear, sort, ask, transform, draw.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, level: Level, matrix: &Matrix) -> Result<(Statistics, Occlusion), TargetError> {
        let Self { clustered, state, viewport, depths, ids, ranges, order, scratch } = self;
        let (region, rows) = (state.scissor, rows_of(matrix));
        let (batches, meshlets) = (clustered.batches(), clustered.meshlets());
        let depths = depths.as_mut_slice();
        let mut depth = HierarchicalDepth::<Standard, D>::new(region, depths, ranges, DepthTest::LESS)?;
        depth.clear(D::FAR);
        let Some(ids) = ids else {
            return Ok(draw_batches(
                level, batches, meshlets, rows, *viewport, order, scratch, 0, state, &mut depth,
            )?);
        };
        let mut ids = Ids::new(region, ids.as_mut_slice())?;
        ids.clear();
        let mut both = (&mut depth, &mut ids);
        Ok(draw_batches(level, batches, meshlets, rows, *viewport, order, scratch, 0, state, &mut both)?)
    }

    /// What can be seen of boxes, each between two corners, behind the last frame's depths: asked so many times, and how
    /// long each took. The first time looks at all depths; later ones find their ranges known.
    ///
    /// # Errors
    ///
    /// None for memory that was made here, and as many answers as boxes.
    pub fn ask(
        &mut self,
        level: Level,
        matrix: &Matrix,
        boxes: &[[[f32; 3]; 2]],
        answers: &mut [Visibility],
        passes: u32,
    ) -> Result<Vec<Duration>, TargetError> {
        let (region, depths) = (self.state.scissor, self.depths.as_mut_slice());
        let mut depth =
            HierarchicalDepth::<Standard, D>::new(region, depths, &mut self.ranges, DepthTest::LESS)?;
        let rows = rows_of(matrix);
        let mut pass = || {
            let started = Instant::now();
            simd::ask(level, boxes, &rows, &self.viewport, &self.state, &mut depth, answers)?;
            Ok(started.elapsed())
        };
        (0..passes).map(|_| pass()).collect()
    }

    /// The depths in rows from the top.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn depth_rows(&mut self) -> Result<Vec<u32>, TargetError> {
        depth_rows::<D>(self.state.scissor, self.depths.as_mut_slice())
    }

    /// The ids in rows from the top: places in the clustered list; none where none are drawn.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn id_rows(&mut self) -> Result<Vec<u32>, TargetError> {
        let ids = self.ids.as_mut();
        ids.map_or(Ok(Vec::new()), |ids| id_rows(self.state.scissor, ids.as_mut_slice()))
    }
}
