//! Only statistics: no attachment.

#![no_std]
#![no_main]

use halfplane::{Region, Standard, State, Vertex, draw};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main() -> Option<()> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;

    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let indices = [input(9) as u16, input(10) as u16, input(11) as u16];
    let statistics = draw(&vertices[..], &indices, input(12), &State::new(region), &mut ());
    output(u64::from(statistics.ok()?.drawn));
    Some(())
}

program!(main);
