//! Triangles that cover the whole target.

use halfplane::{Bounds, Format, Small, Standard};
use halfplane_tests::{
    Frame,
    properties::{clipping::counted as counted_clip, watertight::each_sample_once},
    shapes::{Mesh, triangulation},
    toy::Toy,
};

/// Targets of every awkward size, and at other sample positions.
fn frames<F: Format>() -> Vec<Frame> {
    let mut frames = Vec::new();
    for size in [[1, 1], [3, 5], [4, 4], [64, 64], [65, 63], [17, 90]] {
        let [width, height] = size.map(|side: u32| side.min(F::MAX_TARGET));
        for sample in [[1 << (F::SUBPIXEL_BITS - 1); 2], [0, 0], [(1 << F::SUBPIXEL_BITS) - 1, 0]] {
            frames.push(Frame { sample, ..Frame::whole::<F>(width, height) });
        }
    }
    frames
}

fn two<F: Format>() {
    for frame in frames::<F>() {
        let [x1, y1] = [frame.width(), frame.height()].map(|side| (side << F::SUBPIXEL_BITS) as i32);
        for order in 0..16 {
            each_sample_once::<F>(&frame, &triangulation([0, 0, x1, y1], &[]), order).unwrap();
        }
    }
}

fn one<F: Format>() {
    for frame in frames::<F>() {
        let guard = Bounds::<F>::GUARD_BAND;
        // Half of a square as large as the guard band: its hypotenuse passes the target's far corner.
        let mesh = Mesh {
            xy: vec![[-guard, -guard], [guard, -guard], [guard, guard], [-guard, guard]],
            triangles: vec![[0, 1, 3]],
            outline: [-guard, -guard, guard, guard],
        };
        let counts =
            halfplane_tests::properties::watertight::counted::<F>(&frame, &mesh, &mesh.triangles).unwrap();
        counts
            .matches(|pixel| {
                // Inside where x + y is less than 0 at the sample: never in the target but at (0, 0).
                let [x, y] = frame.sample_at::<F>(pixel);
                u16::from(x + y < 0)
            })
            .unwrap();
        let mesh = Mesh { triangles: vec![[1, 2, 3]], ..mesh };
        let counts =
            halfplane_tests::properties::watertight::counted::<F>(&frame, &mesh, &mesh.triangles).unwrap();
        counts.matches(|_| 1).unwrap();
    }
}

#[test]
fn two_fullscreen_triangles() {
    two::<Standard>();
    two::<Small>();
    two::<Toy>();
}

#[test]
fn one_fullscreen_triangle() {
    one::<Standard>();
    one::<Small>();
    one::<Toy>();
}

/// The usual ones of clip space: (-1, -1) to (1, 1) in two triangles, and (-1, -1) to (3, 3) in one.
#[test]
fn fullscreen_triangles_of_clip_space() {
    let quad = [[-1.0, -1.0, 0.0, 1.0], [1.0, -1.0, 0.0, 1.0], [1.0, 1.0, 1.0, 1.0], [-1.0, 1.0, 1.0, 1.0]];
    let big = [[-2.0, -2.0, 1.0, 2.0], [6.0, -2.0, 1.0, 2.0], [-2.0, 6.0, 1.0, 2.0]];
    for [width, height] in [[1, 1], [7, 5], [100, 61]] {
        let frame = Frame::whole::<Standard>(width, height);
        counted_clip::<Standard>(&frame, &quad, &[[0, 1, 2], [0, 2, 3]]).unwrap().matches(|_| 1).unwrap();
        counted_clip::<Standard>(&frame, &big, &[[0, 1, 2]]).unwrap().matches(|_| 1).unwrap();
    }
}
