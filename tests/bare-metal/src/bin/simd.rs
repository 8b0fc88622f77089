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
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

/// What a caller of the fast path lends it.
struct Memory {
    depths: [u32; texels(WIDTH, HEIGHT)],
    ids: [u32; texels(WIDTH, HEIGHT)],
    meshlets: [Meshlet; max_meshlets(64)],
    scratch: MeshletScratch,
}

impl Memory {
    const NEW: Self = Self {
        depths: [0; texels(WIDTH, HEIGHT)],
        ids: [0; texels(WIDTH, HEIGHT)],
        meshlets: [Meshlet::EMPTY; max_meshlets(64)],
        scratch: MeshletScratch::NEW,
    };
}

fn main(memory: &mut Memory) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut memory.depths, DepthTest::LESS).ok()?;
    let mut ids = Ids::new(region, &mut memory.ids).ok()?;
    depth.clear(u32::MAX);
    ids.clear();
    let vertices = inputs().map(|vertex| vertex.map(f32::from_bits));
    let matrix =
        core::array::from_fn(|row| core::array::from_fn(|c| f32::from_bits(input(16 + 4 * row + c))));
    let viewport = Viewport::new(region);
    let positions = ModelPositions::new(&vertices, matrix, viewport);
    let mut records = [Snapped::default(); 4];
    let scratch = records.get_mut(..input(33) as usize)?;
    let indices = indices();
    let triangles = Triangles::new(indices, vertices.len()).ok()?;
    let level = if input(15) == 0 { Level::FALLBACK } else { Level::baseline() };
    let state = State::new(region);
    let statistics =
        draw(level, &positions, scratch, triangles, input(12), &state, &mut (&mut depth, &mut ids)).ok()?;
    output(u64::from(statistics.submitted));
    let drawn = statistics.drawn;
    if input(11) == 0 {
        return Some(drawn);
    }
    let meshlets = make_meshlets(&vertices, indices, memory.meshlets.get_mut(..input(11) as usize)?).ok()?;
    let mut all = (&mut depth, &mut ids);
    let statistics =
        draw_meshlets(level, meshlets, matrix, viewport, &mut memory.scratch, input(10), &state, &mut all);
    output(u64::from(statistics.ok()?.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(drawn)
}

program!(main, Memory = Memory::NEW);
