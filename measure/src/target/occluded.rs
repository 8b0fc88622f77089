//! Frames that ask what is hidden before they draw it: depth alone.

use halfplane::simd::{BatchOrder, MeshletScratch, Occlusion, draw_batches};
use halfplane::{
    D32, Depth, DepthFormat, DepthRange, DepthTest, HierarchicalDepth, Standard, State, Statistics, Viewport,
    depth_ranges, texels,
};

use super::{Clustered, TargetError, rows_of};
use crate::Matrix;
use crate::buffer::Buffer;
use crate::level::Level;

/// What such a frame needs beside the matrix.
#[derive(Debug)]
pub struct Occluded<'m> {
    clustered: &'m Clustered,
    state: State<Standard>,
    viewport: Viewport<Standard>,
    depths: Buffer<u32>,
    ranges: Vec<DepthRange>,
    order: Vec<BatchOrder>,
    scratch: Box<MeshletScratch>,
}

impl<'m> Occluded<'m> {
    /// For a clustered mesh; the picture is the state's scissor.
    #[must_use]
    pub fn new(clustered: &'m Clustered, state: &State<Standard>) -> Self {
        let (width, height) = (state.scissor.width(), state.scissor.height());
        Self {
            clustered,
            state: *state,
            viewport: Viewport::new(state.scissor),
            depths: Buffer::new(texels(width, height), <D32 as DepthFormat<Standard>>::FAR),
            ranges: vec![DepthRange::UNKNOWN; depth_ranges(width, height)],
            order: vec![BatchOrder::default(); clustered.batches().len()],
            scratch: Box::default(),
        }
    }

    fn depth(&mut self) -> Result<HierarchicalDepth<'_, Standard>, TargetError> {
        let (depths, ranges) = (self.depths.as_mut_slice(), &mut self.ranges);
        Ok(HierarchicalDepth::new(self.state.scissor, depths, ranges, DepthTest::LESS)?)
    }

    /// Everything from positions and a matrix to finished depths: clear, sort, ask, transform, draw.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, level: Level, matrix: &Matrix) -> Result<(Statistics, Occlusion), TargetError> {
        let Self { clustered, state, viewport, depths, ranges, order, scratch } = self;
        let mut depth =
            HierarchicalDepth::<Standard>::new(state.scissor, depths.as_mut_slice(), ranges, DepthTest::LESS)?;
        depth.clear(u32::MAX);
        let (batches, meshlets) = (clustered.batches(), clustered.meshlets());
        let rows = rows_of(matrix);
        Ok(draw_batches(level, batches, meshlets, rows, *viewport, order, scratch, 0, state, &mut depth)?)
    }

    /// What is hidden behind the last frame's depths: asks of every box between two corners.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub fn ask<R>(
        &mut self,
        questions: impl FnOnce(&mut HierarchicalDepth<'_, Standard>, &Viewport<Standard>) -> R,
    ) -> Result<R, TargetError> {
        let viewport = self.viewport;
        Ok(questions(&mut self.depth()?, &viewport))
    }

    /// The depths in rows from the top.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn depth_rows(&mut self) -> Result<Vec<u32>, TargetError> {
        let region = self.state.scissor;
        let mut rows = vec![0; region.width() as usize * region.height() as usize];
        Depth::<Standard>::new(region, self.depths.as_mut_slice(), DepthTest::LESS)?.to_linear(&mut rows)?;
        Ok(rows)
    }
}
