//! A tile of 64x64 pixels and its sixteen squares of 16x16, one in each lane.

use super::{
    mask::Mask,
    step::{Step, corner_steps},
};
use crate::{
    geometry::{HalfPlanes, Region, Rule},
    lanes::Lanes,
    numbers::Format,
};

/// Pixels in a tile's width and height.
pub(super) const TILE: u32 = 64;

/// Pixels in a square's width and height.
pub(super) const SQUARE: u32 = TILE / 4;

/// Visits the squares of the tile at (`x`, `y`), multiples of 64, that no edge rejects, row by row, with
/// the edges over each. A square is given as its whole blocks that are in `blocks`, itself whole blocks; it
/// is visited if there are any.
#[inline(always)]
pub(super) fn squares<L: Lanes, F: Format, R: Rule<F>>(
    token: L::Token,
    half_planes: HalfPlanes<F, R>,
    blocks: Region<F>,
    [x, y]: [u32; 2],
    mut visit: impl FnMut(Region<F>, [Step; 3]),
) {
    let Ok(tile) = Region::new(x, y, x.saturating_add(TILE), y.saturating_add(TILE)) else { return };
    let Some(steps) = Step::all(half_planes, tile) else { return };
    // Per edge: the squares that it rejects, those it accepts, and its values there.
    let mut rejected = 0;
    let mut accepted = [0; 3];
    let mut values = [[0; 16]; 3];
    for ((step, accepted), values) in steps.iter().zip(&mut accepted).zip(&mut values) {
        let (rejects, accepts) = classify::<L>(token, *step, values);
        rejected |= rejects;
        *accepted = accepts;
    }
    for (column, row) in Mask(!rejected).cells() {
        let (left, top) = (x + column * SQUARE, y + row * SQUARE);
        let Some(square) = blocks.cut(left, top, left + SQUARE, top + SQUARE) else { continue };
        let lane = (4 * row + column) as usize & 15;
        // A square that begins inside the blocks is entered there.
        let (columns, rows) = ((square.x0() - left) as i32, (square.y0() - top) as i32);
        let mut inside = steps;
        for ((step, accepted), values) in inside.iter_mut().zip(accepted).zip(&values) {
            if accepted >> lane & 1 != 0 {
                *step = Step::DROPPED;
            } else {
                step.value = values[lane] as i32 + (columns * step.a + rows * step.b);
            }
        }
        visit(square, inside);
    }
}

/// The squares that an edge over a tile rejects, and those it accepts; its values at their first pixels.
#[inline(always)]
pub(super) fn classify<L: Lanes>(token: L::Token, step: Step, values: &mut [u32; 16]) -> (u16, u16) {
    let side = SQUARE as i32;
    let first = L::ramp(token, step.value, side * step.a, side * step.b);
    let (lowest, highest) = corner_steps(step.a, step.b, side, side);
    first.store(values);
    (first.add(L::splat(token, highest as u32)).signs(), !first.add(L::splat(token, lowest as u32)).signs())
}
