//! Frames of coverage in vector registers, at any sample position and of triangles that are kept here.

use halfplane::simd::{Snapped, Triangles};
use halfplane::{Coverage, ModelPositions, Standard, State, Viewport, blocks, simd};
use halfplane_measure::level::Level;

use crate::error::ReportError;
use crate::scene::Scene;

/// A scene, some of its triangles, and memory for coverage.
#[derive(Debug)]
pub struct CoverageFrames<'s> {
    scene: &'s Scene,
    indices: Vec<u32>,
    records: Vec<Snapped>,
    coverage: Vec<u16>,
}

impl<'s> CoverageFrames<'s> {
    /// For triangles of a scene.
    ///
    /// # Errors
    ///
    /// Where the scene has a size that no target has.
    pub fn new(scene: &'s Scene, indices: Vec<u32>) -> Result<Self, ReportError> {
        let region = scene.state::<Standard>()?.scissor;
        Ok(Self {
            scene,
            indices,
            records: vec![Snapped::default(); scene.positions.len()],
            coverage: vec![0; blocks(region.width(), region.height())],
        })
    }

    /// Clears and draws, at the sample position of the state.
    ///
    /// # Errors
    ///
    /// Where the rasterizer refuses: if not the first time, then never.
    pub fn frame(&mut self, level: Level, state: &State<Standard>) -> Result<(), ReportError> {
        let m = &self.scene.matrix;
        let rows = [0, 4, 8, 12].map(|row| [m[row], m[row + 1], m[row + 2], m[row + 3]]);
        let triangles = Triangles::new(&self.indices, self.scene.positions.len())?;
        let positions = ModelPositions::new(&self.scene.positions, rows, Viewport::new(state.scissor));
        let mut coverage = Coverage::<Standard>::new(state.scissor, &mut self.coverage)?;
        coverage.clear();
        simd::draw(level, &positions, &mut self.records, triangles, 0, state, &mut coverage)?;
        Ok(())
    }

    /// Memory of the coverage.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(self.coverage.as_slice())
    }
}
