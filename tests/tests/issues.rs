//! Every bug that was found, as its smallest case, with its story in one line.

use halfplane::{Region, Small, Standard, State, Vertex, draw};
use halfplane_tests::{
    Frame,
    properties::{
        clipping::{mesh_has_no_seam, pieces_have_one_winding},
        neighbours::closed_surfaces_cancel,
        statistics::of_clip_space_add_up,
    },
    shapes::Ground,
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

/// A cut at the guard band came out beside it where an end of the edge is 2^53 times as far away, and one
/// side of a closed surface covered samples that no other did.
#[test]
fn guard_band_cuts_an_edge_that_reaches_very_far() {
    let corners =
        [[0.0, 0.0, 0.0, 1.0], [0.0, -1e20, 0.0, 1.0], [1000.0, 0.0, 0.0, 1.0], [0.0, 1e20, 0.0, 1.0]];
    closed_surfaces_cancel::<Standard>(&Frame::whole::<Standard>(64, 64), &corners).unwrap();
}

/// No bug of the core, but of a test: of a plane seen from its edge every sample was called outside, also
/// those of thin triangles on the line.
#[test]
fn plane_seen_from_its_edge() {
    let numbers = [15607, 15607, 15607, 11, 11, 11, 50, 46, 0, 0, 0, 63];
    let frame = Frame { region: [76, 0, 104, 27], scissor: [76, 0, 104, 27], ..Frame::whole::<Small>(1, 1) };
    mesh_has_no_seam::<Small>(&frame, &Ground::from_numbers(numbers, 9_476_562_641_788_044_163)).unwrap();
}
