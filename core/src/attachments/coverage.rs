//! A bitmap of covered samples.

use super::{
    Attachment, Block, OutsideAttachment,
    storage::{StorageError, Tiled, at_least},
};
use crate::{geometry::Region, numbers::Format, traversal::Mask};

/// One bit per pixel: whether any triangle covered its sample. Sixteen bits for a 4x4 block, as in
/// [`Mask`].
#[derive(Debug)]
pub struct Coverage<'a, F> {
    masks: Tiled<'a, F, u16>,
}

impl<'a, F: Format> Coverage<'a, F> {
    /// A bitmap of `region` in a slice of at least [`blocks`](super::blocks)`(width, height)` masks.
    /// Its contents are kept: [`clear`](Self::clear) it first.
    ///
    /// # Errors
    ///
    /// [`StorageError`].
    pub fn new(region: Region<F>, masks: &'a mut [u16]) -> Result<Self, StorageError> {
        Ok(Self { masks: Tiled::new(region, masks)? })
    }

    /// Nothing is covered.
    pub fn clear(&mut self) {
        self.masks.blocks_mut().fill(0);
    }

    /// The storage.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) const fn tiled(&self) -> &Tiled<'a, F, u16> {
        &self.masks
    }

    /// The storage, to be written.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) const fn tiled_mut(&mut self) -> &mut Tiled<'a, F, u16> {
        &mut self.masks
    }

    /// Whether pixel (`x`, `y`) is covered; `None` outside the region.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<bool> {
        self.masks.block(x, y).map(|&mask| Mask(mask).has(x & 3, y & 3))
    }

    /// Writes the bitmap as rows of `width.div_ceil(8)` bytes, the leftmost pixel in bit 0, unused
    /// bits 0.
    ///
    /// # Errors
    ///
    /// [`StorageError::BufferTooSmall`] where `rows` has fewer bytes; nothing is written then.
    pub fn to_bits(&self, rows: &mut [u8]) -> Result<(), StorageError> {
        let region = self.masks.region();
        let pitch = region.width().div_ceil(8).max(1);
        let given = rows.len();
        let needed = pitch as usize * region.height() as usize;
        at_least(needed, given)?;
        for (y, row) in (region.y0()..region.y1()).zip(rows.chunks_exact_mut(pitch as usize)) {
            for (byte, x) in row.iter_mut().zip((region.x0()..).step_by(8)) {
                let nibble = |x: u32| {
                    let mask = self.masks.block(x, y).map_or(0, |mask| mask >> (4 * (y & 3)));
                    let width = region.x1().saturating_sub(x);
                    mask as u8 & if width < 4 { (1 << width) - 1 } else { 0xF }
                };
                *byte = nibble(x) | nibble(x + 4) << 4;
            }
        }
        Ok(())
    }
}

impl<F: Format> Attachment<F> for Coverage<'_, F> {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        match self.masks.block_mut(block.x, block.y) {
            Some(mask) => {
                *mask |= block.mask.0;
                block.mask
            }
            None => Mask::EMPTY,
        }
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        self.masks.check(area)
    }
}
