//! Every rung of the stiffness ladder: this crate keeps its contract there, and the ladder is no harmless one,
//! as what textbooks do comes off it.

use halfplane_report::stiffness::judged::{Judged, judge};
use halfplane_report::stiffness::{Promise, checks, families};

/// Of the textbooks' planes in units of 2^-32: what an error of theirs must exceed to show that the ladder bites.
const LOST: f64 = 65_536.0;

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
            // G5, and for 16 bits: the vertices' rounding is half a unit more.
            assert!(ours32.largest <= 1.01, "{at}");
            assert!(ours16.largest <= 1.51 * 65_537.0, "{at}");
            assert!(rational.largest <= 0.5, "{at}");
        }
    }
}

#[test]
fn every_family_has_samples_on_most_rungs() {
    for family in families() {
        let rungs: Vec<_> = family.rungs.iter().map(|rung| judge(rung).unwrap()).collect();
        let seen = rungs.iter().filter(|judged| judged.samples >= 8).count();
        assert!(seen * 10 >= rungs.len() * 9, "{}: {seen} of {}", family.id, rungs.len());
    }
}

#[test]
fn textbook_planes_come_off() {
    for (id, plane) in [("needles", 2), ("slats", 2), ("steep-depth", 3), ("far-corners", 2), ("missed", 2)] {
        let rungs = judged(id);
        let (first, last) =
            (rungs.first().unwrap().1.depth[plane].largest, rungs.last().unwrap().1.depth[plane].largest);
        assert!(last > LOST || last > 8.0 * first, "{id}: from {first} to {last}");
    }
}

#[test]
fn textbook_edges_come_off() {
    for id in ["missed", "needles", "scales", "near-plane"] {
        let wrong: u64 = judged(id).iter().map(|(_, judged)| judged.wrong[1]).sum();
        assert!(wrong > 0, "{id}");
    }
}

#[test]
fn nothing_that_must_not_change_a_picture_does() {
    for check in checks::all().unwrap() {
        assert!(check.compared >= 64, "{check:?}");
        assert_eq!(check.differences, 0, "{check:?}");
    }
}
