//! Proofs of the bins: their lists, their tiles, the order of tiles.

use super::{
    BinChunk, BinTile, TileOrder, bin_tiles, columns,
    lists::{ENTRIES, Lists},
    order::hilbert,
    rows,
};
use crate::{
    geometry::Region,
    numbers::{Small, Standard},
    proof::{cover, prove},
    traversal::{Mask, TILE, fill},
};

/// Entries from a number on, each into the tile that a bit says, with memory of so many chunks.
fn come_back_in_order(first: u32, pushes: u32, chunks: usize) {
    let (mut tiles, mut memory) = ([BinTile::EMPTY; 2], [BinChunk::EMPTY; 3]);
    let mut lists = Lists::new(&mut tiles, &mut memory[..chunks]);
    let mut taken = [[None; 4], [None; 4]];
    let mut counts = [0, 0];
    for turn in 0..4 {
        let (entry, tile) = (first + turn, (pushes >> turn & 1) as usize);
        let used = usize::from(counts[0] > 0) + usize::from(counts[1] > 0);
        let pushed = lists.push(tile, entry);
        assert!(pushed == (counts[tile] > 0 || used < chunks));
        if pushed {
            taken[tile][counts[tile]] = Some(entry);
            counts[tile] += 1;
        }
    }
    for (tile, taken) in taken.into_iter().enumerate() {
        let mut entries = lists.entries(tile);
        for entry in taken {
            assert!(entries.next() == entry);
        }
    }
    assert!(!lists.push(2, 0) && lists.entries(2).next().is_none());
}

prove! {
    /// Every entry that was taken is there, in order, and none else; a full memory refuses, and nothing is changed.
    #[kani::unwind(18)]
    [Lists::new, Lists::clear, Lists::push, Lists::entries]
    fn entries_come_back_in_order(first: u32 = 0..=1 << 31) {
        for (pushes, chunks) in [(0b0101, 2), (0b1110, 1), (0b0010, 3), (0b0000, 0), (0b0111, 2)] {
            come_back_in_order(first, pushes, chunks);
        }
    }

    /// A list longer than a chunk goes on in the next one, and back.
    #[kani::unwind(20)]
    [Lists::push, Lists::pop_while, Lists::entries]
    fn long_lists_go_on(left: usize = 0..=16) {
        let (mut tiles, mut memory) = ([BinTile::EMPTY; 1], [BinChunk::EMPTY; 2]);
        let mut lists = Lists::new(&mut tiles, &mut memory);
        for entry in 0..16 {
            assert!(lists.push(0, entry));
        }
        lists.pop_while(|entry| entry as usize >= left);
        assert!(lists.entries(0).count() == left);
        assert!(lists.push(0, 99));
        assert!(lists.entries(0).last() == Some(99) && lists.entries(0).count() == left + 1);
        cover!(left == ENTRIES);
        cover!(left == 0);
    }

    /// As many tiles as the region's ends reach; the last one has a pixel of it.
    [bin_tiles, columns, rows]
    fn tiles_are_counted(ends: [u32; 4] = [0; 4]..=[16384; 4]) {
        let [x0, y0, x1, y1] = ends;
        let Ok(region) = Region::<Standard>::new(x0, y0, x1, y1) else { return };
        let (columns, rows) = (columns(region), rows(region));
        assert!(columns == (x1 - 1) / TILE - x0 / TILE + 1 && rows == (y1 - 1) / TILE - y0 / TILE + 1);
        assert!(bin_tiles(region) == columns as usize * rows as usize);
    }

    /// Row by row: each tile once.
    #[kani::unwind(14)]
    [TileOrder::tiles]
    fn rows_have_each_tile_once(columns: u32 = 1..=4, rows: u32 = 1..=3, tile: [u32; 2] = [0; 2]..=[4; 2]) {
        let found = TileOrder::Rows.tiles(columns, rows).filter(|&(x, y)| [x, y] == tile).count();
        assert!(found == usize::from(tile[0] < columns && tile[1] < rows));
    }

    /// Along the curve: two numbers are at one place only where they are one, and neighbours in number are neighbours
    /// in place.
    #[kani::unwind(5)]
    [hilbert]
    fn the_curve_is_one_to_one(first: u64 = 0..=63, second: u64 = 0..=63) {
        let ((x0, y0), (x1, y1)) = (hilbert(8, first), hilbert(8, second));
        assert!(x0 < 8 && y0 < 8 && (x0 == x1 && y0 == y1) == (first == second));
        assert!(second != first + 1 || x0.abs_diff(x1) + y0.abs_diff(y1) == 1);
    }

    /// A pixel is in one mask, of its block, where the region has it; in none elsewhere.
    #[kani::unwind(8)]
    [fill]
    fn a_region_is_filled_once(
        x0: u32 = 3..=6,
        x1: u32 = 5..=13,
        y0: u32 = 1..=2,
        y1: u32 = 3..=5,
        pixel: [u32; 2] = [0; 2]..=[15, 7],
    ) {
        let Ok(region) = Region::<Small>::new(x0, y0, x1, y1) else { return };
        let [x, y] = pixel;
        let mut found = 0;
        fill(region, |left, top, mask: Mask| {
            assert!(left % 4 == 0 && top % 4 == 0);
            found += u32::from(left == x & !3 && top == y & !3 && mask.has(x & 3, y & 3));
        });
        assert!(found == u32::from(x0 <= x && x < x1 && y0 <= y && y < y1));
    }
}
