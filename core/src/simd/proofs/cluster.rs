//! Triangles made neighbours.

use super::super::cluster::{center, halve};
use crate::proof::{cover, prove};

prove! {
    /// Three times the centre, a corner that names no vertex at 0, and 0 along an axis that is none: for any floats.
    [center]
    fn centers_are_sums(bits: [u32; 2], index: u32) {
        let [x, y] = bits.map(f32::from_bits);
        let positions = [[1.0, x, 2.0], [1.0, y, 4.0]];
        let same = |found: f32, expected: f32| found == expected || found.is_nan() && expected.is_nan();
        assert!(same(center(&positions, &[0_u32, 1, 0], 1), 0.0 + x + y + x));
        let missing = center(&positions, &[1, index, 1], 1);
        assert!(index < 2 || same(missing, 0.0 + y + 0.0 + y));
        assert!(center(&positions, &[0, index, 1], 3) == 0.0);
        cover!(index == u32::MAX && missing == 3.0);
    }

    /// Two triangles become two halves, the nearer one first, each still there: at any whole places.
    #[kani::unwind(5)]
    [halve, center, select, swap]
    fn halves_lie_apart(places: [i32; 2] = [-1000; 2]..=[1000; 2]) {
        let positions = places.map(|y| [0.0, y as f32, 0.0]);
        let mut triangles = [[0_u8; 3], [1; 3]];
        halve(&positions, &mut triangles, 1);
        let [[first, ..], [second, ..]] = triangles;
        assert!(first ^ second == 1 && places[usize::from(first & 1)] <= places[usize::from(second & 1)]);
        cover!(places[1] < places[0]);
    }

    /// Halves lie apart along the axis along which the triangles are the farthest apart: of two, the first such axis.
    #[kani::unwind(5)]
    [halve, center]
    fn the_longest_axis_is_halved(x: [i32; 2] = [-3; 2]..=[3; 2], z: [i32; 2] = [-3; 2]..=[3; 2]) {
        let places = [0, 1].map(|at| [x[at], 5, z[at]].map(|v| v as f32));
        let mut triangles = [[0_u8; 3], [1; 3]];
        halve(&places, &mut triangles, 1);
        let [first, second] = triangles.map(|[first, ..]| usize::from(first & 1));
        let along = if x[0].abs_diff(x[1]) >= z[0].abs_diff(z[1]) { x } else { z };
        assert!(first != second && along[first] <= along[second]);
        cover!(first == 1 && along[0] != x[0] && x[0] < x[1]);
    }
}
