//! Conversions of single numbers.

use halfplane::{Bounds, Format, Small, Standard};
use halfplane_tests::{
    failure::Verdict,
    properties::numbers::{
        about_half_steps, nearest_step_is_the_reference_s, nearest_unorm32_is_the_reference_s,
        snap_is_nearest, special_floats, unorm16_is_nearest, unorm32_is_nearest,
    },
    run::check,
    sizes,
    toy::Toy,
};
use proptest::prelude::*;

fn floats() -> impl Strategy<Value = f32> {
    prop_oneof![any::<u32>().prop_map(f32::from_bits), 0f32..1.0, -1f32..2.0]
}

fn snaps<F: Format>() {
    let property = |pixels| {
        snap_is_nearest::<F>(pixels)?;
        nearest_step_is_the_reference_s::<F>(pixels)
    };
    for value in special_floats() {
        property(value).unwrap();
    }
    let end = 2 * Bounds::<F>::GUARD_BAND;
    for k in (-600..600).chain(end - 60..end + 60).chain(-end - 60..60 - end) {
        for value in about_half_steps::<F>(k) {
            property(value).unwrap();
        }
    }
    let pixels = Bounds::<F>::GUARD_BAND as f32 / Bounds::<F>::STEPS_PER_PIXEL as f32 * 1.01;
    let halves = (-end..=end).prop_map(|k| about_half_steps::<F>(k)[0]);
    check(sizes::NUMBERS, prop_oneof![floats(), -pixels..pixels, halves], property);
}

#[test]
fn snapping_is_to_nearest_even_standard() {
    snaps::<Standard>();
}

#[test]
fn snapping_is_to_nearest_even_small() {
    snaps::<Small>();
}

#[test]
fn snapping_is_to_nearest_even_toy() {
    snaps::<Toy>();
}

#[test]
fn unorm32_is_nearest_for_special_and_random_floats() {
    let property = |depth| -> Verdict {
        unorm32_is_nearest(depth)?;
        nearest_unorm32_is_the_reference_s(depth)
    };
    for value in special_floats() {
        property(value).unwrap();
    }
    check(sizes::NUMBERS, floats(), property);
}

/// All integers and the neighbours of all half-way points between two 16-bit depths, exhaustively.
#[test]
fn unorm16_is_nearest_about_every_multiple() {
    for multiple in (0..=u32::MAX).step_by(65_537) {
        let near = (-3..=3).chain(32_765..=32_771).chain(-32_771..=-32_765);
        for depth in near.filter_map(|offset| multiple.checked_add_signed(offset)) {
            unorm16_is_nearest(depth).unwrap();
        }
    }
    check(sizes::NUMBERS, any::<u32>(), unorm16_is_nearest);
}
