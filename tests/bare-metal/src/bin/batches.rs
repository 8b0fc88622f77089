//! Occlusion culling: clustering, batches drawn from front to back, questions about boxes, spheres and triangle lists.

#![no_std]
#![no_main]

use halfplane::{
    Cull, DepthRange, DepthTest, Frustum, HierarchicalDepth, ModelPositions, Region, Standard, State,
    Viewport, depth_ranges,
    simd::{
        Batch, BatchOrder, Level, Meshlet, MeshletScratch, Visibility, ask, ask_triangles, cluster,
        draw_batches, make_batches, make_meshlets, max_batches, max_meshlets,
    },
    texels,
};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

/// What a caller lends.
struct Memory {
    depths: [u32; texels(WIDTH, HEIGHT)],
    ranges: [DepthRange; depth_ranges(WIDTH, HEIGHT)],
    indices: [u32; 600],
    meshlets: [Meshlet; max_meshlets(200)],
    batches: [Batch; max_batches(max_meshlets(200))],
    order: [BatchOrder; 4],
    scratch: MeshletScratch,
}

impl Memory {
    const NEW: Self = Self {
        depths: [0; texels(WIDTH, HEIGHT)],
        ranges: [DepthRange::UNKNOWN; depth_ranges(WIDTH, HEIGHT)],
        indices: [0; 600],
        meshlets: [Meshlet::EMPTY; max_meshlets(200)],
        batches: [Batch::EMPTY; max_batches(max_meshlets(200))],
        order: [BatchOrder::NEW; 4],
        scratch: MeshletScratch::NEW,
    };
}

fn main(memory: &mut Memory) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let vertices = inputs().map(|vertex| vertex.map(f32::from_bits));
    let matrix =
        core::array::from_fn(|row| core::array::from_fn(|c| f32::from_bits(input(16 + 4 * row + c))));
    for (to, at) in memory.indices.iter_mut().zip(0..) {
        *to = input(32 + at % 16);
    }
    let indices = memory.indices.get_mut(..input(11) as usize)?;
    cluster(&vertices, indices).ok()?;
    let meshlets = make_meshlets(&vertices, indices, memory.meshlets.get_mut(..input(12) as usize)?).ok()?;
    let batches = make_batches(meshlets, memory.batches.get_mut(..input(13) as usize)?).ok()?;
    let viewport = Viewport::new(region);
    let mut depth: HierarchicalDepth<'_, Standard> =
        HierarchicalDepth::new(region, &mut memory.depths, &mut memory.ranges, DepthTest::LESS).ok()?;
    depth.clear(u32::MAX);
    let level = if input(15) == 0 { Level::FALLBACK } else { Level::baseline() };
    let cull = [Cull::None, Cull::Back, Cull::Front][input(54) as usize % 3];
    let state = State { cull, ..State::new(Region::new(input(50), input(51), input(52), input(53)).ok()?) };
    let order = memory.order.get_mut(..input(14) as usize)?;
    let scratch = &mut memory.scratch;
    let (statistics, occlusion) = draw_batches(
        level,
        batches,
        meshlets,
        matrix,
        viewport,
        order,
        scratch,
        input(10),
        &state,
        &mut depth,
    )
    .ok()?;
    output(u64::from(statistics.drawn) << 32 | u64::from(occlusion.hidden_meshlets));
    let [low, high, center] = vertices;
    let boxes = [[low, high], [high, center]];
    let mut answers = [Visibility::Outside; 2];
    let answers = answers.get_mut(..input(9) as usize)?;
    ask(level, &boxes, &matrix, &viewport, &state, &mut depth, answers).ok()?;
    let frustum = Frustum::new(&matrix);
    let radius = f32::from_bits(input(8));
    output(u64::from(frustum.excludes_sphere(center, radius)));
    let spheres = [(low, radius), (center, radius)];
    let mut of_spheres = [Visibility::Outside; 2];
    ask(level, &spheres, &matrix, &viewport, &state, &mut depth, &mut of_spheres).ok()?;
    let positions = ModelPositions::new(&vertices, matrix, viewport);
    let of_list = ask_triangles(level, &positions, indices, &state, &mut depth).ok()?;
    output(u64::from(of_spheres.contains(&of_list)));
    Some(answers.iter().filter(|&&answer| answer == Visibility::Hidden).count() as u32)
}

program!(main, Memory = Memory::NEW);
