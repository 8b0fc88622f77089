//! Proofs of hierarchical depth: what hides something, and where ranges are.

use super::{
    super::hierarchical::{
        DepthRange, depth_ranges,
        limit::Limit,
        range::{SQUARE, Squares},
        square,
    },
    one_lane::OneLane,
};
use crate::{
    attachments::{Compare, D16, D32, DepthFormat},
    geometry::Region,
    numbers::{DEPTH32_MAX, DEPTH32_MIN, Format, Small, Standard, Word},
    proof::{cover, prove},
};

pub(super) const COMPARISONS: [Compare; 5] =
    [Compare::Less, Compare::LessEqual, Compare::Greater, Compare::GreaterEqual, Compare::Always];

/// Whether a depth passes against a stored one.
fn passes(compare: Compare, depth: u32, stored: u32) -> bool {
    match compare {
        Compare::Less => depth < stored,
        Compare::LessEqual => depth <= stored,
        Compare::Greater => depth > stored,
        Compare::GreaterEqual => depth >= stored,
        Compare::Always => true,
    }
}

/// A fragment whose depth is at most one unit before its nearest vertex passes against no depth that hides it; and
/// what does not hide it, such a fragment passes.
fn limits_are_the_test<F: Format, D: DepthFormat<F>>(compare: usize, nearest: u32, behind: u32, stored: u32) {
    let compare = COMPARISONS[compare];
    let vertex = D::vertex(nearest.clamp(DEPTH32_MIN, DEPTH32_MAX)) >> (F::Word::HALF_BITS - D::BITS);
    let farther = matches!(compare, Compare::Greater | Compare::GreaterEqual);
    // From one unit nearer on, to the end of the range.
    let fragment = if farther { (vertex + 1).checked_sub(behind) } else { (vertex - 1).checked_add(behind) };
    let Some(fragment) = fragment else { return };
    let range = DepthRange { low: stored, high: stored, version: 1 };
    match Limit::new::<F, D>(compare, nearest) {
        Some(limit) if limit.hides(range) => assert!(!passes(compare, fragment, stored)),
        _ => assert!(behind != 0 || passes(compare, fragment, stored)),
    }
    cover!(passes(compare, fragment, stored) && behind > 0);
}

prove! {
    /// Of 32 bits: what is hidden passes nowhere, what is not hidden would.
    [Limit::new, Limit::hides]
    fn limits_of_32_bits_are_the_test(compare: usize = 0..=4, nearest: u32, behind: u32, stored: u32) {
        limits_are_the_test::<Standard, D32>(compare, nearest, behind, stored);
    }

    /// Of 16 bits of the standard format.
    [Limit::new, Limit::hides]
    fn limits_of_16_bits_are_the_test(
        compare: usize = 0..=4,
        nearest: u32,
        behind: u32 = 0..=0xFFFF,
        stored: u32 = 0..=0xFFFF,
    ) {
        limits_are_the_test::<Standard, D16>(compare, nearest, behind, stored);
    }

    /// Of the small format.
    [Limit::new, Limit::hides]
    fn limits_of_small_are_the_test(
        compare: usize = 0..=4,
        nearest: u32,
        behind: u32 = 0..=0xFFFF,
        stored: u32 = 0..=0xFFFF,
    ) {
        limits_are_the_test::<Small, D16>(compare, nearest, behind, stored);
    }

    /// A range hides what each depth in it hides, and shows what one of its ends shows.
    [Limit::hides]
    fn ranges_hide_what_their_depths_hide(upward: bool, limit: u32, low: u32, high: u32, depth: u32) {
        let limit = if upward { Limit::From(limit) } else { Limit::UpTo(limit) };
        let of = |low, high| limit.hides(DepthRange { low, high, version: 0 });
        let ordered = low <= depth && depth <= high;
        assert!(!ordered || !of(low, high) || of(depth, depth));
        assert!(!ordered || of(low, high) || !of(low, low) || !of(high, high));
        cover!(ordered && of(depth, depth) && !of(low, high));
    }

    /// A lane shows exactly where its depth does not hide.
    [Limit::shows]
    fn lanes_show_what_is_not_hidden(upward: bool, limit: u32, stored: u32) {
        let limit = if upward { Limit::From(limit) } else { Limit::UpTo(limit) };
        let hidden = limit.hides(DepthRange { low: stored, high: stored, version: 0 });
        assert!((limit.shows((), OneLane::<6>::of(stored)) == 0) == hidden);
    }

    /// The range of two holds both, and is no larger.
    [DepthRange::with]
    fn ranges_join(first: [u32; 2], second: [u32; 2], version: u32) {
        let range = |[low, high]: [u32; 2]| DepthRange { low, high, version };
        let joined = range(first).with(range(second));
        assert!(joined.low == first[0].min(second[0]) && joined.high == first[1].max(second[1]));
        assert!(joined.version == version);
    }

    /// As many ranges as there are squares and tiles, whatever the size.
    [depth_ranges]
    fn ranges_are_counted(width: u32 = 0..=1 << 22, height: u32 = 0..=1 << 22) {
        let squares = |side: u64| (u64::from(width) + side - 1) / side * ((u64::from(height) + side - 1) / side);
        assert!(depth_ranges(width, height) as u64 == squares(16) + squares(64));
    }

    /// Each place of a row and column is its own, and in the memory.
    [Squares::split, Squares::place, Squares::get, Squares::set]
    fn squares_are_stored_apart(columns: u32 = 1..=6, rows: u32 = 1..=3, first: [u32; 2], second: [u32; 2]) {
        let inside = |[column, row]: [u32; 2]| column < columns && row < rows;
        if !inside(first) || !inside(second) {
            return;
        }
        let mut memory = [DepthRange::UNKNOWN; 20];
        let (mut squares, rest) = Squares::split(&mut memory, columns, rows);
        assert!(rest.len() == 20 - (columns * rows) as usize);
        let range = DepthRange { low: 1, high: 2, version: 3 };
        squares.set(first[0], first[1], range);
        let found = squares.get(second[0], second[1]);
        assert!(found == if first == second { range } else { DepthRange::UNKNOWN });
        cover!(first != second && columns == 6);
    }

    /// After the last version, what was found before is of none.
    #[kani::unwind(7)]
    [Squares::forget]
    fn forgotten_squares_are_looked_at_again(place: [u32; 2] = [0; 2]..=[2, 1], found: [u32; 2], version: u32) {
        let mut memory = [DepthRange::UNKNOWN; 6];
        let (mut squares, _) = Squares::split(&mut memory, 3, 2);
        let [low, high] = found;
        squares.set(place[0], place[1], DepthRange { low, high, version });
        squares.forget();
        assert!(squares.get(place[0], place[1]) == DepthRange { low, high, version: 0 });
        cover!(version == u32::MAX);
    }

    /// A square of a region is its sixteen columns and rows, as far as the region has them.
    [square]
    fn squares_are_parts_of_the_region(
        corner: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET - 1; 2],
        size: [u32; 2] = [1; 2]..=[Standard::MAX_TARGET; 2],
        place: [u32; 2] = [0; 2]..=[1024; 2],
    ) {
        let [x0, y0] = corner;
        let Ok(region) = Region::<Standard>::new(x0, y0, x0 + size[0], y0 + size[1]) else { return };
        let [left, top] = [x0 + SQUARE * place[0], y0 + SQUARE * place[1]];
        match square(region, place[0], place[1]) {
            Some(square) => {
                assert!(square.x0() == left && square.y0() == top && region.contains(square));
                assert!(square.x1() == region.x1().min(left + SQUARE));
                assert!(square.y1() == region.y1().min(top + SQUARE));
            }
            None => assert!(left >= region.x1() || top >= region.y1()),
        }
        cover!(left + 1 == region.x1());
    }
}
