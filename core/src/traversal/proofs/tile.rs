//! Proofs of a tile's squares.

use crate::{
    geometry::{Edge, Region, Sample, Triangle, Vertex},
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

/// A triangle over all pixels from (0, 0) to (256, 256).
pub(super) fn everywhere() -> Option<Triangle<Small>> {
    let end = Bounds::<Small>::GUARD_BAND;
    let vertex = |x, y| Vertex::new(x, y, 0).ok();
    Triangle::new([vertex(-end, -end)?, vertex(end, -end)?, vertex(0, end)?], Sample::CENTER)
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
    /// none; squares are within 16 x 16 pixels, and whole blocks. For one tile: others differ in where
    /// they are.
    #[kani::unwind(18)]
    [squares]
    fn squares_are_a_partition(
        ends: [u32; 4] = [0; 4]..=[32; 4],
        pixel: [u32; 2] = [0; 2]..=[127; 2],
    ) {
        let [x0, x1, y0, y1] = ends.map(|end| 4 * end);
        let (Some(triangle), Ok(blocks)) = (everywhere(), Region::new(x0, y0, x1, y1)) else { return };
        let [x, y] = pixel;
        let mut visits = 0;
        squares::<ArrayLanes, Small, _>((), triangle.half_planes(), blocks, [TILE, 0], |square, steps| {
            assert!(square == square.blocks() && square.width() <= SQUARE && square.height() <= SQUARE);
            assert!(steps == [Step::DROPPED; 3]);
            visits += u32::from(square.x0() <= x && x < square.x1() && square.y0() <= y && y < square.y1());
        });
        let inside = x0 <= x && x < x1 && y0 <= y && y < y1;
        let in_tile = x / TILE == 1 && y / TILE == 0;
        assert!(visits == u32::from(inside && in_tile));
        cover!(visits == 1 && x0 > 0 && y1 < 64);
    }

    /// Of triangles with a corner at 4 places: an edge has its own value at each square's first
    /// pixel, or is dropped and accepts the whole square; what is left out is rejected by an edge's
    /// trivial-reject corner. What puts the proved parts together is the same for all triangles.
    #[kani::unwind(18)]
    [squares, Step::all]
    fn squares_keep_every_edges_values(corner: i32 = 0..=3) {
        let vertex = |x: i32, y: i32| Vertex::<Small>::new(x, y, 0);
        let (Ok(a), Ok(b), Ok(c)) = (vertex(48, 32), vertex(800, 320), vertex(204 * corner + 85, 960)) else { return };
        let Some(triangle) = Triangle::new([a, b, c], Sample::CENTER) else { return };
        let Ok(blocks) = Region::new(4, 8, Small::MAX_TARGET, 64) else { return };
        let mut visited = [false; 16];
        squares::<ArrayLanes, Small, _>((), triangle.half_planes(), blocks, [0, 0], |square, steps| {
            let (x, y) = (square.x0(), square.y0());
            visited[(4 * (y / SQUARE) + x / SQUARE) as usize & 15] = true;
            for (step, edge) in steps.iter().zip(&triangle.edges()) {
                let value = edge.reduced(triangle.sample(), x, y);
                let (lowest, _) = corner_steps(edge.a(), edge.b(), square.width() as i32, square.height() as i32);
                let is_its_own = step.value == value && step.a == edge.a() && step.b == edge.b();
                assert!(is_its_own || (*step == Step::DROPPED && value + lowest >= 0));
            }
        });
        for (place, visited) in visited.iter().enumerate() {
            let (x, y) = (SQUARE * (place as u32 % 4), SQUARE * (place as u32 / 4));
            let side = SQUARE as i32;
            let rejects = |edge: &Edge<Small>| {
                edge.reduced(triangle.sample(), x, y) + corner_steps(edge.a(), edge.b(), side, side).1 < 0
            };
            assert!(*visited != triangle.edges().iter().any(rejects));
        }
        cover!(!visited[12] && visited[13]);
    }
}
