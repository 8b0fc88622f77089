//! Proofs of the attachments without depth, and of their combination.

use super::one_lane::OneLane;
use crate::{
    attachments::{Attachment, Block, Count, Coverage, Ids, StorageError},
    geometry::{Region, Sample, Triangle, Vertex},
    numbers::Small,
    proof::{cover, prove},
    traversal::Mask,
};

/// Some triangle: what it is does not count.
fn triangle() -> Triangle<Small> {
    let vertex = |x, y| Vertex::new(x, y, 0).ok();
    let vertices = vertex(0, 0).zip(vertex(1, 0)).zip(vertex(0, 1));
    let triangle = vertices.and_then(|((a, b), c)| Triangle::new([a, b, c], Sample::CENTER));
    triangle.unwrap_or_else(|| unreachable!("it has an area"))
}

/// The region of the blocks at (8, 4) and (12, 4), but for the last column.
fn region() -> Region<Small> {
    Region::new(8, 4, 15, 8).unwrap_or_else(|_| unreachable!("it has pixels"))
}

/// Lets through these samples, covered or not.
struct Only(u16);

impl Attachment<Small> for Only {
    fn block(&mut self, _: &Block<'_, Small>) -> Mask {
        Mask(self.0)
    }
}

prove! {
    /// Covered samples get the id, no other pixel changes, and blocks outside have no sample. For one lane of
    /// each block: the rest of the lanes do the same (`lanes::proofs`).
    #[kani::unwind(33)]
    [Ids::block_with]
    fn covered_samples_get_the_id(first: u32, second: u32, id: u32, bits: u16, column: u32 = 0..=3) {
        let mut texels = [second; 32];
        texels[..16].fill(first);
        let x = 4 * column + 4;
        let Ok(mut ids) = Ids::new(region(), &mut texels) else { unreachable!("there are enough") };
        let triangle = triangle();
        let block = Block { x, y: 4, mask: Mask(bits), triangle: &triangle, id };
        let seen = ids.block_with::<OneLane<6>>((), &block);
        let in_region = x == 8 || x == 12;
        assert!(seen == if in_region { Mask(bits) } else { Mask::EMPTY });
        let covered = bits >> 6 & 1 != 0;
        assert!(texels[6] == if covered && x == 8 { id } else { first });
        assert!(texels[22] == if covered && x == 12 { id } else { second });
        cover!(covered && x == 12 && id != second);
    }

    /// Coverage collects the masks of each block, and each pixel has its bit.
    #[kani::unwind(17)]
    [Coverage::block, Coverage::get]
    fn coverage_collects_masks(stored: [u16; 2], bits: u16, column: u32 = 0..=3, pixel: [u32; 2] = [0; 2]..=[20; 2]) {
        let mut masks = stored;
        let x = 4 * column + 4;
        let Ok(mut coverage) = Coverage::new(region(), &mut masks) else { unreachable!("there are enough") };
        let triangle = triangle();
        let seen = coverage.block(&Block { x, y: 4, mask: Mask(bits), triangle: &triangle, id: 0 });
        let in_region = x == 8 || x == 12;
        assert!(seen == if in_region { Mask(bits) } else { Mask::EMPTY });
        let [px, py] = pixel;
        let covered = coverage.get(px, py);
        if 8 <= px && px < 15 && 4 <= py && py < 8 {
            let place = 4 * (py - 4) + px % 4;
            let before = stored[(px as usize - 8) / 4] >> place & 1 != 0;
            assert!(covered == Some(before || (px & !3 == x && bits >> place & 1 != 0)));
        } else {
            assert!(covered.is_none());
        }
        cover!(covered == Some(true) && stored[1] == 0 && px == 13);
    }

    /// Rows of bits are the pixels, left to right from bit 0, the rest of a row's last byte 0; nothing
    /// behind the rows is written. Three blocks by two, but for their last column and rows.
    #[kani::unwind(17)]
    [Coverage::to_bits]
    fn rows_of_bits_are_the_pixels(stored: [u16; 6], at: usize = 0..=10, bit: u32 = 0..=7) {
        let Ok(region) = Region::<Small>::new(8, 4, 19, 9) else { return };
        let mut masks = stored;
        let Ok(coverage) = Coverage::new(region, &mut masks) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 11];
        assert!(coverage.to_bits(&mut rows).is_ok());
        let (column, row) = (8 * (at as u32 % 2) + bit, at as u32 / 2);
        let pixel = (stored[(row / 4 * 3 + column / 4) as usize % 6] >> (4 * (row % 4) + column % 4)) & 1;
        let expected = row == 5 || (column < 11 && pixel != 0);
        assert!((rows[at] >> bit & 1 != 0) == expected);
    }

    /// The same where a row has one byte of one block.
    #[kani::unwind(17)]
    [Coverage::to_bits]
    fn short_rows_of_bits_are_the_pixels(stored: [u16; 2], at: usize = 0..=5, bit: u32 = 0..=7) {
        let Ok(region) = Region::<Small>::new(8, 4, 11, 9) else { return };
        let mut masks = stored;
        let Ok(coverage) = Coverage::new(region, &mut masks) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 6];
        assert!(coverage.to_bits(&mut rows).is_ok());
        let (column, row) = (bit, at as u32);
        let pixel = (stored[(row / 4) as usize % 2] >> (4 * (row % 4) + column % 4)) & 1;
        let expected = row == 5 || (column < 3 && pixel != 0);
        assert!((rows[at] >> bit & 1 != 0) == expected);
    }

    /// Too few bytes are told, and stay as they were.
    #[kani::unwind(17)]
    [Coverage::to_bits]
    fn too_few_bytes_stay(given: usize = 0..=8, at: usize = 0..=7) {
        let Ok(region) = Region::<Small>::new(8, 4, 17, 8) else { return };
        let mut masks = [0; 3];
        let Ok(coverage) = Coverage::new(region, &mut masks) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 8];
        let written = coverage.to_bits(&mut rows[..given]);
        if given < 8 {
            assert!(written == Err(StorageError::BufferTooSmall { needed: 8, given }) && rows[at] == 0xFF);
        } else {
            assert!(written.is_ok() && rows[at] == 0);
        }
        cover!(given == 7);
        cover!(given == 8);
    }

    /// The count of a mask's samples is added, and saturates.
    [Count::block]
    fn samples_are_counted(samples: u64, bits: u16) {
        let mut count = Count { samples };
        let triangle = triangle();
        let seen = count.block(&Block { x: 0, y: 0, mask: Mask(bits), triangle: &triangle, id: 0 });
        let exact = u128::from(samples) + (0..16).filter(|cell| bits >> cell & 1 != 0).count() as u128;
        assert!(seen == Mask(bits) && u128::from(count.samples) == exact.min(u128::from(u64::MAX)));
        cover!(exact > u128::from(u64::MAX));
    }

    /// A later attachment of a pair or a triple, however they are nested, gets no sample that an earlier one did
    /// not let through, nor one that was not covered, whatever masks they return.
    [Attachment::block_with]
    fn later_attachments_see_what_earlier_let_through(bits: u16, first: u16, second: u16) {
        let mut attachments = (Only(first), Only(second), Count::default());
        let triangle = triangle();
        let block = Block { x: 0, y: 0, mask: Mask(bits), triangle: &triangle, id: 0 };
        let mask = attachments.block(&block);
        assert!(mask.0 == bits & first & second);
        assert!(attachments.2.samples == u64::from((bits & first & second).count_ones()));
        let mut nested = ((Only(first), Only(second)), Count::default());
        assert!(nested.block(&block).0 == bits & first & second);
        assert!(nested.1.samples == u64::from((bits & first & second).count_ones()));
    }
}
