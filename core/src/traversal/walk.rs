//! The hierarchy: tiles of 64x64 pixels, squares of 16x16, blocks of 4x4.

use super::{mask::Mask, square::Square};
use crate::{
    geometry::{Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
};

const TILE: u32 = 64;
const BLOCK: u32 = 4;

/// Visits the 4x4 blocks of `region` in which the triangle covers a sample, each once, with the
/// target coordinates of its first pixel (multiples of 4) and the mask of its covered samples.
/// Whether there was any.
#[inline]
pub fn traverse<F: Format>(
    triangle: &Triangle<F>,
    region: Region<F>,
    visit: impl FnMut(u32, u32, Mask),
) -> bool {
    traverse_with::<ArrayLanes, F>(triangle, region, visit)
}

/// [`traverse`] with other lanes; the masks are the same, and so is their order.
#[inline]
pub fn traverse_with<L: Lanes, F: Format>(
    triangle: &Triangle<F>,
    region: Region<F>,
    mut visit: impl FnMut(u32, u32, Mask),
) -> bool {
    let Ok(bounds) = triangle.bounds(region) else { return false };
    let mut any = false;
    let mut block = |square: &Square| {
        let mask = square.samples::<L>().and(square.cells_in(bounds));
        if !mask.is_empty() {
            any = true;
            visit(square.x, square.y, mask);
        }
    };
    // The smallest aligned square around the bounds is where the hierarchy begins.
    let differing = (bounds.x0() ^ (bounds.x1() - 1)) | (bounds.y0() ^ (bounds.y1() - 1));
    if differing < BLOCK {
        let (x, y) = (bounds.x0() & !(BLOCK - 1), bounds.y0() & !(BLOCK - 1));
        if let Some(square) = Square::new(triangle, x, y, BLOCK) {
            block(&square);
        }
        return any;
    }
    let side = if differing < TILE / 4 { TILE / 4 } else { TILE };
    let mut y = bounds.y0() & !(side - 1);
    while y < bounds.y1() {
        let mut x = bounds.x0() & !(side - 1);
        while x < bounds.x1() {
            if let Some(square) = Square::new(triangle, x, y, side) {
                if side == TILE {
                    square.children::<L, F>(bounds, |child| {
                        child.children::<L, F>(bounds, |grandchild| block(&grandchild));
                    });
                } else {
                    square.children::<L, F>(bounds, |child| block(&child));
                }
            }
            x += side;
        }
        y += side;
    }
    any
}
