//! Properties that no prover finished: for tests alone.

use super::{conservative::is_touched_per_pixel, walk::is_covered_per_sample};
use crate::proof::{cover, prove};

prove! {
    /// A whole triangle against the definition: corners in and around a target of one block by two.
    []
    fn any_tiny_triangle_is_per_sample(
        xs: [i32; 3] = [-8; 3]..=[71; 3],
        ys: [i32; 3] = [-8; 3]..=[135; 3],
        column: u32 = 0..=3,
        row: u32 = 0..=7,
    ) {
        let covered = is_covered_per_sample([[xs[0], ys[0]], [xs[1], ys[1]], [xs[2], ys[2]]], column, row);
        cover!(covered && row == 3);
    }

    /// What a whole triangle touches and contains, against the definition, degenerate ones included.
    []
    fn any_tiny_footprint_is_per_pixel(
        xs: [i32; 3] = [-8; 3]..=[71; 3],
        ys: [i32; 3] = [-8; 3]..=[135; 3],
        column: u32 = 0..=3,
        row: u32 = 0..=7,
        half: bool,
    ) {
        let points = [[xs[0], ys[0]], [xs[1], ys[1]], [xs[2], ys[2]]];
        let [touched, inside] = is_touched_per_pixel(points, column, row, half);
        cover!(touched && !inside && row == 3);
    }
}
