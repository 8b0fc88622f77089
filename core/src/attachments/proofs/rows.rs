//! Proofs of rows of blocks, of which only the vector code makes use.

use super::storage::{PLENTY, region_of};
use crate::{
    attachments::Tiled,
    geometry::Region,
    numbers::{Format, Standard},
    proof::{assume, cover, prove},
};

prove! {
    /// The place of a block without checks is the checked one
    /// (`places_of_standard_are_counted_row_by_row`). Partial blocks count in the pitch as there; how far
    /// down the region reaches does not count.
    [Tiled::place]
    fn unchecked_places_are_the_checked_ones(
        corner: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        columns: u32 = 1..=Standard::MAX_TARGET / 4,
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
    ) {
        let ([x0, y0], [column, row]) = (corner, block);
        let (x1, y1) = (4 * (x0 + columns), Standard::MAX_TARGET);
        let Ok(region) = Region::<Standard>::new(4 * x0, 4 * y0, x1, y1) else { return };
        assume!(column < columns && y0 + row < y1 / 4);
        let mut storage = [(); PLENTY];
        let Ok(tiled) = Tiled::new(region, &mut storage) else { return };
        let place = tiled.place(4 * (x0 + column), 4 * (y0 + row));
        assert!(place == (row * columns + column) as usize);
        cover!(place > 1 << 20);
    }

    /// A row below adds a row's number of blocks.
    [Tiled::below]
    fn a_row_below_adds_the_pitch(
        region: [u32; 4] = [0, 0, 1, 1]..=[Standard::MAX_TARGET / 4; 4],
        less: [u32; 2] = [0; 2]..=[3; 2],
        place: usize = 0..=1 << 24,
    ) {
        let [_, _, columns, _] = region;
        let Some(region) = region_of::<Standard>(region, less) else { return };
        let mut storage = [(); PLENTY];
        let Ok(tiled) = Tiled::new(region, &mut storage) else { unreachable!("there is plenty") };
        assert!(tiled.below(place) == place + columns as usize);
    }

    /// A row of blocks is what the storage has from where it should begin, at most as many as asked for:
    /// for every place and count.
    [Tiled::row_mut]
    fn a_row_is_in_the_storage(place: usize, from: u32, count: u32) {
        let Some(region) = region_of::<Standard>([0, 0, 400, 200], [0; 2]) else { return };
        let mut storage = [(); PLENTY];
        let Ok(mut tiled) = Tiled::new(region, &mut storage) else { unreachable!("there is plenty") };
        let first = place.wrapping_add(from as usize);
        let row = tiled.row_mut(place, from, count);
        assert!(row.len() == 80_000_usize.saturating_sub(first).min(count as usize));
        cover!(row.len() == 3 && count > 3);
    }
}
