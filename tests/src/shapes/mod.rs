//! Shapes by kind, each a total function of plain numbers.
//!
//! Any engine can call them with whatever numbers it has: proptest's (which shrinks the numbers towards
//! 0, and with them the shape), a fuzzer's bytes, a loop's counter.

mod bezout;
mod clip;
mod depths;
mod mesh;
mod model;
mod numbers;
mod patch;
mod triangles;

pub use bezout::{Bezout, bezout};
pub use clip::{Ground, clip_bits, clip_triangle};
pub use depths::depths;
pub use mesh::{Mesh, fan, grid, triangulation};
pub use model::{LARGE_EXTENT, Model, Projection, at_the_limit, model};
pub use numbers::Random;
pub use patch::Patch;
pub use triangles::{Kind, triangle};

/// Corners (x, y) in sub-pixel steps, y down.
pub type Corners = [[i32; 2]; 3];

/// All six orders of a triangle's corners; the first three have one winding, the others the other.
pub const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// Twice the signed area of three corners in square steps, positive where they are clockwise on the
/// screen.
pub fn doubled_area(corners: &Corners) -> i64 {
    let [[ax, ay], [bx, by], [cx, cy]] = corners.map(|corner| corner.map(i64::from));
    (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
}
