//! Bins: triangles sorted by the 64x64 tiles that they touch, to be drawn tile by tile.
//!
//! A tile's depths and ids stay in the cache while all its triangles are drawn, and tiles can be drawn by several
//! threads, each with a part of the target. The picture and the statistics are those of [`draw`](crate::draw()): in
//! each tile the triangles come in the submitted order.

mod add;
mod draw;
mod lists;
mod order;
#[cfg(any(kani, test))]
mod proofs;

pub use add::Added;
#[cfg(feature = "simd")]
pub(crate) use draw::draw_binned_with;
pub use draw::{BinnedDraw, draw_binned};
pub use lists::{BinChunk, BinTile};
pub use order::TileOrder;

use crate::{
    attachments::StorageError,
    geometry::{Culled, Region, Sample, Vertex},
    numbers::{Coordinate, Format},
    traversal::TILE,
};
use core::sync::atomic::AtomicBool;
use lists::Lists;

/// How many tiles a region has: those of the target's that it touches.
#[must_use]
pub fn bin_tiles<F: Format>(region: Region<F>) -> usize {
    columns(region) as usize * rows(region) as usize
}

fn columns<F: Format>(region: Region<F>) -> u32 {
    region.x1().div_ceil(TILE) - region.x0() / TILE
}

fn rows<F: Format>(region: Region<F>) -> u32 {
    region.y1().div_ceil(TILE) - region.y0() / TILE
}

/// Memory for one window triangle: 64 bytes.
#[derive(Debug)]
pub struct BinnedTriangle<F: Format> {
    vertices: [Vertex<F>; 3],
    /// `[x0, y0, x1, y1]`: the pixels that it may cover.
    bounds: [u32; 4],
    id: u32,
    /// Whether it is a further piece of the submitted triangle before.
    continued: bool,
    /// What becomes of the submitted triangle if none of its pieces covers a sample; in the last of them.
    otherwise: Culled,
    /// Whether it has covered a sample; written by whoever draws a tile.
    drawn: AtomicBool,
}

impl<F: Format> BinnedTriangle<F> {
    /// To fill arrays with: `[const { BinnedTriangle::EMPTY }; 1000]`.
    #[expect(clippy::declare_interior_mutable_const, reason = "each use is to be another one")]
    pub const EMPTY: Self = Self {
        vertices: [Vertex::at(Coordinate::ZERO, Coordinate::ZERO, 0); 3],
        bounds: [0; 4],
        id: 0,
        continued: false,
        otherwise: Culled::NoSample,
        drawn: AtomicBool::new(false),
    };
}

/// Triangles that wait to be drawn, by tiles, in memory of the caller.
///
/// ```
/// use halfplane::{bins::*, *};
///
/// let region = Region::<Standard>::of_size(200, 100)?;
/// let mut tiles = [BinTile::EMPTY; 8];
/// let mut chunks = [BinChunk::EMPTY; 32];
/// let mut triangles = [const { BinnedTriangle::EMPTY }; 64];
/// let mut bins = Bins::new(region, &mut tiles, &mut chunks, &mut triangles)?;
///
/// let vertices = [Vertex::new(0, 0, 9)?, Vertex::new(200 << 8, 0, 9)?, Vertex::new(0, 100 << 8, 9)?];
/// let state = State::new(region);
/// let mut storage = [0; texels(200, 100)];
/// let mut depth = Depth::<Standard>::new(region, &mut storage, DepthTest::LESS)?;
/// depth.clear(u32::MAX);
///
/// // All at once; draws in between where the memory is full.
/// let order = TileOrder::Rows;
/// let drawn = draw_binned(&mut bins, &vertices[..], &[0u16, 1, 2], 0, &state, order, &mut depth)?;
/// assert_eq!(drawn.statistics, draw(&vertices[..], &[0u16, 1, 2], 0, &state, &mut ())?);
/// assert_eq!((drawn.rounds, depth.get(0, 0)), (1, Some(9)));
///
/// // By steps: whatever is in the bins is drawn, here a part of the target.
/// let added = bins.add(&vertices[..], &[0u16, 1, 2], 0, &state)?;
/// assert_eq!(added.taken, 1);
/// bins.draw(Region::new(0, 0, 200, 64)?, order, &mut depth)?;
/// bins.draw(Region::new(0, 64, 200, 100)?, order, &mut depth)?;
/// assert_eq!(bins.finish().drawn, 1);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Bins<'m, F: Format> {
    region: Region<F>,
    lists: Lists<'m>,
    triangles: &'m mut [BinnedTriangle<F>],
    /// Triangles in use: the first ones.
    count: usize,
    /// Of all triangles here.
    sample: Sample<F>,
}

/// The largest number of a triangle, and one more; the bit above says that it covers the tile.
const MAX_TRIANGLES: usize = 1 << 31;

impl<'m, F: Format> Bins<'m, F> {
    /// Empty bins for the pixels of `region`, with the memory of [`bin_tiles`] tiles, of as many chunks as there may
    /// be, and of as many window triangles. How many of those are right depends on what is drawn; with fewer, draws
    /// come in more rounds.
    ///
    /// # Errors
    ///
    /// [`StorageError::BufferTooSmall`], counted in tiles.
    pub fn new(
        region: Region<F>,
        tiles: &'m mut [BinTile],
        chunks: &'m mut [BinChunk],
        triangles: &'m mut [BinnedTriangle<F>],
    ) -> Result<Self, StorageError> {
        let (needed, given) = (bin_tiles(region), tiles.len());
        let tiles = tiles.get_mut(..needed).ok_or(StorageError::BufferTooSmall { needed, given })?;
        let most = triangles.len().min(MAX_TRIANGLES);
        let triangles = triangles.get_mut(..most).unwrap_or_default();
        Ok(Self { region, lists: Lists::new(tiles, chunks), triangles, count: 0, sample: Sample::CENTER })
    }

    /// The region.
    #[must_use]
    pub const fn region(&self) -> Region<F> {
        self.region
    }

    /// Whether nothing waits.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The place of a tile's list, by its column and row in the target.
    fn place(&self, column: u32, row: u32) -> usize {
        let (left, top) = (self.region.x0() / TILE, self.region.y0() / TILE);
        row.wrapping_sub(top) as usize * columns(self.region) as usize + column.wrapping_sub(left) as usize
    }
}
