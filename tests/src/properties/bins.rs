//! Triangles that go through bins are those that are drawn at once.

use crate::{Failure, ensure, ensure_eq, failure::Verdict, shapes::Random};
use halfplane::{
    Attachment, Count, Coverage, D16, Depth, DepthTest, DrawError, Format, Ids, NO_ID, Positions, Region,
    State, Statistics, StorageError,
    bins::{Added, BinChunk, BinTile, BinnedDraw, BinnedTriangle, Bins, TileOrder, bin_tiles, draw_binned},
    blocks, draw, texels,
};
use std::collections::BTreeSet;

/// How often what happened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Met {
    /// Rounds beyond the first, as the memory was full.
    pub more_rounds: u32,
    /// Triangles that fitted into no empty bins.
    pub unbinned: u32,
    /// Triangles that were drawn.
    pub drawn: u32,
}

impl Met {
    /// Both together.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self {
            more_rounds: self.more_rounds + other.more_rounds,
            unbinned: self.unbinned + other.unbinned,
            drawn: self.drawn + other.drawn,
        }
    }
}

/// The memory of all attachments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Picture {
    masks: Vec<u16>,
    depths: Vec<u16>,
    pub(super) nearest: Vec<u32>,
    pub(super) last: Vec<u32>,
    samples: u64,
}

impl Picture {
    pub(super) fn new<F: Format>(region: Region<F>) -> Self {
        let (blocks, texels) =
            (blocks(region.width(), region.height()), texels(region.width(), region.height()));
        Self {
            masks: vec![0; blocks],
            depths: vec![u16::MAX; texels],
            nearest: vec![NO_ID; texels],
            last: vec![NO_ID; texels],
            samples: 0,
        }
    }

    /// Lets `paint` draw into everything: coverage, the last id, depth with the nearest id, and a count.
    pub(super) fn paint<F: Format, R>(
        &mut self,
        region: Region<F>,
        paint: impl FnOnce(&mut Everything<'_, '_, F>) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        let mut count = Count { samples: self.samples };
        let depth = Depth::new(region, &mut self.depths, DepthTest::LESS)?;
        let mut all = (
            (Coverage::new(region, &mut self.masks)?, Ids::new(region, &mut self.last)?),
            &mut count,
            (depth, Ids::new(region, &mut self.nearest)?),
        );
        let result = paint(&mut all)?;
        self.samples = count.samples;
        Ok(result)
    }
}

pub(super) type Everything<'a, 'm, F> =
    ((Coverage<'m, F>, Ids<'m, F>), &'a mut Count, (Depth<'m, F, D16>, Ids<'m, F>));

/// Memory for bins, of so many chunks and triangles.
pub(super) struct Memory<F: Format> {
    tiles: Vec<BinTile>,
    chunks: Vec<BinChunk>,
    triangles: Vec<BinnedTriangle<F>>,
}

impl<F: Format> Memory<F> {
    pub(super) fn new(region: Region<F>, chunks: usize, triangles: usize) -> Self {
        Self {
            tiles: vec![BinTile::EMPTY; bin_tiles(region)],
            chunks: vec![BinChunk::EMPTY; chunks],
            triangles: (0..triangles).map(|_| BinnedTriangle::EMPTY).collect(),
        }
    }

    pub(super) fn bins(&mut self, region: Region<F>) -> Result<Bins<'_, F>, StorageError> {
        Bins::new(region, &mut self.tiles, &mut self.chunks, &mut self.triangles)
    }
}

/// The same picture, the same statistics, through bins of any size, in either order of tiles, at once and by steps.
pub fn binned_is_immediate<F: Format, P: Positions<F> + ?Sized>(
    positions: &P,
    indices: &[u32],
    region: Region<F>,
    state: &State<F>,
    seed: u64,
) -> Result<Met, Failure> {
    let mut random = Random(seed);
    let first_id = [0, 7, NO_ID - (indices.len() / 3) as u32][random.below(3)];
    let mut expected = Picture::new(region);
    let wanted = expected.paint(region, |all| Ok(draw(positions, indices, first_id, state, all)?))?;
    let mut met = Met { drawn: wanted.drawn, ..Met::default() };
    for order in [TileOrder::Rows, TileOrder::Hilbert] {
        let chunks = [0, 1, random.below(12), 300][random.below(4)];
        let triangles = [0, 1 + random.below(6), 100][random.below(3)];
        let what = format!("{order:?}, {chunks} chunks, {triangles} triangles");
        let mut memory = Memory::new(region, chunks, triangles);
        let mut bins = memory.bins(region)?;
        let mut given = Picture::new(region);
        let drawn = given.paint(region, |all| {
            draw_anyhow(&mut random, &mut bins, positions, indices, first_id, state, order, all)
        })?;
        ensure_eq!(drawn.statistics, wanted, "{what}");
        ensure!(given == expected, "{what}: another picture");
        ensure!(bins.is_empty(), "{what}: something waits");
        met.more_rounds += drawn.rounds.saturating_sub(1);
        met.unbinned += drawn.unbinned;

        let mut given = Picture::new(region);
        let statistics = given.paint(region, |all| {
            by_steps(&mut bins, positions, indices, first_id, state, &mut random, order, all)
        })?;
        ensure_eq!(statistics, wanted, "{what}, by steps");
        ensure!(given == expected, "{what}, by steps: another picture");
    }
    Ok(met)
}

/// A draw through bins, at any level.
#[expect(clippy::too_many_arguments, reason = "what a draw needs")]
fn draw_anyhow<F: Format, P: Positions<F> + ?Sized, A: Attachment<F>>(
    random: &mut Random,
    bins: &mut Bins<'_, F>,
    positions: &P,
    indices: &[u32],
    first_id: u32,
    state: &State<F>,
    order: TileOrder,
    all: &mut A,
) -> Result<BinnedDraw, Failure> {
    #[cfg(feature = "simd")]
    if let Some(level) = super::simd::levels().nth(random.below(6)) {
        use halfplane::simd;
        return Ok(simd::draw_binned(level, bins, positions, indices, first_id, state, order, all)?);
    }
    let _ = random;
    Ok(draw_binned(bins, positions, indices, first_id, state, order, all)?)
}

/// A part of what waits, at any level.
fn part_anyhow<F: Format, A: Attachment<F>>(
    random: &mut Random,
    bins: &Bins<'_, F>,
    part: Region<F>,
    order: TileOrder,
    all: &mut A,
) -> Result<(), Failure> {
    #[cfg(feature = "simd")]
    if let Some(level) = super::simd::levels().nth(random.below(6)) {
        return Ok(halfplane::simd::draw_bins(level, bins, part, order, all)?);
    }
    let _ = random;
    Ok(bins.draw(part, order, all)?)
}

/// Adds and draws in turns, the target in parts that share no pixel.
#[expect(clippy::too_many_arguments, reason = "what a draw needs")]
fn by_steps<F: Format, P: Positions<F> + ?Sized, A: Attachment<F>>(
    bins: &mut Bins<'_, F>,
    positions: &P,
    indices: &[u32],
    first_id: u32,
    state: &State<F>,
    random: &mut Random,
    order: TileOrder,
    attachments: &mut A,
) -> Result<Statistics, Failure> {
    let region = bins.region();
    let mut statistics = Statistics::default();
    let mut rest = indices;
    let mut id = first_id;
    while !rest.is_empty() {
        // Sometimes a few triangles at a time, so that several lists wait together.
        let some = if random.below(2) == 0 { rest.len() } else { rest.len().min(3 * (1 + random.below(4))) };
        let Added { taken, statistics: now } = bins.add(positions, &rest[..some], id, state)?;
        statistics += now;
        rest = &rest[3 * taken..];
        id += taken as u32;
        if 3 * taken == some && !rest.is_empty() && random.below(3) > 0 {
            continue;
        }
        let cut = region.y0() + 4 * random.below(region.height().div_ceil(4) as usize) as u32;
        let parts = [[region.y0(), cut], [cut, region.y1()]]
            .map(|[y0, y1]| Region::<F>::new(region.x0(), y0, region.x1(), y1));
        let across = region.x0() + random.below(region.width() as usize) as u32;
        for part in parts.into_iter().flatten() {
            let sides = [[part.x0(), across], [across, part.x1()]];
            for side in
                sides.map(|[x0, x1]| Region::<F>::new(x0, part.y0(), x1, part.y1())).into_iter().flatten()
            {
                part_anyhow(random, bins, side, order, attachments)?;
            }
        }
        let empty = bins.is_empty();
        statistics += bins.finish();
        if taken == 0 && empty && !rest.is_empty() {
            statistics += draw(positions, &rest[..3], id, state, attachments)?;
            rest = &rest[3..];
            id += 1;
        }
    }
    Ok(statistics)
}

/// Draws that are refused leave bins and attachments as they were; so do bins with too little memory.
pub fn errors_change_nothing<F: Format>(region: Region<F>, seed: u64) -> Verdict {
    let mut random = Random(seed);
    let mut memory = Memory::new(region, bin_tiles(region), 10);
    let side = |from: u32, to: u32| (from..to).map(|pixel| pixel / 64).collect::<BTreeSet<_>>().len();
    let touched = side(region.x0(), region.x1()) * side(region.y0(), region.y1());
    ensure_eq!(bin_tiles(region), touched, "tiles of {region:?}");
    let (needed, given) = (memory.tiles.len(), random.below(memory.tiles.len()));
    let short = Bins::new(region, &mut memory.tiles[..given], &mut memory.chunks, &mut memory.triangles);
    ensure_eq!(
        short.err(),
        Some(StorageError::BufferTooSmall { needed, given }),
        "{given} of {needed} tiles"
    );
    let mut bins = memory.bins(region)?;
    let corner = |x: u32, y: u32| {
        halfplane::Vertex::<F>::new((x << F::SUBPIXEL_BITS) as i32, (y << F::SUBPIXEL_BITS) as i32, 9)
    };
    let vertices = [
        corner(region.x0(), region.y0())?,
        corner(region.x1(), region.y0())?,
        corner(region.x0(), region.y1())?,
    ];
    let state = State::new(region);
    let before = Picture::new(region);
    let mut picture = before.clone();
    let errors = picture.paint(region, |all| {
        let indices: [&[u32]; 3] = [&[0, 1], &[0, 1, 2, 0, 3, 1], &[0, 1, 2]];
        let ids = [0, 0, NO_ID];
        let mut errors = Vec::new();
        for (indices, id) in indices.into_iter().zip(ids) {
            let order = TileOrder::Rows;
            errors.push(bins.add(&vertices[..], indices, id, &state).err());
            errors.push(draw_binned(&mut bins, &vertices[..], indices, id, &state, order, all).err());
        }
        Ok(errors)
    })?;
    let expected = [
        DrawError::IndexCount { count: 2 },
        DrawError::IndexOutOfRange { at: 4, index: 3, vertices: 3 },
        DrawError::TooManyIds { first_id: NO_ID, triangles: 1 },
    ];
    for (at, expected) in expected.iter().enumerate() {
        ensure_eq!(errors[2 * at].as_ref(), Some(expected), "added");
        ensure_eq!(errors[2 * at + 1].as_ref(), Some(expected), "drawn");
    }
    ensure!(picture == before && bins.is_empty(), "something is there after an error");
    // A scissor beyond the bins.
    if let Ok(larger) = Region::new(region.x0(), region.y0(), region.x1() + 1, region.y1()) {
        let error = bins.add(&vertices[..], &[0u32, 1, 2], 0, &State::new(larger)).err();
        ensure!(
            matches!(error, Some(DrawError::OutsideAttachment(_))),
            "{error:?} for a scissor beyond the bins"
        );
    }
    // A part beyond the attachments.
    let added = bins.add(&vertices[..], &[0u32, 1, 2], 0, &state)?;
    ensure_eq!(added.taken, 1, "taken");
    if let Ok(smaller) = Region::new(region.x0(), region.y0(), region.x1(), region.y1() - 1) {
        let mut picture = Picture::new(smaller);
        let refused = picture.paint(smaller, |all| Ok(bins.draw(region, TileOrder::Rows, all).is_err()))?;
        ensure!(refused && picture == Picture::new(smaller), "a part beyond the attachments is drawn");
    }
    Ok(())
}
