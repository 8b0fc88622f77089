//! One triangle in integers of unbounded size.

use num_bigint::{BigInt, Sign};
use num_traits::{ToPrimitive, Zero};

use super::Model;
use crate::Rational;

/// A model's numbers as whole multiples of powers of two, one for the positions and one for the matrix, so
/// that every product of them is a whole multiple of one power of two.
pub(super) struct Integers {
    position_bits: i32,
    matrix_bits: i32,
    matrix: [BigInt; 16],
    /// What a vertex's fourth component, 1, is as such a multiple.
    one: BigInt,
}

/// The signs and the order of a triangle's values at samples.
pub(super) struct Exact {
    /// Opposite each corner: the edge's value at a sample is the product with (x, y, w).
    edges: [[BigInt; 3]; 3],
    /// The depth times `determinant` and w.
    depth: [BigInt; 3],
    determinant: BigInt,
    /// All clip coordinates are multiples of 2 to this power.
    unit_bits: i32,
}

/// The exponent of a float's last bit, and the float as a multiple of it.
fn decode(value: f32) -> (i64, i32) {
    let bits = value.to_bits();
    let exponent = (bits >> 23 & 0xff) as i32;
    let fraction = i64::from(bits & 0x007f_ffff);
    let magnitude = if exponent == 0 { fraction } else { fraction | 1 << 23 };
    (if value.is_sign_negative() { -magnitude } else { magnitude }, exponent.max(1) - 150)
}

fn last_bit<'v>(values: impl Iterator<Item = &'v f32>) -> i32 {
    values.filter(|value| **value != 0.0).map(|&value| decode(value).1).min().unwrap_or(0)
}

fn multiple(value: f32, of: i32) -> BigInt {
    let (magnitude, exponent) = decode(value);
    if magnitude == 0 { BigInt::ZERO } else { BigInt::from(magnitude) << (exponent - of) }
}

impl Integers {
    pub(super) fn of(model: &Model<'_>) -> Self {
        let matrix_bits = last_bit(model.matrix.iter());
        let position_bits = last_bit(model.positions.as_flattened().iter()).min(0);
        Self {
            position_bits,
            matrix_bits,
            matrix: model.matrix.map(|value| multiple(value, matrix_bits)),
            one: BigInt::from(1) << -position_bits,
        }
    }

    pub(super) fn triangle(&self, corners: [[f32; 3]; 3]) -> Exact {
        let [a, b, c] = corners.map(|corner| self.clip(corner));
        let edges = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
        let determinant = dot(&edges[0], &[&a[0], &a[1], &a[3]]);
        let depth = [0, 1, 2].map(|k| &edges[0][k] * &a[2] + &edges[1][k] * &b[2] + &edges[2][k] * &c[2]);
        Exact { edges, depth, determinant, unit_bits: self.position_bits + self.matrix_bits }
    }

    fn clip(&self, position: [f32; 3]) -> [BigInt; 4] {
        let [x, y, z] = position.map(|value| multiple(value, self.position_bits));
        let m = &self.matrix;
        [0, 1, 2, 3].map(|k| &x * &m[k] + &y * &m[4 + k] + &z * &m[8 + k] + &self.one * &m[12 + k])
    }
}

/// Of the components x, y and w.
fn cross([ax, ay, _, aw]: &[BigInt; 4], [bx, by, _, bw]: &[BigInt; 4]) -> [BigInt; 3] {
    [ay * bw - aw * by, aw * bx - ax * bw, ax * by - ay * bx]
}

fn dot(a: &[BigInt; 3], b: &[&BigInt; 3]) -> BigInt {
    &a[0] * b[0] + &a[1] * b[1] + &a[2] * b[2]
}

fn nearest(numerator: BigInt, denominator: BigInt) -> f64 {
    Rational::new(numerator, denominator).to_f64().unwrap_or(f64::NAN)
}

fn at(plane: &[BigInt; 3], sample: [i64; 3]) -> BigInt {
    &plane[0] * sample[0] + &plane[1] * sample[1] + &plane[2] * sample[2]
}

impl Exact {
    /// The determinant's sign.
    pub(super) fn orientation(&self) -> i32 {
        match self.determinant.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    fn turned(&self, value: BigInt) -> BigInt {
        if self.determinant.sign() == Sign::Minus { -value } else { value }
    }

    /// Whether the triangle covers a sample, between the near and the far plane; for an orientation other
    /// than 0.
    pub(super) fn covers(&self, sample: [i64; 3]) -> bool {
        let inside = self.edges.iter().all(|edge| {
            let value = self.turned(at(edge, sample));
            match value.sign() {
                Sign::Plus => true,
                Sign::Minus => false,
                // On the edge: it counts where it is a left or a top edge, that is where its value grows to
                // the right, or, if level, downwards: against y.
                Sign::NoSign => match self.turned(edge[0].clone()).sign() {
                    Sign::Plus => true,
                    Sign::Minus => false,
                    Sign::NoSign => self.turned(edge[1].clone()).sign() == Sign::Minus,
                },
            }
        });
        let depth = || self.turned(at(&self.depth, sample));
        let far = || self.turned(self.determinant.clone()) * sample[2];
        inside && depth() >= BigInt::zero() && depth() <= far()
    }

    /// The depth at a sample, as the nearest float; for an orientation other than 0.
    pub(super) fn depth(&self, sample: [i64; 3]) -> f64 {
        nearest(at(&self.depth, sample), &self.determinant * sample[2])
    }

    /// 1/w at a sample, as the nearest float.
    pub(super) fn inverse_w(&self, sample: [i64; 3]) -> f64 {
        let sum: BigInt = self.edges.iter().map(|edge| at(edge, sample)).sum();
        let shift = |bits: i32| BigInt::from(1) << bits.max(0);
        let bits = self.unit_bits;
        nearest(sum * shift(-bits), &self.determinant * sample[2] * shift(bits))
    }

    /// Whether the depth at a sample is less than another triangle's there.
    pub(super) fn is_nearer(&self, than: &Self, sample: [i64; 3]) -> bool {
        let value = |of: &Self| of.turned(at(&of.depth, sample));
        let size = |of: &Self| of.turned(of.determinant.clone());
        value(self) * size(than) < value(than) * size(self)
    }
}
