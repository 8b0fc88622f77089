//! Bins and hierarchical depth, without vectors.

#![no_std]
#![no_main]

use halfplane::{
    Depth, DepthRange, DepthTest, HierarchicalDepth, Region, Sample, Small, Standard, State, Vertex,
    bins::{BinChunk, BinTile, BinnedTriangle, Bins, TileOrder, bin_tiles, draw_binned},
    depth_ranges, texels,
};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 130;
const HEIGHT: u32 = 20;

fn binned() -> Option<u64> {
    let region = Region::<Standard>::new(input(25), input(26), input(27), input(28)).ok()?;
    let mut tiles = [BinTile::EMPTY; 6];
    let mut chunks = [BinChunk::EMPTY; 6];
    let mut triangles = [const { BinnedTriangle::EMPTY }; 6];
    let chunks = chunks.get_mut(..input(29) as usize)?;
    let triangles = triangles.get_mut(..input(30) as usize)?;
    let mut bins = Bins::new(region, &mut tiles, chunks, triangles).ok()?;
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let scissor = Region::new(input(31), input(32), input(33), input(34)).ok()?;
    let state = State { sample: Sample::new(input(35) as i32, input(36) as i32)?, ..State::new(scissor) };
    let mut storage = [0; texels(WIDTH, HEIGHT)];
    let mut depth: Depth<'_, Standard> =
        Depth::new(region, storage.get_mut(..input(37) as usize)?, DepthTest::LESS).ok()?;
    let order = if input(38) == 0 { TileOrder::Rows } else { TileOrder::Hilbert };
    let added = bins.add(&vertices[..], indices(), input(39), &state).ok()?;
    bins.draw(scissor, order, &mut depth).ok()?;
    let finished = bins.finish();
    let drawn =
        draw_binned(&mut bins, &vertices[..], indices(), input(40), &state, order, &mut depth).ok()?;
    let counts = added.taken as u64 + u64::from(finished.drawn) + u64::from(drawn.statistics.drawn);
    Some(counts + bin_tiles(region) as u64 + u64::from(drawn.rounds))
}

fn hidden() -> Option<u64> {
    let region = Region::<Small>::new(input(41), input(42), input(43), input(44)).ok()?;
    let mut storage = [0; texels(WIDTH, HEIGHT)];
    let mut ranges = [DepthRange::UNKNOWN; depth_ranges(WIDTH, HEIGHT)];
    let texels = storage.get_mut(..input(45) as usize)?;
    let ranges = ranges.get_mut(..input(46) as usize)?;
    let mut depth: HierarchicalDepth<'_, Small, halfplane::D16> =
        HierarchicalDepth::new(region, texels, ranges, DepthTest::LESS).ok()?;
    depth.clear(input(47) as u16);
    let area = Region::new(input(48), input(49), input(50), input(51)).ok()?;
    let range = depth.range(area)?;
    Some(u64::from(depth.hides(area, input(52))) + u64::from(range[0] ^ range[1]))
}

fn main(_: &mut ()) -> Option<u32> {
    output(binned().unwrap_or(1));
    output(hidden().unwrap_or(2));
    None
}

program!(main, () = ());
