//! Batches and boxes at every level of this machine.

use crate::simd::Met;
use halfplane::simd::Occlusion;
use halfplane_tests::{
    Failure,
    case::Case,
    properties::{
        batches::{
            batches_are_the_mesh, clusters_are_small, clusters_are_the_same_triangles,
            ids_of_batches_are_the_nearest, short_memory_is_refused,
        },
        questions::{
            answers_about_spheres_are_certain, answers_are_certain, beside_the_eye_is_outside,
            occluders_by_any_name_are_the_same,
        },
    },
    run::check,
    shapes::Kind,
    sizes,
    strategies::case,
};
use proptest::prelude::*;
use std::cell::Cell;

/// Most triangles large, some of them over others, most views from the front.
const LARGE: [Kind; 5] = [Kind::Medium, Kind::Medium, Kind::AxisAligned, Kind::GuardBand, Kind::Small];

/// What was asked and hidden in all cases.
#[derive(Default)]
struct Asked(Cell<Occlusion>);

impl Asked {
    fn count(&self, more: Occlusion) {
        let sum = self.0.get();
        self.0.set(Occlusion {
            batches: sum.batches + more.batches,
            hidden_batches: sum.hidden_batches + more.hidden_batches,
            facing_meshlets: sum.facing_meshlets + more.facing_meshlets,
            meshlets: sum.meshlets + more.meshlets,
            hidden_meshlets: sum.hidden_meshlets + more.hidden_meshlets,
        });
    }

    /// One in so many is hidden.
    fn assert_hidden(&self, one_in: u32) {
        let asked = self.0.get();
        println!("{asked:?}");
        let hidden = asked.hidden_batches + asked.hidden_meshlets;
        assert!(hidden >= (asked.batches + asked.meshlets) / one_in, "{asked:?}");
    }
}

#[test]
fn frames_of_batches_are_those_of_the_mesh() {
    let (met, asked) = (Met::default(), Asked::default());
    check(sizes::BATCH_FRAME, case(0..=160, &Kind::ALL), |case| {
        let (statistics, occlusion) = batches_are_the_mesh(&case)?;
        met.count(statistics);
        asked.count(occlusion);
        Ok(())
    });
    met.assert_drawn(20);
}

/// Meshlets beside the picture, and more in it than are worth asking about.
#[test]
fn frames_of_a_grid_are_those_of_the_mesh() -> Result<(), Failure> {
    let (statistics, occlusion) = batches_are_the_mesh(&Case::grid(260))?;
    println!("{statistics}, {occlusion:?}");
    let in_view = statistics.drawn + statistics.culled.no_sample;
    assert!(in_view > 30_000 && statistics.culled.outside > 90_000, "{statistics}");
    // Nothing hides anything: questions stop.
    assert!(occlusion.hidden_meshlets < 5 && occlusion.meshlets < in_view / 150, "{occlusion:?}");
    Ok(())
}

/// What is near is drawn first, wherever it is in the list, and hides what is behind it.
#[test]
fn frames_behind_a_wall_are_those_of_the_mesh() -> Result<(), Failure> {
    let (statistics, occlusion) = batches_are_the_mesh(&Case::behind_a_wall(100))?;
    println!("{statistics}, {occlusion:?}");
    assert!(statistics.culled.hidden > 10_000, "{statistics}");
    assert!(occlusion.hidden_batches > 8 && occlusion.hidden_meshlets > 4, "{occlusion:?}");
    Ok(())
}

/// More than fit into the scratch memory at a time, in several batches.
#[test]
fn frames_of_many_batches_are_those_of_the_mesh() {
    let (met, asked) = (Met::default(), Asked::default());
    check(sizes::BATCH_MANY, case(1500..=4000, &LARGE), |case| {
        let (statistics, occlusion) = batches_are_the_mesh(&case)?;
        met.count(statistics);
        asked.count(occlusion);
        Ok(())
    });
    met.assert_drawn(50);
    asked.assert_hidden(50);
}

#[test]
fn ids_of_batches_are_those_of_the_nearest() {
    let asked = Asked::default();
    check(sizes::BATCH_MANY, case(100..=2500, &LARGE), |case| {
        asked.count(ids_of_batches_are_the_nearest(&case)?.1);
        Ok(())
    });
    asked.assert_hidden(50);
}

#[test]
fn what_is_said_to_be_out_of_sight_is() {
    let met = Cell::new([0; 3]);
    check(sizes::BATCH_FRAME, case(2..=60, &LARGE), |case| {
        let (sum, more) = (met.get(), answers_are_certain(&case)?);
        met.set(std::array::from_fn(|answer| sum[answer] + more[answer]));
        Ok(())
    });
    println!("outside, hidden, visible: {:?}", met.get());
    let all: u32 = met.get().iter().sum();
    assert!(met.get().iter().all(|&count| count > all / 50), "{:?}", met.get());
}

#[test]
fn spheres_that_are_out_of_sight_are() {
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
fn what_is_beside_the_eye_is_outside() {
    beside_the_eye_is_outside().unwrap();
}

#[test]
fn occluders_in_pairs_and_by_reference_are_the_same() {
    check(sizes::MESHLET_ERRORS, case(2..=60, &LARGE), |case| occluders_by_any_name_are_the_same(&case));
}

#[test]
fn clusters_have_the_same_triangles() {
    check(sizes::MESHLET_ERRORS, case(0..=400, &Kind::ALL), |case| clusters_are_the_same_triangles(&case));
}

#[test]
fn clusters_lie_close_together() {
    check(sizes::MESHLET_ALONE, (64..4000usize, any::<u64>()), |(triangles, seed)| {
        clusters_are_small(triangles, seed)
    });
}

#[test]
fn memory_that_is_too_short_is_refused() {
    check(sizes::MESHLET_ERRORS, case(0..=1200, &Kind::ALL), |case| short_memory_is_refused(&case));
}
