//! Every named error, and that nothing is written with it.

use halfplane::{Bounds, Format, Small, Standard};
use halfplane_tests::{
    properties::errors::{Refused, of_draws, of_last_ids, of_regions, of_storage, of_vertices},
    run::check,
    sizes,
    toy::Toy,
};
use proptest::prelude::*;

fn draws<F: Format>() {
    let case = (1..40u32, 1..40u32, 1..9u32, any::<u32>(), any::<u32>()).prop_map(
        |(width, height, triangles, at, beyond)| Refused { size: [width, height], triangles, at, beyond },
    );
    check(sizes::ERRORS, case, of_draws::<F>);
}

fn constructors<F: Format>() {
    let side = || prop_oneof![0..10u32, F::MAX_TARGET - 2..F::MAX_TARGET + 3, any::<u32>()];
    check(sizes::ERRORS, (side(), side(), side(), side()), |(a, b, c, d)| of_regions::<F>([a, b, c, d]));
    let size = (1..30u32, 1..30u32);
    check(sizes::ERRORS, (0..20u32, 0..20u32, size, any::<usize>()), |(x, y, (width, height), missing)| {
        of_storage::<F>(x, y, [width, height], missing)?;
        of_storage::<F>(x & !3, y & !3, [width, height], missing)
    });
    let guard = Bounds::<F>::GUARD_BAND;
    let coordinate = || prop_oneof![any::<i32>(), guard - 2..guard + 3, -guard - 2..3 - guard, -9..9];
    check(sizes::ERRORS, (coordinate(), coordinate()), |(x, y)| of_vertices::<F>(x, y));
}

#[test]
fn draws_are_refused_standard() {
    draws::<Standard>();
}

#[test]
fn draws_are_refused_small() {
    draws::<Small>();
}

#[test]
fn constructors_refuse_standard() {
    constructors::<Standard>();
}

#[test]
fn constructors_refuse_small() {
    constructors::<Small>();
}

#[test]
fn constructors_refuse_toy() {
    constructors::<Toy>();
}

#[test]
fn the_last_ids_are_drawn() {
    for triangles in 0..4 {
        of_last_ids::<Standard>(triangles).unwrap();
    }
}
