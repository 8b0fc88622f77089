//! Spheres before any camera.

use crate::batches::case;
use halfplane_tests::{
    properties::spheres::{
        answers_about_spheres_are_certain, bounds_of_no_spheres_are_anything, bounds_of_spheres_are_tight,
        points_before_tiny_matrices_are_in_their_bound, points_of_spheres_are_in_their_bound,
        spheres_bound_what_they_hold, spheres_left_out_are_outside,
    },
    run::check,
    shapes::Kind,
    sizes,
};
use proptest::{array, prelude::*};
use std::cell::Cell;

#[test]
fn nothing_in_a_sphere_is_outside_its_bound() {
    let (useful, all) = (Cell::new(0), Cell::new(0));
    check(sizes::BOUND, case(1..=12, &Kind::ALL), |case| {
        all.set(all.get() + 1);
        useful.set(useful.get() + u32::from(spheres_bound_what_they_hold(&case)?));
        Ok(())
    });
    println!("{} of {} bounded", useful.get(), all.get());
    assert!(useful.get() >= all.get() / 3);
}

#[test]
fn points_of_a_sphere_are_in_its_bound() {
    let (useful, all) = (Cell::new(0), Cell::new(0));
    let strategy = (case(1..=1, &Kind::ALL), array::uniform3(-4.0..4.0f32), -12.0..3.0f32, any::<u64>());
    check(sizes::BOUND, strategy, |(case, center, scale, seed)| {
        all.set(all.get() + 1);
        let bounded = points_of_spheres_are_in_their_bound(&case, center, scale.exp2(), seed)?;
        useful.set(useful.get() + u32::from(bounded));
        Ok(())
    });
    println!("{} of {} bounded", useful.get(), all.get());
    assert!(useful.get() >= all.get() / 3);
}

#[test]
fn spheres_that_are_out_of_sight_are() {
    const LARGE: [Kind; 5] = [Kind::Medium, Kind::Medium, Kind::AxisAligned, Kind::GuardBand, Kind::Small];
    let met = Cell::new([0; 3]);
    check(sizes::BATCH_FRAME, case(2..=60, &LARGE), |case| {
        let (sum, more) = (met.get(), answers_about_spheres_are_certain(&case)?);
        met.set(std::array::from_fn(|answer| sum[answer] + more[answer]));
        Ok(())
    });
    println!("outside, hidden, visible: {:?}", met.get());
    let all: u32 = met.get().iter().sum();
    assert!(met.get().iter().all(|&count| count > all / 50), "{:?}", met.get());
}

#[test]
fn bounds_of_spheres_before_a_camera_are_tight() {
    let sum = Cell::new([0, 0]);
    let strategy = (array::uniform2(-1.5..1.5f32), 1.0..200.0f32, 0.001..0.8f32);
    check(sizes::BOUND, strategy, |([x, y], z, part)| {
        let [sphere, cube] = bounds_of_spheres_are_tight([x * z, y * z, z], z * part)?;
        sum.set([sum.get()[0] + sphere, sum.get()[1] + cube]);
        Ok(())
    });
    let [spheres, boxes] = sum.get();
    println!("{spheres} pixels, of boxes {boxes}");
    assert!(spheres < boxes / 4 * 3);
}

#[test]
fn digits_that_products_lose_are_allowed_for() {
    check(sizes::BOUND, -20.0..0.0f32, |power| points_before_tiny_matrices_are_in_their_bound(power.exp2()));
}

#[test]
fn what_reaches_the_eye_is_anywhere() {
    for radius in [1.0, 1.5, f32::INFINITY, f32::NAN, -1.0, -f32::MIN_POSITIVE] {
        bounds_of_no_spheres_are_anything([0.0, 0.0, 1.0], radius).unwrap();
    }
    for center in [[0.0, 0.0, -3.0], [f32::NAN, 0.0, 1.0], [0.0, f32::INFINITY, 1.0], [0.0, 0.0, f32::NAN]] {
        bounds_of_no_spheres_are_anything(center, 0.25).unwrap();
    }
}

#[test]
fn spheres_that_are_left_out_are_outside() {
    let (outside, all) = (Cell::new(0), Cell::new(0));
    let strategy = (case(0..=2, &Kind::ALL), array::uniform3(-40.0..40.0f32), -10.0..6.0f32, any::<u64>());
    check(sizes::BOUND, strategy, |(case, center, scale, seed)| {
        all.set(all.get() + 1);
        let excluded = spheres_left_out_are_outside(&case, center, scale.exp2(), seed)?;
        outside.set(outside.get() + u32::from(excluded));
        Ok(())
    });
    println!("{} of {} outside", outside.get(), all.get());
    assert!((all.get() / 10..all.get() * 19 / 20).contains(&outside.get()));
}
