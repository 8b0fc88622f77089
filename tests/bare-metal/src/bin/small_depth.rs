//! The small format: a 16-bit depth buffer.

#![no_std]
#![no_main]

use halfplane::{D16, Depth, DepthTest, Region, Small, State, Vertex, draw, texels};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;
const TEXELS: usize = texels(WIDTH, HEIGHT);

fn main(depths: &mut [u16; TEXELS]) -> Option<u32> {
    let region = Region::<Small>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth: Depth<'_, Small, D16> = Depth::new(region, depths, DepthTest::LESS).ok()?;
    depth.clear(u16::MAX);
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let statistics = draw(&vertices[..], indices(), input(12), &State::new(region), &mut depth).ok()?;
    output(u64::from(statistics.drawn) + u64::from(depth.get(input(13), input(14))?));
    Some(statistics.drawn)
}

program!(main, [u16; TEXELS] = [0; TEXELS]);
