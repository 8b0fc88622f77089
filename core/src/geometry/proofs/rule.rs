//! The rules of conservative coverage: what a whole pixel is to an edge.

use super::{LAST_SMALL, LAST_STANDARD, SMALL, STANDARD, vertex};
use crate::{
    Format, Small, Standard, Uncertainty,
    geometry::{
        Edge,
        rule::{Inside, Rule, Touched},
    },
    numbers::Bounds,
    proof::{assume, cover, prove},
};

#[inline(always)]
fn edge<F: Format>([start, end]: [[i32; 2]; 2]) -> Option<Edge<F>> {
    Some(Edge::new(vertex(start, 0)?, vertex(end, 0)?))
}

#[inline(always)]
pub(super) fn uncertainty(half: bool) -> Uncertainty {
    if half { Uncertainty::HalfStep } else { Uncertainty::None }
}

/// |A| + |B| half a step long, in half steps²: what a square of half a step adds to E, doubled.
#[inline(always)]
fn doubled_margin<F: Format>(edge: Edge<F>, half: bool) -> i64 {
    let steepness = i64::from(edge.a()).abs() + i64::from(edge.b()).abs();
    if half { steepness } else { 0 }
}

/// E at a corner of a pixel.
#[inline(always)]
fn at_corner<F: Format>(edge: Edge<F>, [column, row]: [u32; 2], [right, down]: [i32; 2]) -> i64 {
    let pixel = Bounds::<F>::STEPS_PER_PIXEL;
    edge.at(((column as i32 + right) * pixel, (row as i32 + down) * pixel)).into()
}

/// E at the point of a rule is the largest (or the smallest) at the four corners of the pixel, between which E is
/// linear; and the point is one of them.
#[inline(always)]
fn extremes<F: Format>(ends: [[i32; 2]; 2], pixel: [u32; 2], corner: [i32; 2], half: bool) {
    let Some(edge) = edge::<F>(ends) else { return };
    let other = at_corner(edge, pixel, corner);
    let (touched, inside) = (Touched(uncertainty(half)), Inside(uncertainty(half)));
    let largest: i64 = edge.at(touched.point(edge, pixel[0], pixel[1])).into();
    let smallest: i64 = edge.at(inside.point(edge, pixel[0], pixel[1])).into();
    assert!(smallest <= other && other <= largest);
    cover!(smallest == other && other < largest);
}

#[inline(always)]
fn points<F: Format>(ends: [[i32; 2]; 2], [column, row]: [u32; 2], half: bool) {
    let Some(edge) = edge::<F>(ends) else { return };
    let side = Bounds::<F>::STEPS_PER_PIXEL;
    let (left, top) = (column as i32 * side, row as i32 * side);
    let touched = Touched(uncertainty(half)).point(edge, column, row);
    let inside = Inside(uncertainty(half)).point(edge, column, row);
    for (x, y) in [touched, inside] {
        assert!((x == left || x == left + side) && (y == top || y == top + side));
        assert!(x <= Bounds::<F>::GUARD_BAND && y <= Bounds::<F>::GUARD_BAND);
    }
    // The corner that belongs to the pixel is the left one of the top ones.
    assert!((touched == (left, top)) == (edge.a() <= 0 && edge.b() <= 0));
    cover!(touched == (left, top) && inside == (left + side, top + side));
}

/// Touched: the largest E of the pixel and what the uncertainty adds are positive, or 0 where the pixel has the
/// corner. Both in halves.
#[inline(always)]
fn touches<F: Format>(ends: [[i32; 2]; 2], [column, row]: [u32; 2], half: bool) {
    let Some(edge) = edge::<F>(ends) else { return };
    let rule = Touched(uncertainty(half));
    let largest: i64 = edge.at(rule.point(edge, column, row)).into();
    let doubled = 2 * largest + doubled_margin(edge, half);
    let has_corner = edge.a() <= 0 && edge.b() <= 0;
    let reduced: i64 = edge.reduced(rule, column, row).into();
    assert!((reduced >= 0) == (doubled > 0 || (doubled == 0 && has_corner)));
    let bias = i128::from(rule.bias(edge));
    assert!(-Bounds::<F>::MAX_BIAS <= bias && bias <= Bounds::<F>::MAX_BIAS);
    cover!(doubled == 0 && has_corner);
    cover!(doubled == 0 && !has_corner);
    cover!(doubled == 1 && half);
}

/// Inside: the smallest E of the pixel is not less than what the uncertainty takes. Both in halves.
#[inline(always)]
fn contains<F: Format>(ends: [[i32; 2]; 2], [column, row]: [u32; 2], half: bool) {
    let Some(edge) = edge::<F>(ends) else { return };
    let rule = Inside(uncertainty(half));
    let smallest: i64 = edge.at(rule.point(edge, column, row)).into();
    let doubled = 2 * smallest - doubled_margin(edge, half);
    let reduced: i64 = edge.reduced(rule, column, row).into();
    assert!((reduced >= 0) == (doubled >= 0));
    let bias = i128::from(rule.bias(edge));
    assert!(-Bounds::<F>::MAX_BIAS <= bias && bias <= Bounds::<F>::MAX_BIAS);
    cover!(doubled == 0);
    cover!(doubled == -1);
}

#[inline(always)]
fn stepping<F: Format>(ends: [[i32; 2]; 2], [column, row]: [u32; 2], rule: impl Rule<F>) {
    let Some(edge) = edge::<F>(ends) else { return };
    assume!(column + 1 < F::MAX_TARGET && row + 1 < F::MAX_TARGET);
    let reduced = |column, row| -> i64 { edge.reduced(rule, column, row).into() };
    assert!(reduced(column + 1, row) - reduced(column, row) == i64::from(edge.a()));
    assert!(reduced(column, row + 1) - reduced(column, row) == i64::from(edge.b()));
    cover!(edge.a() < 0 && edge.b() > 0);
}

prove! {
    /// Where the rules look is a corner of the pixel, in the guard band; the pixel itself has it where that is
    /// its first.
    #[kani::unwind(3)]
    [Touched::point, Inside::point, corner]
    fn corners_of_standard(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
        half: bool,
    ) {
        points::<Standard>(ends, pixel, half);
    }

    /// The same for the small format.
    #[kani::unwind(3)]
    [Touched::point, Inside::point, corner]
    fn corners_of_small(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
        half: bool,
    ) {
        points::<Small>(ends, pixel, half);
    }

    /// There E is largest for what is touched and smallest for what is inside, of all corners and so of all points
    /// of the closed pixel.
    [Touched::point, Inside::point, corner, Edge::at]
    fn corners_of_standard_are_extremes(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
        corner: [i32; 2] = [0; 2]..=[1; 2],
        half: bool,
    ) {
        extremes::<Standard>(ends, pixel, corner, half);
    }

    /// The same for the small format, in 32 bits.
    [Touched::point, Inside::point, corner, Edge::at]
    fn corners_of_small_are_extremes(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
        corner: [i32; 2] = [0; 2]..=[1; 2],
        half: bool,
    ) {
        extremes::<Small>(ends, pixel, corner, half);
    }

    /// The reduced test of what is touched is its definition, the border that a pixel has not and the uncertainty
    /// of half a step included.
    [Edge::reduced, Touched::bias, steepness]
    fn touching_of_standard_is_the_definition(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
        half: bool,
    ) {
        touches::<Standard>(ends, pixel, half);
    }

    /// The same for the small format: nothing overflows 32 bits.
    [Edge::reduced, Touched::bias, steepness]
    fn touching_of_small_is_the_definition(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
        half: bool,
    ) {
        touches::<Small>(ends, pixel, half);
    }

    /// So is the one of what is inside.
    [Edge::reduced, Inside::bias, steepness]
    fn containing_of_standard_is_the_definition(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
        half: bool,
    ) {
        contains::<Standard>(ends, pixel, half);
    }

    /// The same for the small format: nothing overflows 32 bits.
    [Edge::reduced, Inside::bias, steepness]
    fn containing_of_small_is_the_definition(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
        half: bool,
    ) {
        contains::<Small>(ends, pixel, half);
    }

    /// Both step by A and B: a pixel to the right, a pixel down.
    [Edge::reduced, Touched::bias, Inside::bias]
    fn conservative_stepping_of_standard_is_exact(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
        half: bool,
        inside: bool,
    ) {
        if inside {
            stepping::<Standard>(ends, pixel, Inside(uncertainty(half)));
        } else {
            stepping::<Standard>(ends, pixel, Touched(uncertainty(half)));
        }
    }

    /// The same for the small format.
    [Edge::reduced, Touched::bias, Inside::bias]
    fn conservative_stepping_of_small_is_exact(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
        half: bool,
        inside: bool,
    ) {
        if inside {
            stepping::<Small>(ends, pixel, Inside(uncertainty(half)));
        } else {
            stepping::<Small>(ends, pixel, Touched(uncertainty(half)));
        }
    }
}
