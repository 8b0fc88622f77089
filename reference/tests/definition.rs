//! The definitions held to what they must mean.

mod common;

use common::{Case, any_case, cases, corners, integer, sample};
use halfplane_reference::{Point, Rational, covered_area, covers, depth_at, from_steps, weights_at};
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

fn covers_integers(xy: [[i64; 2]; 3], at: [i64; 2]) -> bool {
    covers(&xy.map(|[x, y]| Point::from_integers(x, y)), &Point::from_integers(at[0], at[1]))
}

#[test]
fn the_rule_on_a_triangle_with_a_top_and_a_left_edge() {
    // Top edge (0,0)-(4,0), left edge (0,0)-(0,4), hypotenuse on the right.
    let xy = [[0, 0], [4, 0], [0, 4]];
    let expect = |at, covered| assert_eq!(covers_integers(xy, at), covered, "{at:?}");
    expect([1, 1], true); // inside
    expect([2, 0], true); // on the top edge
    expect([0, 2], true); // on the left edge
    expect([0, 0], true); // on both
    expect([2, 2], false); // on the hypotenuse
    expect([4, 0], false); // on top edge and hypotenuse
    expect([0, 4], false); // on left edge and hypotenuse
    expect([5, 0], false); // on the top edge's line only
    expect([-1, -1], false);
    expect([3, 3], false);
}

#[test]
fn the_rule_on_a_triangle_with_a_bottom_and_a_right_edge() {
    let xy = [[4, 4], [0, 4], [4, 0]];
    let expect = |at, covered| assert_eq!(covers_integers(xy, at), covered, "{at:?}");
    expect([3, 3], true); // inside
    expect([2, 2], true); // on the hypotenuse, a left edge
    expect([2, 4], false); // on the bottom edge
    expect([4, 2], false); // on the right edge
    expect([0, 4], false); // left edge and bottom edge
    expect([4, 0], false); // left edge and right edge
}

#[test]
fn a_corner_of_two_left_edges_is_covered() {
    assert!(covers_integers([[0, 2], [4, 0], [4, 4]], [0, 2]));
    assert!(!covers_integers([[4, 2], [0, 0], [0, 4]], [4, 2]));
}

#[test]
fn triangles_without_area_cover_nothing() {
    for xy in [[[0, 0], [2, 2], [4, 4]], [[0, 0], [4, 0], [2, 0]], [[1, 1]; 3], [[0, 0], [0, 0], [3, 1]]] {
        for at in (0..25).map(|i| [i % 5, i / 5]) {
            assert!(!covers_integers(xy, at), "{xy:?} {at:?}");
        }
    }
    let line = [[0, 0], [2, 2], [4, 4]].map(|[x, y]| Point::from_integers(x, y));
    assert_eq!(weights_at(&line, &line[0]), None);
    assert_eq!(depth_at(&line, &[0, 1, 2].map(integer), &line[0]), None);
}

#[test]
fn the_two_halves_of_every_small_quadrilateral_share_no_sample_and_lose_none() {
    // All triangles 0, b, c of a 4 x 4 grid with each fourth corner d on the far side of b c: the two
    // triangles that share b c; whatever lies strictly inside their union or on b c is covered once.
    let points: Vec<[i64; 2]> = (0..16).map(|i| [i % 4, i / 4]).collect();
    let side =
        |a: [i64; 2], b: [i64; 2], p: [i64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let mut shared_edge_samples = 0;
    for (a, b, c, d) in points.iter().flat_map(|&a| {
        let points = &points;
        points
            .iter()
            .flat_map(move |&b| points.iter().flat_map(move |&c| points.iter().map(move |&d| (a, b, c, d))))
    }) {
        if !(side(b, c, a) > 0 && side(b, c, d) < 0) || a > d {
            continue;
        }
        for &at in &points {
            let times = u32::from(covers_integers([a, b, c], at)) + u32::from(covers_integers([d, c, b], at));
            assert!(times <= 1, "{a:?} {b:?} {c:?} {d:?} at {at:?}");
            let inside_edge = side(b, c, at) == 0
                && at != b
                && at != c
                && (0..2).all(|k| at[k] >= b[k].min(c[k]) && at[k] <= b[k].max(c[k]));
            if inside_edge {
                shared_edge_samples += 1;
                assert_eq!(times, 1, "{a:?} {b:?} {c:?} {d:?} at {at:?}");
            }
        }
    }
    assert!(shared_edge_samples > 500, "{shared_edge_samples}");
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn the_order_of_the_corners_does_not_matter(case in any_case()) {
        let [a, b, c] = case.xy;
        for pixel in case.pixels().step_by(5) {
            let at = sample(case.grid, pixel);
            let first = covers(&corners(&[a, b, c]), &at);
            for other in [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
                prop_assert_eq!(first, covers(&corners(&other), &at));
            }
        }
    }

    #[test]
    fn weights_give_back_the_sample_and_decide_the_inside(case in any_case()) {
        let triangle = corners(&case.xy);
        for pixel in case.pixels().step_by(5) {
            let at = sample(case.grid, pixel);
            let Some(weights) = weights_at(&triangle, &at) else {
                prop_assert!(!covers(&triangle, &at));
                continue;
            };
            prop_assert_eq!(weights.iter().sum::<Rational>(), Rational::one());
            let along = |axis: fn(&Point) -> &Rational| -> Rational {
                weights.iter().zip(&triangle).map(|(weight, corner)| weight * axis(corner)).sum()
            };
            prop_assert_eq!(along(|p| &p.x), at.x.clone());
            prop_assert_eq!(along(|p| &p.y), at.y.clone());
            if weights.iter().all(Rational::is_positive) {
                prop_assert!(covers(&triangle, &at));
            }
            if weights.iter().any(Rational::is_negative) {
                prop_assert!(!covers(&triangle, &at));
            }
        }
    }

    #[test]
    fn depth_is_the_corners_own_and_linear_between(case in any_case(), z in any::<[u32; 3]>()) {
        let triangle = corners(&case.xy);
        let z = z.map(|z| integer(z.into()));
        let Some(first) = depth_at(&triangle, &z, &triangle[0]) else { return Ok(()) };
        prop_assert_eq!(&first, &z[0]);
        for i in 0..3 {
            let (a, b) = (&triangle[i], &triangle[(i + 1) % 3]);
            let two = integer(2);
            let middle = Point::new((&a.x + &b.x) / &two, (&a.y + &b.y) / &two);
            let depth = depth_at(&triangle, &z, &middle);
            prop_assert_eq!(depth, Some((&z[i] + &z[(i + 1) % 3]) / &two));
        }
    }

    #[test]
    fn a_row_of_samples_is_covered_in_one_piece(case in any_case()) {
        let Case { grid, rect, .. } = case;
        let triangle = corners(&case.xy);
        for y in rect.y0..rect.y1 {
            let covered: Vec<bool> =
                (rect.x0..rect.x1).map(|x| covers(&triangle, &sample(grid, (x, y)))).collect();
            prop_assert!(covered.chunk_by(|a, b| a == b).filter(|run| run[0]).count() <= 1);
        }
    }

    #[test]
    fn pixel_areas_sum_to_the_triangle(xy in prop::array::uniform3(prop::array::uniform2(-300..300_i64))) {
        let triangle = xy.map(|[x, y]| Point::new(from_steps(x, 6), from_steps(y, 6)));
        let [[ax, ay], [bx, by], [cx, cy]] = xy;
        let doubled = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        let mut sum = Rational::zero();
        for pixel in (-5..5).flat_map(|y| (-5..5).map(move |x| (x, y))) {
            let area = covered_area(&triangle, pixel);
            prop_assert!(!area.is_negative() && area <= Rational::one());
            let inside = |(x, y): (i64, i64)| {
                weights_at(&triangle, &Point::from_integers(x, y))
                    .is_some_and(|weights| !weights.iter().any(Rational::is_negative))
            };
            let (x, y) = pixel;
            let full = [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)].map(inside) == [true; 4];
            prop_assert_eq!(full, area.is_one());
            sum += area;
        }
        prop_assert_eq!(sum, integer(doubled.abs()) / integer(2 * 64 * 64));
    }
}
