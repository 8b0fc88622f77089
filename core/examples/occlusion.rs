//! Occlusion culling in two passes: what was visible in the last frame is drawn first, and hides most of the rest,
//! which is asked for before it is drawn. `cargo run --release --example occlusion --features simd,std`.

use halfplane::{simd::*, *};

/// Objects in a row, one behind the other, at the depths 0.1 to 0.9.
const OBJECTS: usize = 9;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let region = Region::of_size(320, 200)?;
    let (viewport, state) = (Viewport::new(region), State::new(region));
    let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let mut scratch = MeshletScratch::NEW;
    // A rectangle each, the last ones smaller than the first; a box round each.
    let objects: Vec<(Meshlet, [[f32; 3]; 2])> = (1..=OBJECTS)
        .map(|at| {
            let (size, z) = (1.0 - 0.05 * at as f32, 0.1 * at as f32);
            let corners = [[-size, -size, z], [-size, size, z], [size, size, z], [size, -size, z]];
            let mut memory = [Meshlet::EMPTY; max_meshlets(2)];
            let meshlet = make_meshlets(&corners, &[0u16, 1, 2, 0, 2, 3], &mut memory)?[0];
            Ok((meshlet, meshlet.corners_of_box()))
        })
        .collect::<Result<_, MeshletError>>()?;

    let mut storage = vec![0; texels(320, 200)];
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(320, 200)];
    let mut depth: HierarchicalDepth<'_, Standard> =
        HierarchicalDepth::new(region, &mut storage, &mut ranges, DepthTest::LESS)?;
    // Nothing is known of a frame before the first; then, what was not hidden in it.
    let mut visible = [false; OBJECTS];
    for frame in 0..2 {
        depth.clear(u32::MAX);
        let mut draw = |at: usize, depth: &mut HierarchicalDepth<'_, Standard>| {
            let meshlet = std::slice::from_ref(&objects[at].0);
            draw_meshlets(Level::detect(), meshlet, identity, viewport, &mut scratch, 0, &state, depth)
        };
        let before = visible;
        for at in (0..OBJECTS).filter(|&at| before[at]) {
            draw(at, &mut depth)?;
        }
        for at in (0..OBJECTS).rev().filter(|&at| !before[at]) {
            visible[at] = match viewport.bound_box(&identity, objects[at].1, state.sample) {
                Bound::Nothing => false,
                Bound::Within { area, depths: [nearest, _] } => !depth.hides(area, nearest),
                Bound::Anything => true,
            };
            if visible[at] {
                draw(at, &mut depth)?;
            }
        }
        // The next frame begins with what is not hidden now.
        let drawn = visible.iter().filter(|&&visible| visible).count();
        for (at, visible) in visible.iter_mut().enumerate().filter(|(_, visible)| **visible) {
            if let Bound::Within { area, depths: [nearest, _] } =
                viewport.bound_box(&identity, objects[at].1, state.sample)
            {
                *visible = !depth.hides(area, nearest);
            }
        }
        println!("frame {frame}: {drawn} of {OBJECTS} objects drawn");
    }
    assert_eq!(visible, std::array::from_fn(|at| at == 0));
    Ok(())
}
