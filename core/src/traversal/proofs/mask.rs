//! Proofs of the masks: each against what it says of one cell.

use crate::{
    geometry::Region,
    numbers::{Format, Small, Standard},
    proof::{cover, prove},
    traversal::Mask,
};

/// The bit of a cell.
fn bit(mask: Mask, column: u32, row: u32) -> bool {
    mask.0 & 1 << (4 * row + column) != 0
}

fn block_has_the_pixels_of<F: Format>([x0, x1, y0, y1]: [u32; 4], block: [u32; 2], cell: [u32; 2]) {
    let Ok(region) = Region::<F>::new(x0, y0, x1, y1) else { return };
    let ([x, y], [column, row]) = (block, cell);
    let (px, py) = (x + column, y + row);
    let inside = x0 <= px && px < x1 && y0 <= py && py < y1;
    assert!(bit(Mask::of_block(region, x, y), column, row) == inside);
    cover!(inside && x0 > x && y1 < y + 4);
    cover!(!inside && x1 > x && y0 < y);
}

prove! {
    /// A rectangle has the cells between its ends, whatever these are.
    [Mask::rectangle, Mask::run, Mask::below]
    fn a_rectangle_has_its_cells(ends: [u32; 4], column: u32 = 0..=3, row: u32 = 0..=3) {
        let [x0, x1, y0, y1] = ends;
        let inside = x0 <= column && column < x1 && y0 <= row && row < y1;
        assert!(bit(Mask::rectangle(x0, x1, y0, y1), column, row) == inside);
    }

    /// A block has the pixels of any region, wherever both lie.
    [Mask::of_block, Mask::rectangle, Mask::run, Mask::below]
    fn a_block_has_a_regions_pixels(
        ends: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        cell: [u32; 2] = [0; 2]..=[3; 2],
    ) {
        block_has_the_pixels_of::<Standard>(ends, block.map(|at| 4 * at), cell);
    }

    /// The same for the small format.
    [Mask::of_block, Mask::rectangle, Mask::run, Mask::below]
    fn a_block_has_a_small_regions_pixels(
        ends: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        block: [u32; 2] = [0; 2]..=[Small::MAX_TARGET / 4 - 1; 2],
        cell: [u32; 2] = [0; 2]..=[3; 2],
    ) {
        block_has_the_pixels_of::<Small>(ends, block.map(|at| 4 * at), cell);
    }

    /// `has` reads a cell's bit, and has nothing beside the sixteen.
    [Mask::has]
    fn a_mask_has_what_its_bits_say(bits: u16, column: u32, row: u32) {
        let has = Mask(bits).has(column, row);
        assert!(has == (column < 4 && row < 4 && bit(Mask(bits), column & 3, row & 3)));
        cover!(!has && column > 1 << 30);
    }

    /// The cells are the set ones, each once, row by row; there are as many as counted.
    #[kani::unwind(18)]
    [Mask::cells, Mask::count, Mask::and, Mask::is_empty]
    fn cells_are_the_set_ones_in_order(bits: u16, others: u16) {
        let mask = Mask(bits);
        let (mut seen, mut count, mut next) = (0, 0, 0);
        for (column, row) in mask.cells() {
            let place = 4 * row + column;
            assert!(column < 4 && row < 4 && place >= next);
            (seen, count, next) = (seen | 1 << place, count + 1, place + 1);
        }
        assert!(seen == bits && count == mask.count());
        assert!(mask.is_empty() == (count == 0));
        assert!(mask.and(Mask(others)).0 == bits & others);
    }
}
