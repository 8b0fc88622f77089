//! The fast path: object-space vertices to depth and ids, in vector registers.

#![no_std]
#![no_main]

use halfplane::{
    D32, Depth, DepthTest, Ids, ModelPositions, Region, Standard, State, Viewport,
    simd::{
        Level, Meshlet, MeshletScratch, Snapped, Triangles, draw, draw_meshlets, make_meshlets, max_meshlets,
    },
    texels,
};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main() -> Option<()> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth_texels = [0; texels(WIDTH, HEIGHT)];
    let mut id_texels = [0; texels(WIDTH, HEIGHT)];
    let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut depth_texels, DepthTest::LESS).ok()?;
    let mut ids = Ids::new(region, &mut id_texels).ok()?;
    depth.clear(u32::MAX);
    ids.clear();
    let vertices = inputs().map(|vertex| vertex.map(f32::from_bits));
    let matrix =
        core::array::from_fn(|row| core::array::from_fn(|c| f32::from_bits(input(16 + 4 * row + c))));
    let viewport = Viewport::new(region);
    let positions = ModelPositions::new(&vertices, matrix, viewport);
    let mut records = [Snapped::default(); 4];
    let scratch = records.get_mut(..input(33) as usize)?;
    let indices: [u32; 30] = core::array::from_fn(|i| input(34 + i));
    let indices = indices.get(..input(32) as usize)?;
    let triangles = Triangles::new(indices, vertices.len()).ok()?;
    let level = if input(15) == 0 { Level::FALLBACK } else { Level::baseline() };
    let state = State::new(region);
    let statistics =
        draw(level, &positions, scratch, triangles, input(12), &state, &mut (&mut depth, &mut ids));
    output(u64::from(statistics.ok()?.submitted));
    let mut memory = [Meshlet::EMPTY; max_meshlets(10)];
    let meshlets = make_meshlets(&vertices, indices, memory.get_mut(..input(11) as usize)?).ok()?;
    let mut scratch = MeshletScratch::NEW;
    let mut all = (&mut depth, &mut ids);
    let statistics =
        draw_meshlets(level, meshlets, matrix, viewport, &mut scratch, input(10), &state, &mut all);
    output(u64::from(statistics.ok()?.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(())
}

program!(main);
