//! How long rendering and verifying take: run with `--release`.
//!
//! The scenes are random triangles from a fixed seed on 1280x720; the picture that is verified is
//! the reference's own.

use std::time::Instant;

use halfplane_reference::{
    Compare, DepthSpec, NO_ID, Scene, SceneTriangle, cover_count_picture, render, verify,
};

/// A small generator with a fixed seed (Marsaglia's xorshift, 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (((self.0 >> 32) * u64::from(limit)) >> 32) as u32
    }
}

/// Triangles of about `size` pixels anywhere on the target.
fn scene(count: u32, size: u32) -> Scene {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let (width, height) = (1280, 720);
    let mut triangle = |id: u32| {
        let centre = [random.below(width << 8) as i32, random.below(height << 8) as i32];
        let reach = (size << 8) as i32;
        let xy = [(); 3].map(|()| centre.map(|c| c - reach + random.below(size << 9) as i32));
        SceneTriangle { xy, z: [(); 3].map(|()| random.below(u32::MAX)), id }
    };
    let triangles = (0..count).map(&mut triangle).collect();
    Scene { width, height, subpixel_bits: 8, sample: (128, 128), triangles }
}

fn main() {
    for (count, size) in [(50_000, 16), (260_000, 7), (2_000, 300)] {
        let scene = scene(count, size);
        let samples: u64 = cover_count_picture(&scene)
            .expect("the scene is valid")
            .iter()
            .map(|&count| u64::from(count))
            .sum();
        let pixels = u64::from(scene.width) * u64::from(scene.height);
        println!("{count} triangles, depth complexity {:.2}", samples as f64 / pixels as f64);
        let start = Instant::now();
        let picture = render(&scene, Compare::Less, DepthSpec::D32, &|_| ()).expect("valid");
        println!("  render {:.2} s", start.elapsed().as_secs_f64());
        let (depth, mut ids) = (&picture.depth, picture.ids.clone());
        let start = Instant::now();
        let report = verify(&scene, Compare::Less, DepthSpec::D32, depth, Some(&ids), &|_| ());
        println!("  verify {:.2} s", start.elapsed().as_secs_f64());
        println!("{}", report.expect("the pictures have the right size"));
        ids.iter_mut().filter(|id| **id != NO_ID).for_each(|id| *id /= 2);
        let start = Instant::now();
        let report = verify(&scene, Compare::Less, DepthSpec::D32, depth, Some(&ids), &|_| ());
        println!("  verify of a picture with wrong ids {:.2} s", start.elapsed().as_secs_f64());
        println!("{}\n", report.expect("the pictures have the right size"));
    }
}
