//! The small format: a coverage bitmap.

#![no_std]
#![no_main]

use halfplane::{Coverage, Region, Small, State, Vertex, blocks, draw};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main() -> Option<()> {
    let region = Region::<Small>::of_size(WIDTH, HEIGHT).ok()?;
    let mut masks = [0; blocks(WIDTH, HEIGHT)];
    let mut coverage = Coverage::new(region, &mut masks).ok()?;
    coverage.clear();
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let indices = [input(9) as u16, input(10) as u16, input(11) as u16];
    let statistics = draw(&vertices[..], &indices, input(12), &State::new(region), &mut coverage);
    output(u64::from(statistics.ok()?.drawn) + u64::from(coverage.get(input(13), input(14))?));
    Some(())
}

program!(main);
