//! What attachments do with a block.

use super::{
    super::{
        attachment::{Gradients, rows::Rows},
        ops::bits,
    },
    LANES, Mask, Vectors, Words, simd,
};
use crate::{
    attachments::{Coverage, D16, D32, Depth, Ids},
    numbers::Standard,
    proof::{cover, prove},
};
use fearless_simd::{prelude::*, u16x16};

type DepthOf<D> = Depth<'static, Standard, D>;

#[inline(always)]
fn mask(bits: u32) -> Mask {
    Mask::from_bitmask(simd(), u64::from(bits))
}

prove! {
    /// A sample inside that is nearer is stored, and seen by later attachments; nothing else changes.
    #[kani::unwind(17)]
    [Depth::write]
    fn nearer_depths_are_stored(
        stored: [u32; 16],
        offsets: [u32; 16],
        depth: u32,
        inside: u32 = 0..=0xFFFF,
    ) {
        let mut block = stored;
        let lanes = Words::simd_from(simd(), offsets);
        let seen = <DepthOf<D32> as Rows>::write(simd(), &lanes, &mut block, mask(inside), depth);
        for lane in LANES {
            let depth = depth.wrapping_add(offsets[lane]);
            let nearer = inside >> lane & 1 != 0 && depth < stored[lane];
            assert!(block[lane] == if nearer { depth } else { stored[lane] });
            assert!(bits(seen) >> lane & 1 == u32::from(nearer));
            cover!(nearer);
        }
    }

    /// The same for 16 bits, which are the upper half.
    #[kani::unwind(17)]
    [Depth::write, mask16, mask32]
    fn nearer_depths_of_16_bits_are_stored(
        stored: [u16; 16],
        offsets: [u16; 16],
        depth: u32,
        inside: u32 = 0..=0xFFFF,
    ) {
        let mut block = stored;
        let lanes = u16x16::simd_from(simd(), offsets);
        let seen = <DepthOf<D16> as Rows>::write(simd(), &lanes, &mut block, mask(inside), depth);
        for lane in LANES {
            let depth = ((depth >> 16) as u16).wrapping_add(offsets[lane]);
            let nearer = inside >> lane & 1 != 0 && depth < stored[lane];
            assert!(block[lane] == if nearer { depth } else { stored[lane] });
            assert!(bits(seen) >> lane & 1 == u32::from(nearer));
            cover!(nearer);
        }
    }

    /// Ids are stored inside.
    #[kani::unwind(17)]
    [Ids::write]
    fn ids_are_stored_inside(stored: [u32; 16], id: u32, inside: u32 = 0..=0xFFFF) {
        let mut block = stored;
        let lanes = Words::splat(simd(), id);
        let seen = <Ids<'static, Standard> as Rows>::write(simd(), &lanes, &mut block, mask(inside), 0);
        for lane in LANES {
            assert!(block[lane] == if inside >> lane & 1 != 0 { id } else { stored[lane] });
        }
        assert!(bits(seen) == inside);
    }

    /// Coverage grows by what is inside.
    [Coverage::write]
    fn coverage_grows(stored: u16, inside: u32 = 0..=0xFFFF) {
        let mut block = stored;
        let seen = <Coverage<'static, Standard> as Rows>::write::<Vectors>(simd(), &(), &mut block, mask(inside), 0);
        assert!(u32::from(block) == u32::from(stored) | inside);
        assert!(bits(seen) == inside);
    }

    /// Depths and ids together: the id is stored where the depth is nearer.
    #[kani::unwind(17)]
    [Depth::write, Ids::write]
    fn ids_follow_depths(stored: u32, depth: u32, id: u32, inside: u32 = 0..=0xFFFF) {
        let (mut depths, mut ids) = ([stored; 16], [7; 16]);
        let lanes = (Words::splat(simd(), 0), Words::splat(simd(), id));
        let blocks = (&mut depths, &mut ids);
        let seen = <(DepthOf<D32>, Ids<'static, Standard>) as Rows>::write(simd(), &lanes, blocks, mask(inside), depth);
        for lane in LANES {
            let nearer = inside >> lane & 1 != 0 && depth < stored;
            assert!(ids[lane] == if nearer { id } else { 7 });
            assert!(bits(seen) >> lane & 1 == u32::from(nearer));
            cover!(nearer);
        }
    }

    /// The offsets of 16 bits are the rounded ones of 32.
    #[kani::unwind(17)]
    [Depth::prepare, offsets]
    fn offsets_of_16_bits_are_rounded(x: u64, y: u64) {
        let gradients = Gradients { x: x << 8, y: y << 8 };
        let mut storage = [0; 256];
        let Ok(region) = crate::Region::of_size(4, 4) else { return };
        let Ok(depth) = Depth::<Standard, D16>::new(region, &mut storage, crate::DepthTest::LESS) else { return };
        let mut found = [0; 16];
        depth.prepare(simd(), gradients, 0).store_slice(&mut found);
        for lane in LANES {
            let (column, row) = (lane as u64 % 4, lane as u64 / 4);
            let word = gradients.x.wrapping_mul(column).wrapping_add(gradients.y.wrapping_mul(row));
            assert!(found[lane] == ((word >> 32).wrapping_add(1 << 15) >> 16) as u16);
        }
        cover!(found[15] == 1);
    }
}
