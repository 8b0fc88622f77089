//! The exact depth of a triangle at samples, as fractions of 128-bit integers.

use crate::{Fraction, Grid};

/// The exact depth of a triangle, linear on the screen, in the unit of its corners' integers.
///
/// The fast form of [`depth_at`](crate::depth_at): at a sample, each corner's weight is a doubled
/// area, the depth is the weighted sum of the corners' depths over the triangle's doubled area. Exact for
/// every `i32` coordinate, `u32` depth and `u32` pixel: doubled areas with a sample are below 2^83 and the
/// sum of three products with a depth below 2^117.
#[derive(Clone, Copy, Debug)]
pub struct ExactPlane {
    grid: Grid,
    xy: [[i128; 2]; 3],
    z: [i128; 3],
    doubled_area: i128,
    step_x: i128,
}

impl ExactPlane {
    /// A triangle with corners in sub-pixel steps and depths at them; `None` if it has no area.
    pub fn new(xy: &[[i32; 2]; 3], z: &[u32; 3], grid: Grid) -> Option<Self> {
        let mut xy = xy.map(|corner| corner.map(i128::from));
        let mut z = z.map(i128::from);
        let mut doubled_area = doubled(xy[0], xy[1], xy[2]);
        if doubled_area < 0 {
            xy.swap(1, 2);
            z.swap(1, 2);
            doubled_area = -doubled_area;
        }
        let mut plane = ExactPlane { grid, xy, z, doubled_area, step_x: 0 };
        plane.step_x = plane.numerator(1, 0) - plane.numerator(0, 0);
        (doubled_area > 0).then_some(plane)
    }

    /// Twice the triangle's area in square steps: positive, below 2^66; the denominator of every depth.
    pub fn doubled_area(&self) -> i128 {
        self.doubled_area
    }

    /// The exact depth at a pixel's sample.
    pub fn at(&self, x: u32, y: u32) -> Fraction {
        // The area is positive by construction, so the default is never taken.
        Fraction::new(self.numerator(x, y), self.doubled_area).unwrap_or(Fraction::ZERO)
    }

    /// Depths along a row, from a pixel's sample to the right: their integer parts and remainders.
    pub(crate) fn walk(&self, x: u32, y: u32) -> Walk {
        let (numerator, denominator) = (self.numerator(x, y), self.doubled_area);
        Walk {
            whole: numerator.div_euclid(denominator),
            rest: numerator.rem_euclid(denominator),
            step_whole: self.step_x.div_euclid(denominator),
            step_rest: self.step_x.rem_euclid(denominator),
            denominator,
        }
    }

    fn numerator(&self, x: u32, y: u32) -> i128 {
        let (x, y) = self.grid.sample_at(x, y);
        let sample = [i128::from(x), i128::from(y)];
        let [a, b, c] = self.xy;
        doubled(b, c, sample) * self.z[0]
            + doubled(c, a, sample) * self.z[1]
            + doubled(a, b, sample) * self.z[2]
    }
}

/// Twice the signed area of a triangle.
fn doubled(a: [i128; 2], b: [i128; 2], p: [i128; 2]) -> i128 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// A mixed number that moves by a constant, exactly: no division per sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walk {
    whole: i128,
    rest: i128,
    step_whole: i128,
    step_rest: i128,
    denominator: i128,
}

impl Walk {
    /// The integer part of the depth here.
    pub(crate) fn whole(&self) -> i128 {
        self.whole
    }

    /// What the depth here has above its integer part, at least 0 and below 1.
    pub(crate) fn rest(&self) -> Fraction {
        Fraction::new(self.rest, self.denominator).unwrap_or(Fraction::ZERO)
    }

    /// One pixel to the right.
    pub(crate) fn advance(&mut self) {
        self.whole += self.step_whole;
        self.rest += self.step_rest;
        if self.rest >= self.denominator {
            self.rest -= self.denominator;
            self.whole += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use proptest::test_runner::Config;

    use super::*;

    proptest! {
        #![proptest_config(Config { failure_persistence: None, ..Config::default() })]

        #[test]
        fn a_walk_is_the_plane_at_every_step(
            xy in any::<[[i32; 2]; 3]>(), small in 0..31_u32, z in any::<[u32; 3]>(), flat in 0..31_u32,
            bits in 0..9_u32, at in any::<(u32, u32)>(),
        ) {
            // Small ones make remainders that are often 0, where a carry is decided.
            let xy = xy.map(|corner| corner.map(|v| v >> small));
            let z = z.map(|z| z >> flat);
            let grid = Grid::new(bits, (0, 0)).unwrap();
            let Some(plane) = ExactPlane::new(&xy, &z, grid) else { return Ok(()) };
            let (x, y) = (at.0 >> 16, at.1 >> 16);
            let mut walk = plane.walk(x, y);
            for x in x..x + 20 {
                let depth = plane.at(x, y);
                prop_assert_eq!(walk.whole(), depth.floor());
                let rest = Fraction::new(depth.numerator() - depth.floor() * depth.denominator(), depth.denominator());
                prop_assert_eq!(Some(walk.rest()), rest);
                walk.advance();
            }
        }
    }
}
