//! Proofs of the tiled storage: its size, its places, its errors.

use super::super::storage::at_least;
use crate::{
    attachments::{OutsideAttachment, StorageError, Tiled, blocks, texels},
    geometry::Region,
    numbers::{Format, Small, Standard},
    proof::{assume, cover, prove},
};

/// More elements than any region needs. They take no memory, so slices of any length are at hand.
pub(super) const PLENTY: usize = 1 << 40;

/// The region of `blocks`, given in blocks, but for some columns and rows of pixels at its end.
pub(super) fn region_of<F: Format>([x0, y0, columns, rows]: [u32; 4], less: [u32; 2]) -> Option<Region<F>> {
    let (x1, y1) = (4 * (x0 + columns) - less[0], 4 * (y0 + rows) - less[1]);
    Region::new(4 * x0, 4 * y0, x1, y1).ok()
}

/// The place of each block of a region, counted row by row; a block's pixels share it.
fn places_are_counted_row_by_row<F: Format>(
    blocks: [u32; 4],
    less: [u32; 2],
    [column, row]: [u32; 2],
    [i, j]: [u32; 2],
) {
    let Some(region) = region_of::<F>(blocks, less) else { return };
    let (x, y) = (region.x0() + 4 * column + i, region.y0() + 4 * row + j);
    assume!(x < region.x1() && y < region.y1());
    let mut storage = [(); PLENTY];
    let Ok(tiled) = Tiled::new(region, &mut storage) else { unreachable!("there is plenty") };
    let [_, _, columns, _] = blocks;
    assert!(tiled.index(x, y) == Some((row * columns + column) as usize));
    cover!(row * columns > 1 << 12 && less[0] == 3);
}

fn only_pixels_inside_have_places<F: Format>(ends: [u32; 4], [x, y]: [u32; 2]) {
    let [x0, y0, x1, y1] = ends;
    let Ok(region) = Region::<F>::new(x0, y0, x1, y1) else { return };
    let mut storage = [(); PLENTY];
    let Ok(tiled) = Tiled::new(region, &mut storage) else { return };
    assert!(tiled.index(x, y).is_some() == (x0 <= x && x < x1 && y0 <= y && y < y1));
}

fn storage_fits_or_says_why<F: Format>(ends: [u32; 4], given: usize) {
    let [x0, y0, x1, y1] = ends;
    let Ok(region) = Region::<F>::new(x0, y0, x1, y1) else { return };
    let mut storage = [(); PLENTY];
    let Some(storage) = storage.get_mut(..given) else { return };
    let columns = (u64::from(x1 - x0) + 3) / 4;
    let rows = (u64::from(y1 - y0) + 3) / 4;
    let needed = (columns * rows) as usize;
    match Tiled::new(region, storage) {
        Err(StorageError::RegionNotAligned { x0: x, y0: y }) => {
            assert!((x0 % 4 != 0 || y0 % 4 != 0) && x == x0 && y == y0);
        }
        Err(error) => {
            assert!(x0 % 4 == 0 && y0 % 4 == 0 && given < needed);
            assert!(error == StorageError::BufferTooSmall { needed, given });
        }
        Ok(mut tiled) => {
            assert!(x0 % 4 == 0 && y0 % 4 == 0 && given >= needed);
            assert!(tiled.region() == region && tiled.blocks_mut().len() == needed);
        }
    }
    cover!(x0 % 4 == 0 && y0 % 4 == 0 && given + 1 == needed);
    cover!(x0 % 4 == 0 && y0 % 4 == 0 && given == needed);
}

prove! {
    /// As many blocks as a grid of 4 x 4 pixels has, for every width and height: no product overflows.
    [blocks]
    fn blocks_are_counted(width: u32, height: u32) {
        let (columns, rows) = ((u64::from(width) + 3) >> 2, (u64::from(height) + 3) >> 2);
        assert!(blocks(width, height) as u64 == columns * rows);
    }

    /// Sixteen texels for each block, or the largest number.
    [texels]
    fn texels_are_sixteen_a_block(width: u32, height: u32) {
        let (texels, blocks) = (texels(width, height), blocks(width, height));
        assert!(texels == if blocks < 1 << 60 { 16 * blocks } else { usize::MAX });
        cover!(texels == usize::MAX);
    }

    /// Four columns of pixels for each column of blocks are enough, and so are rows: with
    /// `blocks_are_counted`, a slice of `texels` has room for every pixel.
    [blocks, texels]
    fn texels_are_enough(side: u32) {
        assert!(4 * blocks(side, 1) as u64 >= u64::from(side) && 4 * blocks(1, side) as u64 >= u64::from(side));
        assert!(texels(side, 4) as u64 >= 4 * u64::from(side) && texels(4, side) as u64 >= 4 * u64::from(side));
    }

    /// What is too short, and by how much.
    [at_least]
    fn a_short_buffer_is_told(needed: usize, given: usize) {
        let expected = if given < needed { Err(StorageError::BufferTooSmall { needed, given }) } else { Ok(()) };
        assert!(at_least(needed, given) == expected);
    }

    /// Storage is made for each aligned region and each slice of enough blocks, of which it takes those it
    /// needs; every other argument has its error.
    [Tiled::new, blocks]
    fn storage_of_standard_fits_or_says_why(
        ends: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        given: usize = 0..=PLENTY,
    ) {
        storage_fits_or_says_why::<Standard>(ends, given);
    }

    /// The same for the small format.
    [Tiled::new, blocks]
    fn storage_of_small_fits_or_says_why(
        ends: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        given: usize = 0..=PLENTY,
    ) {
        storage_fits_or_says_why::<Small>(ends, given);
    }

    /// Errors of storage by texels are counted in texels; what is left over of a block counts as given.
    [Tiled::of_texels]
    fn storage_by_texels_counts_texels(
        ends: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        given: usize = 0..=PLENTY,
    ) {
        let [x0, y0, x1, y1] = ends;
        let Ok(region) = Region::<Standard>::new(x0, y0, x1, y1) else { return };
        let mut storage = [(); PLENTY];
        let Some(storage) = storage.get_mut(..given) else { return };
        let needed = texels(region.width(), region.height());
        match Tiled::of_texels(region, storage) {
            Err(StorageError::RegionNotAligned { .. }) => assert!(x0 % 4 != 0 || y0 % 4 != 0),
            Err(error) => {
                assert!(given < needed && error == StorageError::BufferTooSmall { needed, given });
            }
            Ok(_) => assert!(given >= needed),
        }
        cover!(x0 % 4 == 0 && y0 % 4 == 0 && given + 1 == needed);
    }

    /// The block in column c and row r of n columns has the place n r + c, c < n, whichever of its pixels
    /// asks: 0, 1, 2, .. row by row. So the blocks of a region and the places of its storage, of which
    /// there are n m (`blocks_are_counted`), are one to one, and in range.
    [Tiled::index]
    fn places_of_standard_are_counted_row_by_row(
        region: [u32; 4] = [0, 0, 1, 1]..=[Standard::MAX_TARGET / 4; 4],
        less: [u32; 2] = [0; 2]..=[3; 2],
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        pixel: [u32; 2] = [0; 2]..=[3; 2],
    ) {
        places_are_counted_row_by_row::<Standard>(region, less, block, pixel);
    }

    /// Pixels of the region have a place, all others none.
    [Tiled::index]
    fn only_pixels_of_standard_inside_have_places(
        ends: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        pixel: [u32; 2],
    ) {
        only_pixels_inside_have_places::<Standard>(ends, pixel);
    }

    /// The same for the small format.
    [Tiled::index]
    fn places_of_small_are_counted_row_by_row(
        region: [u32; 4] = [0, 0, 1, 1]..=[Small::MAX_TARGET / 4; 4],
        less: [u32; 2] = [0; 2]..=[3; 2],
        block: [u32; 2] = [0; 2]..=[Small::MAX_TARGET / 4 - 1; 2],
        pixel: [u32; 2] = [0; 2]..=[3; 2],
    ) {
        places_are_counted_row_by_row::<Small>(region, less, block, pixel);
    }

    /// The same for the small format.
    [Tiled::index]
    fn only_pixels_of_small_inside_have_places(
        ends: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        pixel: [u32; 2],
    ) {
        only_pixels_inside_have_places::<Small>(ends, pixel);
    }

    /// The last block has the last of the places that `blocks` counts: n (m - 1) + n - 1 of n m, which for
    /// the standard format follows from `places_of_standard_are_counted_row_by_row` and
    /// `blocks_are_counted`.
    [Tiled::index, blocks]
    fn the_last_place_of_small_is_the_last(
        region: [u32; 4] = [0, 0, 1, 1]..=[Small::MAX_TARGET / 4; 4],
        less: [u32; 2] = [0; 2]..=[3; 2],
    ) {
        let Some(region) = region_of::<Small>(region, less) else { return };
        let mut storage = [(); PLENTY];
        let Ok(tiled) = Tiled::new(region, &mut storage) else { unreachable!("there is plenty") };
        let last = tiled.index(region.x1() - 1, region.y1() - 1);
        assert!(last.is_some_and(|last| last + 1 == blocks(region.width(), region.height())));
        cover!(last.is_some_and(|last| last > 1 << 12));
    }

    /// In each of its rows, a part has the blocks that it touches, from its first to its last.
    #[kani::unwind(17)]
    [Tiled::rows, Tiled::index]
    fn rows_have_the_blocks_of_a_part(left: u32 = 0..=19, right: u32 = 1..=20, top: u32 = 0..=11, bottom: u32 = 1..=12) {
        let (Ok(region), Ok(part)) =
            (Region::<Small>::new(8, 4, 28, 16), Region::new(8 + left, 4 + top, 8 + right, 4 + bottom))
        else {
            return;
        };
        let mut numbers = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14];
        let Ok(tiled) = Tiled::new(region, &mut numbers) else { unreachable!("there are enough") };
        let mut count = 0;
        for row in tiled.rows(part) {
            assert!(row.len() as u32 == right.div_ceil(4) - left / 4);
            assert!(row.first() == Some(&((top / 4 + count) * 5 + left / 4)));
            assert!(row.last() == Some(&((top / 4 + count) * 5 + right.div_ceil(4) - 1)));
            count += 1;
        }
        assert!(count == bottom.div_ceil(4) - top / 4);
        cover!(count == 2 && left == 5 && right == 18);
    }

    /// An area that is not all inside is told with both rectangles.
    [OutsideAttachment::unless_contained, Tiled::check]
    fn areas_outside_are_told(
        area: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        attachment: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
    ) {
        let region = |[x0, y0, x1, y1]: [u32; 4]| Region::<Standard>::new(x0, y0, x1, y1);
        let (Ok(inner), Ok(outer)) = (region(area), region(attachment)) else { return };
        let (low, high) = ([area[0], area[1]], [area[2], area[3]]);
        let inside = low[0] >= attachment[0]
            && low[1] >= attachment[1]
            && high[0] <= attachment[2]
            && high[1] <= attachment[3];
        let result = OutsideAttachment::unless_contained(inner, outer);
        assert!(result == if inside { Ok(()) } else { Err(OutsideAttachment { area, attachment }) });
        cover!(inside && area[0] > attachment[0]);
    }
}
