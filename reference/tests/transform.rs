//! Rounding and the exact transform.

mod common;

use common::{cases, integer};
use halfplane_reference::{
    ClipError, Planes, Rational, Viewport, clip, decimal, from_f32, from_steps, nearest_ties_even,
    nearest_ties_up, snap, to_window, unorm,
};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

fn ratio(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

#[test]
fn rounding_of_ties_and_others() {
    // value, ties up, ties to even
    let table = [
        (ratio(1, 2), 1, 0),
        (ratio(3, 2), 2, 2),
        (ratio(5, 2), 3, 2),
        (ratio(-1, 2), 0, 0),
        (ratio(-3, 2), -1, -2),
        (ratio(-5, 2), -2, -2),
        (ratio(7, 5), 1, 1),
        (ratio(8, 5), 2, 2),
        (ratio(-7, 5), -1, -1),
        (ratio(-8, 5), -2, -2),
        (ratio(4, 1), 4, 4),
    ];
    for (value, up, even) in table {
        assert_eq!(nearest_ties_up(&value), BigInt::from(up), "{value}");
        assert_eq!(nearest_ties_even(&value), BigInt::from(even), "{value}");
    }
}

#[test]
fn decimals_are_rounded_and_padded() {
    let table = [
        (ratio(1, 3), 3, "0.333"),
        (ratio(2, 3), 3, "0.667"),
        (ratio(-2, 3), 3, "-0.667"),
        (ratio(1, 200), 2, "0.01"),
        (ratio(-1, 1000), 2, "0.00"),
        (ratio(2001, 2), 1, "1000.5"),
        (ratio(999_999, 1_000_000), 3, "1.000"),
        (ratio(5, 2), 0, "3"),
    ];
    for (value, digits, expected) in table {
        assert_eq!(decimal(&value, digits), expected, "{value}");
    }
}

#[test]
fn floats_are_exact_or_nothing() {
    assert_eq!(from_f32(0.1), Some(ratio(13_421_773, 1 << 27)));
    assert_eq!(from_f32(-0.0), Some(integer(0)));
    let smallest = Rational::new(1.into(), BigInt::from(1) << 149);
    assert_eq!(from_f32(f32::from_bits(1)), Some(smallest));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(from_f32(bad), None);
        let mut triangle = [[0.0, 0.0, 0.0, 1.0]; 3];
        triangle[2][1] = bad;
        assert_eq!(clip(triangle, Planes::BOTH), Err(ClipError::NonFinite { corner: 2, component: 1 }));
    }
}

#[test]
fn the_viewport_maps_the_corners_of_clip_space() {
    let viewport = Viewport { x: 10, y: 20, width: 300, height: 201 };
    let at = |x, y, z, w| to_window(&[x, y, z, w].map(integer), viewport);
    let place = |x, y, z, w| at(x, y, z, w).map(|p| (p.position.x, p.position.y, p.z));
    assert_eq!(place(-1, 1, 0, 1), Some((integer(10), integer(20), integer(0))));
    assert_eq!(place(1, -1, 1, 1), Some((integer(310), integer(221), integer(1))));
    assert_eq!(place(0, 0, 1, 2), Some((integer(160), ratio(241, 2), ratio(1, 2))));
    assert_eq!(place(1, 1, 1, 4), Some((ratio(395, 2), ratio(763, 8), ratio(1, 4))));
    assert_eq!(at(0, 0, 0, 0), None);
    assert_eq!(at(0, 0, 0, -1), None);
}

#[test]
fn snapping_and_depth_integers() {
    assert_eq!(snap(&ratio(1, 512), 8), BigInt::from(0)); // half a step, to even
    assert_eq!(snap(&ratio(3, 512), 8), BigInt::from(2));
    assert_eq!(snap(&ratio(-1, 512), 8), BigInt::from(0));
    assert_eq!(snap(&ratio(-5, 2), 4), BigInt::from(-40));
    assert_eq!(snap(&from_steps(-77, 8), 8), BigInt::from(-77));
    assert_eq!(unorm(&integer(1), 32), BigInt::from(u32::MAX));
    assert_eq!(unorm(&integer(0), 32), BigInt::from(0));
    assert_eq!(unorm(&ratio(1, 2), 16), BigInt::from(32_768)); // 32767.5, up
    assert_eq!(unorm(&ratio(-1, 2), 1), BigInt::from(0)); // -0.5, up
}

#[test]
fn what_needs_no_clipping_comes_back_and_what_is_outside_vanishes() {
    let inside = [[1.0, 2.0, 0.0, 1.0], [3.0, -2.0, 1.0, 1.0], [0.5, 0.25, 0.5, 2.0]];
    let exact = inside.map(|vertex| vertex.map(|v| from_f32(v).unwrap())).to_vec();
    assert_eq!(clip(inside, Planes::BOTH), Ok(exact));
    let behind = inside.map(|[x, y, _, w]| [x, y, -0.5, w]);
    assert_eq!(clip(behind, Planes::NEAR), Ok(vec![]));
    let beyond = inside.map(|[x, y, _, w]| [x, y, w + 1.0, w]);
    assert_eq!(clip(beyond, Planes::BOTH), Ok(vec![]));
    assert_eq!(clip(beyond, Planes::NEAR).map(|polygon| polygon.len()), Ok(3));
}

#[test]
fn a_cut_is_at_the_exact_point() {
    // z runs from -1 to 2 along the first edge: the plane is a third of the way.
    let triangle = [[0.0, 0.0, -1.0, 1.0], [3.0, 0.0, 2.0, 4.0], [0.0, 3.0, 2.0, 4.0]];
    let expected = vec![
        [1, 0, 0, 2].map(integer),
        [3, 0, 2, 4].map(integer),
        [0, 3, 2, 4].map(integer),
        [0, 1, 0, 2].map(integer),
    ];
    assert_eq!(clip(triangle, Planes::BOTH), Ok(expected));
}

/// Twice the signed area of a polygon in the plane of x and y, whatever z and w are.
fn doubled_area(polygon: &[[Rational; 4]]) -> Rational {
    (0..polygon.len())
        .map(|i| {
            let (a, b) = (&polygon[i], &polygon[(i + 1) % polygon.len()]);
            &a[0] * &b[1] - &b[0] * &a[1]
        })
        .sum()
}

fn component() -> impl Strategy<Value = f32> {
    prop_oneof![
        -8.0_f32..8.0,
        (-3..=3_i8).prop_map(f32::from),
        prop::num::f32::NORMAL | prop::num::f32::SUBNORMAL
    ]
}

proptest! {
    #![proptest_config(cases(1_000))]

    #[test]
    fn clipping_keeps_exactly_the_inside(triangle in prop::array::uniform3(prop::array::uniform4(component()))) {
        let near = clip(triangle, Planes::NEAR).unwrap();
        let both = clip(triangle, Planes::BOTH).unwrap();
        let far = clip(triangle, Planes { near: false, far: true }).unwrap();
        let whole = clip(triangle, Planes { near: false, far: false }).unwrap();
        prop_assert!(near.len() <= 4 && far.len() <= 4 && both.len() <= 5);
        for [_, _, z, _] in near.iter().chain(&both) {
            prop_assert!(!z.is_negative());
        }
        for [_, _, z, w] in both.iter().chain(&far) {
            prop_assert!(z <= w);
        }
        for [_, _, _, w] in &both {
            prop_assert!(!w.is_negative());
        }
        // A cut and its complement have the whole area: nothing is lost and nothing is added. What lies in the plane
        // is in both.
        let in_plane = triangle.iter().all(|[_, _, z, _]| *z == 0.0);
        let twice = if in_plane { integer(2) } else { integer(1) };
        let behind = clip(triangle.map(|[x, y, z, w]| [x, y, -z, w]), Planes::NEAR).unwrap();
        prop_assert_eq!(doubled_area(&near) + doubled_area(&behind), doubled_area(&whole) * &twice);
        // The area left by both planes is what the far plane leaves without its part behind the near one.
        let far_and_behind: Vec<_> = cut_behind(&far);
        prop_assert_eq!(doubled_area(&both) + doubled_area(&far_and_behind), doubled_area(&far) * &twice);
    }

    #[test]
    fn what_lies_in_the_plane_is_on_both_sides(corners in prop::array::uniform3(prop::array::uniform2(-8.0_f32..8.0))) {
        let triangle = corners.map(|[x, y]| [x, y, 0.0, 1.0]);
        let whole = clip(triangle, Planes { near: false, far: false }).unwrap();
        prop_assert_eq!(clip(triangle, Planes::NEAR).unwrap(), whole.clone());
        prop_assert_eq!(clip(triangle.map(|[x, y, _, w]| [x, y, -0.0, w]), Planes::NEAR).unwrap(), whole);
    }

    #[test]
    fn rounding_is_nearest(n in any::<i64>(), d in 1..1_000_000_i64) {
        let value = ratio(n, d);
        for rounded in [nearest_ties_up(&value), nearest_ties_even(&value)] {
            prop_assert!((Rational::from_integer(rounded) - &value).abs() <= ratio(1, 2));
        }
    }
}

/// The part of a polygon with `z <= 0`, found by walking its outline.
fn cut_behind(polygon: &[[Rational; 4]]) -> Vec<[Rational; 4]> {
    let mut kept = Vec::new();
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        if !a[2].is_positive() {
            kept.push(a.clone());
        }
        if (a[2].is_positive() && b[2].is_negative()) || (a[2].is_negative() && b[2].is_positive()) {
            let (from_a, from_b) = (a[2].abs(), b[2].abs());
            kept.push([0, 1, 2, 3].map(|k| (&a[k] * &from_b + &b[k] * &from_a) / (&from_a + &from_b)));
        } else if a[2].is_positive() && b[2].is_zero() {
            kept.push(b.clone());
        } else if a[2].is_zero() && b[2].is_positive() {
            kept.push(a.clone());
        }
    }
    kept
}
