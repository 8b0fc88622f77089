//! Proofs of conservative traversal: a block's pixels inside, and whole triangles.

use crate::{
    geometry::{Footprint, Region, Uncertainty, Vertex},
    lanes::{ArrayLanes, Lanes},
    numbers::{Bounds, Small, Standard},
    proof::{assume, cover, prove},
    traversal::{
        Mask,
        conservative::block,
        step::{InBlock, Step, corner_steps},
        traverse_conservative,
    },
};

/// Largest magnitude of an edge's deltas.
const DELTA: i32 = Bounds::<Standard>::MAX_DELTA;
/// Largest magnitude of an edge's value at a pixel of a rectangle that it crosses:
/// `an_edge_is_decided_by_its_corners` and the like.
const VALUE: i32 = Bounds::<Standard>::MAX_TILE_VALUE as i32;

/// An edge in every block, by the definition.
fn in_block(a: i32, b: i32) -> InBlock<ArrayLanes> {
    let mut lanes = [0; 16];
    for (lane, value) in lanes.iter_mut().enumerate() {
        let (column, row) = (lane as i32 & 3, lane as i32 >> 2);
        *value = (column * a + row * b) as u32;
    }
    InBlock { lanes: ArrayLanes::load((), &lanes), highest: corner_steps(a, b, 4, 4).1 }
}

type Point = (i64, i64);

/// Whether a pixel's half-open square has a point of a triangle grown by half a step or by nothing, and
/// whether its closed one lies in it shrunk by that: by separating axes in quarter steps, each written out from the
/// four corners of the square.
fn by_axes(triangle: [Point; 3], (column, row): (u32, u32), half: bool) -> [bool; 2] {
    let by = if half { 2 } else { 0 };
    let [a, b, c] = triangle.map(|(x, y)| (4 * x, 4 * y));
    let side =
        |(ax, ay): Point, (bx, by): Point, (px, py): Point| (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    let area = side(a, b, c);
    let [a, b, c] = if area < 0 { [a, c, b] } else { [a, b, c] };
    let (left, top) = (64 * i64::from(column), 64 * i64::from(row));
    let mut touched = true;
    let mut inside = area != 0;
    for (low, first) in [(a.0.min(b.0).min(c.0), left), (a.1.min(b.1).min(c.1), top)] {
        touched &= low - by < first + 64;
    }
    for (high, first) in [(a.0.max(b.0).max(c.0), left), (a.1.max(b.1).max(c.1), top)] {
        touched &= high + by >= first;
    }
    for (p, q) in [(a, b), (b, c), (c, a)] {
        let margin = by * ((q.1 - p.1).abs() + (q.0 - p.0).abs());
        let mut any = false;
        for (x, y) in [(left, top), (left + 64, top), (left, top + 64), (left + 64, top + 64)] {
            let value = side(p, q, (x, y));
            any |= value + margin > 0 || (value + margin == 0 && (x, y) == (left, top));
            inside &= value >= margin;
        }
        // Where it is 0 at most: at a corner or along a border, and those that the pixel has have its first corner.
        touched &= any;
    }
    [touched, inside]
}

/// What a triangle in and around a target of one block by two touches and contains, at a pixel, against the definition.
pub(super) fn is_touched_per_pixel(points: [[i32; 2]; 3], column: u32, row: u32, half: bool) -> [bool; 2] {
    let vertex = |[x, y]: [i32; 2]| Vertex::<Small>::new(x, y, 0);
    let [Ok(a), Ok(b), Ok(c)] = points.map(vertex) else { return [false; 2] };
    let Ok(region) = Region::of_size(4, 8) else { return [false; 2] };
    let uncertainty = if half { Uncertainty::HalfStep } else { Uncertainty::None };
    let mut found = [false; 2];
    traverse_conservative(&Footprint::new([a, b, c], uncertainty), region, |x, y, touched, inside| {
        if x == 0 && y == row & !3 {
            assert!(found == [false; 2]);
            found = [touched.has(column, row & 3), inside.has(column, row & 3)];
        }
    });
    let expected = by_axes(points.map(|[x, y]| (x.into(), y.into())), (column, row), half);
    assert!(found == expected);
    found
}

prove! {
    /// A block's pixels inside are those at which each of three edges is not negative, wherever in the rectangle the
    /// block is; here one edge beside two that accept it, and one lane.
    #[kani::unwind(17)]
    [block, Step::after]
    fn a_blocks_pixels_inside_are_exact(
        value: i32 = -VALUE..=VALUE,
        a: i32 = -DELTA..=DELTA,
        b: i32 = -DELTA..=DELTA,
        column: u32 = 0..=3,
        row: u32 = 0..=3,
    ) {
        let from = [4, 8];
        let at = |x: u32, y: u32| i64::from(value) + i64::from(x) * i64::from(a) + i64::from(y) * i64::from(b);
        let fits = |x, y| at(x, y).abs() <= i64::from(VALUE);
        assume!(fits(11, 0) & fits(0, 11) & fits(11, 11) & fits(4, 0) & fits(4, 8) & fits(7, 8) & fits(4, 11) & fits(7, 11));
        let blocks = [in_block(0, 0), in_block(a, b), in_block(0, 0)];
        let Mask(bits) = block((), blocks, [Step::DROPPED, Step { value, a, b }, Step::DROPPED], from);
        let lane = 4 * row + column;
        assert!((bits >> lane & 1 != 0) == (at(4 + column, 8 + row) >= 0));
        cover!(bits >> lane & 1 != 0 && value < 0);
    }

    /// Whole triangles against the definition: a corner at 4 places.
    #[kani::unwind(18)]
    [traverse_conservative, traverse_conservative_with, block]
    fn a_tiny_footprint_is_per_pixel(corner: i32 = 0..=3, column: u32 = 0..=3) {
        let [touched, inside] = is_touched_per_pixel([[-4, 5], [70, 30], [22 * corner - 4, 116]], column, 4, true);
        cover!(touched && !inside);
        cover!(inside);
    }
}
