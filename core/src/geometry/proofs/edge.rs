//! Edge functions, the fill rule.

use super::{LAST_SMALL, LAST_STANDARD, SMALL, STANDARD, sample, vertex};
use crate::{
    Format, Small, Standard,
    geometry::Edge,
    numbers::Bounds,
    proof::{assume, cover, prove},
};

/// The edge function by its definition, at a sample given in steps.
#[inline(always)]
fn edge_function([start, end]: [[i32; 2]; 2], x: i64, y: i64) -> i64 {
    let ([xa, ya], [xb, yb]) = (start.map(i64::from), end.map(i64::from));
    (ya - yb) * (x - xa) + (xb - xa) * (y - ya)
}

/// Left: the way up. Top: level, to the right. In a triangle that is clockwise on a screen with y down.
#[inline(always)]
fn is_top_left([[xa, ya], [xb, yb]]: [[i32; 2]; 2]) -> bool {
    yb < ya || (yb == ya && xb > xa)
}

#[inline(always)]
fn edge<F: Format>([start, end]: [[i32; 2]; 2]) -> Option<Edge<F>> {
    Some(Edge::new(vertex(start, 0)?, vertex(end, 0)?))
}

#[inline(always)]
fn coefficients<F: Format>(ends: [[i32; 2]; 2]) {
    let (Some(edge), Some(back)) = (edge::<F>(ends), edge::<F>([ends[1], ends[0]])) else { return };
    let limit = Bounds::<F>::MAX_DELTA;
    assert!(-limit <= edge.a() && edge.a() <= limit && -limit <= edge.b() && edge.b() <= limit);
    assert!(edge.a() == -back.a() && edge.b() == -back.b());
    assert!(edge.is_top_left() == is_top_left(ends));
    assert!(ends[0] == ends[1] || edge.is_top_left() != back.is_top_left());
    cover!(edge.a() == limit && edge.b() == -limit);
}

#[inline(always)]
fn values<F: Format>(ends: [[i32; 2]; 2], at: [i32; 2], [column, row]: [u32; 2]) {
    let (Some(edge), Some(sample)) = (edge::<F>(ends), sample::<F>(at)) else { return };
    let (x, y) = sample.of_pixel(column, row);
    let value: i64 = edge.value(sample, column, row).into();
    assert!(value == edge_function(ends, x.into(), y.into()));
    cover!(value == 0);
}

/// The sign of the reduced value is the fill rule, and pixels step by A and B.
#[inline(always)]
fn reduction<F: Format>(ends: [[i32; 2]; 2], at: [i32; 2], [column, row]: [u32; 2]) {
    let (Some(edge), Some(sample)) = (edge::<F>(ends), sample::<F>(at)) else { return };
    let value: i64 = edge.value(sample, column, row).into();
    let reduced: i64 = edge.reduced(sample, column, row).into();
    assert!((reduced >= 0) == (value > 0 || (value == 0 && edge.is_top_left())));
    cover!(value == 0 && reduced < 0);
    cover!(value == 0 && reduced >= 0);
}

#[inline(always)]
fn stepping<F: Format>(ends: [[i32; 2]; 2], at: [i32; 2], [column, row]: [u32; 2]) {
    let (Some(edge), Some(sample)) = (edge::<F>(ends), sample::<F>(at)) else { return };
    assume!(column + 1 < F::MAX_TARGET && row + 1 < F::MAX_TARGET);
    let reduced = |column, row| -> i64 { edge.reduced(sample, column, row).into() };
    assert!(reduced(column + 1, row) - reduced(column, row) == i64::from(edge.a()));
    assert!(reduced(column, row + 1) - reduced(column, row) == i64::from(edge.b()));
    cover!(edge.a() < 0 && edge.b() > 0);
}

/// Of an edge and its reverse, exactly one has any sample.
#[inline(always)]
fn ownership<F: Format>(ends: [[i32; 2]; 2], at: [i32; 2], [column, row]: [u32; 2]) {
    assume!(ends[0] != ends[1]);
    let (Some(edge), Some(back)) = (edge::<F>(ends), edge::<F>([ends[1], ends[0]])) else { return };
    let Some(sample) = sample::<F>(at) else { return };
    let here: i64 = edge.reduced(sample, column, row).into();
    let there: i64 = back.reduced(sample, column, row).into();
    assert!((here >= 0) != (there >= 0));
    cover!(
        edge_function(ends, sample.of_pixel(column, row).0.into(), sample.of_pixel(column, row).1.into())
            == 0
    );
}

prove! {
    /// A and B fit, turn round with the edge, and tell top and left edges; one of an edge and its reverse is.
    [Edge::new, Edge::is_top_left]
    fn coefficients_of_standard(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
    ) {
        coefficients::<Standard>(ends);
    }

    /// The same for the small format.
    [Edge::new, Edge::is_top_left]
    fn coefficients_of_small(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
    ) {
        coefficients::<Small>(ends);
    }

    /// The edge value is the edge function, at every sample of the largest target.
    [Edge::value, Sample::of_pixel, i64::product]
    fn values_of_standard(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        values::<Standard>(ends, at, pixel);
    }

    /// The same for the small format, in 32 bits.
    [Edge::value, Sample::of_pixel, i32::product]
    fn values_of_small(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        values::<Small>(ends, at, pixel);
    }

    /// The reduced edge test is the exact sign with the top-left rule.
    [Edge::reduced]
    fn reduction_of_standard_keeps_the_sign(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        reduction::<Standard>(ends, at, pixel);
    }

    /// The same for the small format.
    [Edge::reduced]
    fn reduction_of_small_keeps_the_sign(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        reduction::<Small>(ends, at, pixel);
    }

    /// A pixel to the right adds A to the reduced value, a pixel down adds B: without loss. So by
    /// induction the reduced test is exact at every pixel that is stepped to.
    [Edge::reduced]
    fn stepping_of_standard_is_exact(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        stepping::<Standard>(ends, at, pixel);
    }

    /// The same for the small format.
    [Edge::reduced]
    fn stepping_of_small_is_exact(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        stepping::<Small>(ends, at, pixel);
    }

    /// A sample belongs to exactly one side of an edge: so of two triangles on both sides of it, each sample
    /// of the edge belongs to exactly one.
    [Edge::reduced]
    fn one_side_of_an_edge_of_standard_owns_a_sample(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        ownership::<Standard>(ends, at, pixel);
    }

    /// The same for the small format.
    [Edge::reduced]
    fn one_side_of_an_edge_of_small_owns_a_sample(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        ownership::<Small>(ends, at, pixel);
    }
}
