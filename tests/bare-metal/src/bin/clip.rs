//! Clip-space vertices to depth: the feature `transform`.

#![no_std]
#![no_main]

use halfplane::{ClipPositions, Depth, DepthTest, Region, Standard, State, Viewport, draw, texels};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;
const TEXELS: usize = texels(WIDTH, HEIGHT);

fn main(depths: &mut [u32; TEXELS]) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth: Depth<'_, Standard> = Depth::new(region, depths, DepthTest::LESS).ok()?;
    depth.clear(u32::MAX);
    let vertices = inputs().map(|[x, y, z]| [x, y, z, input(15)].map(f32::from_bits));
    let positions = ClipPositions::new(&vertices, Viewport::new(region));
    let statistics = draw(&positions, indices(), input(12), &State::new(region), &mut depth).ok()?;
    output(u64::from(statistics.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(statistics.drawn)
}

program!(main, [u32; TEXELS] = [0; TEXELS]);
