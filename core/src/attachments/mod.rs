//! What a draw writes: coverage, depth, triangle ids, or a type of yours.
//!
//! Attachments combine as tuples; a later member sees only the samples that the earlier ones let
//! through, so `(depth, ids)` keeps the id of the nearest triangle. What is not in the tuple is not
//! in the program.

mod count;
mod coverage;
mod depth;
mod depth_format;
mod hierarchical;
mod ids;
#[cfg(any(kani, test))]
mod proofs;
mod storage;

pub use count::Count;
pub use coverage::Coverage;
pub use depth::{Compare, Depth, DepthTest};
pub use depth_format::{D16, D32, DepthFormat};
pub use hierarchical::{DepthRange, HierarchicalDepth, depth_ranges};
pub use ids::{Ids, NO_ID};
pub use storage::{StorageError, Tiled, blocks, texels};

use crate::{
    geometry::{Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
    traversal::Mask,
};
use core::{error::Error, fmt};

/// A 4x4 block of pixels in which a triangle covers something.
#[derive(Clone, Copy, Debug)]
pub struct Block<'t, F: Format> {
    /// First column, a multiple of 4, in target coordinates.
    pub x: u32,
    /// First row, a multiple of 4, in target coordinates.
    pub y: u32,
    /// The samples that are covered and that earlier attachments let through.
    pub mask: Mask,
    /// The triangle: exact barycentric weights come from [`Triangle::weights`].
    pub triangle: &'t Triangle<F>,
    /// The draw's first id plus the triangle's place in the index list.
    pub id: u32,
}

/// A receiver of covered blocks. Only [`block`](Self::block) is required.
///
/// ```
/// use halfplane::{Attachment, Block, Format, Mask};
///
/// /// How often each of 64 columns is covered.
/// struct Histogram([u32; 64]);
///
/// impl<F: Format> Attachment<F> for Histogram {
///     fn block(&mut self, block: &Block<'_, F>) -> Mask {
///         for (column, _row) in block.mask.cells() {
///             if let Some(count) = self.0.get_mut((block.x + column) as usize) {
///                 *count += 1;
///             }
///         }
///         block.mask
///     }
/// }
/// ```
pub trait Attachment<F: Format> {
    /// Takes one block; returns which of its samples later attachments are to see.
    fn block(&mut self, block: &Block<'_, F>) -> Mask;

    /// [`block`](Self::block) with other lanes; the same result. Default: calls it.
    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask
    where
        Self: Sized,
    {
        let _ = token;
        self.block(block)
    }

    /// Called before the blocks of each triangle, with what stays the same in all of them.
    #[inline]
    fn begin(&mut self, triangle: &Triangle<F>) {
        let _ = triangle;
    }

    /// Whether pixels of `area` can be written; a draw asks before it begins. Default: yes.
    ///
    /// # Errors
    ///
    /// [`OutsideAttachment`] where some cannot.
    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        let _ = area;
        Ok(())
    }
}

/// The pixels to be drawn are not all in an attachment's region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutsideAttachment {
    /// `[x0, y0, x1, y1]` of the area to be drawn: scissor and viewport.
    pub area: [u32; 4],
    /// `[x0, y0, x1, y1]` of the attachment.
    pub attachment: [u32; 4],
}

impl OutsideAttachment {
    /// `Ok` where `attachment` contains `area`.
    ///
    /// # Errors
    ///
    /// The error that tells both, otherwise.
    #[inline]
    pub fn unless_contained<F: Format>(area: Region<F>, attachment: Region<F>) -> Result<(), Self> {
        if attachment.contains(area) {
            return Ok(());
        }
        let corners = |r: Region<F>| [r.x0(), r.y0(), r.x1(), r.y1()];
        Err(Self { area: corners(area), attachment: corners(attachment) })
    }
}

impl fmt::Display for OutsideAttachment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([ax0, ay0, ax1, ay1], [bx0, by0, bx1, by1]) = (self.area, self.attachment);
        write!(
            f,
            "the drawn area ({ax0}, {ay0})..({ax1}, {ay1}) is not inside the attachment ({bx0}, {by0})..({bx1}, {by1})"
        )
    }
}

impl Error for OutsideAttachment {}

/// No attachment: the draw only counts triangles.
impl<F: Format> Attachment<F> for () {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        block.mask
    }
}

impl<F: Format, A: Attachment<F>> Attachment<F> for &mut A {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        (**self).block(block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        (**self).block_with::<L>(token, block)
    }

    #[inline]
    fn begin(&mut self, triangle: &Triangle<F>) {
        (**self).begin(triangle);
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        (**self).check(area)
    }
}

impl<F: Format, A: Attachment<F>, B: Attachment<F>> Attachment<F> for (A, B) {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.block_with::<ArrayLanes>((), block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        let mask = self.0.block_with::<L>(token, block).and(block.mask);
        if mask.is_empty() {
            return mask;
        }
        self.1.block_with::<L>(token, &Block { mask, ..*block }).and(mask)
    }

    #[inline]
    fn begin(&mut self, triangle: &Triangle<F>) {
        self.0.begin(triangle);
        self.1.begin(triangle);
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        self.0.check(area)?;
        self.1.check(area)
    }
}

/// A triple is a pair whose second member is a pair.
impl<F: Format, A: Attachment<F>, B: Attachment<F>, C: Attachment<F>> Attachment<F> for (A, B, C) {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        let (a, b, c) = self;
        (a, (b, c)).block(block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        let (a, b, c) = self;
        (a, (b, c)).block_with::<L>(token, block)
    }

    #[inline]
    fn begin(&mut self, triangle: &Triangle<F>) {
        let (a, b, c) = self;
        (a, (b, c)).begin(triangle);
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        let (a, b, c) = self;
        a.check(area)?;
        b.check(area)?;
        c.check(area)
    }
}
