//! Frames that go through bins: depth and ids, by one thread or several.

use std::num::NonZeroUsize;

use halfplane::bins::{BinChunk, BinTile, BinnedTriangle, Bins, TileOrder, bin_tiles};
use halfplane::simd::{draw_any, draw_bins};
use halfplane::{
    D32, Depth, DepthFormat, DepthTest, Ids, ModelPositions, NO_ID, Region, Standard, State, Statistics,
    Viewport, texels,
};
use rayon::prelude::*;

use super::banded::pool;
use super::buffers::{depth_rows, id_rows};
use super::{TargetError, rows_of};
use crate::Matrix;
use crate::buffer::Buffer;
use crate::level::Level;

/// Rows of pixels that one thread draws at a time: a row of tiles.
const BAND: u32 = 64;

/// What such a frame needs beside the matrix.
#[derive(Debug)]
pub struct Binned<'m, D: DepthFormat<Standard> = D32> {
    positions: &'m [[f32; 3]],
    indices: &'m [u32],
    state: State<Standard>,
    order: TileOrder,
    tiles: Vec<BinTile>,
    chunks: Vec<BinChunk>,
    triangles: Vec<BinnedTriangle<Standard>>,
    depths: Buffer<D::Texel>,
    ids: Buffer<u32>,
    threads: rayon::ThreadPool,
}

impl<'m, D: DepthFormat<Standard, Texel: Send>> Binned<'m, D> {
    /// For triangles of three indices each into positions, and so many threads; the picture is the state's scissor.
    /// There is memory for `most` triangles at a time.
    ///
    /// # Errors
    ///
    /// [`TargetError::Threads`] where there are none to be had.
    pub fn new(
        positions: &'m [[f32; 3]],
        indices: &'m [u32],
        state: &State<Standard>,
        order: TileOrder,
        threads: NonZeroUsize,
        most: usize,
    ) -> Result<Self, TargetError> {
        let (width, height) = (state.scissor.width(), state.scissor.height());
        let tiles = bin_tiles(state.scissor);
        Ok(Self {
            positions,
            indices,
            state: *state,
            order,
            tiles: vec![BinTile::EMPTY; tiles],
            // Most triangles are in one tile; a chunk for each tile that is not full, and two for what is in more.
            chunks: vec![BinChunk::EMPTY; 3 * tiles + most / 4],
            triangles: (0..most).map(|_| BinnedTriangle::EMPTY).collect(),
            depths: Buffer::new(texels(width, height), D::FAR),
            ids: Buffer::new(texels(width, height), NO_ID),
            threads: pool(threads)?,
        })
    }

    /// Everything from positions and a matrix to finished buffers; the statistics, and how often the bins were drawn.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, level: Level, matrix: &Matrix) -> Result<(Statistics, u32), TargetError> {
        let Self { positions, indices, state, order, tiles, chunks, triangles, depths, ids, threads } = self;
        let area = state.scissor;
        Depth::<Standard, D>::new(area, depths.as_mut_slice(), DepthTest::LESS)?.clear(D::FAR);
        Ids::<Standard>::new(area, ids.as_mut_slice())?.clear();
        let positions = ModelPositions::new(positions, rows_of(matrix), Viewport::new(area));
        let mut bins = Bins::new(area, tiles, chunks, triangles)?;
        let (mut statistics, mut rounds, mut id) = (Statistics::default(), 0, 0);
        let mut rest = *indices;
        while !rest.is_empty() {
            let added = bins.add(&positions, rest, id, state)?;
            statistics += added.statistics;
            let (taken, next) = rest.split_at(3 * added.taken);
            (rest, id) = (next, id + taken.len() as u32 / 3);
            if bins.is_empty() {
                if let Some((one, next)) = rest.split_first_chunk::<3>() {
                    let depth = Depth::<Standard, D>::new(area, depths.as_mut_slice(), DepthTest::LESS)?;
                    let mut both = (depth, Ids::new(area, ids.as_mut_slice())?);
                    statistics += draw_any(level, &positions, one, id, state, &mut both)?;
                    (rest, id) = (next, id + 1);
                }
                continue;
            }
            draw_bands::<D>(level, &bins, *order, threads, depths.as_mut_slice(), ids.as_mut_slice())?;
            statistics += bins.finish();
            rounds += 1;
        }
        Ok((statistics, rounds))
    }

    /// The depths and the ids in rows from the top.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn rows(&mut self) -> Result<[Vec<u32>; 2], TargetError> {
        let region = self.state.scissor;
        Ok([depth_rows::<D>(region, self.depths.as_mut_slice())?, id_rows(region, self.ids.as_mut_slice())?])
    }
}

/// Draws what waits, each thread a row of tiles at a time.
fn draw_bands<D: DepthFormat<Standard, Texel: Send>>(
    level: Level,
    bins: &Bins<'_, Standard>,
    order: TileOrder,
    threads: &rayon::ThreadPool,
    depths: &mut [D::Texel],
    ids: &mut [u32],
) -> Result<(), TargetError> {
    let area = bins.region();
    let texels = texels(area.width(), BAND);
    let bands = depths.par_chunks_mut(texels).zip(ids.par_chunks_mut(texels)).enumerate();
    threads.install(|| {
        bands.try_for_each(|(at, (depths, ids))| {
            let y = area.y0() + BAND * at as u32;
            // Not empty: there is storage for a row of it.
            let Ok(band) = Region::new(area.x0(), y, area.x1(), area.y1().min(y + BAND)) else {
                return Ok(());
            };
            let depth = Depth::<Standard, D>::new(band, depths, DepthTest::LESS)?;
            let mut both = (depth, Ids::new(band, ids)?);
            Ok(draw_bins(level, bins, band, order, &mut both).map_err(halfplane::DrawError::from)?)
        })
    })
}
