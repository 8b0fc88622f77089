//! What is in the bins, and in which order it comes out.

use super::bins::{Memory, Picture};
use crate::{Failure, ensure, ensure_eq, failure::Verdict};
use halfplane::{
    Attachment, Block, Count, Format, Mask, Region, Sample, Standard, State, Vertex,
    bins::{TileOrder, bin_tiles, draw_binned},
};

/// A triangle that did not fit has left nothing behind: the memory holds as many small ones as it would have, and they
/// are drawn in their order, whatever came between.
pub fn what_did_not_fit_is_gone(small: usize, chunks: usize, between: usize) -> Verdict {
    let region = Region::<Standard>::of_size(640, 64)?;
    let mut memory = Memory::new(region, chunks, small + 2);
    let mut bins = memory.bins(region)?;
    // Ten tiles wide, and inside the first tile.
    let xs = [0, 640, 0, 0, 40, 0];
    let ys = [0, 0, 64, 0, 0, 40];
    let corners = xs.into_iter().zip(ys).map(|(x, y)| Vertex::new(x << 8, y << 8, 9));
    let vertices = corners.collect::<Result<Vec<_>, _>>()?;
    let (wide, narrow) = ([0u32, 1, 2], [3u32, 4, 5]);
    let state = State::new(region);
    let mut taken = 0;
    for id in 0..small {
        if id == between {
            let fits = bins.add(&vertices[..], &wide, 1000, &state)?.taken;
            ensure_eq!(fits, 0, "a triangle of ten tiles in {chunks} chunks");
        }
        taken += bins.add(&vertices[..], &narrow, id as u32, &state)?.taken;
    }
    // Fourteen to a chunk.
    ensure_eq!(taken, small.min(14 * chunks), "small triangles in {chunks} chunks");
    let mut picture = Picture::new(region);
    picture.paint(region, |all| Ok(bins.draw(region, TileOrder::Rows, all)?))?;
    ensure_eq!(picture.last[0], taken as u32 - 1, "the last");
    ensure_eq!(picture.nearest[0], 0, "the first");
    ensure_eq!(bins.finish().drawn as usize, taken, "drawn");
    Ok(())
}

/// What waits is drawn before what is drawn through the same bins.
pub fn what_waits_comes_first(region: Region<Standard>) -> Verdict {
    let mut memory = Memory::new(region, 100, 10);
    let mut bins = memory.bins(region)?;
    let vertices = over_all(region)?;
    let (state, order) = (State::new(region), TileOrder::Rows);
    bins.add(&vertices[..], &[0u32, 1, 2], 5, &state)?;
    let mut picture = Picture::new(region);
    let drawn = picture.paint(region, |all| {
        Ok(draw_binned(&mut bins, &vertices[..], &[0u32, 1, 2], 6, &state, order, all)?)
    })?;
    ensure_eq!((drawn.statistics.submitted, drawn.statistics.drawn), (1, 1), "what waited is not counted");
    ensure_eq!((picture.nearest[0], picture.last[0]), (5, 6), "the first and the last");
    Ok(())
}

/// So many equal triangles, with room for some at a time: as many rounds as that takes, or none and each by itself.
pub fn rounds_are_counted(triangles: usize, room: usize) -> Verdict {
    let region = Region::<Standard>::of_size(130, 70)?;
    let mut memory = Memory::new(region, 100, room);
    let mut bins = memory.bins(region)?;
    let indices = [0u32, 1, 2].repeat(triangles);
    let state = State::new(region);
    let vertices = over_all(region)?;
    let drawn =
        draw_binned(&mut bins, &vertices[..], &indices, 0, &state, TileOrder::Rows, &mut Count::default())?;
    let expected = if room == 0 { (0, triangles) } else { (triangles.div_ceil(room), 0) };
    ensure_eq!(
        (drawn.rounds as usize, drawn.unbinned as usize),
        expected,
        "{triangles} triangles, room for {room}"
    );
    ensure_eq!(drawn.statistics.drawn as usize, triangles, "{triangles} triangles, room for {room}");
    Ok(())
}

/// A long thin triangle is in the tiles that it touches, no others: memory for those is enough, and less is not.
pub fn a_diagonal_needs_few_tiles(tiles: u32) -> Verdict {
    let side = 64 * tiles;
    let region = Region::<Standard>::of_size(side, side)?;
    let end = (side << 8) as i32;
    // A pixel wide, inside the tiles on the diagonal but where it passes their corners.
    let vertices = [Vertex::new(0, 0, 9)?, Vertex::new(end, end, 9)?, Vertex::new(end - 256, end, 9)?];
    for (chunks, fits) in [(3 * tiles as usize - 2, 1), (tiles as usize - 1, 0)] {
        let mut memory = Memory::new(region, chunks, 1);
        let taken = memory.bins(region)?.add(&vertices[..], &[0u32, 1, 2], 0, &State::new(region))?.taken;
        ensure_eq!(taken, fits, "{chunks} chunks for {tiles} tiles");
    }
    Ok(())
}

/// A triangle over all of a region and more.
fn over_all(region: Region<Standard>) -> Result<[Vertex<Standard>; 3], Failure> {
    let corner = |x: u32, y: u32| Vertex::new((x << 8) as i32, (y << 8) as i32, 9);
    let [x0, y0, x1, y1] = [region.x0(), region.y0(), region.x1(), region.y1()];
    Ok([corner(x0, y0)?, corner(2 * x1, y0)?, corner(x0, 2 * y1)?])
}

/// The tiles in the order in which they are drawn, by their columns and rows.
#[derive(Debug, Default)]
struct Tiles(Vec<[u32; 2]>);

impl<F: Format> Attachment<F> for Tiles {
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        let tile = [block.x / 64, block.y / 64];
        if self.0.last() != Some(&tile) {
            self.0.push(tile);
        }
        block.mask
    }
}

/// Every tile comes once; along Hilbert's curve each is next to the one before, where the tiles fill a square.
pub fn tiles_come_in_order(columns: u32, rows: u32, order: TileOrder) -> Verdict {
    let region = Region::of_size(64 * columns, 64 * rows)?;
    let mut memory = Memory::new(region, (columns * rows) as usize, 1);
    let mut bins = memory.bins(region)?;
    bins.add(&over_all(region)?[..], &[0u32, 1, 2], 0, &State::new(region))?;
    let mut tiles = Tiles::default();
    bins.draw(region, order, &mut tiles)?;
    let mut sorted = tiles.0.clone();
    sorted.sort_unstable();
    let all: Vec<_> = (0..columns).flat_map(|x| (0..rows).map(move |y| [x, y])).collect();
    ensure_eq!(sorted, all, "tiles of {columns} x {rows}");
    if order == TileOrder::Rows {
        ensure!(tiles.0.is_sorted_by_key(|[x, y]| [*y, *x]), "rows: {:?}", tiles.0);
    } else if columns == rows && columns.is_power_of_two() {
        let next = |pair: &[[u32; 2]]| pair[0][0].abs_diff(pair[1][0]) + pair[0][1].abs_diff(pair[1][1]) == 1;
        ensure!(tiles.0.windows(2).all(next), "a jump: {:?}", tiles.0);
    }
    Ok(())
}

/// Another sample position is another round.
pub fn samples_do_not_mix<F: Format>(region: Region<F>, other: Sample<F>) -> Verdict {
    let mut memory = Memory::new(region, bin_tiles(region), 10);
    let mut bins = memory.bins(region)?;
    let corner =
        |x: u32, y: u32| Vertex::<F>::new((x << F::SUBPIXEL_BITS) as i32, (y << F::SUBPIXEL_BITS) as i32, 9);
    let vertices = [
        corner(region.x0(), region.y0())?,
        corner(region.x1(), region.y0())?,
        corner(region.x0(), region.y1())?,
    ];
    let (first, second) = (State::new(region), State { sample: other, ..State::new(region) });
    ensure_eq!(bins.add(&vertices[..], &[0u32, 1, 2], 0, &first)?.taken, 1, "into empty bins");
    let same = usize::from(first.sample == second.sample);
    ensure_eq!(bins.add(&vertices[..], &[0u32, 1, 2], 0, &second)?.taken, same, "with another sample");
    bins.finish();
    ensure_eq!(bins.add(&vertices[..], &[0u32, 1, 2], 0, &second)?.taken, 1, "after the first is finished");
    Ok(())
}
