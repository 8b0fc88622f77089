//! Depth and a visibility buffer.

#![no_std]
#![no_main]

use halfplane::{D32, Depth, DepthTest, Ids, Region, Standard, State, Vertex, draw, texels};
use halfplane_bare_metal::{indices, input, inputs, output, program};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 16;
const TEXELS: usize = texels(WIDTH, HEIGHT);

fn main([depths, id_texels]: &mut [[u32; TEXELS]; 2]) -> Option<u32> {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).ok()?;
    let mut depth: Depth<'_, Standard, D32> = Depth::new(region, depths, DepthTest::LESS).ok()?;
    depth.clear(u32::MAX);
    let mut ids = Ids::new(region, id_texels).ok()?;
    ids.clear();
    let [a, b, c] = inputs().map(|[x, y, z]| Vertex::new(x as i32, y as i32, z));
    let vertices = [a.ok()?, b.ok()?, c.ok()?];
    let statistics =
        draw(&vertices[..], indices(), input(12), &State::new(region), &mut (&mut depth, &mut ids)).ok()?;
    output(
        u64::from(statistics.drawn)
            + u64::from(depth.get(input(13), input(14))?)
            + u64::from(ids.get(input(13), input(14))?),
    );
    Some(statistics.drawn)
}

program!(main, [[u32; TEXELS]; 2] = [[0; TEXELS]; 2]);
