//! The way over a triangle's bounds: small ones block by block, large ones by the hierarchy of tiles of
//! 64x64 pixels, squares of 16x16, blocks of 4x4.

use super::{mask::Mask, scan::scan, square::Square};
use crate::{
    geometry::{Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
};

const TILE: u32 = 64;

/// Bounds of at most so many pixels in width and in height, rounded out to whole blocks, are small.
const SMALL: u32 = 32;

/// Visits the 4x4 blocks of `region` in which the triangle covers a sample, each once, with the
/// target coordinates of its first pixel (multiples of 4) and the mask of its covered samples.
/// Whether there was any.
#[inline]
pub fn traverse<F: Format>(
    triangle: &Triangle<F>,
    region: Region<F>,
    visit: impl FnMut(u32, u32, Mask),
) -> bool {
    traverse_with::<ArrayLanes, F>((), triangle, region, visit)
}

/// [`traverse`] with other lanes; the masks are the same, and so is their order.
#[inline(always)]
pub fn traverse_with<L: Lanes, F: Format>(
    token: L::Token,
    triangle: &Triangle<F>,
    region: Region<F>,
    visit: impl FnMut(u32, u32, Mask),
) -> bool {
    match triangle.bounds(region) {
        Ok(bounds) => walk::<L, F>(token, triangle, region, bounds, visit),
        Err(_) => false,
    }
}

/// [`traverse_with`], given the triangle's [bounds](Triangle::bounds) in the region.
#[inline(always)]
pub(crate) fn walk<L: Lanes, F: Format>(
    token: L::Token,
    triangle: &Triangle<F>,
    region: Region<F>,
    bounds: Region<F>,
    mut visit: impl FnMut(u32, u32, Mask),
) -> bool {
    let blocks = bounds.blocks();
    if blocks.width() <= SMALL && blocks.height() <= SMALL {
        return scan::<L, F>(token, triangle, region, bounds, visit);
    }
    let mut any = false;
    let mut y = bounds.y0() & !(TILE - 1);
    while y < bounds.y1() {
        let mut x = bounds.x0() & !(TILE - 1);
        while x < bounds.x1() {
            if let Some(tile) = Square::new(triangle, x, y, TILE) {
                tile.children::<L, F>(
                    token,
                    bounds,
                    #[inline(always)]
                    |square| {
                        square.children::<L, F>(
                            token,
                            bounds,
                            #[inline(always)]
                            |block| {
                                let mask = block.samples::<L>(token).and(block.cells_in(bounds));
                                if !mask.is_empty() {
                                    any = true;
                                    visit(block.x, block.y, mask);
                                }
                            },
                        );
                    },
                );
            }
            x += TILE;
        }
        y += TILE;
    }
    any
}
