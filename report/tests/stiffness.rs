//! Every rung of the stiffness ladder: this crate keeps its contract there, and the ladder is no harmless one,
//! as what textbooks do comes off it.

use halfplane_report::stiffness::judged::{Judged, judge};
use halfplane_report::stiffness::{Promise, checks, families};

fn judged(id: &str) -> Vec<(i32, Judged)> {
    let families = families();
    let family = families.iter().find(|family| family.id == id).unwrap();
    family.rungs.iter().map(|rung| (rung.k, judge(rung).unwrap())).collect()
}

#[test]
fn every_rung_is_within_the_contract() {
    for family in families() {
        for rung in &family.rungs {
            let judged = judge(rung).unwrap();
            let [ours32, ours16, .., rational] = judged.depth;
            let at = format!("{} k = {}: {judged:?}", family.id, rung.k);
            if family.promise != Promise::Measured {
                assert_eq!(judged.wrong[0], 0, "{at}");
            }
            // G5, and for 16 bits: vertices are moved by two units at most, into 2..=65533.
            assert!(ours32.largest <= 1.01, "{at}");
            assert!(ours16.largest <= 3.01 * 65_537.0, "{at}");
            assert!(rational.largest <= 0.5, "{at}");
        }
    }
}

#[test]
fn every_family_has_samples_on_most_rungs() {
    for family in families() {
        let rungs: Vec<_> = family.rungs.iter().map(|rung| judge(rung).unwrap()).collect();
        let seen = rungs.iter().filter(|judged| judged.samples >= 4).count();
        assert!(seen == rungs.len(), "{}: {seen} of {}", family.id, rungs.len());
    }
}

#[test]
fn textbook_planes_come_off() {
    // The plane's place among the errors: 2 barycentric, 3 gradient, both in f32.
    for (id, plane) in
        [("needles", 2), ("needles", 3), ("slats", 3), ("collinear", 3), ("fans", 2), ("fans", 3)]
    {
        let rungs = judged(id);
        let largest = |of: &(i32, Judged)| of.1.depth[plane].largest;
        let (first, last) = (largest(&rungs[0]), largest(&rungs[rungs.len() - 1]));
        assert!(last > 8.0 * first && last > 1000.0, "{id}: from {first} to {last}");
    }
}

#[test]
fn textbook_edges_come_off() {
    for id in ["missed", "w-ratios", "scales", "distant"] {
        let wrong: u64 = judged(id).iter().map(|(_, judged)| judged.wrong[1]).sum();
        assert!(wrong > 0, "{id}");
    }
}

/// What is only measured stays small where floats keep the vertices: the cut at the near plane moves no sample
/// that is farther than a step from it.
#[test]
fn the_near_plane_moves_few_samples() {
    for (k, judged) in judged("near-plane") {
        assert!(judged.wrong[0] * 200 <= judged.samples, "k = {k}: {judged:?}");
    }
}

#[test]
fn nothing_that_must_not_change_a_picture_does() {
    for check in checks::all().unwrap() {
        assert!(check.compared >= 64, "{check:?}");
        assert_eq!(check.differences, 0, "{check:?}");
    }
}
