//! Frames drawn by several threads, each a band of the picture at a time.

use std::num::NonZeroUsize;

use halfplane::simd::{MeshletScratch, RowAttachment, draw_meshlets};
use halfplane::{D32, Depth, DepthFormat, DepthTest, Ids, NO_ID, Region, Standard, State, Viewport, texels};
use rayon::prelude::*;

use super::buffers::{depth_rows, id_rows};
use super::{Prepared, TargetError, rows_of};
use crate::Matrix;
use crate::buffer::Buffer;
use crate::level::Level;

/// Bands for each thread: those who are done early take another's. More of them share the work better, and draw what
/// lies across their ends more often.
const BANDS: usize = 2;

/// A band's first row, its depths and its ids.
type Band<'b, T> = ((u32, &'b mut [T]), Option<&'b mut [u32]>);

/// So many threads.
pub(super) fn pool(threads: NonZeroUsize) -> Result<rayon::ThreadPool, TargetError> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build();
    pool.map_err(|error| TargetError::Threads(error.to_string()))
}

/// What such a frame needs beside the matrix: depth, and ids where they are asked for.
#[derive(Debug)]
pub struct Banded<'m, D: DepthFormat<Standard> = D32> {
    prepared: &'m Prepared,
    state: State<Standard>,
    viewport: Viewport<Standard>,
    depths: Buffer<D::Texel>,
    ids: Option<Buffer<u32>>,
    /// Rows of pixels in a band, a multiple of 4.
    band: u32,
    threads: rayon::ThreadPool,
}

impl<'m, D: DepthFormat<Standard, Texel: Send>> Banded<'m, D>
where
    for<'a> Depth<'a, Standard, D>: RowAttachment,
{
    /// For a mesh's meshlets and so many threads; the picture is the state's scissor.
    ///
    /// # Errors
    ///
    /// [`TargetError::Threads`] where there are none to be had.
    pub fn new(
        prepared: &'m Prepared,
        state: &State<Standard>,
        threads: NonZeroUsize,
        with_ids: bool,
    ) -> Result<Self, TargetError> {
        let (width, height) = (state.scissor.width(), state.scissor.height());
        let bands = if threads.get() == 1 { 1 } else { threads.get().saturating_mul(BANDS) };
        let band = (height as usize).div_ceil(bands).next_multiple_of(16) as u32;
        Ok(Self {
            prepared,
            state: *state,
            viewport: Viewport::new(state.scissor),
            depths: Buffer::new(texels(width, height), D::FAR),
            ids: with_ids.then(|| Buffer::new(texels(width, height), NO_ID)),
            band,
            threads: pool(threads)?,
        })
    }

    /// Everything from positions and a matrix to finished buffers.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, level: Level, matrix: &Matrix) -> Result<(), TargetError> {
        let Self { prepared, state, viewport, depths, ids, band, threads } = self;
        let (area, rows) = (state.scissor, rows_of(matrix));
        let texels = texels(area.width(), *band);
        let bands: Vec<(u32, &mut [D::Texel])> =
            (area.y0()..).step_by(*band as usize).zip(depths.as_mut_slice().chunks_mut(texels)).collect();
        let ids: Vec<Option<&mut [u32]>> = match ids {
            Some(ids) => ids.as_mut_slice().chunks_mut(texels).map(Some).collect(),
            None => bands.iter().map(|_| None).collect(),
        };
        let draw = |scratch: &mut Box<MeshletScratch>, ((y, depths), ids): Band<'_, D::Texel>| {
            let end = area.y1().min(y + *band);
            // Not empty: there is storage for a row of it.
            let Ok(region) = Region::new(area.x0(), y, area.x1(), end) else { return Ok(()) };
            let state = State { scissor: region, ..*state };
            let mut depth = Depth::<Standard, D>::new(region, depths, DepthTest::LESS)?;
            depth.clear(D::FAR);
            let meshlets = prepared.meshlets();
            match ids {
                Some(ids) => {
                    let mut ids = Ids::new(region, ids)?;
                    ids.clear();
                    let mut both = (&mut depth, &mut ids);
                    draw_meshlets(level, meshlets, rows, *viewport, scratch, 0, &state, &mut both)?;
                }
                None => {
                    draw_meshlets(level, meshlets, rows, *viewport, scratch, 0, &state, &mut depth)?;
                }
            }
            Ok(())
        };
        threads.install(|| bands.into_par_iter().zip(ids).try_for_each_init(Box::default, draw))
    }

    /// The depths in rows from the top.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn depth_rows(&mut self) -> Result<Vec<u32>, TargetError> {
        depth_rows::<D>(self.state.scissor, self.depths.as_mut_slice())
    }

    /// The ids in rows from the top; none where none are drawn.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn id_rows(&mut self) -> Result<Vec<u32>, TargetError> {
        let ids = self.ids.as_mut();
        ids.map_or(Ok(Vec::new()), |ids| id_rows(self.state.scissor, ids.as_mut_slice()))
    }
}
