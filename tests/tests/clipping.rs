//! Clipped triangles against their neighbours and against the exact outline.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{
    Frame,
    properties::clipping,
    run::check,
    shapes::{Ground, clip_triangle},
    sizes,
    strategies::numbers,
};
use proptest::prelude::*;

/// A viewport anywhere in the target, its scissor all of it, sampled at pixel centres.
fn viewport<F: Format>() -> impl Strategy<Value = Frame> {
    numbers::<12>().prop_map(|numbers| {
        let frame = Frame::from_numbers::<F>(numbers);
        Frame { scissor: frame.region, ..frame }
    })
}

fn meshes<F: Format>() {
    check(sizes::CLIP_MESH, (viewport::<F>(), numbers::<12>(), any::<u64>()), |(frame, numbers, seed)| {
        clipping::mesh_has_no_seam::<F>(&frame, &Ground::from_numbers(numbers, seed))
    });
}

fn exact<F: Format>() {
    check(sizes::CLIP_EXACT, (viewport::<F>(), numbers::<10>()), |(frame, numbers)| {
        clipping::triangle_is_where_the_exact_one_is::<F>(&frame, &clip_triangle(numbers))
    });
}

/// Thin triangles of a few steps, w = 1: after clipping, snapping turns a corner inwards now and then.
fn thin<F: Format>() -> impl Strategy<Value = (Frame, [[f32; 4]; 3])> {
    (proptest::collection::vec(-30i32..30, 6), proptest::collection::vec(-5i32..6, 3)).prop_map(|(xy, z)| {
        let frame = Frame::whole::<F>(32, 32);
        let steps = (16 << F::SUBPIXEL_BITS) as f32;
        let vertex =
            |k: usize| [xy[2 * k] as f32 / steps, xy[2 * k + 1] as f32 / steps, z[k] as f32 / 4.0, 1.0];
        (frame, [vertex(0), vertex(1), vertex(2)])
    })
}

#[test]
fn clipped_meshes_have_no_seam_standard() {
    meshes::<Standard>();
}

#[test]
fn clipped_meshes_have_no_seam_small() {
    meshes::<Small>();
}

#[test]
fn clipped_triangles_are_where_the_exact_ones_are_standard() {
    exact::<Standard>();
}

#[test]
fn clipped_triangles_are_where_the_exact_ones_are_small() {
    exact::<Small>();
}

#[test]
fn pieces_of_thin_triangles_have_one_winding() {
    check(sizes::CLIP_PIECES, thin::<Standard>(), |(frame, triangle)| {
        clipping::pieces_have_one_winding::<Standard>(&frame, &triangle)
    });
}

#[test]
fn pieces_of_any_triangle_have_one_winding() {
    check(sizes::CLIP_PIECES, (viewport::<Standard>(), numbers::<10>()), |(frame, numbers)| {
        clipping::pieces_have_one_winding::<Standard>(&frame, &clip_triangle(numbers))
    });
}

/// The ends of the common edge cancel down to the last bits of a double where the plane cuts it:
/// computed from the other end, the cut would be elsewhere by pixels.
#[test]
fn neighbours_share_the_cut_of_an_edge_that_cancels() {
    let small = || 1i32..4096;
    let strategy = (small(), small(), 1i32..4_000_000, 1i32..4_000_000, numbers::<4>());
    check(sizes::CLIP_PIECES, strategy, |(p, q, aw, ax, others)| {
        // Heights p and -q over the plane; at the cut, w is (q a + p b) / (p + q), nearly nothing.
        let opposite = |a: i32| (i64::from(q) * i64::from(a) / i64::from(p)) as f32;
        let a = [ax as f32, (ax / 3) as f32, p as f32, aw as f32 + p as f32];
        let b = [-opposite(ax), -opposite(ax / 3) + 1.0, -(q as f32), -opposite(aw + p) + 1.0];
        let outside = |k: usize| {
            let [x, y] = [others[2 * k] % 2_000_000, others[2 * k + 1] % 2_000_000].map(|v| v as f32 - 1e6);
            [x, y, -(q as f32), 1.0]
        };
        let frame = Frame::whole::<Standard>(64, 64);
        clipping::neighbours_share_their_cut::<Standard>(&frame, [a, b, outside(0), outside(1)])
    });
}
