//! Hierarchical depth as rows, those of its depth, and as what hides something.

use super::{
    attachment::{Gradients, rows::Rows},
    setup::DepthSetup,
};
use crate::{
    attachments::{Attachment as _, Compare, Depth, DepthFormat, HierarchicalDepth, OutsideAttachment},
    geometry::Region,
    lanes::Lanes,
    numbers::Standard,
};
use fearless_simd::{Simd, mask32x16};

mod sealed {
    pub trait Sealed {}
}
use sealed::Sealed;

/// Attachments that can tell what would be hidden: a [`HierarchicalDepth`], and tuples that begin with one.
pub trait Occluder: Sealed {
    /// Whether what is in the pixels of `area`, at depths from `depths[0]` to `depths[1]` as a vertex has them,
    /// would be seen nowhere.
    #[doc(hidden)]
    fn hides<L: Lanes>(&mut self, token: L::Token, area: Region<Standard>, depths: [u32; 2]) -> bool;

    /// Whether there are depths for all pixels of an area.
    #[doc(hidden)]
    fn check_area(&self, area: Region<Standard>) -> Result<(), OutsideAttachment>;
}

impl<D: DepthFormat<Standard>> Sealed for HierarchicalDepth<'_, Standard, D> {}

impl<D: DepthFormat<Standard>> Occluder for HierarchicalDepth<'_, Standard, D> {
    #[inline(always)]
    fn hides<L: Lanes>(&mut self, token: L::Token, area: Region<Standard>, [least, most]: [u32; 2]) -> bool {
        let nearest = match self.depth().test().compare {
            Compare::Greater | Compare::GreaterEqual => most,
            _ => least,
        };
        self.hides_with::<L>(token, area, nearest)
    }

    fn check_area(&self, area: Region<Standard>) -> Result<(), OutsideAttachment> {
        self.check(area)
    }
}

impl<A: Occluder> Sealed for &mut A {}

impl<A: Occluder> Occluder for &mut A {
    #[inline(always)]
    fn hides<L: Lanes>(&mut self, token: L::Token, area: Region<Standard>, depths: [u32; 2]) -> bool {
        (**self).hides::<L>(token, area, depths)
    }

    fn check_area(&self, area: Region<Standard>) -> Result<(), OutsideAttachment> {
        (**self).check_area(area)
    }
}

impl<A: Occluder, B> Sealed for (A, B) {}

impl<A: Occluder, B> Occluder for (A, B) {
    #[inline(always)]
    fn hides<L: Lanes>(&mut self, token: L::Token, area: Region<Standard>, depths: [u32; 2]) -> bool {
        self.0.hides::<L>(token, area, depths)
    }

    fn check_area(&self, area: Region<Standard>) -> Result<(), OutsideAttachment> {
        self.0.check_area(area)
    }
}

impl<'a, D: DepthFormat<Standard>> Rows for HierarchicalDepth<'a, Standard, D>
where
    Depth<'a, Standard, D>: Rows,
{
    const DEPTH: DepthSetup = <Depth<'a, Standard, D> as Rows>::DEPTH;
    const ORDERED: bool = <Depth<'a, Standard, D> as Rows>::ORDERED;
    type Lanes<S: Simd> = <Depth<'a, Standard, D> as Rows>::Lanes<S>;
    type Row<'r>
        = <Depth<'a, Standard, D> as Rows>::Row<'r>
    where
        Self: 'r;
    type Cursor = <Depth<'a, Standard, D> as Rows>::Cursor;

    #[inline]
    fn fast(&self) -> bool {
        self.depth().fast()
    }

    #[inline(always)]
    fn prepare<S: Simd>(&self, simd: S, gradients: Gradients, id: u32) -> Self::Lanes<S> {
        self.depth().prepare(simd, gradients, id)
    }

    #[inline(always)]
    fn cursor(&self, x: u32, y: u32) -> Self::Cursor {
        self.depth().cursor(x, y)
    }

    #[inline(always)]
    fn next_row(&self, cursor: Self::Cursor) -> Self::Cursor {
        self.depth().next_row(cursor)
    }

    #[inline(always)]
    fn row(&mut self, cursor: Self::Cursor, from: u32, blocks: u32) -> Self::Row<'_> {
        self.depth_mut().row(cursor, from, blocks)
    }

    #[inline(always)]
    fn write<'r, S: Simd>(
        simd: S,
        lanes: &Self::Lanes<S>,
        block: <Self::Row<'r> as Iterator>::Item,
        inside: mask32x16<S>,
        depth: u32,
    ) -> mask32x16<S>
    where
        Self: 'r,
    {
        <Depth<'a, Standard, D> as Rows>::write(simd, lanes, block, inside, depth)
    }
}
