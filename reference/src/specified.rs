//! The written definition of a stored depth: an integer for every sample, the same on every machine.
//!
//! With `z` in units of the plane's word (H fraction bits above it), S sub-pixel bits, K stored bits:
//!
//! * anchor: the corner with the smallest y, of those the smallest x; the other two in the order that
//!   makes the doubled area D positive (so the order of the corners never changes a bit);
//! * gradient per sub-pixel step: the integer nearest to `2^H N / D`, ties up, in x and in y;
//! * base: the plane's value at the first sample of the pixel's 4x4 block, blocks counted from the
//!   target's origin, rounded to K bits; offset: from there to the pixel's sample, rounded to K bits;
//! * depth: base plus offset, modulo 2^K. Rounding is to nearest, ties up.
//!
//! A triangle's 16-bit depth with a 32-bit plane uses corners of `z 2^16`.
//!
//! [`specified_depth`] is this, word for word, in unbounded integers. [`SpecifiedPlane`] is the same in
//! 128 bits, checked, for pictures. Neither reduces anything before the end.

use std::error::Error;
use std::fmt;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

use crate::rational::nearest_ties_up;
use crate::{Grid, Rational};

/// A format of stored depth: K stored bits, computed with H fraction bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthSpec {
    bits: u32,
    half_word: u32,
}

/// There is no such depth format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DepthSpecError {
    /// Stored bits asked for.
    pub bits: u32,
    /// Fraction bits asked for.
    pub half_word: u32,
}

impl fmt::Display for DepthSpecError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "no depth format of {} bits with {} fraction bits: 32 with 32, 16 with 32 and 16 with 16 are",
            self.bits, self.half_word
        )
    }
}

impl Error for DepthSpecError {}

impl DepthSpec {
    /// 32-bit depth, 32 fraction bits.
    pub const D32: DepthSpec = DepthSpec { bits: 32, half_word: 32 };
    /// 16-bit depth, 32 fraction bits.
    pub const D16: DepthSpec = DepthSpec { bits: 16, half_word: 32 };
    /// 16-bit depth, 16 fraction bits: the format for small targets.
    pub const SMALL: DepthSpec = DepthSpec { bits: 16, half_word: 16 };

    /// K stored bits with H fraction bits.
    ///
    /// # Errors
    /// [`DepthSpecError`] for other pairs than (32, 32), (16, 32) and (16, 16).
    pub fn new(bits: u32, half_word: u32) -> Result<Self, DepthSpecError> {
        match (bits, half_word) {
            (32, 32) | (16, 32) | (16, 16) => Ok(DepthSpec { bits, half_word }),
            _ => Err(DepthSpecError { bits, half_word }),
        }
    }

    /// K, stored bits: 32 or 16.
    pub fn bits(self) -> u32 {
        self.bits
    }

    /// H, fraction bits of the gradients: 32 or 16.
    pub fn half_word(self) -> u32 {
        self.half_word
    }

    /// The largest stored value, 2^K - 1: the farthest.
    pub fn farthest(self) -> u32 {
        u32::MAX >> (32 - self.bits)
    }

    /// A corner's depth moved into `2..=2^K - 3`, where every vertex of this rasterizer has it: so no
    /// rounding leaves the format.
    pub fn keep(self, z: u32) -> u32 {
        z.clamp(2, self.farthest() - 2)
    }

    /// How far a stored depth may be from the exact one, in stored units, as numerator and denominator:
    /// 1.01, and 1.5 for [`DepthSpec::SMALL`], inside the coordinate ranges of its formats (2^23 steps
    /// of 2^-8 px; 2^14 steps of 2^-4 px).
    pub fn bound(self) -> (i128, i128) {
        if self.half_word == 16 { (150, 100) } else { (101, 100) }
    }

    /// What a corner's depth is multiplied by before the plane is set up: 2^(word - K).
    fn scale_bits(self) -> u32 {
        self.half_word.saturating_sub(self.bits)
    }

    /// Bits below a stored unit in a plane's value.
    fn fraction_bits(self) -> u32 {
        2 * self.half_word - self.bits
    }
}

/// The 16-bit depth of a vertex from its 32-bit one: nearest to `z 65535 / (2^32 - 1)`, ties up, kept
/// within `2..=65533`.
pub fn z16_from_z32(z: u32) -> u16 {
    let (scaled, whole) = (u64::from(z) * 65_535, u64::from(u32::MAX));
    let nearest = (2 * scaled + whole) / (2 * whole);
    u16::try_from(nearest.clamp(2, 65_533)).unwrap_or(65_533)
}

/// The stored depth of a triangle at a pixel's sample, from the definition; `None` without area.
///
/// `xy` in sub-pixel steps, `z` in units of 2^-K, taken as they are (see [`DepthSpec::keep`]). Defined
/// for every pixel; only where the triangle covers the sample is it near the exact depth.
pub fn specified_depth(
    xy: &[[i32; 2]; 3],
    z: &[u32; 3],
    grid: Grid,
    spec: DepthSpec,
    pixel: (u32, u32),
) -> Option<u32> {
    let mut order = [0, 1, 2];
    order.sort_by_key(|&i| (xy[i][1], xy[i][0]));
    let corner = |i: usize| {
        let [x, y]: [i32; 2] = xy[order[i]];
        (BigInt::from(x), BigInt::from(y), BigInt::from(z[order[i]]) << spec.scale_bits())
    };
    let ((x0, y0, z0), (mut x1, mut y1, mut z1), (mut x2, mut y2, mut z2)) =
        (corner(0), corner(1), corner(2));
    let doubled_area = |x1: &BigInt, y1: &BigInt, x2: &BigInt, y2: &BigInt| {
        (x1 - &x0) * (y2 - &y0) - (x2 - &x0) * (y1 - &y0)
    };
    let mut d = doubled_area(&x1, &y1, &x2, &y2);
    if d < BigInt::ZERO {
        ((x1, y1, z1), (x2, y2, z2)) = ((x2, y2, z2), (x1, y1, z1));
        d = doubled_area(&x1, &y1, &x2, &y2);
    }
    if d == BigInt::ZERO {
        return None;
    }
    let (dz1, dz2) = (&z1 - &z0, &z2 - &z0);
    let nx = &dz1 * (&y2 - &y0) - &dz2 * (&y1 - &y0);
    let ny = &dz2 * (&x1 - &x0) - &dz1 * (&x2 - &x0);
    let gradient = |n: BigInt| nearest_ties_up(&Rational::new(n << spec.half_word, d.clone()));
    let (gx, gy) = (gradient(nx), gradient(ny));

    let (block_x, block_y) = (pixel.0 / 4 * 4, pixel.1 / 4 * 4);
    let (first_x, first_y) = grid.sample_at(block_x, block_y);
    let (sample_x, sample_y) = grid.sample_at(pixel.0, pixel.1);
    let base = (z0 << spec.half_word) + &gx * (first_x - &x0) + &gy * (first_y - &y0);
    let offset = gx * (sample_x - first_x) + gy * (sample_y - first_y);

    let stored = |v: BigInt| nearest_ties_up(&Rational::new(v, BigInt::from(1) << spec.fraction_bits()));
    (stored(base) + stored(offset)).mod_floor(&(BigInt::from(1) << spec.bits)).to_u32()
}

/// The stored depths of one triangle: [`specified_depth`], fast.
///
/// Gradients fit 128 bits for every input; where a base does not, the definition is asked instead, so
/// the answer is the same for every input.
#[derive(Clone, Debug)]
pub struct SpecifiedPlane {
    xy: [[i32; 2]; 3],
    z: [u32; 3],
    grid: Grid,
    spec: DepthSpec,
    anchor: [i128; 3],
    gradient: [i128; 2],
    offsets: [i128; 16],
}

impl SpecifiedPlane {
    /// A triangle with corners in sub-pixel steps and depths in units of 2^-K, taken as they are (see
    /// [`DepthSpec::keep`]); `None` if it has no area.
    pub fn new(xy: &[[i32; 2]; 3], z: &[u32; 3], grid: Grid, spec: DepthSpec) -> Option<Self> {
        let mut corners = [0, 1, 2].map(|i| {
            let [x, y] = xy[i].map(i128::from);
            (y, x, i128::from(z[i]) << spec.scale_bits())
        });
        corners.sort_unstable_by_key(|&(y, x, _)| (y, x));
        let [(y0, x0, z0), first, second] = corners;
        let relative = |(y, x, z): (i128, i128, i128)| (x - x0, y - y0, z - z0);
        let ((mut bx, mut by, mut bz), (mut cx, mut cy, mut cz)) = (relative(first), relative(second));
        let mut d = bx * cy - cx * by;
        if d == 0 {
            return None;
        }
        if d < 0 {
            ((bx, by, bz), (cx, cy, cz)) = ((cx, cy, cz), (bx, by, bz));
            d = -d;
        }
        // |N| <= 2^65 (32-bit differences of depth and of place), so 2 (N << H) + D is below 2^99.
        let gradient =
            [bz * cy - cz * by, cz * bx - bz * cx].map(|n| (2 * (n << spec.half_word) + d).div_euclid(2 * d));
        let mut offsets = [0; 16];
        for (lane, offset) in offsets.iter_mut().enumerate() {
            let (column, row) = (lane as i128 % 4, lane as i128 / 4);
            *offset = stored((gradient[0] * column + gradient[1] * row) << grid.subpixel_bits(), spec);
        }
        Some(SpecifiedPlane { xy: *xy, z: *z, grid, spec, anchor: [x0, y0, z0], gradient, offsets })
    }

    /// The stored depth at a pixel's sample.
    pub fn at(&self, x: u32, y: u32) -> u32 {
        self.in_block(self.block(x, y), x, y)
    }

    /// The rounded base of the pixel's 4x4 block, where it can be had in 128 bits.
    pub(crate) fn block(&self, x: u32, y: u32) -> Option<i128> {
        let (first_x, first_y) = self.grid.sample_at(x / 4 * 4, y / 4 * 4);
        let [x0, y0, z0] = self.anchor;
        let along_x = self.gradient[0].checked_mul(i128::from(first_x) - x0)?;
        let along_y = self.gradient[1].checked_mul(i128::from(first_y) - y0)?;
        let base = (z0 << self.spec.half_word).checked_add(along_x)?.checked_add(along_y)?;
        base.checked_add(1 << self.spec.fraction_bits())?; // room for the rounding
        Some(stored(base, self.spec))
    }

    /// The stored depth at a pixel whose block has this base.
    pub(crate) fn in_block(&self, base: Option<i128>, x: u32, y: u32) -> u32 {
        let lane = (y % 4 * 4 + x % 4) as usize;
        let reduced = base
            .and_then(|base| base.checked_add(self.offsets[lane]))
            .and_then(|sum| u32::try_from(sum & i128::from(self.spec.farthest())).ok());
        // A plane has area, so the definition has an answer.
        reduced.unwrap_or_else(|| {
            specified_depth(&self.xy, &self.z, self.grid, self.spec, (x, y)).unwrap_or(self.spec.farthest())
        })
    }
}

/// A plane's value in stored units: nearest, ties up.
fn stored(value: i128, spec: DepthSpec) -> i128 {
    (value + (1 << (spec.fraction_bits() - 1))) >> spec.fraction_bits()
}
