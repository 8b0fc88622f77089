//! Exact depths, fractions and specified depths against rationals.

mod common;

use common::{Case, any_case, cases, corners, integer, sample};
use halfplane_reference::{
    DepthSpec, ExactPlane, Fraction, Grid, Point, Rational, SpecifiedPlane, covers, depth_at,
    nearest_ties_up, specified_depth, z16_from_z32,
};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

/// Formats, weighted alike.
fn specs() -> impl Strategy<Value = DepthSpec> {
    prop_oneof![Just(DepthSpec::D32), Just(DepthSpec::D16), Just(DepthSpec::SMALL)]
}

/// Depths at three corners: anywhere, nearly equal, and at the ends of the range.
fn depths() -> impl Strategy<Value = [u32; 3]> {
    prop_oneof![
        any::<[u32; 3]>(),
        (any::<u32>(), prop::array::uniform3(0..5_u32))
            .prop_map(|(z, near)| near.map(|near| z.saturating_add(near))),
        prop::array::uniform3(prop_oneof![Just(0), Just(u32::MAX)]),
    ]
}

/// The definition once more, from the exact depth alone: a gradient is the rounded difference of the
/// depths one step apart. Shares no formula with the crate's.
fn from_exact_depths(case: &Case, z: [u32; 3], spec: DepthSpec, (x, y): (u32, u32)) -> Option<u32> {
    let word = spec.half_word().max(spec.bits());
    let triangle = corners(&case.xy);
    let scaled = z.map(|z| integer(z.into()) * integer(1 << (word - spec.bits())));
    let anchor = triangle.iter().min_by_key(|corner| (corner.y.clone(), corner.x.clone())).unwrap().clone();
    let h = integer(1 << spec.half_word());
    let at_anchor = depth_at(&triangle, &scaled, &anchor)?;
    let beside = |dx: i64, dy: i64| Point::new(&anchor.x + integer(dx), &anchor.y + integer(dy));
    let gradient = |to: Point| {
        let difference = depth_at(&triangle, &scaled, &to).unwrap() - &at_anchor;
        Rational::from_integer(nearest_ties_up(&(difference * &h)))
    };
    let (gx, gy) = (gradient(beside(1, 0)), gradient(beside(0, 1)));
    let first = sample(case.grid, (x - x % 4, y - y % 4));
    let here = sample(case.grid, (x, y));
    let base = at_anchor * &h + &gx * (&first.x - &anchor.x) + &gy * (&first.y - &anchor.y);
    let offset = gx * (here.x - first.x) + gy * (here.y - first.y);
    let unit = Rational::from_integer(BigInt::from(1) << (2 * spec.half_word() - spec.bits()));
    let sum = nearest_ties_up(&(base / &unit)) + nearest_ties_up(&(offset / &unit));
    sum.mod_floor(&(BigInt::from(1) << spec.bits())).to_u32()
}

#[test]
fn worked_by_hand() {
    // A plane that rises by 1 per step in x and 3 per step in y from 10 at (0, 0), S = 2.
    let grid = Grid::new(2, (2, 2)).unwrap();
    let (xy, z) = ([[0, 0], [40, 0], [0, 40]], [10, 50, 130]);
    for spec in [DepthSpec::D32, DepthSpec::D16, DepthSpec::SMALL] {
        let plane = SpecifiedPlane::new(&xy, &z, grid, spec).unwrap();
        for (x, y) in (0..64).map(|i| (i % 8, i / 8)) {
            let expected = 10 + (4 * x + 2) + 3 * (4 * y + 2);
            assert_eq!(plane.at(x, y), expected);
            assert_eq!(specified_depth(&xy, &z, grid, spec, (x, y)), Some(expected));
        }
    }
    // A third of a unit per step: g = floor(2^32 / 3 + 1/2). Sample (0, 0) at 2/3 of a unit rounds to 1;
    // sample (5, 0) is 6 from the base at 18 steps (6) and 4 steps (4/3 -> 1).
    let plane =
        SpecifiedPlane::new(&[[0, 0], [120, 0], [0, 120]], &[0, 40, 0], grid, DepthSpec::D32).unwrap();
    assert_eq!((plane.at(0, 0), plane.at(4, 0), plane.at(5, 0)), (1, 6, 7));
}

#[test]
fn z16_is_the_nearest_kept_in_range() {
    assert_eq!([0, 1, u32::MAX, u32::MAX - 1].map(z16_from_z32), [2, 2, 65_533, 65_533]);
    for z16 in 2..=65_533_u32 {
        // 65537 z16 is exactly z16; half of an odd 65537 on either side still belongs to it.
        let exact = z16 * 65_537;
        for z in [exact - 32_768, exact, exact + 32_768] {
            assert_eq!(u32::from(z16_from_z32(z)), z16, "{z}");
        }
    }
}

#[test]
fn formats() {
    for (bits, half_word) in [(32, 32), (16, 32), (16, 16)] {
        let spec = DepthSpec::new(bits, half_word).unwrap();
        assert_eq!((spec.bits(), spec.half_word()), (bits, half_word));
    }
    for (bits, half_word) in [(32, 16), (24, 32), (0, 0), (64, 64)] {
        assert!(DepthSpec::new(bits, half_word).is_err());
    }
    assert_eq!((DepthSpec::D32.farthest(), DepthSpec::D16.farthest()), (u32::MAX, 65_535));
    assert_eq!([0, 7, u32::MAX].map(|z| DepthSpec::D32.keep(z)), [2, 7, u32::MAX - 2]);
    assert_eq!([0, 7, u32::MAX].map(|z| DepthSpec::SMALL.keep(z)), [2, 7, 65_533]);
}

/// A 128-bit integer of any size.
fn any_size() -> impl Strategy<Value = i128> {
    (any::<i128>(), 0..127_u32).prop_map(|(value, shift)| value >> shift)
}

fn fraction() -> impl Strategy<Value = Fraction> {
    (any_size(), any_size()).prop_map(|(n, d)| Fraction::new(n, (d >> 1).abs() + 1).unwrap())
}

/// Two fractions that are often equal or as near as they can be.
fn near_fractions() -> impl Strategy<Value = (Fraction, Fraction)> {
    let scaled = (any_size(), any_size(), 1..1_000_i128, -1..=1_i128).prop_map(|(n, d, scale, more)| {
        let (n, d) = (n >> 12, (d >> 12).abs() + 1);
        (Fraction::new(n, d).unwrap(), Fraction::new(n * scale + more, d * scale).unwrap())
    });
    prop_oneof![scaled, (fraction(), fraction())]
}

proptest! {
    #![proptest_config(cases(4_000))]

    #[test]
    fn fractions_compare_like_rationals((a, b) in near_fractions()) {
        prop_assert_eq!(a.cmp(&b), a.to_rational().cmp(&b.to_rational()));
        prop_assert_eq!(a == b, a.to_rational() == b.to_rational());
        prop_assert_eq!(BigInt::from(a.floor()), a.to_rational().floor().to_integer());
    }

    #[test]
    fn distances_are_exact(a in fraction(), to in any::<u32>()) {
        let exact = (Rational::from_integer(to.into()) - a.to_rational()).abs();
        match a.distance_to(to.into()) {
            Some(distance) => prop_assert_eq!(distance.to_rational(), exact),
            None => prop_assert!(BigInt::from(a.denominator()) * to + BigInt::from(a.numerator()).abs() >= BigInt::from(i128::MAX)),
        }
    }

    #[test]
    fn floats_are_near(a in fraction()) {
        let exact = a.to_rational().to_f64().unwrap();
        prop_assert!((a.approximate() - exact).abs() <= exact.abs() * 1e-15 + 1e-15);
    }
}

proptest! {
    #![proptest_config(cases(600))]

    #[test]
    fn exact_planes_are_the_definition(case in any_case(), z in depths()) {
        let triangle = corners(&case.xy);
        let exact_z = z.map(|z| integer(z.into()));
        let plane = ExactPlane::new(&case.xy, &z, case.grid);
        for pixel in case.pixels().step_by(3) {
            let fast = plane.map(|plane| plane.at(pixel.0, pixel.1).to_rational());
            prop_assert_eq!(fast, depth_at(&triangle, &exact_z, &sample(case.grid, pixel)));
        }
    }

    #[test]
    fn specified_planes_are_the_definition_everywhere(case in any_case(), z in depths(), spec in specs()) {
        let z = z.map(|z| z & spec.farthest());
        let plane = SpecifiedPlane::new(&case.xy, &z, case.grid, spec);
        for (x, y) in case.pixels().step_by(3) {
            let defined = specified_depth(&case.xy, &z, case.grid, spec, (x, y));
            prop_assert_eq!(plane.as_ref().map(|plane| plane.at(x, y)), defined);
            prop_assert_eq!(from_exact_depths(&case, z, spec, (x, y)), defined);
        }
    }

    #[test]
    fn any_integers_are_specified_alike(
        xy in any::<[[i32; 2]; 3]>(), near in any::<bool>(), z in depths(), spec in specs(),
        pixels in any::<[(u32, u32); 4]>(),
    ) {
        // Half of them within a few steps: the steepest planes, whose bases leave 128 bits far away.
        let xy = if near { xy.map(|corner| corner.map(|v| v >> 29)) } else { xy };
        let grid = Grid::new(16, (3, 65_535)).unwrap();
        let plane = SpecifiedPlane::new(&xy, &z, grid, spec);
        let exact = ExactPlane::new(&xy, &z, grid);
        let exact_z = z.map(|z| integer(z.into()));
        for pixel in pixels {
            let (fast, defined) = (
                plane.as_ref().map(|plane| plane.at(pixel.0, pixel.1)),
                specified_depth(&xy, &z, grid, spec, pixel),
            );
            prop_assert_eq!(fast, defined);
            let fast = exact.map(|plane| plane.at(pixel.0, pixel.1).to_rational());
            prop_assert_eq!(fast, depth_at(&corners(&xy), &exact_z, &sample(grid, pixel)));
        }
    }

    #[test]
    fn the_order_of_corners_changes_no_bit(case in any_case(), z in depths(), spec in specs()) {
        let z = z.map(|z| z & spec.farthest());
        for (x, y) in case.pixels().step_by(11) {
            let depth = |order: [usize; 3]| {
                let plane = SpecifiedPlane::new(&order.map(|i| case.xy[i]), &order.map(|i| z[i]), case.grid, spec);
                plane.map(|plane| plane.at(x, y))
            };
            let first = depth([0, 1, 2]);
            for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                prop_assert_eq!(depth(order), first);
            }
        }
    }

    #[test]
    fn covered_samples_are_within_the_bound(case in any_case(), z in depths(), wide in any::<bool>()) {
        // The small format promises its bound for coordinates up to 2^14 steps.
        let spec = if wide { DepthSpec::D16 } else { DepthSpec::SMALL };
        let small = case.xy.iter().flatten().all(|v| v.abs() <= 1 << 14);
        for spec in [Some(DepthSpec::D32), (wide || small).then_some(spec)].into_iter().flatten() {
            let z = z.map(|z| spec.keep(z & spec.farthest()));
            let (Some(plane), Some(exact)) =
                (SpecifiedPlane::new(&case.xy, &z, case.grid, spec), ExactPlane::new(&case.xy, &z, case.grid))
            else {
                return Ok(());
            };
            let triangle = corners(&case.xy);
            let (n, d) = spec.bound();
            for (x, y) in case.pixels() {
                if covers(&triangle, &sample(case.grid, (x, y))) {
                    let error = exact.at(x, y).distance_to(plane.at(x, y).into()).unwrap();
                    prop_assert!(error <= Fraction::new(n, d).unwrap(), "{} at {:?}", error.approximate(), (x, y));
                }
            }
        }
    }
}
