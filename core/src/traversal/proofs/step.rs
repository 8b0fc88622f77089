//! Proofs of one edge over a rectangle: its corners, its reduction to 32 bits, and its values in blocks.

use crate::{
    geometry::{Edge, Inside, Region, Rule, Sample, Touched, Uncertainty, Vertex},
    lanes::{ArrayLanes, Lanes},
    numbers::{Bounds, Format, Small, Standard},
    proof::{assume, cover, prove},
    traversal::step::{InBlock, Step, corner_steps},
};

/// The least and the greatest of the bounded magnitudes.
const fn magnitudes<const N: usize>(limit: i32) -> core::ops::RangeInclusive<[i32; N]> {
    [-limit; N]..=[limit; N]
}

/// Largest magnitude of an edge's deltas.
const DELTA: i32 = Bounds::<Standard>::MAX_DELTA;

/// Largest magnitude of an edge's value at a pixel of a rectangle that it crosses:
/// `an_edge_is_decided_by_its_corners`.
const VALUE: i32 = Bounds::<Standard>::MAX_TILE_VALUE as i32;

fn uncertainty(half: bool) -> Uncertainty {
    if half { Uncertainty::HalfStep } else { Uncertainty::None }
}

/// An edge within the guard band.
fn edge<F: Format>([ax, ay, bx, by]: [i32; 4]) -> Option<Edge<F>> {
    let vertex = |x, y| Vertex::<F>::new(x, y, 0).ok();
    Some(Edge::new(vertex(ax, ay)?, vertex(bx, by)?))
}

/// `Step::over` against the edge's value at the rectangle's first pixel and its two corners.
fn decides_by_the_corners<F: Format>(
    ends: [i32; 4],
    rule: Option<impl Rule<F>>,
    block: [u32; 2],
    blocks: [u32; 2],
) {
    let (Some(edge), Some(rule)) = (edge::<F>(ends), rule) else { return };
    let ([x0, y0], [width, height]) = (block.map(|at| 4 * at), blocks.map(|count| 4 * count));
    let Ok(rectangle) = Region::<F>::new(x0, y0, x0 + width, y0 + height) else { return };
    let value: i64 = edge.reduced(rule, x0, y0).into();
    let (lowest, highest) = corner_steps(edge.a(), edge.b(), width as i32, height as i32);
    let (lowest, highest) = (value + i64::from(lowest), value + i64::from(highest));
    match Step::over(edge, rule, rectangle) {
        None => assert!(highest < 0),
        Some(Step::DROPPED) => assert!(lowest >= 0),
        Some(step) => {
            assert!(lowest < 0 && highest >= 0);
            assert!(i64::from(step.value) == value && step.a == edge.a() && step.b == edge.b());
            let limit = Bounds::<F>::MAX_TILE_VALUE as i64;
            assert!(-limit <= lowest && highest <= limit);
        }
    }
    cover!(highest == -1);
    cover!(lowest == 0);
    cover!(lowest == -1 && highest > 1 << 16);
}

prove! {
    /// The corners' steps bound those of every pixel of a rectangle of up to 64 x 64 pixels; A and B are
    /// within `MAX_DELTA`. By columns and rows apart, with one product each: the sum of both is the
    /// corner's.
    [corner_steps]
    fn corners_bound_the_columns(a: i32 = -DELTA..=DELTA, width: i32 = 1..=64, column: i32 = 0..=63) {
        assume!(column < width);
        let (lowest, highest) = corner_steps(a, 0, width, 1);
        assert!(lowest <= column * a && column * a <= highest);
        cover!(column == width - 1 && lowest == column * a && lowest < 0);
    }

    /// The same for rows.
    [corner_steps]
    fn corners_bound_the_rows(b: i32 = -DELTA..=DELTA, height: i32 = 1..=64, row: i32 = 0..=63) {
        assume!(row < height);
        let (lowest, highest) = corner_steps(0, b, 1, height);
        assert!(lowest <= row * b && row * b <= highest);
        cover!(row == height - 1 && highest == row * b && highest > 0);
    }

    /// Both directions add up, so the corners are corners: nothing between them and the extremes.
    [corner_steps]
    fn corners_are_sums_of_both_directions(
        deltas: [i32; 2] = magnitudes(DELTA),
        sides: [i32; 2] = [1; 2]..=[64; 2],
    ) {
        let ([a, b], [width, height]) = (deltas, sides);
        let (lowest, highest) = corner_steps(a, b, width, height);
        let (left, right) = corner_steps(a, 0, width, 1);
        let (top, bottom) = corner_steps(0, b, 1, height);
        assert!(lowest == left + top && highest == right + bottom);
        assert!(i128::from(highest) - i128::from(lowest) <= Bounds::<Standard>::MAX_TILE_VALUE);
        assert!(left == 0 && right == (width - 1) * a || left == (width - 1) * a && right == 0);
    }

    /// An edge rejects a rectangle where its value at the trivial-reject corner is negative, accepts it
    /// where that at the other corner is not, and else its values at both corners, and so at all pixels,
    /// fit: nothing is lost by the reduction to 32 bits. Together with the corners' proofs, and with the
    /// one that a reduced value steps by A and B: trivial accept and reject are never wrong.
    [Step::over, corner_steps]
    fn an_edge_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Standard>::GUARD_BAND),
        sample: [i32; 2] = [0; 2]..=[255; 2],
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Standard>(ends, Sample::new(sample[0], sample[1]), block, blocks);
    }

    /// The same for the small format.
    [Step::over, corner_steps]
    fn a_small_edge_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Small>::GUARD_BAND),
        sample: [i32; 2] = [0; 2]..=[15; 2],
        block: [u32; 2] = [0; 2]..=[Small::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Small>(ends, Sample::new(sample[0], sample[1]), block, blocks);
    }

    /// The same with the rules of conservative coverage, at the corners of pixels: what is touched.
    [Step::over, corner_steps]
    fn slow_touching_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Standard>::GUARD_BAND),
        half: bool,
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Standard>(ends, Some(Touched(uncertainty(half))), block, blocks);
    }

    /// And what is inside.
    [Step::over, corner_steps]
    fn slow_containing_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Standard>::GUARD_BAND),
        half: bool,
        block: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Standard>(ends, Some(Inside(uncertainty(half))), block, blocks);
    }

    /// The same for the small format.
    [Step::over, corner_steps]
    fn slow_small_touching_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Small>::GUARD_BAND),
        half: bool,
        block: [u32; 2] = [0; 2]..=[Small::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Small>(ends, Some(Touched(uncertainty(half))), block, blocks);
    }

    /// And what is inside.
    [Step::over, corner_steps]
    fn small_containing_is_decided_by_its_corners(
        ends: [i32; 4] = magnitudes(Bounds::<Small>::GUARD_BAND),
        half: bool,
        block: [u32; 2] = [0; 2]..=[Small::MAX_TARGET / 4 - 1; 2],
        blocks: [u32; 2] = [1; 2]..=[16; 2],
    ) {
        decides_by_the_corners::<Small>(ends, Some(Inside(uncertainty(half))), block, blocks);
    }

    /// An edge so many columns and rows on is the edge there, exactly where it fits at the rectangle's corners, as
    /// it does where it is not dropped; one that is dropped stays so.
    [Step::after]
    fn an_edge_further_on_is_exact(
        value: i32 = -VALUE..=VALUE,
        a: i32 = -DELTA..=DELTA,
        b: i32 = -DELTA..=DELTA,
        from: [u32; 2] = [0; 2]..=[63; 2],
    ) {
        assert!(Step::DROPPED.after(from) == Step::DROPPED);
        let at = |x: u32, y: u32| {
            i64::from(value) + i64::from(x) * i64::from(a) + i64::from(y) * i64::from(b)
        };
        let fits = |x, y| at(x, y).abs() <= i64::from(VALUE);
        assume!(fits(63, 0) & fits(0, 63) & fits(63, 63));
        assume!(fits(from[0], 0) & fits(from[0], from[1]));
        let step = Step { value, a, b }.after(from);
        assert!(i64::from(step.value) == at(from[0], from[1]) && step.a == a && step.b == b);
        cover!(step.value < 0 && value > 0);
    }

    /// An edge's values in a block, relative to its first pixel: i A + j B in lane 4 j + i; the greatest
    /// of them at the trivial-reject corner; all within `MAX_BLOCK_STEPS`.
    #[kani::unwind(17)]
    [InBlock::of, corner_steps]
    fn a_blocks_lanes_are_the_steps_to_its_pixels(
        ends: [i32; 4] = magnitudes(Bounds::<Standard>::GUARD_BAND),
        column: i32 = 0..=3,
        row: i32 = 0..=3,
    ) {
        let Some(edge) = edge::<Standard>(ends) else { return };
        let block = InBlock::<ArrayLanes>::of((), edge);
        let mut lanes = [0; 16];
        block.lanes.store(&mut lanes);
        let steps = column * edge.a() + row * edge.b();
        assert!(lanes[(4 * row + column) as usize & 15] as i32 == steps && steps <= block.highest);
        assert!(i128::from(steps).abs() <= Bounds::<Standard>::MAX_BLOCK_STEPS);
        cover!(steps == block.highest && column == 3 && row == 0);
    }
}
