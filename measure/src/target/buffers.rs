//! The memory of every attachment; each is made when it is first asked for.

use halfplane::simd::RowAttachment;
use halfplane::{
    Coverage, D16, D32, Depth, DepthFormat, DepthTest, Ids, NO_ID, Region, Standard, blocks, texels,
};

use super::{Attachments, TargetError};
use crate::buffer::Buffer;

const FAR32: u32 = <D32 as DepthFormat<Standard>>::FAR;
const FAR16: u16 = <D16 as DepthFormat<Standard>>::FAR;

/// The memory.
#[derive(Debug)]
pub(super) struct Buffers {
    region: Region<Standard>,
    depth32: Buffer<u32>,
    depth16: Buffer<u16>,
    ids: Buffer<u32>,
    coverage: Buffer<u16>,
}

/// Something that is done with attachments, whatever they are.
pub(super) trait Visitor {
    /// What comes of it.
    type Result;

    /// Does it.
    fn visit<A: RowAttachment>(self, attachments: &mut A) -> Self::Result;
}

/// Depths in rows from the top.
pub(super) fn depth_rows<D: DepthFormat<Standard>>(
    region: Region<Standard>,
    texels: &mut [D::Texel],
) -> Result<Vec<u32>, TargetError> {
    let mut rows = vec![D::FAR; region.width() as usize * region.height() as usize];
    Depth::<Standard, D>::new(region, texels, DepthTest::LESS)?.to_linear(&mut rows)?;
    Ok(rows.into_iter().map(Into::into).collect())
}

/// Ids in rows from the top.
pub(super) fn id_rows(region: Region<Standard>, texels: &mut [u32]) -> Result<Vec<u32>, TargetError> {
    let mut rows = vec![NO_ID; region.width() as usize * region.height() as usize];
    Ids::<Standard>::new(region, texels)?.to_linear(&mut rows)?;
    Ok(rows)
}

impl Buffers {
    /// None yet.
    #[must_use]
    pub(super) fn new(region: Region<Standard>) -> Self {
        Self {
            region,
            depth32: Buffer::new(0, 0),
            depth16: Buffer::new(0, 0),
            ids: Buffer::new(0, 0),
            coverage: Buffer::new(0, 0),
        }
    }

    /// Makes what is not there yet, cleared.
    fn make(&mut self, attachments: Attachments) {
        let (width, height) = (self.region.width(), self.region.height());
        let (texels, blocks) = (texels(width, height), blocks(width, height));
        let empty = |len: usize| len == 0;
        if attachments.has_depth32() && empty(self.depth32.as_slice().len()) {
            self.depth32 = Buffer::new(texels, FAR32);
        }
        if attachments.has_depth16() && empty(self.depth16.as_slice().len()) {
            self.depth16 = Buffer::new(texels, FAR16);
        }
        if attachments.has_ids() && empty(self.ids.as_slice().len()) {
            self.ids = Buffer::new(texels, NO_ID);
        }
        if attachments.has_coverage() && empty(self.coverage.as_slice().len()) {
            self.coverage = Buffer::new(blocks, 0);
        }
    }

    /// Clears what a frame would.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub(super) fn clear(&mut self, attachments: Attachments) -> Result<(), TargetError> {
        self.make(attachments);
        if attachments.has_depth32() {
            self.depth32()?.clear(FAR32);
        }
        if attachments.has_depth16() {
            self.depth16()?.clear(FAR16);
        }
        if attachments.has_ids() {
            self.ids()?.clear();
        }
        if attachments.has_coverage() {
            Coverage::<Standard>::new(self.region, self.coverage.as_mut_slice())?.clear();
        }
        Ok(())
    }

    /// Hands the attachments to a visitor.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub(super) fn visit<V: Visitor>(
        &mut self,
        attachments: Attachments,
        visitor: V,
    ) -> Result<V::Result, TargetError> {
        self.make(attachments);
        let region = self.region;
        Ok(match attachments {
            Attachments::Depth32 => visitor.visit(&mut self.depth32()?),
            Attachments::Depth16 => visitor.visit(&mut self.depth16()?),
            Attachments::Ids => visitor.visit(&mut self.ids()?),
            Attachments::DepthIds32 => {
                let mut ids = Ids::new(region, self.ids.as_mut_slice())?;
                let mut depth =
                    Depth::<Standard, D32>::new(region, self.depth32.as_mut_slice(), DepthTest::LESS)?;
                visitor.visit(&mut (&mut depth, &mut ids))
            }
            Attachments::DepthIds16 => {
                let mut ids = Ids::new(region, self.ids.as_mut_slice())?;
                let mut depth =
                    Depth::<Standard, D16>::new(region, self.depth16.as_mut_slice(), DepthTest::LESS)?;
                visitor.visit(&mut (&mut depth, &mut ids))
            }
            Attachments::Coverage => {
                visitor.visit(&mut Coverage::<Standard>::new(region, self.coverage.as_mut_slice())?)
            }
        })
    }

    fn depth32(&mut self) -> Result<Depth<'_, Standard, D32>, TargetError> {
        Ok(Depth::new(self.region, self.depth32.as_mut_slice(), DepthTest::LESS)?)
    }

    fn depth16(&mut self) -> Result<Depth<'_, Standard, D16>, TargetError> {
        Ok(Depth::new(self.region, self.depth16.as_mut_slice(), DepthTest::LESS)?)
    }

    fn ids(&mut self) -> Result<Ids<'_, Standard>, TargetError> {
        Ok(Ids::new(self.region, self.ids.as_mut_slice())?)
    }

    /// How many pixels something covers, by an attachment that was drawn.
    #[must_use]
    pub(super) fn covered(&self, attachments: Attachments) -> usize {
        // What pads the blocks at the borders is never covered.
        fn other<T: PartialEq + Copy>(texels: &[T], than: T) -> usize {
            texels.iter().filter(|&&texel| texel != than).count()
        }
        match attachments {
            Attachments::Depth32 => other(self.depth32.as_slice(), FAR32),
            Attachments::Depth16 => other(self.depth16.as_slice(), FAR16),
            Attachments::Ids | Attachments::DepthIds32 | Attachments::DepthIds16 => {
                other(self.ids.as_slice(), NO_ID)
            }
            Attachments::Coverage => {
                self.coverage.as_slice().iter().map(|mask| mask.count_ones() as usize).sum()
            }
        }
    }

    /// The depths in rows from the top; none if depth is not attached.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub(super) fn depth_rows(&mut self, attachments: Attachments) -> Result<Vec<u32>, TargetError> {
        self.make(attachments);
        if attachments.has_depth32() {
            return depth_rows::<D32>(self.region, self.depth32.as_mut_slice());
        }
        if attachments.has_depth16() {
            return depth_rows::<D16>(self.region, self.depth16.as_mut_slice());
        }
        Ok(Vec::new())
    }

    /// The ids in rows from the top; none if ids are not attached.
    ///
    /// # Errors
    ///
    /// None for memory that was made here.
    pub(super) fn id_rows(&mut self, attachments: Attachments) -> Result<Vec<u32>, TargetError> {
        if !attachments.has_ids() {
            return Ok(Vec::new());
        }
        self.make(attachments);
        id_rows(self.region, self.ids.as_mut_slice())
    }

    /// A number that two pictures share only if they are the same (FNV-1a, 64 bits).
    #[must_use]
    pub(super) fn fingerprint(&self, attachments: Attachments) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325u64;
        let mut add = |word: u32| hash = (hash ^ u64::from(word)).wrapping_mul(0x100_0000_01b3);
        if attachments.has_depth32() {
            self.depth32.as_slice().iter().copied().for_each(&mut add);
        }
        if attachments.has_depth16() {
            self.depth16.as_slice().iter().map(|&depth| u32::from(depth)).for_each(&mut add);
        }
        if attachments.has_ids() {
            self.ids.as_slice().iter().copied().for_each(&mut add);
        }
        if attachments.has_coverage() {
            self.coverage.as_slice().iter().map(|&mask| u32::from(mask)).for_each(&mut add);
        }
        hash
    }
}
