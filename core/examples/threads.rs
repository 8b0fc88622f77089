//! One frame by several threads, each a band of the target: `cargo run --release --example threads --features simd,std`.

use halfplane::{simd::*, *};
use rayon::prelude::*;

const WIDTH: u32 = 640;
const HEIGHT: u32 = 360;
/// Rows of pixels in a band: a multiple of 4.
const BAND: u32 = 64;

fn main() -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
    let vertices = [[-1.0, -1.0, 0.5], [0.0, 1.0, 0.5], [1.0, -1.0, 0.5]];
    let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let target = Region::of_size(WIDTH, HEIGHT)?;
    let viewport = Viewport::new(target);
    let mut memory = [Meshlet::EMPTY; max_meshlets(1)];
    let meshlets = &*make_meshlets(&vertices, &[0u16, 1, 2], &mut memory)?;

    let mut storage = vec![u32::MAX; texels(WIDTH, HEIGHT)];
    // A band's blocks lie together: each thread gets its own part of the storage.
    storage.par_chunks_mut(texels(WIDTH, BAND)).enumerate().try_for_each(|(at, texels)| {
        let y = BAND * at as u32;
        let band = Region::new(0, y, WIDTH, HEIGHT.min(y + BAND))?;
        let mut depth: Depth<'_, Standard> = Depth::new(band, texels, DepthTest::LESS)?;
        let mut scratch = MeshletScratch::NEW;
        // Pixels keep the target's coordinates; what is outside the band is not looked at.
        let (level, state) = (Level::detect(), State::new(band));
        draw_meshlets(level, meshlets, identity, viewport, &mut scratch, 0, &state, &mut depth)?;
        Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
    })?;

    let covered = storage.iter().filter(|&&depth| depth != u32::MAX).count();
    println!("{covered} of {} pixels are covered", WIDTH * HEIGHT);
    assert_eq!(covered as u32, WIDTH * HEIGHT / 2);
    Ok(())
}
