//! A rectangle, block by block.

use super::{
    mask::Mask,
    step::{InBlock, Step},
};
use crate::{geometry::Region, lanes::Lanes, numbers::Format};

/// One edge on its way over the blocks.
#[derive(Clone, Copy)]
pub(super) struct Edge<L> {
    /// Its value at a block's first pixel.
    pub(super) value: i32,
    /// What it grows by from block to block, to the right and down.
    right: i32,
    down: i32,
    block: InBlock<L>,
}

impl<L: Lanes> Edge<L> {
    #[inline(always)]
    pub(super) const fn new(block: InBlock<L>, Step { value, a, b }: Step) -> Self {
        Self { value, right: 4 * a, down: 4 * b, block }
    }

    /// Its value at a block's trivial-reject corner, a pixel of the rectangle: it fits, as all do.
    #[inline(always)]
    pub(super) const fn corner(self) -> i32 {
        self.value.wrapping_add(self.block.highest)
    }

    #[inline(always)]
    pub(super) fn samples(self, token: L::Token) -> L {
        self.block.lanes.add(L::splat(token, self.value as u32))
    }

    /// The edge one block to the right. What is beyond the rectangle may have wrapped, and is not used.
    #[inline(always)]
    pub(super) const fn to_the_right(self) -> Self {
        Self { value: self.value.wrapping_add(self.right), ..self }
    }

    /// The edge one block down.
    #[inline(always)]
    pub(super) const fn below(self) -> Self {
        Self { value: self.value.wrapping_add(self.down), ..self }
    }
}

/// Visits the blocks of a rectangle of whole blocks in which all edges have a sample, row by row; `cut` is
/// the region that samples must lie in, where the rectangle is not all inside it. Whether there was any.
#[inline(always)]
pub(super) fn scan<L: Lanes, F: Format>(
    token: L::Token,
    [block0, block1, block2]: [InBlock<L>; 3],
    steps: [Step; 3],
    rectangle: Region<F>,
    cut: Option<Region<F>>,
    mut visit: impl FnMut(u32, u32, Mask),
) -> bool {
    let accepted = steps == [Step::DROPPED; 3];
    let [step0, step1, step2] = steps;
    let (mut row0, mut row1, mut row2) =
        (Edge::new(block0, step0), Edge::new(block1, step1), Edge::new(block2, step2));
    let mut any = false;
    let mut y = rectangle.y0();
    while y < rectangle.y1() {
        let (mut e0, mut e1, mut e2) = (row0, row1, row2);
        let mut x = rectangle.x0();
        while x < rectangle.x1() {
            if e0.corner() | e1.corner() | e2.corner() >= 0 {
                let mut mask = Mask::FULL;
                if !accepted {
                    let outside = e0.samples(token).or(e1.samples(token)).or(e2.samples(token)).signs();
                    mask = Mask(!outside);
                }
                if let Some(region) = cut {
                    mask = mask.and(Mask::of_block(region, x, y));
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
