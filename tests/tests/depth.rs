//! Depth is the specified integer and within its bound of the exact rational.

use halfplane::{D16, D32, DepthFormat, Format, Small, Standard};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    properties::depth,
    run::check,
    sizes,
    strategies::shot,
    toy::{Middle, Toy},
};
use std::cell::Cell;

fn specified<F: Format, D: DepthFormat<F>>(spec: DepthSpec) {
    let largest = Cell::new(0.0f64);
    check(sizes::DEPTH, shot::<F>(), |shot| {
        let error = depth::is_specified_and_bounded::<F, D>(&shot.frame, &shot.corners, shot.z, spec)?;
        largest.set(largest.get().max(error.approximate()));
        Ok(())
    });
    println!("largest error: {:.6} units of 2^-{}", largest.get(), spec.bits());
}

fn definition<F: Format, D: DepthFormat<F>>(spec: DepthSpec) {
    check(sizes::DEPTH_DEFINITION, shot::<F>(), |shot| {
        depth::equals_definition::<F, D>(&shot.frame, &shot.corners, shot.z, spec)
    });
}

fn order<F: Format, D: DepthFormat<F>>() {
    check(sizes::ORDERS, shot::<F>(), |shot| {
        depth::does_not_depend_on_the_order::<F, D>(&shot.frame, &shot.corners, shot.z)
    });
}

macro_rules! for_each_format {
    ($($module:ident $format:ident $depth:ident $spec:ident;)+) => {
        $(mod $module {
            use super::*;

            #[test]
            fn depth_is_specified_and_bounded() {
                specified::<$format, $depth>(DepthSpec::$spec);
            }

            #[test]
            fn depth_equals_definition() {
                definition::<$format, $depth>(DepthSpec::$spec);
            }

            #[test]
            fn depth_does_not_depend_on_the_order_of_vertices() {
                order::<$format, $depth>();
            }
        })+
    };
}

for_each_format! {
    standard_d32 Standard D32 D32;
    standard_d16 Standard D16 D16;
    middle_d32 Middle D32 D32;
    small_d16 Small D16 SMALL;
    toy_d16 Toy D16 SMALL;
}

/// Areas from 2^16 to the largest square steps, by every width.
#[test]
fn depths_over_powers_of_two_are_specified() {
    let depths = [[2, u32::MAX - 2, 77], [0x9000_0001, 3, 0xFFFF_0000], [1 << 8, 3 << 8, u32::MAX]];
    for z in depths {
        for (width, height) in (8..=23).flat_map(|width| (8..=23).map(move |height| (width, height))) {
            depth::of_a_power_of_two::<Standard, D32>([width, height], z, DepthSpec::D32).unwrap();
        }
        for (width, height) in (4..=14).flat_map(|width| (4..=14).map(move |height| (width, height))) {
            depth::of_a_power_of_two::<Small, D16>([width, height], z, DepthSpec::SMALL).unwrap();
        }
    }
}
