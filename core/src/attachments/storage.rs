//! 4x4-tiled storage in a caller's slice.

use super::OutsideAttachment;
use crate::{geometry::Region, numbers::Format};
use core::{error::Error, fmt};

/// How many 4x4 blocks a region of that size in pixels has, partial ones included, if its corner is
/// at a multiple of 4. For array lengths; saturates.
#[must_use]
pub const fn blocks(width: u32, height: u32) -> usize {
    (width.div_ceil(4) as usize).saturating_mul(height.div_ceil(4) as usize)
}

/// How many texels the storage of such a region has: sixteen for each of its [`blocks`].
#[must_use]
pub const fn texels(width: u32, height: u32) -> usize {
    blocks(width, height).saturating_mul(16)
}

/// A slice that does not fit its region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StorageError {
    /// The slice is shorter than the region needs.
    BufferTooSmall {
        /// Elements needed.
        needed: usize,
        /// Elements given.
        given: usize,
    },
    /// The region does not begin at multiples of 4.
    RegionNotAligned {
        /// First column as given.
        x0: u32,
        /// First row as given.
        y0: u32,
    },
}

impl fmt::Display for StorageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BufferTooSmall { needed, given } => {
                write!(f, "the buffer has {given} elements, the region needs {needed}")
            }
            Self::RegionNotAligned { x0, y0 } => {
                write!(f, "an attachment's region begins at ({x0}, {y0}): both must be multiples of 4")
            }
        }
    }
}

impl Error for StorageError {}

pub(super) fn at_least(needed: usize, given: usize) -> Result<(), StorageError> {
    if given < needed {
        return Err(StorageError::BufferTooSmall { needed, given });
    }
    Ok(())
}

/// A region's blocks in a slice, row by row; `T` is what one block holds.
///
/// A region that begins elsewhere than at (0, 0) is a band or a dirty rectangle of a larger target:
/// its blocks keep the target's coordinates.
#[derive(Debug)]
pub struct Tiled<'a, F, T> {
    region: Region<F>,
    /// Blocks in a row.
    pitch: u32,
    blocks: &'a mut [T],
}

impl<'a, F: Format, T> Tiled<'a, F, T> {
    /// The region's blocks in the first elements of `blocks`.
    ///
    /// # Errors
    ///
    /// [`StorageError::RegionNotAligned`]; [`StorageError::BufferTooSmall`], counted in `T`.
    pub fn new(region: Region<F>, blocks: &'a mut [T]) -> Result<Self, StorageError> {
        let (x0, y0) = (region.x0(), region.y0());
        if !x0.is_multiple_of(4) || !y0.is_multiple_of(4) {
            return Err(StorageError::RegionNotAligned { x0, y0 });
        }
        let (needed, given) = (self::blocks(region.width(), region.height()), blocks.len());
        match blocks.get_mut(..needed) {
            Some(blocks) => Ok(Self { region, pitch: region.width().div_ceil(4), blocks }),
            None => Err(StorageError::BufferTooSmall { needed, given }),
        }
    }

    /// The region.
    #[inline]
    #[must_use]
    pub const fn region(&self) -> Region<F> {
        self.region
    }

    /// The block whose first pixel is (`x`, `y`); `None` outside the region.
    #[inline]
    #[must_use]
    pub fn block_mut(&mut self, x: u32, y: u32) -> Option<&mut T> {
        let index = self.index(x, y)?;
        self.blocks.get_mut(index)
    }

    /// The block that pixel (`x`, `y`) is in; `None` outside the region.
    #[inline]
    #[must_use]
    pub fn block(&self, x: u32, y: u32) -> Option<&T> {
        self.blocks.get(self.index(x, y)?)
    }

    /// All blocks, row by row.
    #[inline]
    pub const fn blocks_mut(&mut self) -> &mut [T] {
        self.blocks
    }

    /// The place of the block whose first pixel is (`x`, `y`), if it is in the region.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(crate) const fn place(&self, x: u32, y: u32) -> usize {
        let row = y.wrapping_sub(self.region.y0()) >> 2;
        let column = x.wrapping_sub(self.region.x0()) >> 2;
        row.wrapping_mul(self.pitch).wrapping_add(column) as usize
    }

    /// The place one row of blocks below.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(crate) const fn below(&self, place: usize) -> usize {
        place.wrapping_add(self.pitch as usize)
    }

    /// `count` blocks from the one `from` blocks to the right of a place, as far as the storage has them.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(crate) fn row_mut(&mut self, place: usize, from: u32, count: u32) -> &mut [T] {
        let rest = self.blocks.get_mut(place.wrapping_add(from as usize)..).unwrap_or(&mut []);
        let count = rest.len().min(count as usize);
        rest.get_mut(..count).unwrap_or(&mut [])
    }

    /// The blocks that `part`, of the region, touches, row by row.
    #[inline(always)]
    pub(super) fn rows(&self, part: Region<F>) -> impl Iterator<Item = &[T]> {
        let (part, pitch) = (part.blocks(), (self.pitch as usize).max(1));
        let first = self.index(part.x0(), part.y0()).unwrap_or(usize::MAX);
        let columns = (part.width() / 4) as usize;
        let rows = self.blocks.get(first..).unwrap_or(&[]).chunks(pitch).take((part.height() / 4) as usize);
        rows.map(
            #[inline(always)]
            move |row| row.get(..columns).unwrap_or(&[]),
        )
    }

    #[inline]
    pub(super) fn index(&self, x: u32, y: u32) -> Option<usize> {
        let column = x.checked_sub(self.region.x0())?;
        let row = y.checked_sub(self.region.y0())?;
        if column >= self.region.width() || row >= self.region.height() {
            return None;
        }
        Some((row / 4 * self.pitch + column / 4) as usize)
    }

    #[inline]
    pub(super) fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        OutsideAttachment::unless_contained(area, self.region)
    }
}

impl<'a, F: Format, E: Copy> Tiled<'a, F, [E; 16]> {
    /// The region in a slice of texels, sixteen to a block; texel 4 j + i of a block is its pixel in
    /// column i of row j.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new), counted in texels.
    pub fn of_texels(region: Region<F>, texels: &'a mut [E]) -> Result<Self, StorageError> {
        let given = texels.len();
        Self::new(region, texels.as_chunks_mut().0).map_err(|error| match error {
            StorageError::BufferTooSmall { needed, .. } => {
                StorageError::BufferTooSmall { needed: needed.saturating_mul(16), given }
            }
            StorageError::RegionNotAligned { .. } => error,
        })
    }

    /// Sets every texel.
    pub fn fill(&mut self, value: E) {
        self.blocks.fill([value; 16]);
    }

    /// The texel of pixel (`x`, `y`), in target coordinates; `None` outside the region.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<E> {
        let block = self.block(x, y)?;
        // The region begins at multiples of 4, so a block's pixels do too.
        block.get((4 * (y & 3) + (x & 3)) as usize).copied()
    }

    /// Copies the region to rows of `width` texels, top to bottom.
    ///
    /// # Errors
    ///
    /// [`StorageError::BufferTooSmall`] where `rows` has fewer than `width * height` elements;
    /// nothing is written then.
    pub fn to_linear(&self, rows: &mut [E]) -> Result<(), StorageError> {
        let (width, height) = (self.region.width() as usize, self.region.height() as usize);
        at_least(width * height, rows.len())?;
        let pitch = self.pitch as usize;
        for (y, row) in rows.chunks_exact_mut(width.max(1)).take(height).enumerate() {
            let blocks = self.blocks.iter().skip(y / 4 * pitch);
            for (pixels, block) in row.chunks_mut(4).zip(blocks) {
                let texels = block.iter().skip(4 * (y % 4));
                for (pixel, texel) in pixels.iter_mut().zip(texels) {
                    *pixel = *texel;
                }
            }
        }
        Ok(())
    }
}
