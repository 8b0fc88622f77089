//! Hierarchical depth against every pixel.

use halfplane::{Compare, D16, D32, DepthFormat, DepthTest, Format, Small, Standard};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    Failure,
    properties::{
        depth_test::COMPARISONS,
        hierarchical::{
            Answers, answers_are_those_of_the_pixels, hidden_triangles_change_nothing, holes_are_found,
            short_memory_is_refused, versions_come_round,
        },
    },
    run::check,
    sizes,
    strategies::scene_anywhere,
};
use proptest::prelude::*;
use std::cell::Cell;

/// Both answers are given, each in one of so many cases at least.
fn assert_both(answers: &Cell<Answers>, one_in: u64) {
    let Answers { hidden, seen } = answers.get();
    println!("{hidden} hidden, {seen} seen");
    assert!(hidden * one_in >= seen && seen * one_in >= hidden, "{hidden} hidden, {seen} seen");
}

fn add(answers: &Cell<Answers>, more: Answers) {
    let sum = answers.get();
    answers.set(Answers { hidden: sum.hidden + more.hidden, seen: sum.seen + more.seen });
}

fn answers<F: Format, D: DepthFormat<F>>(spec: DepthSpec) {
    for compare in COMPARISONS {
        for write in [true, false] {
            let met = Cell::default();
            let case = (scene_anywhere::<F>(150, 6), any::<u64>());
            check(sizes::HIERARCHY, case, |((frame, shots), seed)| {
                let test = DepthTest { compare, write };
                add(&met, answers_are_those_of_the_pixels::<F, D>(&frame, &shots, test, spec, seed)?);
                Ok(())
            });
            if compare != Compare::Always {
                assert_both(&met, 30);
            }
        }
    }
}

#[test]
fn answers_of_standard_are_those_of_the_pixels() {
    answers::<Standard, D32>(DepthSpec::D32);
}

#[test]
fn answers_of_16_bits_are_those_of_the_pixels() {
    answers::<Standard, D16>(DepthSpec::D16);
}

#[test]
fn answers_of_small_are_those_of_the_pixels() {
    answers::<Small, D16>(DepthSpec::SMALL);
}

/// Scenes of large triangles, so that many are hidden.
fn hidden<F: Format, D: DepthFormat<F>>() {
    for compare in COMPARISONS {
        let met = Cell::default();
        check(sizes::HIERARCHY, scene_anywhere::<F>(60, 24), |(frame, shots)| {
            let test = DepthTest { compare, write: true };
            add(&met, hidden_triangles_change_nothing::<F, D>(&frame, &shots, test)?);
            Ok(())
        });
        if compare != Compare::Always {
            assert_both(&met, 100);
        }
    }
}

#[test]
fn hidden_triangles_of_standard_change_nothing() {
    hidden::<Standard, D32>();
    hidden::<Standard, D16>();
}

#[test]
fn hidden_triangles_of_small_change_nothing() {
    hidden::<Small, D16>();
}

fn holes<F: Format, D: DepthFormat<F>>() {
    for compare in COMPARISONS {
        let met = Cell::default();
        check(sizes::HIERARCHY, any::<u64>(), |seed| {
            if compare != Compare::Always {
                add(&met, holes_are_found::<F, D>(compare, seed)?);
            }
            Ok(())
        });
        if compare != Compare::Always {
            assert_both(&met, 30);
        }
    }
}

#[test]
fn holes_in_standard_are_found() {
    holes::<Standard, D32>();
    holes::<Standard, D16>();
}

#[test]
fn holes_in_small_are_found() {
    holes::<Small, D16>();
}

#[test]
fn versions_that_come_round_are_told_apart() -> Result<(), Failure> {
    versions_come_round(70_000)
}

#[test]
fn memory_that_is_too_short_is_refused() {
    check(sizes::STORAGE, (1..200u32, 1..200u32, any::<usize>()), |(width, height, less)| {
        short_memory_is_refused(width, height, less)
    });
}
