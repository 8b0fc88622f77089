//! The fast path at one level only, the best that every processor of the target has.

#![no_std]
#![no_main]

use halfplane::{
    D32, Depth, DepthTest, Ids, ModelPositions, Region, Standard, State, Viewport,
    simd::{Level, Snapped, Triangles, draw},
    texels,
};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;
const TEXELS: usize = texels(WIDTH, HEIGHT);

fn main([depths, id_texels]: &mut [[u32; TEXELS]; 2]) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth: Depth<'_, Standard, D32> = Depth::new(region, depths, DepthTest::LESS).ok()?;
    let mut ids = Ids::new(region, id_texels).ok()?;
    depth.clear(u32::MAX);
    ids.clear();
    let vertices = inputs().map(|vertex| vertex.map(f32::from_bits));
    let matrix =
        core::array::from_fn(|row| core::array::from_fn(|c| f32::from_bits(input(16 + 4 * row + c))));
    let positions = ModelPositions::new(&vertices, matrix, Viewport::new(region));
    let mut records = [Snapped::default(); 4];
    let scratch = records.get_mut(..input(33) as usize)?;
    let triangles = Triangles::new(indices(), vertices.len()).ok()?;
    let state = State::new(region);
    let mut both = (&mut depth, &mut ids);
    let statistics =
        draw(Level::baseline(), &positions, scratch, triangles, input(12), &state, &mut both).ok()?;
    output(u64::from(statistics.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(statistics.drawn)
}

program!(main, [[u32; TEXELS]; 2] = [[0; TEXELS]; 2]);
