//! Small rectangles, block by block: most triangles are small, and do not pay for the hierarchy.

use super::{
    mask::Mask,
    step::{Step, corner_steps},
};
use crate::{
    geometry::{Region, Triangle},
    lanes::Lanes,
    numbers::Format,
};

/// One edge on its way over the blocks.
#[derive(Clone, Copy)]
struct Edge<L> {
    /// Its value at a block's first pixel.
    value: i32,
    /// What it grows by from block to block, to the right and down.
    right: i32,
    down: i32,
    /// What its value at a block's trivial-reject corner is above that at the first pixel.
    highest: i32,
    /// The same for every pixel of a block.
    lanes: L,
}

impl<L: Lanes> Edge<L> {
    #[inline(always)]
    fn new(token: L::Token, Step { value, a, b }: Step) -> Self {
        let (_, highest) = corner_steps(a, b, 4, 4);
        Self { value, right: 4 * a, down: 4 * b, highest, lanes: L::ramp(token, 0, a, b) }
    }

    /// Its value at a block's trivial-reject corner, a pixel of the rectangle: it fits, as all do.
    #[inline(always)]
    const fn corner(self) -> i32 {
        self.value.wrapping_add(self.highest)
    }

    #[inline(always)]
    fn samples(self, token: L::Token) -> L {
        self.lanes.add(L::splat(token, self.value as u32))
    }

    /// The edge one block to the right. What is beyond the rectangle may have wrapped, and is not used.
    #[inline(always)]
    const fn to_the_right(self) -> Self {
        Self { value: self.value.wrapping_add(self.right), ..self }
    }

    /// The edge one block down.
    #[inline(always)]
    const fn below(self) -> Self {
        Self { value: self.value.wrapping_add(self.down), ..self }
    }
}

/// Visits the blocks of `bounds`, at most 64 x 64 pixels when rounded out to whole blocks, in which the
/// triangle covers a sample of `region`, row by row. Whether there was any.
#[inline(always)]
pub(super) fn scan<L: Lanes, F: Format>(
    token: L::Token,
    triangle: &Triangle<F>,
    region: Region<F>,
    bounds: Region<F>,
    mut visit: impl FnMut(u32, u32, Mask),
) -> bool {
    let blocks = bounds.blocks();
    // No sample beside the bounds is covered, so blocks of the region need no mask of it.
    let whole = region.contains(blocks);
    let [e0, e1, e2] = triangle.edges();
    let sample = triangle.sample();
    let (origin, size) = ([blocks.x0(), blocks.y0()], [blocks.width() as i32, blocks.height() as i32]);
    let (Some(e0), Some(e1), Some(e2)) = (
        Step::over(e0, sample, origin, size),
        Step::over(e1, sample, origin, size),
        Step::over(e2, sample, origin, size),
    ) else {
        return false;
    };
    let (mut row0, mut row1, mut row2) =
        (Edge::<L>::new(token, e0), Edge::<L>::new(token, e1), Edge::<L>::new(token, e2));
    let mut any = false;
    let mut y = blocks.y0();
    while y < blocks.y1() {
        let (mut e0, mut e1, mut e2) = (row0, row1, row2);
        let mut x = blocks.x0();
        while x < blocks.x1() {
            if e0.corner() | e1.corner() | e2.corner() >= 0 {
                let outside = e0.samples(token).or(e1.samples(token)).or(e2.samples(token)).signs();
                let mut mask = Mask(!outside);
                if !whole {
                    mask = mask.and(Mask::of_block(bounds, x, y));
                }
                if !mask.is_empty() {
                    any = true;
                    visit(x, y, mask);
                }
            }
            (e0, e1, e2) = (e0.to_the_right(), e1.to_the_right(), e2.to_the_right());
            x += 4;
        }
        (row0, row1, row2) = (row0.below(), row1.below(), row2.below());
        y += 4;
    }
    any
}
