//! Edges of sixteen triangles.

use super::{
    super::{
        extent::SMALL_EXTENT,
        fetch::Corner,
        ops::splat,
        setup::{Edge, place_edges},
    },
    Floats, LANES, Vectors, floats, ints, simd,
};
use crate::{
    geometry::{self, Sample, Vertex},
    numbers::Standard,
    proof::{cover, prove},
};
use fearless_simd::prelude::*;

#[inline(always)]
fn corner([x, y]: [i32; 2]) -> Corner<Vectors> {
    Corner { x: splat(simd(), x), y: splat(simd(), y) }
}

#[inline(always)]
fn edge(value: i32, a: i32, b: i32) -> Edge<Vectors> {
    Edge { value: splat(simd(), value), a: splat(simd(), a), b: splat(simd(), b) }
}

prove! {
    /// A, B and the reduced value are those of the scalar edge, in 32 bits: corners within the small
    /// extent of each other, the sample within 128 pixels of both.
    [Edge::new, geometry::Edge::new, geometry::Edge::reduced]
    fn edges_are_those_of_one_triangle(
        column: u32 = 0..=16383,
        row: u32 = 0..=16383,
        from: [i32; 2] = [-(128 << 8); 2]..=[128 << 8; 2],
        along: [i32; 2] = [-SMALL_EXTENT; 2]..=[SMALL_EXTENT; 2],
        sample: [i32; 2] = [0; 2]..=[255; 2],
    ) {
        let Some(sample) = Sample::<Standard>::new(sample[0], sample[1]) else { return };
        let (x, y) = sample.of_pixel(column, row);
        let start = [x + from[0], y + from[1]];
        let end = [start[0] + along[0], start[1] + along[1]];
        let found = Edge::new(simd(), corner(start), corner(end), splat(simd(), x), splat(simd(), y));
        let [Ok(start), Ok(end)] = [start, end].map(|[x, y]| Vertex::new(x, y, 9)) else { return };
        let expected = geometry::Edge::new(start, end);
        assert!(ints(found.a)[2] == expected.a() && ints(found.b)[2] == expected.b());
        assert!(i64::from(ints(found.value)[2]) == expected.reduced(sample, column, row));
        assert!(ints(found.value)[2].unsigned_abs() <= 1 << 23);
        cover!(ints(found.value)[2] == -1);
    }

    /// The crossing's numbers are exact: F and B, which have at most 24 and 16 bits.
    [Edge::crossing]
    fn crossings_are_exact(value: i32 = -(1 << 23)..=(1 << 23) - 1, b: i32 = -SMALL_EXTENT..=SMALL_EXTENT) {
        let crossing = edge(value, 3, b).crossing(simd());
        assert!(f64::from(floats(crossing.value)[1]) == f64::from(value) + 0.5);
        assert!(f64::from(floats(crossing.step)[1]) == f64::from(b));
        cover!(value == -(1 << 23));
    }

    /// The factor has the sign that sorts left from right: negative for A > 0, positive for A < 0, -∞ for a
    /// level edge.
    [Edge::crossing]
    fn factors_have_the_sign_of_the_side(a: i32 = -SMALL_EXTENT..=SMALL_EXTENT) {
        let factor = floats(edge(0, a, 1).crossing(simd()).factor)[1];
        assert!((factor < 0.0) == (a >= 0) && (factor > 0.0) == (a < 0));
        assert!(factor.is_finite() == (a != 0));
        cover!(a == 0);
    }

    /// Of three edges around an area the first is a left one, the second a right one; all three are there.
    [place_edges, Edge::select, Edge::plus, Edge::minus, Edge::crossing]
    fn edges_are_placed(a0: i32 = -SMALL_EXTENT..=SMALL_EXTENT, a1: i32 = -SMALL_EXTENT..=SMALL_EXTENT) {
        let a2 = -a0 - a1;
        if a0 == 0 && a1 == 0 {
            return;
        }
        let zero = Floats::splat(simd(), 0.0);
        let placed = place_edges(simd(), [edge(1, a0, 10), edge(2, a1, 20), edge(4, a2, 40)], zero, zero);
        let [left, right, third] = placed.edges.map(|edge| {
            (floats(edge.value)[LANES[1]] - 0.5, floats(edge.step)[LANES[1]], floats(edge.factor)[LANES[1]])
        });
        assert!(left.2 < 0.0 && left.2.is_finite() && right.2 > 0.0);
        assert!(left.0 + right.0 + third.0 == 7.0 && left.0 != right.0 && left.0 != third.0 && right.0 != third.0);
        for edge in [left, right, third] {
            assert!((edge.0 == 1.0 || edge.0 == 2.0 || edge.0 == 4.0) && edge.1 == 10.0 * edge.0);
        }
        // The third's bound is where its crossing does not count: +∞ for a left edge.
        assert!(floats(placed.third)[LANES[1]] == if third.2 < 0.0 { f32::INFINITY } else { f32::NEG_INFINITY });
        cover!(third.2 > 0.0);
        cover!(third.2 == f32::NEG_INFINITY);
    }
}
