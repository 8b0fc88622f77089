//! A coverage bitmap.

#![no_std]
#![no_main]

use halfplane::{Coverage, Region, Standard, State, Vertex, blocks, draw};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;
const BLOCKS: usize = blocks(WIDTH, HEIGHT);

fn main(masks: &mut [u16; BLOCKS]) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut coverage = Coverage::new(region, masks).ok()?;
    coverage.clear();
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let statistics = draw(&vertices[..], indices(), input(12), &State::new(region), &mut coverage).ok()?;
    output(u64::from(statistics.drawn) + u64::from(coverage.get(input(13), input(14))?));
    Some(statistics.drawn)
}

program!(main, [u16; BLOCKS] = [0; BLOCKS]);
