//! One triangle's set-up: area, winding, canonical order, weights.

use super::{LAST_SMALL, LAST_STANDARD, SMALL, STANDARD, sample, vertex};
use crate::{
    Format, Sample, Small, Standard, Triangle, Vertex, Winding,
    geometry::{Edge, doubled_area, winding},
    proof::{assume, cover, prove},
};

#[inline(always)]
fn corners<F: Format>([a, b, c]: [[i32; 2]; 3]) -> Option<[Vertex<F>; 3]> {
    Some([vertex(a, 0)?, vertex(b, 0)?, vertex(c, 0)?])
}

/// The doubled area by its definition.
#[inline(always)]
fn area([a, b, c]: [[i32; 2]; 3]) -> i64 {
    let ([xa, ya], [xb, yb], [xc, yc]) = (a.map(i64::from), b.map(i64::from), c.map(i64::from));
    (xb - xa) * (yc - ya) - (xc - xa) * (yb - ya)
}

#[inline(always)]
fn areas<F: Format>(given: [[i32; 2]; 3]) {
    let Some(vertices) = corners::<F>(given) else { return };
    let signed: i64 = doubled_area(vertices).into();
    assert!(signed == area(given));
    assert!(winding(vertices).is_some() == (signed != 0));
    assert!((winding(vertices) == Some(Winding::Clockwise)) == (signed > 0));
    cover!(signed == 0);
}

/// There is no triangle without an area.
#[inline(always)]
fn flat<F: Format>(given: [[i32; 2]; 3]) {
    let Some(vertices) = corners::<F>(given) else { return };
    assume!(doubled_area(vertices) == F::Wide::default());
    assert!(Triangle::new(vertices, Sample::CENTER).is_none());
    cover!(given[0] != given[1]);
}

/// A clockwise triangle has its area, a counter-clockwise one the negated one.
#[inline(always)]
fn set_up<F: Format>(given: [[i32; 2]; 3], clockwise: bool) {
    let Some(vertices) = corners::<F>(given) else { return };
    let signed: i64 = doubled_area(vertices).into();
    assume!(signed != 0 && (signed > 0) == clockwise);
    let Some(triangle) = Triangle::new(vertices, Sample::CENTER) else { unreachable!("there is an area") };
    let doubled: i64 = triangle.doubled_area().into();
    assert!(doubled == if clockwise { signed } else { -signed });
    assert!((triangle.winding() == Winding::Clockwise) == clockwise);
    cover!(signed == 1 || signed == -1);
}

/// The vertex of that number.
#[inline(always)]
fn pick<F: Format>([a, b, c]: [Vertex<F>; 3], number: u8) -> Vertex<F> {
    match number {
        0 => a,
        1 => b,
        _ => c,
    }
}

/// The canonical order: a permutation, the topmost, then leftmost vertex first.
#[inline(always)]
fn order<F: Format>(given: [[i32; 2]; 3]) {
    let Some(vertices) = corners::<F>(given) else { return };
    let Some(triangle) = Triangle::new(vertices, Sample::CENTER) else { return };
    let [i, j, k] = triangle.order();
    assert!(i < 3 && j < 3 && k < 3 && i != j && j != k && k != i);
    let [first, second, third] = triangle.vertices();
    assert!(first == pick(vertices, i) && second == pick(vertices, j) && third == pick(vertices, k));
    let key = |v: Vertex<F>| (v.y(), v.x());
    assert!(key(first) < key(second) && key(first) < key(third));
    assert!(
        triangle.edges() == [Edge::new(second, third), Edge::new(third, first), Edge::new(first, second)]
    );
    cover!(i == 1 && j == 0);
}

/// The three edge values of a sample add up to the area.
#[inline(always)]
fn weights<F: Format>(given: [[i32; 2]; 3], at: [i32; 2], [column, row]: [u32; 2]) {
    let (Some([a, b, c]), Some(sample)) = (corners::<F>(given), sample::<F>(at)) else { return };
    let value = |start, end| -> i64 { Edge::new(start, end).value(sample, column, row).into() };
    assert!(value(b, c) + value(c, a) + value(a, b) == area(given));
    cover!(value(b, c) < 0);
}

/// Which weight is whose.
#[inline(always)]
fn weight_order(given: [[i32; 2]; 3]) {
    let Some(vertices) = corners::<Small>(given) else { return };
    let Some(triangle) = Triangle::new(vertices, Sample::CENTER) else { return };
    let Some([first, second, third]) = triangle.weights(0, 0) else {
        unreachable!("the pixel is in the target")
    };
    let sign = if triangle.winding() == Winding::Clockwise { 1 } else { -1 };
    let value = |start: u8, end: u8| {
        let edge = Edge::new(pick(vertices, start), pick(vertices, end));
        sign * edge.value(Sample::CENTER, 0, 0)
    };
    assert!(first == value(1, 2) && second == value(2, 0) && third == value(0, 1));
    cover!(first < 0 && second > 0);
}

prove! {
    /// The doubled area fits, and its sign is the winding.
    [doubled_area, winding, i64::product]
    fn areas_of_standard(given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3]) {
        areas::<Standard>(given);
    }

    /// The same for the small format: in 32 bits, at the guard band's very corners.
    [doubled_area, winding, i32::product]
    fn areas_of_small(given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3]) {
        areas::<Small>(given);
    }

    /// Flat triangles.
    [Triangle::new]
    fn flat_triangles_of_standard(given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3]) {
        flat::<Standard>(given);
    }

    /// The same for the small format.
    [Triangle::new]
    fn flat_triangles_of_small(given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3]) {
        flat::<Small>(given);
    }

    /// The area of a triangle.
    [Triangle::new]
    fn set_up_of_clockwise_standard(given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3]) {
        set_up::<Standard>(given, true);
    }

    /// The same, counter-clockwise.
    [Triangle::new]
    fn set_up_of_counter_clockwise_standard(given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3]) {
        set_up::<Standard>(given, false);
    }

    /// The same for the small format, in 32 bits.
    [Triangle::new]
    fn set_up_of_clockwise_small(given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3]) {
        set_up::<Small>(given, true);
    }

    /// The same, counter-clockwise.
    [Triangle::new]
    fn set_up_of_counter_clockwise_small(given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3]) {
        set_up::<Small>(given, false);
    }

    /// The canonical order of vertices does not depend on the order they came in, as there is one topmost,
    /// then leftmost vertex. Comparisons alone decide; three points of a 4x4 lattice are in every order there is.
    [Triangle::new]
    fn order_is_canonical(given: [[i32; 2]; 3] = [[0; 2]; 3]..=[[3; 2]; 3]) {
        order::<Small>(given);
    }

    /// Barycentric weights.
    [Triangle::weights, Edge::value]
    fn weights_of_standard_add_up(
        given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        weights::<Standard>(given, at, pixel);
    }

    /// The same for the small format.
    [Triangle::weights, Edge::value]
    fn weights_of_small_add_up(
        given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        weights::<Small>(given, at, pixel);
    }

    /// Weights are in submitted order: again by comparisons alone.
    #[kani::unwind(4)]
    [Triangle::weights]
    fn slow_weights_are_in_submitted_order(given: [[i32; 2]; 3] = [[0; 2]; 3]..=[[3; 2]; 3]) {
        weight_order(given);
    }

    /// There are none beyond the largest target.
    [Triangle::weights]
    fn weights_are_of_pixels_of_the_target(pixel: [u32; 2]) {
        let Some(vertices) = corners::<Standard>([[0, 0], [1, 0], [0, 1]]) else { return };
        let Some(triangle) = Triangle::new(vertices, Sample::CENTER) else { return };
        let inside = pixel[0] < Standard::MAX_TARGET && pixel[1] < Standard::MAX_TARGET;
        assert!(triangle.weights(pixel[0], pixel[1]).is_some() == inside);
        cover!(pixel[0] == Standard::MAX_TARGET);
    }
}
