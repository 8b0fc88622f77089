//! Conservative coverage by strips of rows in integers: the fast form of [`HalfOpen`](crate::HalfOpen).
//!
//! What a convex set has of a row, a strip between two horizontal lines, is as wide as its corners in the strip
//! and its crossings of the two lines are; what it has of all heights in the strip is between both crossings.
//! Unlike samples, strips have ends that belong to them and ends that do not.

use std::ops::Range;

use crate::grid::{ceil_div, clamp_to};
use crate::{Fraction, Rect};

/// A closed triangle over pixel rows, in half steps.
struct Strips {
    corners: [[i128; 2]; 3],
    /// A pixel.
    pixel: i128,
    /// By how much the triangle is grown, or shrunk.
    grown: i128,
}

/// Where one of the triangle's edges, all of them closed segments, meets a horizontal line.
fn crossings(corners: &[[i128; 2]; 3], y: i128) -> Vec<Fraction> {
    let mut all = Vec::new();
    for k in 0..3 {
        let (mut a, mut b) = (corners[k], corners[(k + 1) % 3]);
        if a[1] > b[1] {
            (a, b) = (b, a);
        }
        let ([xa, ya], [xb, yb]) = (a, b);
        if ya <= y && y <= yb {
            if ya == yb {
                all.extend([Fraction::new(xa, 1), Fraction::new(xb, 1)]);
            } else {
                all.push(Fraction::new(xa * (yb - ya) + (xb - xa) * (y - ya), yb - ya));
            }
        }
    }
    all.into_iter().flatten().collect()
}

impl Strips {
    fn new(xy: &[[i32; 2]; 3], subpixel_bits: u32, half_steps: u32) -> Self {
        Strips {
            corners: xy.map(|corner| corner.map(|v| 2 * i128::from(v))),
            pixel: 2 << subpixel_bits,
            grown: half_steps.into(),
        }
    }

    /// The row's first line and the one that ends it, moved outwards by what the triangle is grown by: instead.
    fn lines(&self, row: u32) -> (i128, i128) {
        (i128::from(row) * self.pixel - self.grown, (i128::from(row) + 1) * self.pixel + self.grown)
    }

    /// The columns that are touched in a row, of any.
    fn touched(&self, row: u32) -> Option<(i128, i128)> {
        let (first, end) = self.lines(row);
        // With each x whether its height is in the strip, and not only at its end.
        let mut reached: Vec<(Fraction, bool)> = Vec::new();
        let corners = self.corners.iter().filter(|[_, y]| first <= *y && *y <= end);
        reached.extend(corners.filter_map(|&[x, y]| Some((Fraction::new(x, 1)?, y < end))));
        reached.extend(crossings(&self.corners, first).into_iter().map(|x| (x, true)));
        reached.extend(crossings(&self.corners, end).into_iter().map(|x| (x, false)));
        if !reached.iter().any(|&(_, is_in)| is_in) {
            return None;
        }
        let left = reached.iter().map(|&(x, _)| x).min()?;
        let right = reached.iter().map(|&(x, _)| x).max()?;
        let is_attained = reached.iter().any(|&(x, is_in)| is_in && x == right);
        let in_pixels =
            |x: Fraction, by: i128| (x.numerator() + by * x.denominator(), self.pixel * x.denominator());
        // A column is touched where left < its end and right >= its start, or > where the right is not attained.
        let (n, d) = in_pixels(left, -self.grown);
        let first = n.div_euclid(d);
        let (n, d) = in_pixels(right, self.grown);
        Some((first, if is_attained { n.div_euclid(d) + 1 } else { ceil_div(n, d) }))
    }

    /// The columns that are inside in a row, of any.
    fn inside(&self, row: u32) -> Option<(i128, i128)> {
        let [[xa, ya], [xb, yb], [xc, yc]] = self.corners;
        if (xb - xa) * (yc - ya) == (xc - xa) * (yb - ya) {
            return None;
        }
        let (first, end) = self.lines(row);
        let (above, below) = (crossings(&self.corners, first), crossings(&self.corners, end));
        let left = above.iter().min()?.max(below.iter().min()?);
        let right = above.iter().max()?.min(below.iter().max()?);
        let first = left.numerator() + self.grown * left.denominator();
        let end = right.numerator() - self.grown * right.denominator();
        Some((
            ceil_div(first, self.pixel * left.denominator()),
            end.div_euclid(self.pixel * right.denominator()),
        ))
    }
}

fn rows(rect: Rect, columns: impl Fn(u32) -> Option<(i128, i128)>, mut row: impl FnMut(u32, Range<u32>)) {
    for y in rect.y0..rect.y1 {
        let Some((first, end)) = columns(y) else { continue };
        let columns = clamp_to(first, rect.x0, rect.x1)..clamp_to(end, rect.x0, rect.x1);
        if !columns.is_empty() {
            row(y, columns);
        }
    }
}

/// Calls `row(y, x0..x1)` for every row of the rectangle in which the closed triangle, grown by a square of
/// that half-size, touches pixels, top down, with the (never empty) interval of touched columns.
///
/// `xy` in sub-pixel steps: any `i32`; at most 16 sub-pixel bits. Exact: numerators stay below 2^100.
pub fn touch_rows(
    xy: &[[i32; 2]; 3],
    subpixel_bits: u32,
    half_steps: u32,
    rect: Rect,
    row: impl FnMut(u32, Range<u32>),
) {
    let strips = Strips::new(xy, subpixel_bits, half_steps);
    rows(rect, |y| strips.touched(y), row);
}

/// The same for the pixels that lie wholly in the triangle, shrunk by that square.
pub fn inside_rows(
    xy: &[[i32; 2]; 3],
    subpixel_bits: u32,
    half_steps: u32,
    rect: Rect,
    row: impl FnMut(u32, Range<u32>),
) {
    let strips = Strips::new(xy, subpixel_bits, half_steps);
    rows(rect, |y| strips.inside(y), row);
}
