//! Proofs of the depth test.

use super::one_lane::OneLane;
use crate::{
    attachments::{Attachment, Block, Compare, D16, D32, Depth, DepthFormat, DepthTest},
    geometry::{Plane, Region, Sample, Triangle, Vertex},
    lanes::{ArrayLanes, Lanes},
    numbers::{DEPTH16_MAX, DEPTH16_MIN, Format, Small, Standard, Word},
    proof::{cover, prove},
    traversal::Mask,
};

/// The depth of [`level`], as unorm32.
const BASE: u32 = 0x9ABC_DEF0;

/// A triangle at one depth: its plane has that base everywhere.
fn level<F: Format>() -> Triangle<F> {
    let vertex = |x, y| Vertex::<F>::new(x, y, BASE).ok();
    let vertices = vertex(0, 0).zip(vertex(1, 0)).zip(vertex(0, 1));
    let triangle = vertices.and_then(|((a, b), c)| Triangle::new([a, b, c], Sample::CENTER));
    triangle.unwrap_or_else(|| unreachable!("it has an area"))
}

/// A texel through the test, in the lanes that stand for all, against the definition: its new depth, the stored
/// one, and whether it is seen. The offset is what `Plane::offsets` would have given: any, and so is its sum
/// with the plane's base modulo its range.
fn tests_a_texel<F: Format, D: DepthFormat<F>>(
    test: DepthTest,
    offset: u32,
    stored: D::Texel,
    bits: u16,
) -> (u32, u32, bool) {
    tests_one_lane::<F, D, 0>(test, offset, stored, bits);
    tests_one_lane::<F, D, 6>(test, offset, stored, bits);
    tests_one_lane::<F, D, 15>(test, offset, stored, bits)
}

fn tests_one_lane<F: Format, D: DepthFormat<F>, const LANE: usize>(
    test: DepthTest,
    offset: u32,
    stored: D::Texel,
    bits: u16,
) -> (u32, u32, bool) {
    let Ok(region) = Region::<F>::new(8, 4, 12, 8) else { unreachable!("it has pixels") };
    let mut texels = [stored; 16];
    let triangle = &level::<F>();
    let base = D::vertex(triangle.vertices()[0].z()) >> (F::Word::HALF_BITS - D::BITS);
    let Ok(mut depth) = Depth::<F, D>::new(region, &mut texels, test) else { unreachable!("it fits") };
    depth.plane = Some((Plane::new(triangle, D::vertex), [offset; 16]));
    let block = Block { x: 8, y: 4, mask: Mask(bits), triangle, id: 0 };
    let mask = depth.block_with::<OneLane<LANE>>((), &block);
    let new = ((u64::from(base) + u64::from(offset)) % (1 << D::BITS)) as u32;
    let old: u32 = stored.into();
    let passes = match test.compare {
        Compare::Less => new < old,
        Compare::LessEqual => new <= old,
        Compare::Greater => new > old,
        Compare::GreaterEqual => new >= old,
        Compare::Always => true,
    };
    let seen = passes && bits >> LANE & 1 != 0;
    assert!(mask.0 == u16::from(seen) << LANE);
    let now: u32 = texels[LANE].into();
    assert!(now == if seen && test.write { new } else { old });
    // No test lets the farther win, whichever way is farther.
    match test.compare {
        Compare::Less | Compare::LessEqual => assert!(now <= old),
        Compare::Greater | Compare::GreaterEqual => assert!(now >= old),
        Compare::Always => {}
    }
    (new, old, seen)
}

prove! {
    /// For each mask and offset: a covered sample passes where its depth, base plus offset modulo 2^32, is
    /// less than the stored one; then its depth is stored, if it is to be; nothing else changes.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D32::load, D32::store, D32::vertex]
    fn less_is_tested_and_stored(
        write: bool,
        offset: u32,
        stored: u32,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::Less, write };
        let (new, old, seen) = tests_a_texel::<Standard, D32>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// The same for this comparison.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D32::load, D32::store, D32::vertex]
    fn less_equal_is_tested_and_stored(
        write: bool,
        offset: u32,
        stored: u32,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::LessEqual, write };
        let (new, old, seen) = tests_a_texel::<Standard, D32>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// The same for this comparison.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D32::load, D32::store, D32::vertex]
    fn greater_is_tested_and_stored(
        write: bool,
        offset: u32,
        stored: u32,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::Greater, write };
        let (new, old, seen) = tests_a_texel::<Standard, D32>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// The same for this comparison.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D32::load, D32::store, D32::vertex]
    fn greater_equal_is_tested_and_stored(
        write: bool,
        offset: u32,
        stored: u32,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::GreaterEqual, write };
        let (new, old, seen) = tests_a_texel::<Standard, D32>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// The same for this comparison.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D32::load, D32::store, D32::vertex]
    fn always_is_tested_and_stored(
        write: bool,
        offset: u32,
        stored: u32,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::Always, write };
        let (new, _, seen) = tests_a_texel::<Standard, D32>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(!seen);
    }

    /// The same for 16 bits, modulo 2^16; offsets have 16 (`Plane::offsets`).
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D16::load, D16::store, D16::vertex]
    fn less_of_16_bits_is_tested_and_stored(
        write: bool,
        offset: u32 = 0..=0xFFFF,
        stored: u16,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::Less, write };
        let (new, old, seen) = tests_a_texel::<Small, D16>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// The same for this comparison.
    #[kani::unwind(17)]
    [Depth::block_with, Compare::passes, D16::load, D16::store, D16::vertex]
    fn greater_equal_of_16_bits_is_tested_and_stored(
        write: bool,
        offset: u32 = 0..=0xFFFF,
        stored: u16,
        bits: u16,
    ) {
        let test = DepthTest { compare: Compare::GreaterEqual, write };
        let (new, old, seen) = tests_a_texel::<Small, D16>(test, offset, stored, bits);
        cover!(seen && new < offset);
        cover!(new == old && bits == 0xFFFF);
    }

    /// With `Less` the smaller depth remains of every two: farther ones never win.
    #[kani::unwind(17)]
    [Depth::block_with]
    fn less_keeps_the_nearest(offset: u32, stored: u32) {
        let Ok(region) = Region::<Standard>::of_size(4, 4) else { unreachable!("it has pixels") };
        let mut texels = [stored; 16];
        let Ok(mut depth) = Depth::<Standard>::new(region, &mut texels, DepthTest::LESS) else {
            unreachable!("it fits")
        };
        let triangle = level();
        depth.plane = Some((Plane::new(&triangle, |depth| depth), [offset; 16]));
        depth.block_with::<OneLane<9>>((), &Block { x: 0, y: 0, mask: Mask::FULL, triangle: &triangle, id: 0 });
        assert!(texels[9] == stored.min(BASE.wrapping_add(offset)));
    }

    /// A vertex's depth of 16 bits is the nearest one, kept off both ends, with the planes' fraction.
    [D16::vertex]
    fn vertices_of_16_bits_are_rounded(depth: u32) {
        let (small, standard) =
            (<D16 as DepthFormat<Small>>::vertex(depth), <D16 as DepthFormat<Standard>>::vertex(depth));
        assert!(DEPTH16_MIN <= small && small <= DEPTH16_MAX && standard == small << 16);
        // |65537 v - z| <= 32768, where v is not at an end.
        let error = 65537 * i64::from(small) - i64::from(depth);
        assert!(error.abs() <= 32768 || (small == DEPTH16_MIN && error > 0) || (small == DEPTH16_MAX && error < 0));
        cover!(error == 32768);
    }

    /// Texels of 16 bits are loaded as they are, and stored as they were.
    #[kani::unwind(17)]
    [D16::load, D16::store]
    fn texels_of_16_bits_go_in_and_out(texels: [u16; 16], lane: usize = 0..=15) {
        let lanes: ArrayLanes = <D16 as DepthFormat<Small>>::load((), &texels);
        let mut values = [0; 16];
        lanes.store(&mut values);
        assert!(values[lane] == u32::from(texels[lane]));
        let mut stored = [0; 16];
        <D16 as DepthFormat<Small>>::store(lanes, &mut stored);
        assert!(stored[lane] == texels[lane]);
    }

    /// Without a triangle begun, or outside the region, nothing is seen and nothing changes.
    #[kani::unwind(17)]
    [Depth::block_with]
    fn no_depth_outside(stored: u16, begun: bool, x: u32 = 0..=5, y: u32 = 0..=5, bits: u16, lane: usize = 0..=31) {
        let Ok(region) = Region::<Small>::new(8, 4, 12, 12) else { unreachable!("it has pixels") };
        let mut texels = [stored; 32];
        let Ok(mut depth) = Depth::<Small, D16>::new(region, &mut texels, DepthTest::LESS) else {
            unreachable!("it fits")
        };
        let triangle = level();
        if begun {
            depth.plane = Some((Plane::new(&triangle, <D16 as DepthFormat<Small>>::vertex), [0; 16]));
        }
        let (x, y) = (4 * x, 4 * y);
        let mask = depth.block(&Block { x, y, mask: Mask(bits), triangle: &triangle, id: 0 });
        let inside = begun && x == 8 && (y == 4 || y == 8);
        if !inside {
            assert!(mask.is_empty() && texels[lane] == stored);
        }
        cover!(inside && !mask.is_empty());
    }
}
