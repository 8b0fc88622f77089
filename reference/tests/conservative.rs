//! Conservative coverage: the strips in integers against the definition in rationals, and what is known
//! without either.

mod common;

use std::{collections::BTreeSet, ops::Range};

use common::{Case, Steps, any_case, cases, corners, integer};
use halfplane_reference::{
    Grid, HalfOpen, Point, Rational, Rect, covered_area, from_steps, inside_rows, touch_rows,
};
use num_traits::{One, Zero};
use proptest::prelude::*;

type Pixels = BTreeSet<(u32, u32)>;

type Rows = fn(&Steps, u32, u32, Rect, &mut dyn FnMut(u32, Range<u32>));

/// What is touched and what is inside.
fn fast(case: &Case, half_steps: u32) -> [Pixels; 2] {
    let rules: [Rows; 2] = [
        |xy, bits, half_steps, rect, row| touch_rows(xy, bits, half_steps, rect, row),
        |xy, bits, half_steps, rect, row| inside_rows(xy, bits, half_steps, rect, row),
    ];
    rules.map(|rows| {
        let (mut found, mut last) = (Pixels::new(), None);
        rows(&case.xy, case.grid.subpixel_bits(), half_steps, case.rect, &mut |y, columns| {
            assert!(!columns.is_empty() && last < Some(y), "rows come once, top down");
            last = Some(y);
            found.extend(columns.map(|x| (x, y)));
        });
        found
    })
}

/// A pixel in steps, grown.
fn pixel(grid: Grid, (x, y): (u32, u32), half_steps: u32) -> HalfOpen {
    let at = |pixel: u32| i64::from(pixel) << grid.subpixel_bits();
    HalfOpen::pixels([at(x), at(y), at(x + 1), at(y + 1)]).grown(&(integer(half_steps.into()) / integer(2)))
}

fn by_definition(case: &Case, half_steps: u32) -> [Pixels; 2] {
    let triangle = corners(&case.xy);
    let of = |rule: fn(&HalfOpen, &[Point; 3]) -> bool| {
        case.pixels().filter(|&at| rule(&pixel(case.grid, at, half_steps), &triangle)).collect()
    };
    [of(HalfOpen::meets), of(HalfOpen::is_inside)]
}

#[test]
fn every_triangle_of_a_small_lattice() {
    // Steps of a quarter of a pixel, positions on corners, borders and beside them.
    let values = [3, 4, 8, 12, 13];
    let points: Vec<[i32; 2]> = values.iter().flat_map(|&y| values.map(|x| [x, y])).collect();
    let (grid, rect) = (Grid::new(2, (0, 0)).unwrap(), Rect { x0: 0, y0: 0, x1: 5, y1: 5 });
    let mut inside = 0;
    for (i, &a) in points.iter().enumerate() {
        for &b in &points[..=i] {
            for &c in &points[..=i] {
                let case = Case { xy: [a, b, c], grid, rect };
                for half_steps in 0..2 {
                    let expected = by_definition(&case, half_steps);
                    assert_eq!(fast(&case, half_steps), expected, "{case:?} {half_steps}");
                    assert!(!expected[0].is_empty() && expected[1].is_subset(&expected[0]));
                    inside += expected[1].len();
                }
            }
        }
    }
    assert!(inside > 20, "{inside}");
}

#[test]
fn a_point_is_in_one_pixel() {
    let grid = Grid::new(4, (0, 0)).unwrap();
    for (x, y) in [(32, 48), (31, 48), (32, 47), (31, 47), (33, 49)] {
        let case = Case { xy: [[x, y]; 3], grid, rect: Rect { x0: 0, y0: 0, x1: 9, y1: 9 } };
        assert_eq!(fast(&case, 0), [Pixels::from([(x as u32 / 16, y as u32 / 16)]), Pixels::new()]);
    }
}

proptest! {
    #![proptest_config(cases(250))]

    #[test]
    fn strips_are_the_definition(case in any_case(), half_steps in 0..=3_u32) {
        prop_assert_eq!(fast(&case, half_steps), by_definition(&case, half_steps));
    }

    #[test]
    fn strips_are_the_definition_for_any_integers(
        xy in any::<Steps>(), small in 0..31_u32, bits in 0..=16_u32, at in any::<(u16, u16)>(), half_steps in 0..=1_u32,
    ) {
        let (x0, y0) = (u32::from(at.0) >> small.min(15), u32::from(at.1) >> small.min(15));
        let rect = Rect { x0, y0, x1: x0 + 3, y1: y0 + 3 };
        let case = Case { xy: xy.map(|corner| corner.map(|v| v >> small)), grid: Grid::new(bits, (0, 0)).unwrap(), rect };
        prop_assert_eq!(fast(&case, half_steps), by_definition(&case, half_steps));
    }

    /// By areas, which know no borders: what has some is touched, what is inside has all, and the other way round
    /// but for what the outline alone touches.
    #[test]
    fn areas_agree(case in any_case()) {
        let [touched, inside] = by_definition(&case, 0);
        let bits = case.grid.subpixel_bits();
        let triangle = case.xy.map(|[x, y]| Point::new(from_steps(x.into(), bits), from_steps(y.into(), bits)));
        for (x, y) in case.pixels() {
            let area = covered_area(&triangle, (x.into(), y.into()));
            prop_assert_eq!(inside.contains(&(x, y)), area == Rational::one());
            prop_assert!(area.is_zero() || touched.contains(&(x, y)));
            // Grown by any amount, it has an area wherever it touches.
            if touched.contains(&(x, y)) && area.is_zero() {
                let a_bit = Rational::new(1.into(), 1_000_000_000_000_i64.into());
                let square = HalfOpen::pixels([x.into(), y.into(), i64::from(x) + 1, i64::from(y) + 1]);
                prop_assert!(square.grown(&a_bit).meets(&triangle) && !square.grown(&a_bit).is_inside(&triangle));
            }
        }
    }

    /// A point of the triangle, with any displacement in the square, is in a pixel that is touched.
    #[test]
    fn points_are_where_they_are_said_to_be(
        case in any_case(), weights in any::<[u16; 3]>(), displaced in any::<[i8; 2]>(),
    ) {
        let sum: i64 = weights.iter().map(|&w| i64::from(w)).sum::<i64>().max(1);
        let scale = |v: i64, by: i64| Rational::new(v.into(), by.into());
        let mut at = [0, 1].map(|axis| {
            (0..3).map(|k| scale(i64::from(case.xy[k][axis]) * i64::from(weights[k]), sum)).sum::<Rational>()
        });
        if weights == [0; 3] {
            at = case.xy[0].map(|v| integer(v.into()));
        }
        for (at, d) in at.iter_mut().zip(displaced) {
            *at += scale(i64::from(d.max(-127)), 254);
        }
        let steps = integer(1 << case.grid.subpixel_bits());
        let [x, y] = at.map(|v| (v / &steps).floor().to_integer());
        if let (Ok(x), Ok(y)) = (u32::try_from(&x), u32::try_from(&y)) {
            let rect = Rect { x0: x, y0: y, x1: x + 1, y1: y + 1 };
            let [touched, _] = fast(&Case { rect, ..case }, 1);
            prop_assert!(touched.contains(&(x, y)));
        }
    }
}
