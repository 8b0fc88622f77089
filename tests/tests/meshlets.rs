//! Meshlets at every level of this machine.

use crate::simd::Met;
use halfplane_tests::{
    case::Case,
    properties::meshlets::{
        Grazing, grazing_meshlets_are_the_mesh, meshlet_errors, meshlets_are_the_mesh,
        meshlets_can_be_drawn_alone, meshlets_say_what_they_hold, single_triangles_are_the_mesh,
    },
    run::check,
    shapes::Kind,
    sizes,
    strategies::{numbers, triangles},
};
use proptest::prelude::*;
use std::cell::Cell;

#[test]
fn frames_are_those_of_the_mesh() {
    let met = Met::default();
    check(
        sizes::MESHLET_FRAME,
        (numbers::<12>(), numbers::<10>(), triangles(0..=160)),
        |(place, how, triangles)| {
            met.count(meshlets_are_the_mesh(&Case::from_numbers(place, how, &triangles, &Kind::ALL))?);
            Ok(())
        },
    );
    met.assert_all();
}

/// More than fit into the scratch memory at a time.
#[test]
fn frames_of_many_triangles_are_those_of_the_mesh() {
    let kinds = [Kind::Tiny, Kind::Small, Kind::Small, Kind::AxisAligned, Kind::Medium, Kind::GuardBand];
    let met = Met::default();
    check(
        sizes::MESHLET_MANY,
        (numbers::<12>(), numbers::<10>(), triangles(600..=1600)),
        |(place, how, triangles)| {
            met.count(meshlets_are_the_mesh(&Case::from_numbers(place, how, &triangles, &kinds))?);
            Ok(())
        },
    );
    met.assert_drawn(20);
}

#[test]
fn boxes_that_graze_the_frustum_are_left_out_only_where_all_is_outside() {
    let grazing = (0..3usize, any::<bool>(), -20..20, -10..24, any::<u64>());
    let grazing =
        grazing.prop_map(|(axis, upper, scale, shift, seed)| Grazing { axis, upper, scale, shift, seed });
    let (outside, all) = (Cell::new(0), Cell::new(0));
    check(sizes::MESHLET_GRAZING, grazing, |grazing| {
        all.set(all.get() + 1);
        outside.set(outside.get() + u32::from(grazing_meshlets_are_the_mesh(&grazing)?));
        Ok(())
    });
    println!("{} of {} wholly outside", outside.get(), all.get());
    assert!((all.get() / 10..all.get() * 9 / 10).contains(&outside.get()));
}

#[test]
fn meshlets_drawn_one_by_one_are_the_mesh() {
    check(sizes::MESHLET_ALONE, (1..700usize, any::<u64>()), |(triangles, seed)| {
        meshlets_can_be_drawn_alone(triangles, seed)
    });
}

#[test]
fn refused_meshes_say_why() {
    check(sizes::MESHLET_ERRORS, (1..300usize, any::<u64>()), |(triangles, seed)| {
        meshlet_errors(triangles, seed)
    });
}

#[test]
fn single_triangles_as_meshlets_are_the_mesh() {
    check(sizes::MESHLET_ALONE, (1..200usize, any::<u64>()), |(triangles, seed)| {
        single_triangles_are_the_mesh(triangles, seed)
    });
}

#[test]
fn meshlets_hold_their_triangles() {
    check(sizes::MESHLET_ERRORS, (1..300usize, any::<u64>()), |(triangles, seed)| {
        meshlets_say_what_they_hold(triangles, seed)
    });
}
