//! A rectangle of which every pixel is covered.

use super::mask::Mask;
use crate::{geometry::Region, numbers::Format};

/// Visits the blocks that a region touches, row by row, with the mask of its pixels.
#[inline(always)]
pub(crate) fn fill<F: Format>(region: Region<F>, mut visit: impl FnMut(u32, u32, Mask)) {
    let blocks = region.blocks();
    let cut = blocks != region;
    let mut y = blocks.y0();
    while y < blocks.y1() {
        let mut x = blocks.x0();
        while x < blocks.x1() {
            visit(x, y, if cut { Mask::of_block(region, x, y) } else { Mask::FULL });
            x += 4;
        }
        y += 4;
    }
}
