//! What is said of boxes and of spheres before any camera.

use halfplane_tests::{
    Failure,
    properties::{
        boxes::{
            bounds_of_points_are_tight, boxes_are_where_they_are_said_to_be, boxes_bound_what_they_hold,
            points_of_boxes_are_in_their_bound, quotients_beyond_floats_are_anywhere,
            rectangles_beside_samples_are_in_their_bound,
        },
        points::points_are_in_their_bounds,
        spheres::{
            bounds_of_no_spheres_are_anything, bounds_of_spheres_are_tight,
            points_before_tiny_matrices_are_in_their_bound, points_of_spheres_are_in_their_bound,
            spheres_bound_what_they_hold, spheres_left_out_are_outside,
        },
    },
    run::check,
    shapes::Kind,
    sizes,
    strategies::case,
};
use proptest::{array, prelude::*};
use std::{cell::Cell, ops::Range};

/// In how many of the cases something was said.
#[derive(Default)]
struct Said(Cell<[u32; 2]>);

impl Said {
    fn count(&self, said: bool) {
        let [yes, all] = self.0.get();
        self.0.set([yes + u32::from(said), all + 1]);
    }

    /// In so many of a hundred.
    fn assert_percent(&self, range: Range<u32>) {
        let [yes, all] = self.0.get();
        println!("{yes} of {all}");
        assert!(yes >= all * range.start / 100 && yes <= all * range.end / 100, "{yes} of {all}");
    }
}

#[test]
fn nothing_in_a_box_is_outside_its_bound() {
    let bounded = Said::default();
    check(sizes::BOUND, case(1..=12, &Kind::ALL), |case| {
        bounded.count(boxes_bound_what_they_hold(&case)?);
        Ok(())
    });
    bounded.assert_percent(33..100);
}

#[test]
fn points_of_a_box_are_in_its_bound() {
    let bounded = Said::default();
    let size = (-12.0..3.0f32).prop_map(|scale| if scale < -8.0 { 0.0 } else { scale.exp2() });
    let place = (array::uniform3(-4.0..4.0f32), array::uniform3(size), any::<u64>());
    check(sizes::BOUND, (case(1..=1, &Kind::ALL), place), |(case, (low, size, seed))| {
        bounded.count(points_of_boxes_are_in_their_bound(&case, low, size, seed)?);
        Ok(())
    });
    bounded.assert_percent(33..100);
}

#[test]
fn quotients_that_are_no_floats_are_anywhere() -> Result<(), Failure> {
    quotients_beyond_floats_are_anywhere()
}

#[test]
fn boxes_are_inside_or_outside_where_it_is_said() {
    let said: [Said; 3] = Default::default();
    let size = (-12.0..5.0f32).prop_map(f32::exp2);
    let place = (array::uniform3(-6.0..6.0f32), array::uniform3(size), any::<u64>());
    check(sizes::BOUND, (case(0..=1, &Kind::ALL), place), |(case, (low, size, seed))| {
        let answers = boxes_are_where_they_are_said_to_be(&case, low, size, seed)?;
        said.iter().zip(answers).for_each(|(said, answer)| said.count(answer));
        Ok(())
    });
    // Outside, inside, beside the area.
    said[0].assert_percent(10..95);
    said[1].assert_percent(1..50);
    said[2].assert_percent(20..99);
}

#[test]
fn points_whose_sums_cancel_are_in_their_bounds() {
    check(sizes::BOUND, any::<u64>(), points_are_in_their_bounds);
}

#[test]
fn what_is_snapped_to_a_sample_is_in_its_bound() {
    let strategy = (array::uniform4(any::<u32>()), array::uniform4(-8..=8i32), array::uniform2(any::<u32>()));
    check(sizes::BOUND, strategy, |(samples, beside, sample)| {
        rectangles_beside_samples_are_in_their_bound(samples, beside, sample)
    });
}

#[test]
fn bounds_of_points_are_a_pixel() {
    let end = 1 << 20;
    let number = move || (-end * 3 / 2..=end * 3 / 2).prop_map(move |v: i32| v as f32 / end as f32);
    check(sizes::BOUND, ([number(), number(), number()], [1..=16384u32, 1..=16384]), |([x, y, z], size)| {
        bounds_of_points_are_tight([x, y, z.abs().min(1.0)], size)
    });
}

#[test]
fn nothing_in_a_sphere_is_outside_its_bound() {
    let bounded = Said::default();
    check(sizes::BOUND, case(1..=12, &Kind::ALL), |case| {
        bounded.count(spheres_bound_what_they_hold(&case)?);
        Ok(())
    });
    bounded.assert_percent(33..100);
}

#[test]
fn points_of_a_sphere_are_in_its_bound() {
    let bounded = Said::default();
    let strategy = (case(1..=1, &Kind::ALL), array::uniform3(-4.0..4.0f32), -12.0..3.0f32, any::<u64>());
    check(sizes::BOUND, strategy, |(case, center, scale, seed)| {
        bounded.count(points_of_spheres_are_in_their_bound(&case, center, scale.exp2(), seed)?);
        Ok(())
    });
    bounded.assert_percent(33..100);
}

#[test]
fn bounds_of_spheres_before_a_camera_are_tight() {
    let sum = Cell::new([0, 0]);
    let turns = array::uniform2(-4.0..4.0f32);
    let strategy = (array::uniform2(-1.5..1.5f32), 1.0..200.0f32, 0.001..0.8f32, turns);
    check(sizes::BOUND, strategy, |([x, y], z, part, turns)| {
        let [sphere, cube] = bounds_of_spheres_are_tight([x * z, y * z, z], z * part, turns)?;
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
    let outside = Said::default();
    let strategy = (case(0..=2, &Kind::ALL), array::uniform3(-40.0..40.0f32), -10.0..6.0f32, any::<u64>());
    check(sizes::BOUND, strategy, |(case, center, scale, seed)| {
        outside.count(spheres_left_out_are_outside(&case, center, scale.exp2(), seed)?);
        Ok(())
    });
    outside.assert_percent(10..95);
}
