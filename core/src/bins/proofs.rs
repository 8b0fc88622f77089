//! Proofs of the bins: their lists, their tiles, the order of tiles.

use super::{
    BinChunk, BinTile, BinnedTriangle, Bins, TileOrder, bin_tiles, columns, draw_binned,
    lists::{ENTRIES, Lists},
    order::hilbert,
    rows,
};
use crate::{
    attachments::{Ids, NO_ID},
    draw::{State, draw},
    geometry::{Region, Vertex},
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

/// Ids of two blocks, one in each of two tiles, and what a draw to them returns.
fn drawn<R>(region: Region<Small>, draw: impl FnOnce(&mut Ids<'_, Small>) -> R) -> ([u32; 32], R) {
    let mut texels = [NO_ID; 32];
    let Ok(mut ids) = Ids::new(region, &mut texels) else { unreachable!("there are enough") };
    let result = draw(&mut ids);
    (texels, result)
}

/// Three triangles, one of them without area, through bins with so much memory, and without bins: the ids and the
/// statistics are the same.
fn bins_change_nothing(corner: i32, first_id: u32, chunks: usize, triangles: usize, order: TileOrder) {
    let Ok(region) = Region::<Small>::new(60, 0, 68, 4) else { return };
    let vertex = |x, y| Vertex::new(x, y, 0);
    let (Ok(a), Ok(b), Ok(c)) = (vertex(965, 3), vertex(corner, 40), vertex(1075, 60)) else { return };
    let (vertices, indices) = ([a, b, c], [0_u8, 1, 2, 1, 1, 2, 1, 0, 2]);
    let state = State::new(region);
    let (expected, Ok(statistics)) =
        drawn(region, |ids| draw(&vertices[..], &indices, first_id, &state, ids))
    else {
        unreachable!("nothing is wrong with it")
    };
    let (mut tiles, mut memory) = ([BinTile::EMPTY; 2], [BinChunk::EMPTY; 2]);
    let mut room = [const { BinnedTriangle::EMPTY }; 2];
    let bins = Bins::new(region, &mut tiles, &mut memory[..chunks], &mut room[..triangles]);
    let Ok(mut bins) = bins else { unreachable!("there are enough tiles") };
    let (texels, Ok(found)) =
        drawn(region, |ids| draw_binned(&mut bins, &vertices[..], &indices, first_id, &state, order, ids))
    else {
        unreachable!("nothing is wrong with it")
    };
    assert!(texels == expected && found.statistics == statistics);
    assert!(found.statistics.drawn == 2 && found.statistics.culled.zero_area == 1);
    assert!((found.unbinned > 0) == (chunks < 2));
}

prove! {
    /// Triangles across the border of two tiles are drawn with their ids, whatever the first one is.
    [Bins::add_checked, Bins::insert, Bins::draw_with, Bins::draw_tile, draw_binned_with]
    fn a_draw_through_bins_is_a_draw(first_id: u32 = 0..=u32::MAX - 3) {
        for corner in [960, 1020, 1060, 1088] {
            bins_change_nothing(corner, first_id, 2, 2, TileOrder::Rows);
        }
    }

    /// The same with memory for one chunk of entries, so that a triangle in both tiles is taken away again.
    [Bins::add_checked, Bins::insert, Bins::forget, draw_binned_with]
    fn a_draw_through_too_small_bins_is_a_draw(first_id: u32 = 0..=u32::MAX - 3) {
        for corner in [960, 1020, 1060, 1088] {
            bins_change_nothing(corner, first_id, 1, 1, TileOrder::Hilbert);
        }
    }

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
