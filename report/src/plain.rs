//! Frames at any sub-pixel format, into any attachments, with plain arrays for lanes: what is compared here
//! differs in one thing only.

use std::marker::PhantomData;

use halfplane::{
    Attachment, ClipPositions, D32, Depth, DepthTest, DrawError, Format, Ids, NO_ID, RegionError, State,
    Statistics, StorageError, Viewport, draw, texels,
};
use halfplane_measure::clip;

use crate::formats::{Grid, On, Own};
use crate::scene::Scene;

/// A scene and room for its clip-space vertices.
#[derive(Debug)]
pub struct Plain<'s, F> {
    scene: &'s Scene,
    clip: Vec<[f32; 4]>,
    state: State<F>,
    viewport: Viewport<F>,
}

impl<'s, F: Format> Plain<'s, F> {
    /// For a scene of a size that the format has.
    ///
    /// # Errors
    ///
    /// Where it has not.
    pub fn new(scene: &'s Scene) -> Result<Self, RegionError> {
        let state = scene.state()?;
        let viewport = Viewport::new(state.scissor);
        Ok(Self { scene, clip: vec![[0.0; 4]; scene.positions.len()], state, viewport })
    }

    /// The drawing state.
    #[must_use]
    pub fn state(&self) -> &State<F> {
        &self.state
    }

    /// The viewport.
    #[must_use]
    pub fn viewport(&self) -> &Viewport<F> {
        &self.viewport
    }

    /// Transforms every vertex and draws every triangle.
    ///
    /// # Errors
    ///
    /// None for attachments that are as large as the picture.
    pub fn draw<A: Attachment<F>>(&mut self, attachments: &mut A) -> Result<Statistics, DrawError> {
        self.draw_on::<Own, A>(attachments)
    }

    /// The same on another grid.
    ///
    /// # Errors
    ///
    /// As [`draw`](Self::draw).
    pub fn draw_on<G: Grid<F>, A: Attachment<F>>(
        &mut self,
        attachments: &mut A,
    ) -> Result<Statistics, DrawError> {
        for (vertex, &position) in self.clip.iter_mut().zip(&self.scene.positions) {
            *vertex = clip(position, &self.scene.matrix);
        }
        let positions = On(ClipPositions::new(&self.clip, self.viewport), PhantomData::<G>);
        draw(&positions, &self.scene.indices, 0, &self.state, attachments)
    }
}

/// Memory for depth and ids.
#[derive(Debug)]
pub struct DepthIds<F> {
    state: State<F>,
    depth: Vec<u32>,
    ids: Vec<u32>,
}

impl<F: Format<Word = u64>> DepthIds<F> {
    /// For a picture that is the state's scissor.
    #[must_use]
    pub fn new(state: &State<F>) -> Self {
        let texels = texels(state.scissor.width(), state.scissor.height());
        Self { state: *state, depth: vec![u32::MAX; texels], ids: vec![NO_ID; texels] }
    }

    /// Both, cleared.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub fn clear(&mut self) -> Result<(Depth<'_, F, D32>, Ids<'_, F>), StorageError> {
        let mut depth = Depth::new(self.state.scissor, &mut self.depth, DepthTest::LESS)?;
        let mut ids = Ids::new(self.state.scissor, &mut self.ids)?;
        depth.clear(u32::MAX);
        ids.clear();
        Ok((depth, ids))
    }

    /// The ids, row by row.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub fn id_rows(&mut self) -> Result<Vec<u32>, StorageError> {
        rows(&self.state, &mut self.ids)
    }
}

/// Ids, row by row.
///
/// # Errors
///
/// [`StorageError`] for memory of another size.
pub fn rows<F: Format>(state: &State<F>, ids: &mut [u32]) -> Result<Vec<u32>, StorageError> {
    let region = state.scissor;
    let mut rows = vec![NO_ID; region.width() as usize * region.height() as usize];
    Ids::<F>::new(region, ids)?.to_linear(&mut rows)?;
    Ok(rows)
}
