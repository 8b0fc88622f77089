//! Depth with the nearest and the farthest value of each square of 16x16 pixels and each tile of 64x64.

pub(super) mod limit;
pub(super) mod range;

pub use range::{DepthRange, depth_ranges};

use super::{
    Attachment, Block, OutsideAttachment, StorageError,
    depth::{Depth, DepthTest},
    depth_format::{D32, DepthFormat},
    storage::at_least,
};
use crate::{
    geometry::{Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
    traversal::{Mask, TILE},
};
use limit::Limit;
use range::{SQUARE, Squares};

/// A [`Depth`] that can tell whether something behind it would be hidden, without drawing it.
///
/// It keeps the smallest and the largest depth of each square of 16x16 pixels and of each tile of 64x64, from
/// the region's corner on, in memory of the caller. Drawing costs nothing for it: a square is looked at when a
/// question needs it, and again only where the answer may have changed since. Between the looks its range stays
/// what it was, which is never wrong: depths only move in the direction of the test.
///
/// ```
/// use halfplane::*;
///
/// let region = Region::<Standard>::of_size(64, 64)?;
/// let mut storage = [0; texels(64, 64)];
/// let mut ranges = [DepthRange::UNKNOWN; depth_ranges(64, 64)];
/// let mut depth: HierarchicalDepth<'_, Standard> =
///     HierarchicalDepth::new(region, &mut storage, &mut ranges, DepthTest::LESS)?;
/// depth.clear(u32::MAX);
///
/// // A wall over the left half.
/// let corner = |x: i32, y: i32| Vertex::new(x * 256, y * 256, 1 << 30);
/// let wall = [corner(0, 0)?, corner(32, 0)?, corner(32, 64)?, corner(0, 64)?];
/// draw(&wall[..], &[0u16, 1, 2, 0, 2, 3], 0, &State::new(region), &mut depth)?;
///
/// // Is what lies in these pixels, at this depth or farther, hidden?
/// assert!(depth.hides(Region::new(5, 5, 30, 60)?, 1 << 31));
/// assert!(!depth.hides(Region::new(5, 5, 33, 60)?, 1 << 31));
/// assert!(!depth.hides(Region::new(5, 5, 30, 60)?, 1 << 29));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct HierarchicalDepth<'a, F: Format, D: DepthFormat<F> = D32> {
    depth: Depth<'a, F, D>,
    squares: Squares<'a>,
    tiles: Squares<'a>,
    /// Counts what was drawn, as far as questions came between; never 0.
    version: u32,
    /// Whether something may have been drawn since the last question.
    drawn: bool,
}

/// Versions begin so near to the last one that what comes after it, 1, is met: by tests, and not after a year in the
/// field.
const FIRST_VERSION: u32 = u32::MAX - (1 << 16);

impl<'a, F: Format, D: DepthFormat<F>> HierarchicalDepth<'a, F, D> {
    /// Depths of `region` in a slice of at least [`texels`](super::texels)`(width, height)`, and their ranges in
    /// one of at least [`depth_ranges`]`(width, height)`. The contents of `texels` are kept, those of `ranges`
    /// do not matter.
    ///
    /// # Errors
    ///
    /// [`StorageError`].
    pub fn new(
        region: Region<F>,
        texels: &'a mut [D::Texel],
        ranges: &'a mut [DepthRange],
        test: DepthTest,
    ) -> Result<Self, StorageError> {
        let (width, height) = (region.width(), region.height());
        at_least(depth_ranges(width, height), ranges.len())?;
        let depth = Depth::new(region, texels, test)?;
        ranges.fill(DepthRange::UNKNOWN);
        let (squares, ranges) = Squares::split(ranges, width.div_ceil(SQUARE), height.div_ceil(SQUARE));
        let (tiles, _) = Squares::split(ranges, width.div_ceil(TILE), height.div_ceil(TILE));
        Ok(Self { depth, squares, tiles, version: FIRST_VERSION, drawn: false })
    }

    /// Sets every depth.
    pub fn clear(&mut self, depth: D::Texel) {
        self.depth.clear(depth);
        let version = self.version();
        let range = DepthRange { low: depth.into(), high: depth.into(), version };
        self.squares.fill(range);
        self.tiles.fill(range);
    }

    /// The depths.
    #[must_use]
    pub const fn depth(&self) -> &Depth<'a, F, D> {
        &self.depth
    }

    /// The region.
    #[must_use]
    pub const fn region(&self) -> Region<F> {
        self.depth.tiled().region()
    }

    /// The smallest and the largest depth in the pixels of `area` that are in the region; `None` where there are
    /// none.
    #[must_use]
    pub fn range(&self, area: Region<F>) -> Option<[D::Texel; 2]> {
        let area = area.intersect(self.region())?;
        let (mut low, mut high) = (D::FAR, D::NEAR);
        for y in area.y0()..area.y1() {
            for x in area.x0()..area.x1() {
                if let Some(depth) = self.depth.get(x, y) {
                    (low, high) = (low.min(depth), high.max(depth));
                }
            }
        }
        Some([low, high])
    }

    /// Whether whatever is in the pixels of `area` and nowhere nearer than `nearest`, in units of 2^-32 as a
    /// [`Vertex`](crate::Vertex) has it, would fail the depth test at each of them. With a test in which the
    /// farther wins, `nearest` is the farthest.
    ///
    /// `true` is certain: an interpolated depth less than [two units](crate::Bounds::MAX_DEPTH_ERROR_2_16) before
    /// its vertices is allowed for. So is `false`, but for those two units: a pixel of `area` is not hidden.
    /// Pixels outside the region are not looked at. Nothing is hidden where the test is [`Compare::Always`](super::Compare::Always).
    pub fn hides(&mut self, area: Region<F>, nearest: u32) -> bool {
        self.hides_with::<ArrayLanes>((), area, nearest)
    }

    /// [`hides`](Self::hides) with other lanes; the same answer.
    #[inline(always)]
    pub(crate) fn hides_with<L: Lanes>(&mut self, token: L::Token, area: Region<F>, nearest: u32) -> bool {
        let Some(limit) = Limit::new::<F, D>(self.depth.test().compare, nearest) else { return false };
        let region = self.region();
        let Some(area) = area.intersect(region) else { return true };
        // Most of what can be seen can be seen in its middle.
        let middle = (area.x0() + area.width() / 2, area.y0() + area.height() / 2);
        if self.depth.get(middle.0, middle.1).is_some_and(|depth| !limit.hides(DepthRange::one(depth.into())))
        {
            return false;
        }
        let version = self.version();
        let (left, right) = ((area.x0() - region.x0()) / SQUARE, (area.x1() - 1 - region.x0()) / SQUARE);
        let (top, bottom) = ((area.y0() - region.y0()) / SQUARE, (area.y1() - 1 - region.y0()) / SQUARE);
        for tile_row in top / 4..=bottom / 4 {
            for tile_column in left / 4..=right / 4 {
                if limit.hides(self.tiles.get(tile_column, tile_row)) {
                    continue;
                }
                let mut squares = DepthRange { low: u32::MAX, high: 0, version };
                for row in top.max(4 * tile_row)..=bottom.min(4 * tile_row + 3) {
                    for column in left.max(4 * tile_column)..=right.min(4 * tile_column + 3) {
                        let mut range = self.squares.get(column, row);
                        if !limit.hides(range) {
                            let Some(square) = square(region, column, row) else { continue };
                            if range.version != version {
                                range = self.look::<L>(token, square, version);
                                self.squares.set(column, row, range);
                            }
                            if !limit.hides(range)
                                && (area.contains(square) || self.shows::<L>(token, limit, square, area))
                            {
                                return false;
                            }
                        }
                        squares = squares.with(range);
                    }
                }
                // All squares of the tile have been asked.
                let whole = left <= 4 * tile_column
                    && top <= 4 * tile_row
                    && (4 * tile_column + 3).min(self.squares.columns() - 1) <= right
                    && (4 * tile_row + 3).min(self.squares.rows() - 1) <= bottom;
                if whole {
                    self.tiles.set(tile_column, tile_row, squares);
                }
            }
        }
        true
    }

    /// The version of what is stored now.
    #[inline(always)]
    fn version(&mut self) -> u32 {
        if self.drawn {
            self.drawn = false;
            self.version = self.version.checked_add(1).unwrap_or_else(|| {
                self.squares.forget();
                1
            });
        }
        self.version
    }

    /// The range of a square as it is now.
    #[inline(always)]
    fn look<L: Lanes>(&self, token: L::Token, square: Region<F>, version: u32) -> DepthRange {
        let (mut low, mut high): (L, L) = (L::splat(token, u32::MAX), L::splat(token, 0));
        let whole = square.width() == SQUARE && square.height() == SQUARE;
        for (row, y) in self.depth.tiled().rows(square).zip((square.y0()..).step_by(4)) {
            if let (Some(blocks), true) = (row.first_chunk::<{ SQUARE as usize / 4 }>(), whole) {
                for block in blocks {
                    let texels = D::load::<L>(token, block);
                    low = low.select(texels, low.less(texels));
                    high = texels.select(high, high.less(texels));
                }
                continue;
            }
            for (block, x) in row.iter().zip((square.x0()..).step_by(4)) {
                let texels = D::load::<L>(token, block);
                let inside = L::mask(token, Mask::of_block(square, x, y).0);
                let least = texels.select(L::splat(token, u32::MAX), inside);
                let most = texels.select(L::splat(token, 0), inside);
                low = low.select(least, low.less(least));
                high = most.select(high, high.less(most));
            }
        }
        let (mut lows, mut highs) = ([0; 16], [0; 16]);
        low.store(&mut lows);
        high.store(&mut highs);
        let least = lows.iter().fold(u32::MAX, |a, &b| a.min(b));
        let most = highs.iter().fold(0, |a, &b| a.max(b));
        DepthRange { low: least, high: most, version }
    }

    /// Whether a pixel in `area` of a square is not hidden.
    #[inline(always)]
    fn shows<L: Lanes>(&self, token: L::Token, limit: Limit, square: Region<F>, area: Region<F>) -> bool {
        let Some(part) = square.intersect(area) else { return false };
        for (row, y) in self.depth.tiled().rows(part).zip((part.y0() & !3..).step_by(4)) {
            for (block, x) in row.iter().zip((part.x0() & !3..).step_by(4)) {
                let shown = limit.shows::<L>(token, D::load::<L>(token, block));
                if shown & Mask::of_block(part, x, y).0 != 0 {
                    return true;
                }
            }
        }
        false
    }

    /// The depths, to be written: what is known of them may be no more.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(crate) const fn depth_mut(&mut self) -> &mut Depth<'a, F, D> {
        self.drawn = true;
        &mut self.depth
    }
}

/// A square of a region, as far as it is inside.
#[inline(always)]
pub(super) fn square<F: Format>(region: Region<F>, column: u32, row: u32) -> Option<Region<F>> {
    let (x, y) = (region.x0() + SQUARE * column, region.y0() + SQUARE * row);
    region.cut(x, y, x + SQUARE, y + SQUARE)
}

impl<F: Format, D: DepthFormat<F>> Attachment<F> for HierarchicalDepth<'_, F, D> {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.block_with::<ArrayLanes>((), block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        self.drawn = true;
        self.depth.block_with::<L>(token, block)
    }

    #[inline]
    fn begin(&mut self, triangle: &Triangle<F>) {
        self.depth.begin(triangle);
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        self.depth.check(area)
    }
}
