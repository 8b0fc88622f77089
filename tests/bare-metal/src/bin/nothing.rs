//! Only statistics: no attachment.

#![no_std]
#![no_main]

use halfplane::{Region, Standard, State, Vertex, draw};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main(_: &mut ()) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let statistics = draw(&vertices[..], indices(), input(12), &State::new(region), &mut ()).ok()?;
    output(u64::from(statistics.drawn));
    Some(statistics.drawn)
}

program!(main, () = ());
