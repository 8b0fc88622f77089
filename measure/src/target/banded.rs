//! Frames drawn by several threads, each a band of the picture at a time.

use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

use halfplane::simd::{MeshletScratch, RowAttachment, draw_meshlets};
use halfplane::{D32, Depth, DepthFormat, DepthTest, Ids, NO_ID, Region, Standard, State, Viewport, texels};

use super::buffers::{depth_rows, id_rows};
use super::split::Split;
use super::{Prepared, TargetError, rows_of};
use crate::Matrix;
use crate::buffer::Buffer;
use crate::level::Level;

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
    split: Split,
    /// One for each band.
    scratch: Vec<MeshletScratch>,
    /// All but the one that calls.
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
        let split = Split::even(height, threads.get());
        let others = NonZeroUsize::new(split.count() - 1).unwrap_or(NonZeroUsize::MIN);
        Ok(Self {
            prepared,
            state: *state,
            viewport: Viewport::new(state.scissor),
            depths: Buffer::new(texels(width, height), D::FAR),
            ids: with_ids.then(|| Buffer::new(texels(width, height), NO_ID)),
            scratch: vec![MeshletScratch::NEW; split.count()],
            split,
            threads: pool(others)?,
        })
    }

    /// Everything from positions and a matrix to finished buffers.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, level: Level, matrix: &Matrix) -> Result<(), TargetError> {
        let Self { prepared, state, viewport, depths, ids, split, scratch, threads } = self;
        let (area, rows) = (state.scissor, rows_of(matrix));
        let draw = |band: &mut Band<'_, D::Texel>| -> Result<Duration, TargetError> {
            let started = Instant::now();
            let state = State { scissor: band.region, ..*state };
            let mut depth = Depth::<Standard, D>::new(band.region, band.depths, DepthTest::LESS)?;
            depth.clear(D::FAR);
            let (meshlets, scratch) = (prepared.meshlets(), &mut *band.scratch);
            match &mut band.ids {
                Some(ids) => {
                    let mut ids = Ids::new(band.region, ids)?;
                    ids.clear();
                    let mut both = (&mut depth, &mut ids);
                    draw_meshlets(level, meshlets, rows, *viewport, scratch, 0, &state, &mut both)?;
                }
                None => {
                    draw_meshlets(level, meshlets, rows, *viewport, scratch, 0, &state, &mut depth)?;
                }
            }
            Ok(started.elapsed())
        };
        let mut bands = Vec::with_capacity(split.count());
        let mut depths = depths.as_mut_slice();
        let mut ids = ids.as_mut().map(Buffer::as_mut_slice);
        for (band, scratch) in split.bands().zip(scratch) {
            let own = texels(area.width(), band.len() as u32);
            let region = Region::new(area.x0(), area.y0() + band.start, area.x1(), area.y0() + band.end);
            bands.push(Band {
                // As the picture is not empty, nor is a part of it.
                region: region.unwrap_or(area),
                depths: depths.split_off_mut(..own).unwrap_or_default(),
                ids: ids.as_mut().and_then(|ids| ids.split_off_mut(..own)),
                scratch,
                drawn: Ok(Duration::ZERO),
            });
        }
        let (first, others) = bands.split_first_mut().unzip();
        threads.in_place_scope(|scope| {
            for band in others.into_iter().flatten() {
                scope.spawn(|_| band.drawn = draw(band));
            }
            if let Some(band) = first {
                band.drawn = draw(band);
            }
        });
        let times: Result<Vec<_>, _> = bands.into_iter().map(|band| band.drawn).collect();
        split.learn(&times?);
        Ok(())
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

/// A thread's part of a frame.
struct Band<'a, T> {
    region: Region<Standard>,
    depths: &'a mut [T],
    ids: Option<&'a mut [u32]>,
    scratch: &'a mut MeshletScratch,
    /// How long it took.
    drawn: Result<Duration, TargetError>,
}
