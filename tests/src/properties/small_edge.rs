//! All lines of small direction that cross a tile, drawn as an edge that is longer than the tile.

use crate::{
    Failure, Frame, ensure,
    frame::window_vertices,
    shapes::{Bezout, bezout},
};
use halfplane::{Bounds, Format, Region, Triangle, traverse};

/// Pixels on a side of a tile.
const TILE: u32 = 64;

/// The tile's first column and row: a multiple of its side.
const AT: u32 = 64;

/// For one direction `[dx, dy]`, without a common divisor, every line A x + B y + C = 0, A = -dy and B = dx,
/// that crosses or touches a square of pixels `first..end` in the tile, and one before and one after those:
/// the masks of the tile are where the edge function is positive, or 0 on a top or left edge. Returns the
/// number of lines; other directions have none.
///
/// Edges between lattice points on such a line have a multiple of that edge function. The line is drawn as the
/// hypotenuse of a right triangle whose other edges pass the tile at a distance.
pub fn every_line_along<F: Format>(direction: [i32; 2], pixels: [u32; 2]) -> Result<u64, Failure> {
    let [dx, dy] = direction.map(i64::from);
    let shape = Bezout { sample: [0, 0], direction: [dx, dy], middle: false, flip: false, slide: 0 };
    let [_, along, [u, v]] = bezout(shape);
    if along != [dx, dy] || dx == 0 && dy == 0 {
        return Ok(0);
    }
    let (a, b) = (-dy, dx);
    let frame = Frame::whole::<F>(AT + TILE, AT + TILE);
    let samples = pixels.map(|pixel| frame.sample_at::<F>((AT + pixel, AT + pixel))[0]);
    // A x + B y at the corners of the square.
    let corners = samples.map(|x| samples.map(|y| a * x + b * y));
    let values = corners.as_flattened();
    let (least, most) = (values.iter().min().copied(), values.iter().max().copied());
    let (Some(least), Some(most)) = (least, most) else { return Ok(0) };
    let constants = -most - 1..=-least + 1;
    for c in constants.clone() {
        // A u + B v = 1.
        let on_line = [-c * u, -c * v];
        line::<F>(&frame, [a, b, c], on_line)?;
    }
    Ok((constants.end() - constants.start() + 1) as u64)
}

/// One line through a lattice point.
fn line<F: Format>(frame: &Frame, [a, b, c]: [i64; 3], on_line: [i64; 2]) -> Result<(), Failure> {
    let (dx, dy) = (b, -a);
    let center = i64::from(AT + TILE / 2) << F::SUBPIXEL_BITS;
    // The lattice point of the line next to the tile's centre, and as many directions as fit half the guard
    // band.
    let [x, y] = on_line;
    let slide = ((center - x) * dx + (center - y) * dy).div_euclid(dx * dx + dy * dy);
    let [x, y] = [x + slide * dx, y + slide * dy];
    let count = i64::from(Bounds::<F>::GUARD_BAND / 2) / dx.abs().max(dy.abs());
    let point = |[u, v]: [i64; 2]| [(x + count * u) as i32, (y + count * v) as i32];
    let corners = [point([-dx, -dy]), point([dx, dy]), point([a, b])];
    let Some(triangle) = Triangle::new(window_vertices::<F>(&corners, [9; 3])?, frame.core_sample()?) else {
        return Err(Failure::new(format_args!("{corners:?} has no area")));
    };
    let mut given = [0u64; TILE as usize];
    traverse(&triangle, Region::new(AT, AT, AT + TILE, AT + TILE)?, |x, y, mask| {
        for row in 0..4 {
            given[(y - AT + row) as usize % 64] |= u64::from(mask.0 >> (4 * row) & 0xF) << (x - AT);
        }
    });
    // Whole numbers below 2^31, and E >= 1 is E > 0.
    let bound = i32::from(!(a > 0 || a == 0 && b > 0));
    let (step, first) = ((a << F::SUBPIXEL_BITS) as i32, frame.sample_at::<F>((AT, AT)));
    for (row, given) in (0..).zip(given) {
        let y = first[1] + (row << F::SUBPIXEL_BITS);
        let value = (a * first[0] + b * y + c) as i32;
        let expected =
            (0..64).fold(0, |bits, column| bits | u64::from(value + column * step >= bound) << column);
        ensure!(
            given == expected,
            "{a} x + {b} y + {c}, {corners:?}: row {row} of the tile is {given:#b}, expected {expected:#b}"
        );
    }
    Ok(())
}
