//! The scanline coverage in integers against the definition in rationals.

mod common;

use std::collections::BTreeSet;

use common::{Case, Steps, any_case, cases, corners, sample};
use halfplane_reference::{
    Grid, Rect, Scene, SceneError, SceneTriangle, cover_count_picture, cover_counts, cover_rows, covers,
    weights_at,
};
use num_traits::Zero;
use proptest::prelude::*;

fn fast(case: &Case) -> BTreeSet<(u32, u32)> {
    let mut covered = BTreeSet::new();
    let mut last_row = None;
    cover_rows(&case.xy, case.grid, case.rect, |y, columns| {
        assert!(!columns.is_empty() && last_row < Some(y), "rows come once, top down");
        last_row = Some(y);
        covered.extend(columns.map(|x| (x, y)));
    });
    covered
}

fn by_definition(case: &Case) -> BTreeSet<(u32, u32)> {
    let triangle = corners(&case.xy);
    case.pixels().filter(|&pixel| covers(&triangle, &sample(case.grid, pixel))).collect()
}

#[test]
fn every_triangle_of_a_small_grid() {
    // Steps of half a pixel, samples at the corner, an edge and the centre: 5^6 triangles each.
    let values = [-1, 0, 1, 4, 7];
    let points: Vec<[i32; 2]> = values.iter().flat_map(|&y| values.map(|x| [x, y])).collect();
    let (mut on_edges, mut triangles) = (0, 0);
    for place in [(0, 0), (1, 0), (1, 1)] {
        let grid = Grid::new(1, place).unwrap();
        let rect = Rect { x0: 0, y0: 0, x1: 4, y1: 4 };
        for (i, &a) in points.iter().enumerate() {
            for &b in &points[..=i] {
                for &c in &points {
                    let case = Case { xy: [a, b, c], grid, rect };
                    let covered = by_definition(&case);
                    assert_eq!(fast(&case), covered, "{case:?}");
                    triangles += u32::from(!covered.is_empty());
                    on_edges += covered.iter().filter(|&&pixel| on_an_edge(&case, pixel)).count();
                }
            }
        }
    }
    assert!(triangles > 5_000 && on_edges > 5_000, "{triangles} {on_edges}");
}

fn on_an_edge(case: &Case, pixel: (u32, u32)) -> bool {
    let weights = weights_at(&corners(&case.xy), &sample(case.grid, pixel));
    weights.is_some_and(|weights| weights.iter().any(Zero::is_zero))
}

/// The generator must make the samples on which fill rules fail.
#[test]
fn the_kinds_reach_samples_on_edges_and_tiny_areas() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let (mut edges, mut covered_edges, mut tiny, mut extreme) = (0, 0, 0, 0);
    for _ in 0..400 {
        let case = any_case().new_tree(&mut runner).unwrap().current();
        let covered = by_definition(&case);
        let edge = |pixel: &(u32, u32)| on_an_edge(&case, *pixel);
        edges += u32::from(case.pixels().any(|pixel| edge(&pixel)));
        covered_edges += u32::from(covered.iter().any(edge));
        let [a, b, c] = case.xy.map(|corner| corner.map(i64::from));
        let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        tiny += u32::from(doubled.abs() == 1) + u32::from(doubled.abs() == 2);
        extreme += u32::from(case.xy.iter().flatten().any(|v| v.abs() > 1 << 22) && !covered.is_empty());
    }
    assert!(
        edges > 80 && covered_edges > 40 && tiny > 40 && extreme > 10,
        "{edges} {covered_edges} {tiny} {extreme}"
    );
}

proptest! {
    #![proptest_config(cases(1_500))]

    #[test]
    fn scanlines_are_the_definition(case in any_case()) {
        prop_assert_eq!(fast(&case), by_definition(&case));
    }

    #[test]
    fn scanlines_are_the_definition_for_any_integers(
        xy in any::<Steps>(),
        bits in 0..=16_u32,
        place in any::<(u32, u32)>(),
        at in any::<(u16, u16)>(),
    ) {
        let last = (1_u32 << bits) - 1;
        let grid = Grid::new(bits, (place.0 & last, place.1 & last)).unwrap();
        let (x0, y0) = (u32::from(at.0), u32::from(at.1));
        let case = Case { xy, grid, rect: Rect { x0, y0, x1: x0 + 3, y1: y0 + 3 } };
        prop_assert_eq!(fast(&case), by_definition(&case));
    }

    #[test]
    fn a_fan_around_a_point_covers_every_sample_of_its_square_once(
        x in 0..=64 * 16, y in 0..=64 * 16, place in (0..64_u32, 0..64_u32),
        cuts in prop::collection::vec(1..64 * 16, 0..4),
    ) {
        // The square's outline with extra points on it, each neighbouring pair joined to (x, y).
        let size = 64 * 16;
        let mut outline = vec![[0, 0]];
        let cuts: BTreeSet<i32> = cuts.into_iter().collect();
        outline.extend(cuts.iter().map(|&cut| [cut, 0]));
        outline.extend([[size, 0], [size, size], [0, size]]);
        let triangles: Vec<SceneTriangle> = (0..outline.len())
            .map(|i| [outline[i], outline[(i + 1) % outline.len()], [x, y]])
            .map(|xy| SceneTriangle { xy, z: [5; 3], id: 0 })
            .collect();
        let scene = Scene { width: 20, height: 18, subpixel_bits: 6, sample: place, triangles };
        let counts = cover_count_picture(&scene).unwrap();
        for (i, &count) in counts.iter().enumerate() {
            prop_assert_eq!(count, u32::from(i % 20 < 16 && i / 20 < 16), "pixel {}", i);
        }
        let sum: u64 = cover_counts(&scene).unwrap().iter().sum();
        prop_assert_eq!(sum, 16 * 16);
    }
}

#[test]
fn pictures_of_counts_are_the_definition() {
    let triangles: Vec<SceneTriangle> = [
        [[0, 0], [320, 16], [40, 600]],
        [[8, 8], [520, 8], [8, 520]],
        [[-400, 60], [900, 90], [10, 560]],
        [[3, 3], [9, 9], [30, 30]],
    ]
    .map(|xy| SceneTriangle { xy, z: [9; 3], id: 1 })
    .to_vec();
    let scene = Scene { width: 37, height: 35, subpixel_bits: 4, sample: (8, 8), triangles };
    let grid = scene.grid().unwrap();
    let covering = |triangle: &SceneTriangle, pixel| covers(&corners(&triangle.xy), &sample(grid, pixel));
    let pixels: Vec<(u32, u32)> = (0..35).flat_map(|y| (0..37).map(move |x| (x, y))).collect();
    let expected: Vec<u32> = pixels
        .iter()
        .map(|&pixel| scene.triangles.iter().map(|triangle| u32::from(covering(triangle, pixel))).sum())
        .collect();
    assert_eq!(cover_count_picture(&scene).unwrap(), expected);
    assert!(expected.contains(&3));
    let per_triangle: Vec<u64> = scene
        .triangles
        .iter()
        .map(|triangle| pixels.iter().filter(|&&pixel| covering(triangle, pixel)).count() as u64)
        .collect();
    assert_eq!(cover_counts(&scene).unwrap(), per_triangle);
    assert!(per_triangle[0] > 0 && per_triangle[3] == 0);
}

#[test]
fn bad_scenes_are_named() {
    let good = Scene { width: 4, height: 4, subpixel_bits: 4, sample: (8, 8), triangles: vec![] };
    assert_eq!(cover_counts(&good), Ok(vec![]));
    let error = |change: &dyn Fn(&mut Scene)| {
        let mut scene = good.clone();
        change(&mut scene);
        cover_count_picture(&scene).unwrap_err()
    };
    assert!(matches!(error(&|scene| scene.width = 0), SceneError::Size { width: 0, .. }));
    assert!(matches!(error(&|scene| scene.height = 65_537), SceneError::Size { height: 65_537, .. }));
    assert!(matches!(error(&|scene| scene.subpixel_bits = 17), SceneError::Grid(_)));
    assert!(matches!(error(&|scene| scene.sample.0 = 16), SceneError::Grid(_)));
    let nobody = SceneTriangle { xy: [[0; 2]; 3], z: [0; 3], id: u32::MAX };
    assert_eq!(error(&|scene| scene.triangles.push(nobody)), SceneError::ReservedId { triangle: 0 });
}
