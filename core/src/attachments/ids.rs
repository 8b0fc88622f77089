//! The visibility buffer: which triangle is seen.

use super::{
    Attachment, Block, OutsideAttachment,
    storage::{StorageError, Tiled},
};
use crate::{
    geometry::Region,
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
    traversal::Mask,
};

/// The id of a pixel that no triangle covers; no draw hands it out.
pub const NO_ID: u32 = u32::MAX;

/// One triangle id per pixel: of the last triangle drawn there, or after a depth attachment of the
/// one that won.
#[derive(Debug)]
pub struct Ids<'a, F> {
    texels: Tiled<'a, F, [u32; 16]>,
}

impl<'a, F: Format> Ids<'a, F> {
    /// Ids of `region` in a slice of at least [`texels`](super::texels)`(width, height)`. Its
    /// contents are kept: [`clear`](Self::clear) it first.
    ///
    /// # Errors
    ///
    /// [`StorageError`].
    pub fn new(region: Region<F>, texels: &'a mut [u32]) -> Result<Self, StorageError> {
        Ok(Self { texels: Tiled::of_texels(region, texels)? })
    }

    /// Sets every id to [`NO_ID`].
    pub fn clear(&mut self) {
        self.texels.fill(NO_ID);
    }

    /// The storage.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) const fn tiled(&self) -> &Tiled<'a, F, [u32; 16]> {
        &self.texels
    }

    /// The storage, to be written.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) const fn tiled_mut(&mut self) -> &mut Tiled<'a, F, [u32; 16]> {
        &mut self.texels
    }

    /// The id at pixel (`x`, `y`); `None` outside the region.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<u32> {
        self.texels.get(x, y)
    }

    /// [`Tiled::to_linear`].
    ///
    /// # Errors
    ///
    /// [`StorageError::BufferTooSmall`].
    pub fn to_linear(&self, rows: &mut [u32]) -> Result<(), StorageError> {
        self.texels.to_linear(rows)
    }
}

impl<F: Format> Attachment<F> for Ids<'_, F> {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.block_with::<ArrayLanes>((), block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        let Some(texels) = self.texels.block_mut(block.x, block.y) else { return Mask::EMPTY };
        let stored = L::load(token, texels);
        L::splat(token, block.id).select(stored, L::mask(token, block.mask.0)).store(texels);
        block.mask
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        self.texels.check(area)
    }
}
