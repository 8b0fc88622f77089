//! The same way with the rules for whole pixels: what a triangle touches, and what it contains.

use super::{
    mask::Mask,
    scan::{Edge, scan},
    step::{InBlock, Step},
    walk::{is_small, tiles},
};
use crate::{
    geometry::{Footprint, Region},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
};

/// Visits the 4x4 blocks of `region` in which the triangle touches a pixel, each once, with the target
/// coordinates of its first pixel (multiples of 4), the mask of the pixels that are touched, and the mask of those
/// that are inside: a subset of the former. Whether there was any.
///
/// Pixels outside the region are in neither mask. What is touched and what is inside: [`Footprint`].
///
/// ```
/// use halfplane::{Footprint, Region, Standard, Uncertainty, Vertex, traverse_conservative};
///
/// // 1/256 px: the corners (1, 1), (5, 1), (1, 5).
/// let (near, far) = (256, 5 * 256);
/// let corners = [Vertex::<Standard>::new(near, near, 2)?, Vertex::new(far, near, 2)?, Vertex::new(near, far, 2)?];
/// let triangle = Footprint::new(corners, Uncertainty::None);
/// let (mut touched, mut inside) = (0, 0);
/// traverse_conservative(&triangle, Region::of_size(8, 8)?, |_, _, some, all| {
///     touched += some.count();
///     inside += all.count();
/// });
/// // Rows 1 to 4 have 4, 3, 2 and 1 pixels of which more than a corner is in the triangle, and in each the
/// // hypotenuse ends at the corner of one pixel more; row 5 has the corner (1, 5).
/// assert_eq!(touched, 10 + 4 + 1);
/// // All but those on the hypotenuse.
/// assert_eq!(inside, 3 + 2 + 1);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[inline]
pub fn traverse_conservative<F: Format>(
    footprint: &Footprint<F>,
    region: Region<F>,
    visit: impl FnMut(u32, u32, Mask, Mask),
) -> bool {
    traverse_conservative_with::<ArrayLanes, F>((), footprint, region, visit)
}

/// [`traverse_conservative`] with other lanes; the masks are the same, and so is their order.
#[inline(always)]
pub fn traverse_conservative_with<L: Lanes, F: Format>(
    token: L::Token,
    footprint: &Footprint<F>,
    region: Region<F>,
    mut visit: impl FnMut(u32, u32, Mask, Mask),
) -> bool {
    let Some(bounds) = footprint.bounds(region) else { return false };
    let blocks = bounds.blocks();
    // Beside the bounds half-planes may still meet, at a sharp corner for instance: blocks are cut to the bounds.
    let cut = if bounds == blocks { None } else { Some(bounds) };
    let (touched, inside) = (footprint.touched(), footprint.inside());
    let in_block = InBlock::<L>::all(token, touched.edges);
    let mut any = false;
    let mut within = |rectangle: Region<F>, steps| {
        let inside = inside.and_then(|inside| Step::all(inside, rectangle));
        any |= scan::<L, F>(token, in_block, steps, rectangle, cut, |x, y, touched| {
            let inside = match inside {
                Some(steps) => block(token, in_block, steps, [x - rectangle.x0(), y - rectangle.y0()]),
                None => Mask::EMPTY,
            };
            visit(x, y, touched, inside.and(touched));
        });
    };
    if !is_small(blocks) {
        tiles::<L, F, _>(token, touched, bounds, within);
    } else if let Some(steps) = Step::all(touched, blocks) {
        within(blocks, steps);
    }
    any
}

/// The pixels that three edges accept in the block that begins so many columns and rows after a rectangle of
/// at most a tile; the block is in it, so all values fit, as [`Step::over`] says.
#[inline(always)]
pub(super) fn block<L: Lanes>(
    token: L::Token,
    [in0, in1, in2]: [InBlock<L>; 3],
    [step0, step1, step2]: [Step; 3],
    from: [u32; 2],
) -> Mask {
    let edge = |in_block, step: Step| Edge::new(in_block, step.after(from)).samples(token);
    Mask(!edge(in0, step0).or(edge(in1, step1)).or(edge(in2, step2)).signs())
}
