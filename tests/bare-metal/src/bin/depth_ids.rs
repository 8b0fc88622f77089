//! Depth and a visibility buffer.

#![no_std]
#![no_main]

use halfplane::{D32, Depth, DepthTest, Ids, Region, Standard, State, Vertex, draw, texels};
use halfplane_bare_metal::{input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;

fn main() -> Option<()> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depths = [0; texels(WIDTH, HEIGHT)];
    let mut depth: Depth<'_, Standard, D32> = Depth::new(region, &mut depths, DepthTest::LESS).ok()?;
    depth.clear(u32::MAX);
    let mut id_texels = [0; texels(WIDTH, HEIGHT)];
    let mut ids = Ids::new(region, &mut id_texels).ok()?;
    ids.clear();
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let indices = [input(9) as u16, input(10) as u16, input(11) as u16];
    let statistics =
        draw(&vertices[..], &indices, input(12), &State::new(region), &mut (&mut depth, &mut ids));
    output(
        u64::from(statistics.ok()?.drawn)
            + u64::from(depth.get(input(13), input(14))?)
            + u64::from(ids.get(input(13), input(14))?),
    );
    Some(())
}

program!(main);
