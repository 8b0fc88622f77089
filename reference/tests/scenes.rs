//! Whole scenes against the definitions, and the verifier against pictures with known faults.

mod common;

use std::sync::atomic::{AtomicU64, Ordering};

use common::{cases, corners, integer, sample};
use halfplane_reference::{
    Compare, DepthSpec, Mismatches, NO_ID, Picture, Rational, Report, Scene, SceneError, SceneTriangle,
    VerifyError, covers, depth_at, render, specified_depth, verify,
};
use num_traits::Signed;
use proptest::prelude::*;

const COMPARES: [Compare; 5] =
    [Compare::Less, Compare::LessEqual, Compare::Greater, Compare::GreaterEqual, Compare::Always];
const SPECS: [DepthSpec; 3] = [DepthSpec::D32, DepthSpec::D16, DepthSpec::SMALL];

/// Scenes with triangles that overlap, repeat and meet: depths often tie or lie within a unit.
fn scenes() -> impl Strategy<Value = Scene> {
    let place = prop::array::uniform3(prop::array::uniform2(-6..30 * 16_i32));
    let depth = prop_oneof![
        prop::array::uniform3(0..65_536_u32),
        prop::array::uniform3(500..504_u32),
        prop::array::uniform3(prop_oneof![Just(0), Just(65_535_u32)]),
    ];
    let triangle = (place, depth, 0..6_u32).prop_map(|(xy, z, id)| SceneTriangle { xy, z, id });
    let size = (1..24_u32, 1..40_u32, any::<(u8, u8)>());
    (size, prop::collection::vec(triangle, 0..8), any::<bool>()).prop_map(|(size, mut triangles, again)| {
        if again {
            triangles.extend_from_within(..triangles.len() / 2);
        }
        let (width, height, (x, y)) = size;
        Scene { width, height, subpixel_bits: 4, sample: (u32::from(x) % 16, u32::from(y) % 16), triangles }
    })
}

/// One pixel from the definitions: depth, winner, and the exactly best depth.
fn pixel(
    scene: &Scene,
    compare: Compare,
    spec: DepthSpec,
    at: (u32, u32),
) -> (u32, Option<u32>, Option<Rational>) {
    let grid = scene.grid().unwrap();
    let mut depth = match compare {
        Compare::Greater | Compare::GreaterEqual => 0,
        _ if spec.bits() == 32 => u32::MAX,
        _ => 65_535,
    };
    let (mut winner, mut best): (_, Option<Rational>) = (None, None);
    for (index, triangle) in (0..).zip(&scene.triangles) {
        let triangle_corners = corners(&triangle.xy);
        if !covers(&triangle_corners, &sample(grid, at)) {
            continue;
        }
        let z =
            triangle.z.map(|z| if spec.bits() == 32 { z.clamp(2, u32::MAX - 2) } else { z.clamp(2, 65_533) });
        let new = specified_depth(&triangle.xy, &z, grid, spec, at).unwrap();
        let exact = depth_at(&triangle_corners, &z.map(|z| integer(z.into())), &sample(grid, at)).unwrap();
        let (wins, better): (bool, fn(&Rational, &Rational) -> bool) = match compare {
            Compare::Less => (new < depth, |a, b| a < b),
            Compare::LessEqual => (new <= depth, |a, b| a < b),
            Compare::Greater => (new > depth, |a, b| a > b),
            Compare::GreaterEqual => (new >= depth, |a, b| a > b),
            Compare::Always => (true, |_, _| true),
        };
        if wins {
            (depth, winner) = (new, Some(index));
        }
        if best.as_ref().is_none_or(|best| better(&exact, best)) {
            best = Some(exact);
        }
    }
    (depth, winner, best)
}

fn check(scene: &Scene, picture: &Picture, compare: Compare, spec: DepthSpec, report: &Report) {
    let one = Rational::from_integer(1.into());
    let (mut covered, mut largest, mut sum) = (0, integer(0), integer(0));
    let grid = scene.grid().unwrap();
    for i in 0..scene.width as usize * scene.height as usize {
        let at = (i as u32 % scene.width, i as u32 / scene.width);
        let (depth, winner, best) = pixel(scene, compare, spec, at);
        assert_eq!((picture.depth[i], picture.winners[i]), (depth, winner), "{at:?} {compare:?} {spec:?}");
        assert_eq!(picture.ids[i], winner.map_or(NO_ID, |winner| scene.triangles[winner as usize].id));
        let found = picture.best[i].map(|index| {
            let triangle = &scene.triangles[index as usize];
            let z = triangle.z.map(|z| integer(spec.keep(z).into()));
            depth_at(&corners(&triangle.xy), &z, &sample(grid, at)).unwrap()
        });
        assert_eq!(found, best, "{at:?} {compare:?}");
        if compare == Compare::Less {
            let best = picture.exact_best(scene, spec, at.0, at.1).map(|exact| exact.to_rational());
            assert_eq!(found, best);
        }
        if let Some(winner) = winner {
            let triangle = &scene.triangles[winner as usize];
            let z = triangle.z.map(|z| integer(spec.keep(z).into()));
            let exact = depth_at(&corners(&triangle.xy), &z, &sample(grid, at)).unwrap();
            let error = (exact - integer(depth.into())).abs();
            covered += 1;
            sum += &error;
            largest = largest.max(error);
        }
    }
    assert_eq!(
        (report.covered, report.measured, report.pixels),
        (covered, covered, picture.depth.len() as u64)
    );
    let near = |float: f64, exact: Rational| {
        let float = Rational::from_float(float).unwrap();
        assert!((float - &exact).abs() <= &one / integer(1_000_000_000), "{exact}");
    };
    near(report.max_error, largest);
    near(report.mean_error, if covered == 0 { integer(0) } else { sum / integer(covered as i64) });
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn pictures_are_the_definition_and_verify(scene in scenes(), compare in 0..5_usize, spec in 0..3_usize) {
        let (compare, spec) = (COMPARES[compare], SPECS[spec]);
        let done = AtomicU64::new(0);
        let progress = |pixels| {
            done.fetch_add(pixels, Ordering::Relaxed);
        };
        let picture = render(&scene, compare, spec, &progress).unwrap();
        let pixels = u64::from(scene.width) * u64::from(scene.height);
        prop_assert_eq!(done.load(Ordering::Relaxed), pixels);
        for ids in [Some(&picture.ids[..]), None] {
            let report = verify(&scene, compare, spec, &picture.depth, ids, &progress).unwrap();
            prop_assert!(report.identical(), "{}", report);
            prop_assert!(report.first.is_none());
            check(&scene, &picture, compare, spec, &report);
        }
        prop_assert_eq!(done.load(Ordering::Relaxed), 3 * pixels);
    }
}

/// Two parallel planes 100 apart (ids 4 far, 5 near) with a third (6) one unit behind the nearer, on
/// 40 x 40 pixels of which the left 20 columns are covered.
fn layers() -> (Scene, Picture) {
    let half = |z, id| {
        let (w, h) = (20 * 256, 40 * 256);
        let at = |xy| SceneTriangle { xy, z: [z; 3], id };
        [at([[0, 0], [w, 0], [0, h]]), at([[w, 0], [w, h], [0, h]])]
    };
    let triangles = [half(1_100, 4), half(1_000, 5), half(1_001, 6)].concat();
    let scene = Scene { width: 40, height: 40, subpixel_bits: 8, sample: (128, 128), triangles };
    let picture = render(&scene, Compare::Less, DepthSpec::D32, &|_| ()).unwrap();
    (scene, picture)
}

fn judge(change: impl Fn(&mut Picture)) -> Report {
    let (scene, mut picture) = layers();
    change(&mut picture);
    verify(&scene, Compare::Less, DepthSpec::D32, &picture.depth, Some(&picture.ids), &|_| ()).unwrap()
}

/// The kinds of a single wrong pixel at (3, 2) or, uncovered, (30, 2).
fn kinds(change: impl Fn(&mut u32, &mut u32), x: u32) -> Mismatches {
    let i = 2 * 40 + x as usize;
    let report = judge(|picture| change(&mut picture.depth[i], &mut picture.ids[i]));
    let first = report.first.expect("a difference");
    assert_eq!((first.x, first.y), (x, 2));
    assert_eq!((first.kinds, report.covered), (report.mismatches, 800));
    assert!(!report.identical());
    report.mismatches
}

#[test]
fn every_kind_of_fault_is_found_and_named() {
    let one = Mismatches { pixels: 1, ..Mismatches::default() };
    assert!(judge(|_| ()).identical());
    let missing = kinds(|depth, id| (*depth, *id) = (u32::MAX, NO_ID), 3);
    assert_eq!(missing, Mismatches { missing: 1, ..one });
    let extra = kinds(|depth, id| (*depth, *id) = (1_000, 5), 30);
    assert_eq!(extra, Mismatches { extra: 1, ..one });
    let uncleared = kinds(|depth, _| *depth = 7, 30);
    assert_eq!(uncleared, Mismatches { depth: 1, ..one });
    let off_by_one = kinds(|depth, _| *depth += 1, 3);
    assert_eq!(off_by_one, Mismatches { depth: 1, ..one });
    let off_by_two = kinds(|depth, _| *depth -= 2, 3);
    assert_eq!(off_by_two, Mismatches { depth: 1, bound: 1, ..one });
    // The layer one unit behind: another winner, but one that quantisation could explain.
    let near_tie = kinds(|depth, id| (*depth, *id) = (1_001, 6), 3);
    assert_eq!(near_tie, Mismatches { id: 1, depth: 1, ..one });
    let wrong_layer = kinds(|depth, id| (*depth, *id) = (1_100, 4), 3);
    assert_eq!(wrong_layer, Mismatches { id: 1, depth: 1, winner: 1, ..one });
    let wrong_layer_right_depth = kinds(|_, id| *id = 4, 3);
    assert_eq!(wrong_layer_right_depth, Mismatches { id: 1, bound: 1, winner: 1, ..one });
    let no_such_triangle = kinds(|_, id| *id = 77, 3);
    assert_eq!(no_such_triangle, Mismatches { id: 1, ..one });
}

#[test]
fn the_first_difference_is_the_first_in_row_major_order_and_all_are_counted() {
    let report = judge(|picture| {
        for (x, y) in [(9, 33), (2, 39), (19, 17), (5, 17), (0, 18)] {
            picture.depth[y * 40 + x] += 1;
        }
    });
    let first = report.first.unwrap();
    assert_eq!((first.x, first.y, report.mismatches.pixels), (5, 17, 5));
    let shown = report.to_string();
    for part in [
        "NOT identical: 5 pixels differ (depth 5)",
        "(x 5, y 17)",
        "depth 1001, exact depth 1000 = 1000.000000",
    ] {
        assert!(shown.contains(part), "{shown}");
    }
    assert!(judge(|_| ()).to_string().contains("identical: every pixel is as specified"));
}

#[test]
fn a_piece_is_found_by_the_id_it_shares() {
    // Id 4 has a piece on the left half at 1100, two on the right half, at 1200 and 1300.
    let (mut scene, picture) = layers();
    let extra = scene.triangles[1];
    scene.triangles[1].z = [1_200; 3];
    scene.triangles.push(SceneTriangle { z: [1_300; 3], ..extra });
    let judge = |x: usize, y: usize, value| {
        let (mut depth, mut ids) = (picture.depth.clone(), picture.ids.clone());
        (depth[y * 40 + x], ids[y * 40 + x]) = (value, 4);
        verify(&scene, Compare::Less, DepthSpec::D32, &depth, Some(&ids), &|_| ()).unwrap()
    };
    let wrong_id = Mismatches { pixels: 1, id: 1, depth: 1, winner: 1, ..Mismatches::default() };
    for (x, y, value) in [(1, 35, 1_100), (18, 35, 1_200), (18, 35, 1_300)] {
        let report = judge(x, y, value);
        assert_eq!((report.mismatches, report.measured, report.max_error), (wrong_id, 800, 0.0));
    }
    assert_eq!(judge(18, 35, 1_100).mismatches, Mismatches { bound: 1, ..wrong_id });
}

#[test]
fn without_ids_what_is_not_clear_is_drawn() {
    let (scene, picture) = layers();
    let judge = |x: usize, value| {
        let mut depth = picture.depth.clone();
        depth[x] = value;
        verify(&scene, Compare::Less, DepthSpec::D32, &depth, None, &|_| ()).unwrap().mismatches
    };
    let one = Mismatches { pixels: 1, ..Mismatches::default() };
    assert_eq!(judge(3, 1_000), Mismatches::default());
    assert_eq!(judge(3, 1_001), Mismatches { depth: 1, ..one });
    assert_eq!(judge(3, 1_002), Mismatches { depth: 1, bound: 1, ..one });
    assert_eq!(judge(3, u32::MAX), Mismatches { missing: 1, ..one });
    assert_eq!(judge(30, 5), Mismatches { extra: 1, ..one });
}

#[test]
fn bad_input_is_named() {
    let (mut scene, picture) = layers();
    let run = |scene: &Scene, spec, depth: &[u32], ids: Option<&[u32]>| {
        verify(scene, Compare::Less, spec, depth, ids, &|_| ()).map(|report| report.identical())
    };
    let (depth, ids) = (&picture.depth[..], &picture.ids[..]);
    assert_eq!(run(&scene, DepthSpec::D32, depth, Some(ids)), Ok(true));
    let short = VerifyError::DepthLength { needed: 1_600, given: 1_599 };
    assert_eq!(run(&scene, DepthSpec::D32, &depth[1..], Some(ids)), Err(short));
    let short = VerifyError::IdsLength { needed: 1_600, given: 1_599 };
    assert_eq!(run(&scene, DepthSpec::D32, depth, Some(&ids[1..])), Err(short));
    scene.triangles[2].z[1] = 65_536;
    let wide = SceneError::DepthTooWide { triangle: 2, z: 65_536, bits: 16 };
    assert_eq!(run(&scene, DepthSpec::D16, depth, None), Err(VerifyError::Scene(wide)));
    assert_eq!(render(&scene, Compare::Less, DepthSpec::SMALL, &|_| ()).map(|_| ()), Err(wide));
}
