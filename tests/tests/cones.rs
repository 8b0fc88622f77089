//! Meshlets whose triangles all face the same way, or nearly.

use halfplane_tests::{
    properties::cones::{Faced, meshes_are_their_triangles, patches_are_their_triangles},
    run::check,
    shapes::{Kind, Patch},
    sizes,
    strategies::case,
};
use proptest::prelude::*;
use std::cell::Cell;

/// Patches by the sizes of their triangles, as [`Patch::powers`].
fn patch(powers: [std::ops::RangeInclusive<i32>; 5], spread: f64) -> impl Strategy<Value = Patch> {
    (1..40usize, 0..=4u32, powers, -1.0..1.0f64, 0..4u32, any::<u64>()).prop_map(
        move |(count, part, powers, cosine, kind, seed)| Patch {
            count,
            spread: spread * f64::from(part) / 4.0,
            powers,
            cosine,
            orthographic: kind == 0,
            seed,
        },
    )
}

fn run(powers: [std::ops::RangeInclusive<i32>; 5], spread: f64) -> Faced {
    let met = Cell::new(Faced::default());
    check(sizes::CONES, patch(powers, spread), |patch| {
        met.set(met.get().and(patches_are_their_triangles(&patch, [64, 48])?));
        Ok(())
    });
    println!("{:?}", met.get());
    met.get()
}

#[test]
fn ordinary_patches_are_left_out_where_they_face_away() {
    let Faced { facing, left_out, cones: [cones, all] } = run([-4..=-1, -3..=0, -4..=-2, -2..=3, 4..=6], 0.4);
    assert!(cones > all / 2, "{cones} cones of {all}");
    assert!(left_out > facing / 2, "{left_out} of {facing}");
}

/// Heights about a sub-pixel step, where snapping turns triangles round.
#[test]
fn patches_of_slivers_are_their_triangles() {
    let Faced { facing, left_out, .. } = run([-4..=0, -12..=-2, -4..=-1, -2..=8, 1..=7], 0.1);
    assert!(left_out > facing / 20, "{left_out} of {facing}");
}

/// Triangles of a few sub-pixel steps.
#[test]
fn tiny_patches_are_their_triangles() {
    let Faced { facing, left_out, .. } = run([-6..=0, -4..=0, -6..=-1, -2..=8, -9..=1], 0.3);
    assert!(left_out > facing / 50, "{left_out} of {facing}");
}

/// Far from the origin, near the eye, far beyond the picture.
#[test]
fn extreme_patches_are_their_triangles() {
    run([-10..=2, -14..=0, -20..=1, -20..=20, -12..=14], 1.0);
}

#[test]
fn meshes_of_any_kind_are_their_triangles() {
    check(sizes::CONES, case(1..=6, &Kind::ALL), |case| meshes_are_their_triangles(&case).map(|_| ()));
}
