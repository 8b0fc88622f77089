//! What set-up triangles and masks say of themselves.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{
    properties::setup::{of_mask, of_regions, of_triangle},
    run::check,
    sizes,
    strategies::{frame, shot},
    toy::Toy,
};

fn triangles<F: Format>() {
    check(sizes::SETUP, shot::<F>(), |shot| of_triangle::<F>(&shot.frame, &shot.corners, shot.z));
}

#[test]
fn triangles_are_set_up_as_documented_standard() {
    triangles::<Standard>();
}

#[test]
fn triangles_are_set_up_as_documented_small() {
    triangles::<Small>();
}

#[test]
fn triangles_are_set_up_as_documented_toy() {
    triangles::<Toy>();
}

#[test]
fn every_mask_has_its_cells() {
    for bits in 0..=u16::MAX {
        of_mask(bits, bits.rotate_left(3) ^ 0x5A).unwrap();
    }
}

#[test]
fn regions_have_in_common_what_both_have() {
    check(sizes::SETUP, (frame::<Small>(), frame::<Small>()), |(one, other)| {
        for regions in [[one.region, other.region], [one.region, one.scissor], [one.scissor, one.region]] {
            of_regions::<Small>(regions)?;
        }
        Ok(())
    });
}
