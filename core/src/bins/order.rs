//! In which order tiles are drawn.

/// The order of tiles; no picture depends on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TileOrder {
    /// Row by row, each from the left.
    #[default]
    Rows,
    /// Along Hilbert's curve: each tile next to the one before, as far as the tiles fill a square of a power of two.
    Hilbert,
}

impl TileOrder {
    /// (column, row) of each tile of so many columns and rows, each once.
    pub(super) fn tiles(self, columns: u32, rows: u32) -> impl Iterator<Item = (u32, u32)> {
        // A target has at most 2^17 tiles to a side: sides are below 2^23 px.
        let side = columns.max(rows).checked_next_power_of_two().unwrap_or(0);
        let width = u64::from(columns.max(1));
        let count = match self {
            Self::Rows => width * u64::from(rows),
            Self::Hilbert => u64::from(side) * u64::from(side),
        };
        (0..count).filter_map(move |at| {
            let (column, row) = match self {
                Self::Rows => ((at % width) as u32, (at / width) as u32),
                Self::Hilbert => hilbert(side, at),
            };
            (column < columns && row < rows).then_some((column, row))
        })
    }
}

/// The place of a number on Hilbert's curve through a square whose side is a power of two: of each two bits, from the
/// lowest up, a quadrant, and what was found so far turned into it.
pub(super) fn hilbert(side: u32, mut at: u64) -> (u32, u32) {
    let (mut x, mut y) = (0, 0);
    let mut size = 1;
    while size < side {
        let right = ((at / 2) & 1) as u32;
        let down = (at & 1) as u32 ^ right;
        if down == 0 {
            if right == 1 {
                (x, y) = (size - 1 - x, size - 1 - y);
            }
            (x, y) = (y, x);
        }
        (x, y) = (x + size * right, y + size * down);
        at /= 4;
        size *= 2;
    }
    (x, y)
}
