//! Proofs of the way over a rectangle's blocks.

use crate::{
    geometry::Region,
    lanes::{ArrayLanes, Lanes},
    numbers::{Bounds, Standard},
    proof::{assume, cover, prove},
    traversal::{
        Mask,
        scan::{Edge, scan},
        step::{InBlock, Step, corner_steps},
    },
};

/// Largest magnitude of an edge's deltas.
const DELTA: i32 = Bounds::<Standard>::MAX_DELTA;
/// Largest magnitude of an edge's value at a pixel of a rectangle that it crosses:
/// `an_edge_is_decided_by_its_corners`.
const VALUE: i32 = Bounds::<Standard>::MAX_TILE_VALUE as i32;

/// The same where whole masks are compared: only signs matter to them, and those of wide values are proved
/// lane by lane (`a_blocks_samples_are_exact`, `signs_are_the_negative_lanes`).
const NARROW_DELTA: i32 = 1 << 3;
const NARROW_VALUE: i32 = 1 << 6;

/// An edge in every block, by the definition.
fn in_block(a: i32, b: i32) -> InBlock<ArrayLanes> {
    let mut lanes = [0; 16];
    for (lane, value) in lanes.iter_mut().enumerate() {
        let (column, row) = (lane as i32 & 3, lane as i32 >> 2);
        *value = (column * a + row * b) as u32;
    }
    InBlock { lanes: ArrayLanes::load((), &lanes), highest: corner_steps(a, b, 4, 4).1 }
}

/// Where the rectangles begin.
const LEFT: u32 = 8;
const TOP: u32 = 4;

/// The masks that a scan hands out for the blocks of the rectangle, row by row, and how often it visits
/// each; `cut` as in `scan`.
fn masks_of<const COLUMNS: usize, const ROWS: usize>(
    steps: [Step; 3],
    deltas: [[i32; 2]; 3],
    cut: Option<Region<Standard>>,
) -> ([[u16; COLUMNS]; ROWS], [[u8; COLUMNS]; ROWS], bool) {
    let (right, bottom) = (LEFT + 4 * COLUMNS as u32, TOP + 4 * ROWS as u32);
    let (mut masks, mut visits) = ([[0; COLUMNS]; ROWS], [[0; COLUMNS]; ROWS]);
    let Ok(rectangle) = Region::<Standard>::new(LEFT, TOP, right, bottom) else {
        return (masks, visits, false);
    };
    let blocks = deltas.map(|[a, b]| in_block(a, b));
    let any = scan((), blocks, steps, rectangle, cut, |x, y, Mask(mask)| {
        assert!(x % 4 == 0 && y % 4 == 0);
        let (column, row) = (((x - LEFT) / 4) as usize, ((y - TOP) / 4) as usize);
        masks[row][column] = mask;
        visits[row][column] += 1;
    });
    (masks, visits, any)
}

/// The edge at a pixel of the rectangle, exactly.
const fn at(Step { value, a, b }: Step, column: i32, row: i32) -> i64 {
    value as i64 + column as i64 * a as i64 + row as i64 * b as i64
}

/// The samples inside an edge in the block that begins at a column and a row of the rectangle.
fn samples(Step { value, a, b }: Step, column: i32, row: i32) -> u16 {
    let mut inside = 0;
    for place in 0..16 {
        let (column, row) = (column + place % 4, row + place / 4);
        inside |= u16::from(value + column * a + row * b >= 0) << place;
    }
    inside
}

/// Whether an edge fits at the corners of a rectangle of that size, and so everywhere in it.
fn fits(step: Step, columns: i32, rows: i32) -> bool {
    let fits = |column, row| at(step, column, row).abs() <= i64::from(VALUE);
    fits(0, 0) & fits(columns - 1, 0) & fits(0, rows - 1) & fits(columns - 1, rows - 1)
}

prove! {
    /// One block to the right adds 4 A, one down 4 B, exactly where that block is still in the rectangle:
    /// there the value fits. So by induction each block's value is the first one's plus 4 i A + 4 j B.
    [Edge::new, Edge::to_the_right, Edge::below]
    fn an_edge_steps_by_blocks(
        value: i32 = -VALUE..=VALUE,
        a: i32 = -DELTA..=DELTA,
        b: i32 = -DELTA..=DELTA,
    ) {
        let edge = Edge::new(in_block(0, 0), Step { value, a, b });
        let (right, down) = (i64::from(value) + 4 * i64::from(a), i64::from(value) + 4 * i64::from(b));
        if right.abs() <= i64::from(VALUE) {
            assert!(i64::from(edge.to_the_right().value) == right);
        }
        if down.abs() <= i64::from(VALUE) {
            assert!(i64::from(edge.below().value) == down);
        }
        cover!(right < 0 && value > 0);
        cover!(down > i64::from(VALUE));
    }

    /// A block's samples and its trivial-reject corner are the edge's values at its pixels, without a wrap
    /// where these fit, as in the rectangle they do; a dropped edge is positive at all of them, whatever
    /// its steps.
    #[kani::unwind(17)]
    [Edge::corner, Edge::samples]
    fn a_blocks_samples_are_exact(
        value: i32 = -VALUE..=VALUE,
        a: i32 = -DELTA..=DELTA,
        b: i32 = -DELTA..=DELTA,
        column: i32 = 0..=3,
        row: i32 = 0..=3,
    ) {
        let step = Step { value, a, b };
        let lane = (4 * row + column) as usize & 15;
        let mut lanes = [0; 16];
        let dropped = Edge::new(in_block(a, b), Step::DROPPED);
        dropped.samples(()).store(&mut lanes);
        assert!(lanes[lane] as i32 > 0 && dropped.corner() > 0);
        assume!(fits(step, 4, 4));
        let edge = Edge::new(in_block(a, b), step);
        edge.samples(()).store(&mut lanes);
        let exact = at(step, column, row);
        assert!(i64::from(lanes[lane] as i32) == exact && i64::from(edge.corner()) >= exact);
        cover!(exact < 0 && edge.corner() >= 0);
    }

    /// The masks of two blocks side by side are the per-sample test, for one edge beside two that accept
    /// them; a block is visited once where its mask is not empty, else never.
    #[kani::unwind(17)]
    [scan, Edge::new, Edge::corner, Edge::samples, Edge::to_the_right, Edge::below]
    fn blocks_in_a_row_have_masks_per_sample(
        value: i32 = -NARROW_VALUE..=NARROW_VALUE,
        a: i32 = -NARROW_DELTA..=NARROW_DELTA,
        b: i32 = -NARROW_DELTA..=NARROW_DELTA,
    ) {
        let step = Step { value, a, b };
        let ([[first, second]], [[once, again]], any) = masks_of::<2, 1>([Step::DROPPED, step, Step::DROPPED], [[0, 0], [a, b], [0, 0]], None);
        assert!(first == samples(step, 0, 0) && second == samples(step, 4, 0));
        assert!(once == u8::from(first != 0) && again == u8::from(second != 0) && any == (first | second != 0));
        cover!(first == 0 && second == 0x8888);
    }

    /// The same for two blocks one above the other.
    #[kani::unwind(17)]
    [scan, Edge::new, Edge::corner, Edge::samples, Edge::to_the_right, Edge::below]
    fn blocks_in_a_column_have_masks_per_sample(
        value: i32 = -NARROW_VALUE..=NARROW_VALUE,
        a: i32 = -NARROW_DELTA..=NARROW_DELTA,
        b: i32 = -NARROW_DELTA..=NARROW_DELTA,
    ) {
        let step = Step { value, a, b };
        let ([[first], [second]], [[once], [again]], any) = masks_of::<1, 2>([Step::DROPPED, step, Step::DROPPED], [[0, 0], [a, b], [0, 0]], None);
        assert!(first == samples(step, 0, 0) && second == samples(step, 0, 4));
        assert!(once == u8::from(first != 0) && again == u8::from(second != 0) && any == (first | second != 0));
        cover!(first == 0 && second == 0xF000);
    }

    /// The same for three edges over one block.
    #[kani::unwind(17)]
    [scan]
    fn three_edges_masks_are_per_sample(
        values: [i32; 3] = [-NARROW_VALUE; 3]..=[NARROW_VALUE; 3],
        a: [i32; 3] = [-NARROW_DELTA; 3]..=[NARROW_DELTA; 3],
        b: [i32; 3] = [-NARROW_DELTA; 3]..=[NARROW_DELTA; 3],
    ) {
        let steps = [0, 1, 2].map(|k| Step { value: values[k], a: a[k], b: b[k] });
        let [inside0, inside1, inside2] = steps.map(|step| samples(step, 0, 0));
        let ([[mask]], [[visits]], any) = masks_of::<1, 1>(steps, [0, 1, 2].map(|k| [a[k], b[k]]), None);
        assert!(mask == inside0 & inside1 & inside2);
        assert!(visits == u8::from(mask != 0) && any == (mask != 0));
        cover!(mask.count_ones() == 5);
        cover!(!any && a[0] > 0 && b[1] < 0);
    }

    /// Of a rectangle that no edge cuts, the samples in the region, and no others; blocks without any are
    /// not visited. Two blocks side by side; a block's part of a region: `Mask::of_block`'s proofs.
    #[kani::unwind(17)]
    [scan]
    fn a_cut_rectangle_has_the_regions_samples(columns: [u32; 2] = [0; 2]..=[20; 2], row: u32 = 0..=7) {
        let [x0, x1] = columns;
        let Ok(region) = Region::new(x0, row, x1, row + 1) else { return };
        let ([[first, second]], [[once, again]], any) =
            masks_of::<2, 1>([Step::DROPPED; 3], [[0; 2]; 3], Some(region));
        for column in 0..4 {
            let (bit, x) = (4 * (row & 3) + column, LEFT + column);
            let inside = |x| row >= TOP && x0 <= x && x < x1;
            assert!((first >> bit & 1 != 0) == inside(x) && (second >> bit & 1 != 0) == inside(x + 4));
        }
        let whole_row = 0xF << (4 * (row & 3));
        assert!((first | second) & !whole_row == 0);
        assert!(once == u8::from(first != 0) && again == u8::from(second != 0) && any == (first | second != 0));
        cover!(first == 0x80 && second == 0x70);
    }

    /// The same for two blocks one above the other.
    #[kani::unwind(17)]
    [scan]
    fn a_cut_column_has_the_regions_samples(rows: [u32; 2] = [0; 2]..=[20; 2], column: u32 = 4..=15) {
        let [y0, y1] = rows;
        let Ok(region) = Region::new(column, y0, column + 1, y1) else { return };
        let ([[first], [second]], [[once], [again]], any) =
            masks_of::<1, 2>([Step::DROPPED; 3], [[0; 2]; 3], Some(region));
        for row in 0..4 {
            let (bit, y) = (4 * row + (column & 3), TOP + row);
            let inside = |y| LEFT <= column && column < LEFT + 4 && y0 <= y && y < y1;
            assert!((first >> bit & 1 != 0) == inside(y) && (second >> bit & 1 != 0) == inside(y + 4));
        }
        let whole_column = 0x1111 << (column & 3);
        assert!((first | second) & !whole_column == 0);
        assert!(once == u8::from(first != 0) && again == u8::from(second != 0) && any == (first | second != 0));
        cover!(first == 0x2000 && second == 0x22);
    }
}
