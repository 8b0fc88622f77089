//! Every implementation of the lanes, and whole frames drawn with them.

#[cfg(not(feature = "simd"))]
use halfplane_tests::properties::lanes::every_operation_of_arrays as every_operation_at_every_level;
use halfplane_tests::{run::check, sizes};
use proptest::prelude::*;
#[cfg(feature = "simd")]
use {
    crate::simd::Met,
    halfplane_tests::{
        case::Case,
        properties::{
            definition_path::{frame_is_the_one_of_arrays, small_format_is_the_one_of_arrays},
            lanes::every_operation_at_every_level,
        },
        shapes::Kind,
        strategies::{numbers, triangles},
    },
};

#[test]
fn lanes_do_what_they_say() {
    let extremes = || {
        prop_oneof![
            any::<u32>(),
            any::<u32>(),
            Just(0),
            Just(1),
            Just(u32::MAX),
            Just(u32::MAX - 1),
            Just(1 << 31),
            Just((1 << 31) - 1)
        ]
    };
    let lanes = || proptest::collection::vec(extremes(), 16).prop_map(|v| std::array::from_fn(|k| v[k]));
    let ramp = [extremes(), extremes(), extremes()];
    check(sizes::LANES, (lanes(), lanes(), any::<[u16; 2]>(), ramp), |(a, b, masks, ramp)| {
        every_operation_at_every_level(a, b, masks, ramp.map(|v| v as i32))?;
        // Some lanes equal.
        let c = std::array::from_fn(|k| if masks[0] >> k & 1 == 0 { a[k] } else { b[k] });
        every_operation_at_every_level(a, c, masks, ramp.map(|v| v as i32))
    });
}

/// All masks, by themselves and with a neighbour.
#[test]
fn every_mask_is_kept() {
    for mask in 0..=u16::MAX {
        let masks = [mask, mask.rotate_left(1)];
        every_operation_at_every_level([1; 16], [u32::MAX; 16], masks, [0, 1, -1]).unwrap();
    }
}

#[cfg(feature = "simd")]
#[test]
fn frames_at_every_level_are_those_of_arrays() {
    let met = Met::default();
    check(
        sizes::LEVEL_FRAME,
        (numbers::<12>(), numbers::<10>(), triangles(0..=40)),
        |(place, how, triangles)| {
            let case = Case::from_numbers(place, how, &triangles, &Kind::ALL);
            met.count(frame_is_the_one_of_arrays(&case)?);
            Ok(())
        },
    );
    met.assert_all();
}

#[cfg(feature = "simd")]
#[test]
fn frames_of_the_small_format_at_every_level_are_those_of_arrays() {
    let met = Met::default();
    check(
        sizes::LEVEL_SMALL,
        (numbers::<12>(), any::<u32>(), triangles(0..=40)),
        |(place, how, triangles)| {
            met.count(small_format_is_the_one_of_arrays(place, how, &triangles)?);
            Ok(())
        },
    );
    met.assert_drawn(5);
}
