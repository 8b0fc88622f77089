//! Every bug that was found, as its smallest case, with its story in one line.

use halfplane::{Region, Small, Standard, State, Vertex, draw};
use halfplane_tests::{
    Frame,
    properties::{clipping::pieces_have_one_winding, statistics::of_clip_space_add_up},
};

/// The id after the last one was computed, and overflowed, when a draw used the very last ids.
#[test]
fn first_id_at_the_end_with_nothing_to_draw() {
    let vertices: [Vertex<Standard>; 0] = [];
    let state = State::new(Region::of_size(1, 1).unwrap());
    let statistics = draw(&vertices[..], &[0u16; 0], u32::MAX, &state, &mut ()).unwrap();
    assert_eq!(statistics.submitted, 0);
}

/// A cut far beyond the eye came out at w = 0, and a triangle of finite numbers was called infinite.
#[test]
fn cut_between_a_huge_and_a_tiny_w() {
    let triangle =
        [[1.80144e16, 3.6028797e16, 0.51, 0.0], [0.0, 0.0, 0.0, f32::MAX], [0.0, 0.01, 0.438, 1.0]];
    of_clip_space_add_up::<Small>(&[triangle], [0, 0, 1, 1]).unwrap();
    let triangle = [
        [4.377_154e-38, 0.0, 0.0, 0.0],
        [0.0, 1.192_092_9e-7, 0.0, 1.80144e16],
        [1e-30, 0.0, 2.01, 0.999_999_94],
    ];
    of_clip_space_add_up::<Standard>(&[triangle], [0, 0, 1, 1]).unwrap();
}

/// No bug of the core, but of a test: a snapped pentagon that crosses itself has pieces of both windings.
#[test]
fn pentagon_that_snapping_twisted() {
    let triangle = [
        [0.007_080_078, -0.001_953_125, 1.25, 1.0],
        [0.001_953_125, 0.000_244_140_63, -1.0, 1.0],
        [0.000_732_421_9, 0.001_220_703_1, 0.5, 1.0],
    ];
    pieces_have_one_winding::<Standard>(&Frame::whole::<Standard>(32, 32), &triangle).unwrap();
}
