//! The ranges of depth of a region's squares.

use crate::traversal::TILE;

/// Pixels in the width and height of a square: 16 of them are a tile.
pub(in crate::attachments) const SQUARE: u32 = TILE / 4;

/// Memory for what is known of the depths in a square or a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthRange {
    /// No depth is smaller, and none greater.
    pub(in crate::attachments) low: u32,
    pub(in crate::attachments) high: u32,
    /// When both were depths; 0 is never.
    pub(in crate::attachments) version: u32,
}

impl DepthRange {
    /// Any depths. To fill arrays with.
    pub const UNKNOWN: Self = Self { low: 0, high: u32::MAX, version: 0 };

    /// A depth alone.
    #[inline(always)]
    pub(in crate::attachments) const fn one(depth: u32) -> Self {
        Self { low: depth, high: depth, version: 0 }
    }

    /// The range of both.
    #[inline(always)]
    pub(in crate::attachments) const fn with(self, other: Self) -> Self {
        let low = if other.low < self.low { other.low } else { self.low };
        let high = if other.high > self.high { other.high } else { self.high };
        Self { low, high, version: self.version }
    }
}

/// How many ranges a region of that size in pixels has: one for each square of 16x16 pixels and each tile of
/// 64x64, partial ones included. For array lengths; saturates.
#[must_use]
pub const fn depth_ranges(width: u32, height: u32) -> usize {
    let squares = (width.div_ceil(SQUARE) as usize).saturating_mul(height.div_ceil(SQUARE) as usize);
    let tiles = (width.div_ceil(TILE) as usize).saturating_mul(height.div_ceil(TILE) as usize);
    squares.saturating_add(tiles)
}

/// Ranges in rows.
#[derive(Debug)]
pub(in crate::attachments) struct Squares<'a> {
    ranges: &'a mut [DepthRange],
    columns: u32,
    rows: u32,
}

impl<'a> Squares<'a> {
    /// Rows of ranges in the first elements of a slice, and those left.
    pub(in crate::attachments) fn split(
        ranges: &'a mut [DepthRange],
        columns: u32,
        rows: u32,
    ) -> (Self, &'a mut [DepthRange]) {
        let count = ranges.len().min(columns as usize * rows as usize);
        let (ranges, rest) = ranges.split_at_mut_checked(count).unwrap_or_default();
        (Self { ranges, columns, rows }, rest)
    }

    /// How many there are in a row.
    pub(in crate::attachments) const fn columns(&self) -> u32 {
        self.columns
    }

    /// How many rows there are.
    pub(in crate::attachments) const fn rows(&self) -> u32 {
        self.rows
    }

    #[inline(always)]
    const fn place(&self, column: u32, row: u32) -> usize {
        row as usize * self.columns as usize + column as usize
    }

    /// One of them; beside them, any depths.
    #[inline(always)]
    pub(in crate::attachments) fn get(&self, column: u32, row: u32) -> DepthRange {
        self.ranges.get(self.place(column, row)).copied().unwrap_or(DepthRange::UNKNOWN)
    }

    #[inline(always)]
    pub(in crate::attachments) fn set(&mut self, column: u32, row: u32, range: DepthRange) {
        let place = self.place(column, row);
        if let Some(to) = self.ranges.get_mut(place) {
            *to = range;
        }
    }

    pub(in crate::attachments) fn fill(&mut self, range: DepthRange) {
        self.ranges.fill(range);
    }

    /// Takes all for what they were at some time.
    #[cold]
    pub(in crate::attachments) fn forget(&mut self) {
        for range in &mut *self.ranges {
            range.version = 0;
        }
    }
}
