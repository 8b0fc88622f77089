//! Questions about triangle lists.

use halfplane_tests::{
    properties::lists::{
        Said, lists_of_window_triangles_are_asked_about, lists_out_of_sight_change_nothing,
        wrong_lists_are_refused,
    },
    run::check,
    shapes::Kind,
    sizes,
    strategies::case,
};
use std::cell::Cell;

/// Large ones often hide others.
const LARGE: [Kind; 5] = [Kind::Medium, Kind::Medium, Kind::AxisAligned, Kind::GuardBand, Kind::Small];

fn is_certain(most: usize, kinds: &'static [Kind]) -> Said {
    let met = Cell::new(Said::default());
    check(sizes::BATCH_FRAME, case(2..=most, kinds), |case| {
        let (sum, more) = (met.get(), lists_out_of_sight_change_nothing(&case)?);
        let add = |a: [u32; 3], b: [u32; 3]| std::array::from_fn(|answer| a[answer] + b[answer]);
        met.set(Said { lists: add(sum.lists, more.lists), boxes: add(sum.boxes, more.boxes) });
        Ok(())
    });
    println!("outside, hidden, visible: {:?}", met.get());
    met.get()
}

#[test]
fn lists_that_are_out_of_sight_change_nothing() {
    let Said { lists, boxes } = is_certain(60, &LARGE);
    let all: u32 = lists.iter().sum();
    assert!(lists.iter().all(|&count| count > all / 50), "{lists:?}");
    // Less is seen in vain.
    assert!(lists[2] < boxes[2], "{lists:?}, boxes {boxes:?}");
}

#[test]
fn lists_of_all_kinds_change_nothing() {
    is_certain(20, &Kind::ALL);
}

#[test]
fn lists_of_window_triangles_are_seen_where_they_have_samples() {
    check(sizes::MESHLET_ERRORS, case(0..=6, &Kind::ALL), |case| {
        lists_of_window_triangles_are_asked_about(&case)
    });
}

#[test]
fn lists_that_are_no_good_are_refused() {
    check(sizes::MESHLET_ERRORS, case(0..=20, &Kind::ALL), |case| wrong_lists_are_refused(&case));
}
