//! All pairs of triangles with a common edge and corners on a small lattice.

use super::enumeration::Lattice;
use crate::{Failure, Frame, frame::window_vertices, shapes::doubled_area};
use halfplane::{Format, Region, Triangle, traverse};

/// Pixels on a side of the window that is looked at: a bit each in a [`Picture`].
const SIDE: u32 = 8;

/// Eight rows of eight pixels.
type Picture = u64;

/// A triangle on one side of the edge.
struct Neighbour {
    opposite: [i32; 2],
    covered: Picture,
    /// The samples strictly inside, by the signs of the edge functions.
    inside: Picture,
}

/// Every pair of triangles (p, q, r) and (p, q, s), p the point `first` and q, r, s any points of the
/// lattice: on opposite sides of the edge they cover each sample strictly inside their union once and none
/// twice; on the same side they both cover a sample strictly between p and q, or both do not. A triangle
/// without area covers nothing.
///
/// Every triangle is drawn once for its edge; every pair is compared. Returns the number of pairs, ordered.
/// The lattice, with a pixel round it, lies in the window of 8x8 pixels from `origin`, multiples of 4.
pub fn every_pair_from<F: Format>(lattice: Lattice, origin: [u32; 2], first: i32) -> Result<u64, Failure> {
    let [x, y] = origin;
    let region = [x, y, x + SIDE, y + SIDE];
    let frame = Frame { region, scissor: region, ..Frame::whole::<F>(x + SIDE, y + SIDE) };
    let p = lattice.point(first);
    let mut pairs = 0;
    for second in 0..lattice.points() {
        let q = lattice.point(second);
        let mut sides = [const { Vec::new() }; 2];
        let mut flat: u64 = 0;
        for third in 0..lattice.points() {
            let opposite = lattice.point(third);
            let corners = [p, q, opposite];
            let covered = covered::<F>(&frame, &corners)?;
            let inside = pixels(|pixel| strictly_inside(&corners, frame.sample_at::<F>(add(origin, pixel))));
            match doubled_area(&corners) {
                0 if covered == 0 => flat += 1,
                0 => return Err(failure(&corners, "has no area and covers", covered)),
                area => sides[usize::from(area < 0)].push(Neighbour { opposite, covered, inside }),
            }
        }
        let between = pixels(|pixel| strictly_between(p, q, frame.sample_at::<F>(add(origin, pixel))));
        let [left, right] = &sides;
        opposite_sides([p, q], left, right, between)?;
        for side in &sides {
            same_side([p, q], side, between)?;
        }
        let (left, right) = (left.len() as u64, right.len() as u64);
        pairs += 2 * left * right + left * left + right * right + flat * (flat + 2 * (left + right));
    }
    Ok(pairs)
}

/// Each sample strictly inside the union once, none twice.
fn opposite_sides(
    [p, q]: [[i32; 2]; 2],
    left: &[Neighbour],
    right: &[Neighbour],
    between: Picture,
) -> Result<(), Failure> {
    for a in left {
        let wrong = |b: &Neighbour| {
            let inside = a.inside | b.inside | between;
            a.covered & b.covered | inside & !(a.covered | b.covered)
        };
        // All at once: only what is wrong is looked for.
        if right.iter().fold(0, |all, b| all | wrong(b)) != 0
            && let Some(b) = right.iter().find(|b| wrong(b) != 0)
        {
            return Err(failure(&[p, q, a.opposite, b.opposite], "not once", wrong(b)));
        }
    }
    Ok(())
}

/// The samples between p and q belong to both or to neither.
fn same_side([p, q]: [[i32; 2]; 2], side: &[Neighbour], between: Picture) -> Result<(), Failure> {
    for a in side {
        let wrong = |b: &Neighbour| (a.covered ^ b.covered) & between;
        if side.iter().fold(0, |all, b| all | wrong(b)) != 0
            && let Some(b) = side.iter().find(|b| wrong(b) != 0)
        {
            return Err(failure(&[p, q, a.opposite, b.opposite], "by one alone", wrong(b)));
        }
    }
    Ok(())
}

fn failure(points: &[[i32; 2]], what: &str, picture: Picture) -> Failure {
    let rows: Vec<String> = picture.to_le_bytes().iter().map(|row| format!("{row:08b}")).collect();
    Failure::new(format_args!("{points:?} {what}, rows from the top, leftmost pixel last: {rows:?}"))
}

fn add([x, y]: [u32; 2], (column, row): (u32, u32)) -> (u32, u32) {
    (x + column, y + row)
}

/// The pixels of the window that have a property.
fn pixels(has: impl Fn((u32, u32)) -> bool) -> Picture {
    (0..SIDE * SIDE).fold(0, |picture, bit| picture | u64::from(has((bit % SIDE, bit / SIDE))) << bit)
}

/// The core's coverage, by the level below `draw`.
fn covered<F: Format>(frame: &Frame, corners: &[[i32; 2]; 3]) -> Result<Picture, Failure> {
    let [x0, y0, x1, y1] = frame.region;
    let mut picture = 0;
    if let Some(triangle) = Triangle::new(window_vertices::<F>(corners, [9; 3])?, frame.core_sample()?) {
        traverse(&triangle, Region::new(x0, y0, x1, y1)?, |x, y, mask| {
            for (row, nibble) in (0..4).map(|row| (row, u64::from(mask.0 >> (4 * row) & 0xF))) {
                picture |= nibble << ((y - y0 + row) * SIDE + (x - x0));
            }
        });
    }
    Ok(picture)
}

/// Whether a point is on the inner side of all three edges and on none of them.
fn strictly_inside(corners: &[[i32; 2]; 3], [x, y]: [i64; 2]) -> bool {
    let [a, b, c] = corners.map(|[u, v]| [i64::from(u) - x, i64::from(v) - y]);
    let cross = |[u, v]: [i64; 2], [s, t]: [i64; 2]| (u * t - v * s).signum();
    let signs = cross(a, b) + cross(b, c) + cross(c, a);
    signs == 3 || signs == -3
}

/// Whether a point is on the line through p and q and between them.
fn strictly_between(p: [i32; 2], q: [i32; 2], [x, y]: [i64; 2]) -> bool {
    let [[px, py], [qx, qy]] = [p, q].map(|[u, v]| [i64::from(u) - x, i64::from(v) - y]);
    px * qy == py * qx && px * qx + py * qy < 0
}
