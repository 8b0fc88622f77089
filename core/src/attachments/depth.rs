//! The depth buffer.

use super::{
    Attachment, Block, OutsideAttachment,
    depth_format::{D32, DepthFormat},
    storage::{StorageError, Tiled},
};
use crate::{
    geometry::{Plane, Region, Triangle},
    lanes::{ArrayLanes, Lanes},
    numbers::{Format, WordArithmetic},
    traversal::Mask,
};
use core::marker::PhantomData;

/// When a sample passes: how its depth compares with the stored one.
///
/// With the strict comparisons the earlier of two triangles wins a tie, with the others the later.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Compare {
    /// Nearer wins, earlier wins a tie.
    #[default]
    Less,
    /// Nearer wins, later wins a tie.
    LessEqual,
    /// Farther wins, earlier wins a tie: reversed depth.
    Greater,
    /// Farther wins, later wins a tie.
    GreaterEqual,
    /// The last one drawn wins.
    Always,
}

/// The comparison, and whether samples that pass are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DepthTest {
    /// The comparison.
    pub compare: Compare,
    /// Whether depths that pass are stored.
    pub write: bool,
}

impl DepthTest {
    /// Nearer wins and is stored.
    pub const LESS: Self = Self { compare: Compare::Less, write: true };
}

impl Default for DepthTest {
    fn default() -> Self {
        Self::LESS
    }
}

/// One depth per pixel, and the test of new ones against it.
///
/// The depth of a covered sample is the plane at its 4x4 block's first sample, rounded to a texel,
/// plus the plane's difference from there to the sample, rounded, modulo the texel's range. Each
/// rounding is half a unit; [`Bounds::MAX_DEPTH_ERROR_2_16`](crate::Bounds::MAX_DEPTH_ERROR_2_16)
/// has the sum.
#[derive(Debug)]
pub struct Depth<'a, F: Format, D: DepthFormat<F> = D32> {
    texels: Tiled<'a, F, [D::Texel; 16]>,
    test: DepthTest,
    pub(super) plane: Option<(Plane<F>, [u32; 16])>,
    format: PhantomData<D>,
}

impl<'a, F: Format, D: DepthFormat<F>> Depth<'a, F, D> {
    /// [`DepthFormat::FAR`].
    pub const FAR: D::Texel = D::FAR;
    /// [`DepthFormat::NEAR`].
    pub const NEAR: D::Texel = D::NEAR;

    /// Depths of `region` in a slice of at least [`texels`](super::texels)`(width, height)`. Its
    /// contents are kept: [`clear`](Self::clear) it first.
    ///
    /// # Errors
    ///
    /// [`StorageError`].
    pub fn new(region: Region<F>, texels: &'a mut [D::Texel], test: DepthTest) -> Result<Self, StorageError> {
        let texels = Tiled::of_texels(region, texels)?;
        Ok(Self { texels, test, plane: None, format: PhantomData })
    }

    /// Sets every depth.
    pub fn clear(&mut self, depth: D::Texel) {
        self.texels.fill(depth);
    }

    /// The storage.
    #[inline]
    pub(crate) const fn tiled(&self) -> &Tiled<'a, F, [D::Texel; 16]> {
        &self.texels
    }

    /// The storage, to be written.
    #[cfg(feature = "simd")]
    #[inline]
    pub(crate) const fn tiled_mut(&mut self) -> &mut Tiled<'a, F, [D::Texel; 16]> {
        &mut self.texels
    }

    /// The comparison, and whether depths are stored.
    #[inline]
    pub(crate) const fn test(&self) -> DepthTest {
        self.test
    }

    /// The depth at pixel (`x`, `y`); `None` outside the region.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<D::Texel> {
        self.texels.get(x, y)
    }

    /// [`Tiled::to_linear`].
    ///
    /// # Errors
    ///
    /// [`StorageError::BufferTooSmall`].
    pub fn to_linear(&self, rows: &mut [D::Texel]) -> Result<(), StorageError> {
        self.texels.to_linear(rows)
    }
}

impl Compare {
    /// The lanes in which `new` passes against `stored`.
    #[inline(always)]
    fn passes<L: Lanes>(self, token: L::Token, new: L, stored: L) -> L::Mask {
        match self {
            Self::Less => new.less(stored),
            Self::LessEqual => L::not(stored.less(new)),
            Self::Greater => stored.less(new),
            Self::GreaterEqual => L::not(new.less(stored)),
            Self::Always => L::mask(token, Mask::FULL.0),
        }
    }
}

impl<F: Format, D: DepthFormat<F>> Attachment<F> for Depth<'_, F, D> {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.block_with::<ArrayLanes>((), block)
    }

    #[inline(always)]
    fn block_with<L: Lanes>(&mut self, token: L::Token, block: &Block<'_, F>) -> Mask {
        let (Some((plane, offsets)), Some(texels)) = (&self.plane, self.texels.block_mut(block.x, block.y))
        else {
            return Mask::EMPTY;
        };
        let base = plane.at(block.x, block.y).rounded(D::BITS);
        let range = L::splat(token, u32::MAX >> (32 - D::BITS));
        let depths = L::load(token, offsets).add(L::splat(token, base)).and(range);
        let stored: L = D::load(token, texels);
        let covered = L::mask(token, block.mask.0);
        // The usual test by itself, so that the choice between the others costs it nothing.
        if self.test == DepthTest::LESS {
            let mask = L::both(depths.less(stored), covered);
            D::store(depths.select(stored, mask), texels);
            return Mask(L::bits(mask));
        }
        let passing = self.test.compare.passes::<L>(token, depths, stored);
        let mask = L::both(passing, covered);
        if self.test.write {
            D::store(depths.select(stored, mask), texels);
        }
        Mask(L::bits(mask))
    }

    // Once for each triangle: one copy of the divisions is enough.
    #[inline(never)]
    fn begin(&mut self, triangle: &Triangle<F>) {
        let plane = Plane::new(triangle, D::vertex);
        let offsets = plane.offsets(D::BITS);
        self.plane = Some((plane, offsets));
    }

    #[inline]
    fn check(&self, area: Region<F>) -> Result<(), OutsideAttachment> {
        self.texels.check(area)
    }
}
