//! Proofs of the storage by texels.

use crate::{
    attachments::{StorageError, Tiled},
    geometry::Region,
    numbers::Small,
    proof::{cover, prove},
};

const LEFT: u32 = 8;
const TOP: u32 = 4;

/// A region of up to two blocks by two.
fn region(width: u32, height: u32) -> Option<Region<Small>> {
    Region::new(LEFT, TOP, LEFT + width, TOP + height).ok()
}

/// The numbers from 0, one for each texel of four blocks.
fn numbered() -> [u8; 64] {
    core::array::from_fn(|at| at as u8)
}

prove! {
    /// Each texel of the storage is one pixel's: block by block in their order, and in a block row by row.
    /// Pixels outside have none. Small regions: `places_of_small_are_counted_row_by_row` is for all.
    [Tiled::get, Tiled::block, Tiled::of_texels]
    fn pixels_have_their_own_texels(
        width: u32 = 1..=8,
        height: u32 = 1..=8,
        pixel: [u32; 2] = [0; 2]..=[20; 2],
    ) {
        let Some(region) = region(width, height) else { return };
        let mut storage = numbered();
        let Ok(tiled) = Tiled::of_texels(region, &mut storage) else { unreachable!("there are enough") };
        let [x, y] = pixel;
        let texel = tiled.get(x, y);
        let inside = LEFT <= x && x < LEFT + width && TOP <= y && y < TOP + height;
        assert!(texel.is_some() == inside);
        if let Some(texel) = texel {
            let (column, row) = (x - LEFT, y - TOP);
            let pitch = if width > 4 { 2 } else { 1 };
            let block = row / 4 * pitch + column / 4;
            assert!(u32::from(texel) == 16 * block + row % 4 * 4 + column % 4);
        }
        cover!(texel == Some(31) && width > 4);
    }

    /// A block that is written is the one that is read; others keep their texels.
    [Tiled::block_mut, Tiled::get]
    fn a_written_block_is_read(
        block: [u32; 2] = [0; 2]..=[1; 2],
        pixel: [u32; 2] = [0; 2]..=[7; 2],
        width: u32 = 5..=8,
    ) {
        let Some(region) = region(width, 7) else { return };
        let (mut storage, mut other) = (numbered(), numbered());
        let Ok(mut tiled) = Tiled::of_texels(region, &mut storage) else { unreachable!("there are enough") };
        let Ok(untouched) = Tiled::of_texels(region, &mut other) else { unreachable!("there are enough") };
        if let Some(texels) = tiled.block_mut(LEFT + 4 * block[0], TOP + 4 * block[1]) {
            *texels = [99; 16];
        }
        let (x, y) = (LEFT + pixel[0], TOP + pixel[1]);
        let written = pixel.map(|at| at / 4) == block;
        let expected = untouched.get(x, y).map(|texel| if written { 99 } else { texel });
        assert!(tiled.get(x, y) == expected);
        cover!(written && expected.is_some() && pixel[0] == 7);
    }

    /// Filled, every pixel has the value.
    [Tiled::fill]
    fn filled_texels_are_equal(width: u32 = 1..=8, height: u32 = 1..=8, pixel: [u32; 2] = [0; 2]..=[7; 2], value: u8) {
        let Some(region) = region(width, height) else { return };
        let mut storage = [0; 64];
        let Ok(mut tiled) = Tiled::of_texels(region, &mut storage) else { unreachable!("there are enough") };
        tiled.fill(value);
        assert!(tiled.get(LEFT + pixel[0], TOP + pixel[1]).is_none_or(|texel| texel == value));
    }

    /// Rows of texels are the pixels top to bottom; nothing behind them is written. Two blocks by two, but
    /// for their last column and rows.
    #[kani::unwind(66)]
    [Tiled::to_linear]
    fn rows_are_the_pixels(storage: [u8; 64], at: usize = 0..=44) {
        let Some(region) = region(7, 6) else { return };
        let mut texels = storage;
        let Ok(tiled) = Tiled::of_texels(region, &mut texels) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 45];
        assert!(tiled.to_linear(&mut rows).is_ok());
        let (column, row) = (at % 7, at / 7);
        let texel = 16 * (row / 4 * 2 + column / 4) + row % 4 * 4 + column % 4;
        assert!(rows[at] == if row < 6 { storage[texel & 63] } else { 0xFF });
    }

    /// The same where a row has one block.
    #[kani::unwind(66)]
    [Tiled::to_linear]
    fn short_rows_are_the_pixels(storage: [u8; 32], at: usize = 0..=15) {
        let Some(region) = region(3, 5) else { return };
        let mut texels = storage;
        let Ok(tiled) = Tiled::of_texels(region, &mut texels) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 16];
        assert!(tiled.to_linear(&mut rows).is_ok());
        let (column, row) = (at % 3, at / 3);
        let texel = 4 * row + column;
        assert!(rows[at] == if row < 5 { storage[texel & 31] } else { 0xFF });
    }

    /// Too few texels are told, and stay as they were.
    #[kani::unwind(66)]
    [Tiled::to_linear]
    fn too_few_texels_stay(given: usize = 0..=20, at: usize = 0..=19) {
        let Some(region) = region(5, 4) else { return };
        let mut storage = numbered();
        let Ok(tiled) = Tiled::of_texels(region, &mut storage) else { unreachable!("there are enough") };
        let mut rows = [0xFF; 20];
        let written = tiled.to_linear(&mut rows[..given]);
        if given < 20 {
            assert!(written == Err(StorageError::BufferTooSmall { needed: 20, given }) && rows[at] == 0xFF);
        } else {
            assert!(written.is_ok() && rows[at] != 0xFF);
        }
        cover!(given == 19);
        cover!(given == 20);
    }
}
