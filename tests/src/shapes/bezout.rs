//! Triangles whose doubled area is 1 or 2 square steps, with a sample exactly on the outline.
//!
//! Ordinary random triangles almost never catch a wrong edge function or fill rule; these do.

use super::{Corners, numbers::pick};

/// What to construct.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bezout {
    /// The sample, in steps.
    pub sample: [i64; 2],
    /// The direction of the edge through the sample; made primitive, (1, 0) where it is 0.
    pub direction: [i64; 2],
    /// Doubled area 2 with the sample in the middle of an edge, or 1 with the sample at a corner.
    pub middle: bool,
    /// Which side of the edge the third corner is on.
    pub flip: bool,
    /// Slides the third corner along the edge by so many primitive directions.
    pub slide: i64,
}

/// The corners: a = s - d (or s), b = s + d, and c at the least distance from the line there is, from
/// Bezout's identity: with d = (x, y) primitive, there are (u, v) with x v - y u = 1, found by the
/// extended Euclidean algorithm.
pub fn bezout(shape: Bezout) -> [[i64; 2]; 3] {
    let Bezout { sample: [sx, sy], direction: [dx, dy], middle, flip, slide } = shape;
    let (gcd, p, q) = extended_gcd(dx, dy);
    let ([x, y], [p, q]) = if gcd == 0 { ([1, 0], [1, 0]) } else { ([dx / gcd, dy / gcd], [p, q]) };
    // x p + y q = 1, so (u, v) = (-q, p) has x v - y u = 1.
    let sign = if flip { -1 } else { 1 };
    let (u, v) = (-q * sign + slide * x, p * sign + slide * y);
    let back = i64::from(middle);
    [[sx - back * x, sy - back * y], [sx + x, sy + y], [sx + u, sy + v]]
}

/// The greatest common divisor g >= 0 of a and b, and (p, q) with a p + b q = g.
fn extended_gcd(a: i64, b: i64) -> (i64, i64, i64) {
    let (mut r0, mut r1, mut p0, mut p1, mut q0, mut q1) = (a, b, 1, 0, 0, 1);
    while r1 != 0 {
        let quotient = r0 / r1;
        (r0, r1) = (r1, r0 - quotient * r1);
        (p0, p1) = (p1, p0 - quotient * p1);
        (q0, q1) = (q1, q0 - quotient * q1);
    }
    if r0 < 0 { (-r0, -p0, -q0) } else { (r0, p0, q0) }
}

/// [`bezout`] from any numbers, near a sample; directions up to `reach` steps.
pub(super) fn from_numbers(sample: [i64; 2], reach: i64, numbers: [u32; 6]) -> [[i64; 2]; 3] {
    let [dx, dy, middle, flip, slide, scale] = numbers;
    // Short directions as well as long ones.
    let reach = (reach >> (scale % 16)).max(2);
    bezout(Bezout {
        sample,
        direction: [pick(dx, -reach, reach), pick(dy, -reach, reach)],
        middle: !middle.is_multiple_of(4),
        flip: flip % 2 == 1,
        slide: pick(slide, -1, 1),
    })
}

/// `Corners` with every coordinate inside the guard band.
pub(super) fn clamped<F: halfplane::Format>(corners: [[i64; 2]; 3]) -> Corners {
    corners.map(|corner| corner.map(crate::frame::into_guard_band::<F>))
}
