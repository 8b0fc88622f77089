//! The way over a triangle's bounds: small ones block by block, large ones by tiles of 64x64 pixels and
//! their squares of 16x16, those again block by block.

use super::{
    mask::Mask,
    scan::scan,
    step::{InBlock, Step},
    tile::{TILE, squares},
};
use crate::{
    geometry::{HalfPlanes, Region, Rule, Triangle},
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
    let half_planes = triangle.half_planes();
    if is_small(blocks) {
        let Some(steps) = Step::all(half_planes, blocks) else { return false };
        return scan::<L, F>(token, InBlock::all(token, half_planes.edges), steps, blocks, cut, visit);
    }
    let in_block = InBlock::<L>::all(token, half_planes.edges);
    let mut any = false;
    tiles::<L, F, _>(
        token,
        half_planes,
        bounds,
        #[inline(always)]
        |square, steps| any |= scan::<L, F>(token, in_block, steps, square, cut, &mut visit),
    );
    any
}

/// Whether bounds, as whole blocks, are gone through block by block at once.
#[inline(always)]
pub(super) const fn is_small<F: Format>(blocks: Region<F>) -> bool {
    blocks.width() <= SMALL && blocks.height() <= SMALL
}

/// Visits the squares that no edge rejects of all tiles that have a pixel of the bounds; [`squares`] says how.
#[inline(always)]
pub(super) fn tiles<L: Lanes, F: Format, R: Rule<F>>(
    token: L::Token,
    half_planes: HalfPlanes<F, R>,
    bounds: Region<F>,
    mut visit: impl FnMut(Region<F>, [Step; 3]),
) {
    let blocks = bounds.blocks();
    let mut y = bounds.y0() & !(TILE - 1);
    while y < bounds.y1() {
        let mut x = bounds.x0() & !(TILE - 1);
        while x < bounds.x1() {
            squares::<L, F, R>(token, half_planes, blocks, [x, y], &mut visit);
            x += TILE;
        }
        y += TILE;
    }
}
