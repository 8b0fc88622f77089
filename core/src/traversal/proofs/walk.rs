//! Proofs of the way over a triangle's bounds.

use super::tile::everywhere;
use crate::{
    geometry::{Region, Sample, Triangle, Vertex},
    lanes::ArrayLanes,
    numbers::Small,
    proof::{cover, prove},
    traversal::{traverse, walk::walk},
};

type Point = (i64, i64);

/// Whether a point is inside a triangle, from the definition alone: on the inner side of each edge, or on
/// a left or a top edge.
fn covers(mut triangle: [Point; 3], (px, py): Point) -> bool {
    let side =
        |(ax, ay): Point, (bx, by): Point, (px, py): Point| (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    let [a, b, c] = triangle;
    let area = side(a, b, c);
    if area < 0 {
        triangle = [a, c, b];
    }
    let [a, b, c] = triangle;
    let inside = |(ax, ay): Point, (bx, by): Point| {
        let value = side((ax, ay), (bx, by), (px, py));
        value > 0 || (value == 0 && (by < ay || (by == ay && bx > ax)))
    };
    area != 0 && inside(a, b) & inside(b, c) & inside(c, a)
}

/// A triangle's coverage of a pixel in a target of one block by two, against the definition.
pub(super) fn is_covered_per_sample(points: [[i32; 2]; 3], column: u32, row: u32) -> bool {
    let vertex = |[x, y]: [i32; 2]| Vertex::<Small>::new(x, y, 0);
    let [Ok(a), Ok(b), Ok(c)] = points.map(vertex) else { return false };
    let Ok(region) = Region::of_size(4, 8) else { return false };
    let mut covered = false;
    if let Some(triangle) = Triangle::new([a, b, c], Sample::CENTER) {
        traverse(&triangle, region, |x, y, mask| {
            if x == 0 && y == row & !3 {
                assert!(!covered);
                covered = mask.has(column, row & 3);
            }
        });
    }
    let sample = (16 * i64::from(column) + 8, 16 * i64::from(row) + 8);
    assert!(covered == covers(points.map(|[x, y]| (x.into(), y.into())), sample));
    covered
}

prove! {
    /// Whole triangles against the definition: a corner at 4 places.
    #[kani::unwind(18)]
    [traverse, traverse_with, walk]
    fn a_tiny_triangle_is_per_sample(corner: i32 = 0..=3, column: u32 = 0..=3, row: u32 = 0..=7) {
        let covered = is_covered_per_sample([[-4, 5], [70, 30], [22 * corner - 4, 116]], column, row);
        cover!(covered && row == 4);
    }

    /// Of a triangle that is everywhere, each pixel of the region is visited once, through tiles and
    /// squares, all others never; regions of one row of blocks, over the borders of tiles.
    #[kani::unwind(18)]
    [walk, tiles]
    fn slow_every_pixel_is_visited_once(
        x0: u32 = 27..=30,
        x1: u32 = 66..=69,
        pixel: u32 = 16..=79,
    ) {
        let Some(triangle) = everywhere() else { return };
        let Ok(region) = Region::new(x0, 4, x1, 7) else { return };
        let mut visits = 0;
        let any = walk::<ArrayLanes, Small>((), &triangle, region, region, |x, y, mask| {
            assert!(y == 4 && x % 4 == 0);
            visits += u32::from(x == pixel & !3 && mask.has(pixel & 3, 2) && !mask.has(pixel & 3, 3));
        });
        assert!(any && visits == u32::from(x0 <= pixel && pixel < x1));
        cover!(visits == 0 && pixel > x1);
    }
}
