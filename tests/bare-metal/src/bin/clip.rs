//! Clip-space vertices to depth: the feature `transform`.

#![no_std]
#![no_main]

use halfplane::{ClipPositions, Depth, DepthTest, Region, Standard, State, Viewport, draw, texels};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main() -> Option<()> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depths = [0; texels(WIDTH, HEIGHT)];
    let mut depth: Depth<'_, Standard> = Depth::new(region, &mut depths, DepthTest::LESS).ok()?;
    depth.clear(u32::MAX);
    let vertices = inputs().map(|[x, y, z]| [x, y, z, input(15)].map(f32::from_bits));
    let positions = ClipPositions::new(&vertices, Viewport::new(region));
    let indices = [input(9), input(10), input(11)];
    let statistics = draw(&positions, &indices, input(12), &State::new(region), &mut depth);
    output(u64::from(statistics.ok()?.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(())
}

program!(main);
