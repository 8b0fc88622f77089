//! Sixteen bits for the sixteen cells of a square.

use crate::{geometry::Region, numbers::Format};

/// One bit for each cell of a 4x4 arrangement: bit 4 j + i is column i of row j. The samples of a
/// block, or the children of a larger square.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Mask(pub u16);

impl Mask {
    /// No cell.
    pub const EMPTY: Self = Self(0);
    /// All sixteen cells.
    pub const FULL: Self = Self(0xFFFF);

    /// Whether no cell is set.
    #[inline]
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The number of set cells.
    #[inline]
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// The cells set in both.
    #[inline]
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Whether the cell in `column` and `row`, both below 4, is set; elsewhere nothing is.
    #[inline]
    #[must_use]
    pub const fn has(self, column: u32, row: u32) -> bool {
        column < 4 && row < 4 && self.0 >> (4 * row + column) & 1 != 0
    }

    /// The (column, row) of each set cell, row by row.
    #[inline]
    pub fn cells(self) -> impl Iterator<Item = (u32, u32)> {
        let mut rest = self.0;
        core::iter::from_fn(move || {
            let cell = rest.trailing_zeros();
            (rest != 0).then(|| {
                rest &= rest - 1;
                (cell & 3, cell >> 2)
            })
        })
    }

    /// The pixels of the block at (`x`, `y`) that are in a region which touches it.
    #[inline]
    pub(crate) const fn of_block<F: Format>(region: Region<F>, x: u32, y: u32) -> Self {
        Self::rectangle(
            region.x0().saturating_sub(x),
            region.x1().saturating_sub(x),
            region.y0().saturating_sub(y),
            region.y1().saturating_sub(y),
        )
    }

    /// The cells in columns `x0..x1` and rows `y0..y1`, ends beyond 4 taken as 4.
    #[inline]
    #[must_use]
    pub(crate) const fn rectangle(x0: u32, x1: u32, y0: u32, y1: u32) -> Self {
        let columns = Self::run(x0, x1);
        // Row j's four bits are set where bit j of the rows is: spread them four apart.
        let rows = Self::run(y0, y1);
        let spread = rows & 1 | (rows & 2) << 3 | (rows & 4) << 6 | (rows & 8) << 9;
        Self((spread * columns) as u16)
    }

    /// The bits `first..end` of four.
    const fn run(first: u32, end: u32) -> u32 {
        Self::below(end) & !Self::below(first)
    }

    const fn below(n: u32) -> u32 {
        if n >= 4 { 0xF } else { (1 << n) - 1 }
    }
}
