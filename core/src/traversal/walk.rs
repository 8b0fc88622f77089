//! The way over a triangle's bounds: small ones block by block, large ones by tiles of 64x64 pixels and
//! their squares of 16x16, those again block by block.

use super::{
    mask::Mask,
    scan::scan,
    step::{InBlock, Step},
    tile::{TILE, squares},
};
use crate::{
    geometry::{Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
};

/// Bounds of at most so many pixels in width and in height, rounded out to whole blocks, are small: most
/// triangles are, and do not pay for tiles. Not more than a tile, so that 32 bits are enough. The report leaves this out to
/// see what it saves.
const SMALL: u32 = if cfg!(halfplane_without_small) { 0 } else { 32 };

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
    // No sample beside the bounds is covered, so blocks that are all in the region need no cutting.
    let cut = if region.contains(blocks) { None } else { Some(bounds) };
    if blocks.width() <= SMALL && blocks.height() <= SMALL {
        let Some(steps) = Step::all(triangle, blocks) else { return false };
        return scan::<L, F>(token, InBlock::all(token, triangle), steps, blocks, cut, visit);
    }
    let in_block = InBlock::<L>::all(token, triangle);
    let mut any = false;
    let mut y = bounds.y0() & !(TILE - 1);
    while y < bounds.y1() {
        let mut x = bounds.x0() & !(TILE - 1);
        while x < bounds.x1() {
            squares::<L, F>(
                token,
                triangle,
                blocks,
                [x, y],
                #[inline(always)]
                |square, steps| any |= scan::<L, F>(token, in_block, steps, square, cut, &mut visit),
            );
            x += TILE;
        }
        y += TILE;
    }
    any
}
