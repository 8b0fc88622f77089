//! Proofs of a tile's squares.

use crate::{
    geometry::{Region, Sample, Triangle, Vertex},
    lanes::ArrayLanes,
    numbers::{Bounds, Format, Small, Standard},
    proof::{assume, cover, prove},
    traversal::{
        step::{Step, corner_steps},
        tile::{SQUARE, TILE, classify, squares},
    },
};

/// Largest magnitude of an edge's deltas.
const DELTA: i32 = Bounds::<Standard>::MAX_DELTA;
/// Largest magnitude of an edge's value at a pixel of a tile that it crosses:
/// `an_edge_is_decided_by_its_corners`.
const VALUE: i32 = Bounds::<Standard>::MAX_TILE_VALUE as i32;

/// A triangle over the whole of the largest target, and a region of it.
fn everywhere() -> Option<Triangle<Small>> {
    let end = Bounds::<Small>::GUARD_BAND;
    let vertex = |x, y| Vertex::new(x, y, 0).ok();
    Triangle::new([vertex(-end, -end)?, vertex(end, -end)?, vertex(-end, end)?], Sample::CENTER)
}

prove! {
    /// An edge over a tile that it crosses: its value at a square's first pixel is exact, it rejects the
    /// square where that at the trivial-reject corner is negative, and accepts it where that at the other
    /// corner is not. (The corners are extremes: `corners_bound_the_columns`.)
    #[kani::unwind(17)]
    [classify]
    fn a_square_is_decided_by_its_corners(
        value: i32 = -VALUE..=VALUE,
        a: i32 = -DELTA..=DELTA,
        b: i32 = -DELTA..=DELTA,
        column: i32 = 0..=3,
        row: i32 = 0..=3,
    ) {
        let at = |x: i32, y: i32| i64::from(value) + i64::from(x) * i64::from(a) + i64::from(y) * i64::from(b);
        let last = TILE as i32 - 1;
        let fits = |x, y| at(x, y).abs() <= i64::from(VALUE);
        assume!(fits(last, 0) & fits(0, last) & fits(last, last));
        let mut values = [0; 16];
        let (rejected, accepted) = classify::<ArrayLanes>((), Step { value, a, b }, &mut values);
        let side = SQUARE as i32;
        let first = at(side * column, side * row);
        let (lowest, highest) = corner_steps(a, b, side, side);
        let lane = 4 * row as usize + column as usize;
        assert!(i64::from(values[lane & 15] as i32) == first);
        assert!((rejected >> lane & 1 != 0) == (first + i64::from(highest) < 0));
        assert!((accepted >> lane & 1 != 0) == (first + i64::from(lowest) >= 0));
        cover!(first < 0 && first + i64::from(highest) == 0);
    }

    /// A dropped edge accepts every square and rejects none.
    #[kani::unwind(17)]
    [classify]
    fn a_dropped_edge_accepts_every_square(lane: usize = 0..=15) {
        let mut values = [0; 16];
        assert!(classify::<ArrayLanes>((), Step::DROPPED, &mut values) == (0, 0xFFFF));
        assert!(values[lane] as i32 > 0);
    }

    /// Of a triangle that is everywhere, each pixel of `blocks` in the tile is in one square, all others in
    /// none; squares are within 16 x 16 pixels, and whole blocks.
    #[kani::unwind(18)]
    [squares]
    fn squares_are_a_partition(
        ends: [u32; 4] = [0; 4]..=[32; 4],
        tile: [u32; 2] = [0; 2]..=[1; 2],
        pixel: [u32; 2] = [0; 2]..=[127; 2],
    ) {
        let [x0, x1, y0, y1] = ends.map(|end| 4 * end);
        let (Some(triangle), Ok(blocks)) = (everywhere(), Region::new(x0, y0, x1, y1)) else { return };
        let [x, y] = pixel;
        let mut visits = 0;
        squares::<ArrayLanes, Small>((), &triangle, blocks, tile.map(|at| TILE * at), |square, steps| {
            assert!(square == square.blocks() && square.width() <= SQUARE && square.height() <= SQUARE);
            assert!(steps == [Step::DROPPED; 3]);
            visits += u32::from(square.x0() <= x && x < square.x1() && square.y0() <= y && y < square.y1());
        });
        let inside = x0 <= x && x < x1 && y0 <= y && y < y1;
        let in_tile = x / TILE == tile[0] && y / TILE == tile[1];
        assert!(visits == u32::from(inside && in_tile));
        cover!(visits == 1 && x0 > 0 && y1 < 64);
    }

    /// Of triangles with one free corner: a pixel of the tile is in no square only where an edge rejects
    /// it; in its square each edge has its own value there, or is dropped and accepts it. Narrow, for what
    /// puts the proved parts together: all corners within the tile's 64 pixels, at whole ones.
    #[kani::unwind(18)]
    [squares, Step::all]
    fn squares_keep_every_edges_values(
        corner: [i32; 2] = [0; 2]..=[63; 2],
        pixel: [u32; 2] = [0; 2]..=[63; 2],
        first: u32 = 0..=3,
    ) {
        let pixels = Bounds::<Small>::STEPS_PER_PIXEL;
        let vertex = |x: i32, y: i32| Vertex::<Small>::new(x * pixels, y * pixels, 0);
        let [cx, cy] = corner;
        let (Ok(a), Ok(b), Ok(c)) = (vertex(3, 2), vertex(50, 20), vertex(cx, cy)) else { return };
        let Some(triangle) = Triangle::new([a, b, c], Sample::CENTER) else { return };
        let Ok(blocks) = Region::new(4 * first, 0, Small::MAX_TARGET, Small::MAX_TARGET) else { return };
        let [x, y] = pixel;
        let values = triangle.edges().map(|edge| edge.reduced(triangle.sample(), x, y));
        let mut visits = 0;
        squares::<ArrayLanes, Small>((), &triangle, blocks, [0, 0], |square, steps| {
            if square.x0() <= x && x < square.x1() && square.y0() <= y && y < square.y1() {
                visits += 1;
                let (column, row) = ((x - square.x0()) as i32, (y - square.y0()) as i32);
                for (step, exact) in steps.iter().zip(&values) {
                    let value = step.value + column * step.a + row * step.b;
                    assert!(value == *exact || (*step == Step::DROPPED && *exact >= 0));
                }
            }
        });
        assert!(visits == 1 || (visits == 0 && (x < 4 * first || values.iter().any(|value| *value < 0))));
        cover!(visits == 1 && first == 3);
        cover!(visits == 0 && x > 12);
    }
}
