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
