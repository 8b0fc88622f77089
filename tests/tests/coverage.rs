//! Coverage equals the reference, in every format.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{
    properties::coverage,
    run::check,
    shapes::{Kind, Random},
    sizes,
    strategies::shot,
    toy::{Middle, Toy},
};
use proptest::{prelude::*, sample::select};

fn equals_reference<F: Format>() {
    check(sizes::COVERAGE, shot::<F>(), |shot| coverage::equals_reference::<F>(&shot.frame, &shot.corners));
}

fn equals_definition<F: Format>() {
    check(sizes::DEFINITION, shot::<F>(), |shot| {
        coverage::equals_definition::<F>(&shot.frame, &shot.corners)
    });
}

fn bounds<F: Format>() {
    check(sizes::COVERAGE, shot::<F>(), |shot| {
        coverage::bounds_are_half_open::<F>(&shot.frame, &shot.corners)
    });
}

macro_rules! for_each_format {
    ($($format:ident $reference:ident $definition:ident $bounds:ident;)+) => {
        $(
            #[test]
            fn $reference() {
                equals_reference::<$format>();
            }

            #[test]
            fn $definition() {
                equals_definition::<$format>();
            }

            #[test]
            fn $bounds() {
                bounds::<$format>();
            }
        )+
    };
}

for_each_format! {
    Standard coverage_equals_reference_standard coverage_equals_definition_standard bounds_are_half_open_standard;
    Small coverage_equals_reference_small coverage_equals_definition_small bounds_are_half_open_small;
    Middle coverage_equals_reference_middle coverage_equals_definition_middle bounds_are_half_open_middle;
    Toy coverage_equals_reference_toy coverage_equals_definition_toy bounds_are_half_open_toy;
}

/// Scissors of many tiles in one direction and a few pixels in the other, where edges are as steep as they can be.
#[test]
fn coverage_equals_reference_in_long_and_narrow_scissors() {
    check(sizes::LONG, (any::<u64>(), any::<bool>(), select(Kind::ALL.to_vec())), |(seed, tall, kind)| {
        coverage::equals_reference_in_a_long_scissor::<Standard>(&mut Random(seed), tall, kind)
    });
}
