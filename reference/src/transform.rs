//! The exact transform: clip space to window coordinates in rationals, then one rounding.
//!
//! Clip space: x right, y **up**, `0 <= z <= w`, `w > 0` in front of the eye. Window: y **down**.

use std::error::Error;
use std::fmt;

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::rational::{from_f32, nearest_ties_even, nearest_ties_up};
use crate::{Point, Rational};

/// Which of the two depth planes cut a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Planes {
    /// Keep `z >= 0`.
    pub near: bool,
    /// Keep `z <= w`.
    pub far: bool,
}

impl Planes {
    /// Both planes, as depth clip does. What is left has `w >= 0`.
    pub const BOTH: Planes = Planes { near: true, far: true };
    /// Only `z >= 0`.
    pub const NEAR: Planes = Planes { near: true, far: false };
}

/// Why a triangle has no exact clipped form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipError {
    /// A component is NaN or infinite.
    NonFinite {
        /// Which corner, 0 to 2.
        corner: usize,
        /// Which component, 0 to 3 for x, y, z, w.
        component: usize,
    },
}

impl fmt::Display for ClipError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ClipError::NonFinite { corner, component } = self;
        write!(f, "component {component} of corner {corner} is not a finite number")
    }
}

impl Error for ClipError {}

/// Clips a triangle of clip space at the chosen depth planes, exactly and before any division.
///
/// The answer is a convex polygon of exact homogeneous vertices (x, y, z, w) in the triangle's order:
/// empty, or with 3 to 5 vertices, of which neighbours may coincide where a corner lies on a plane.
/// A triangle that needs no clipping comes back as it is.
///
/// # Errors
/// [`ClipError::NonFinite`] where a component is NaN or infinite.
pub fn clip(triangle: [[f32; 4]; 3], planes: Planes) -> Result<Vec<[Rational; 4]>, ClipError> {
    let mut polygon = Vec::with_capacity(5);
    for (corner, vertex) in triangle.iter().enumerate() {
        let mut exact = Vec::with_capacity(4);
        for (component, &value) in vertex.iter().enumerate() {
            exact.push(from_f32(value).ok_or(ClipError::NonFinite { corner, component })?);
        }
        polygon.extend(<[Rational; 4]>::try_from(exact));
    }
    if planes.near {
        polygon = cut(&polygon, |v| v[2].clone());
    }
    if planes.far {
        polygon = cut(&polygon, |v| &v[3] - &v[2]);
    }
    Ok(polygon)
}

/// Keeps where `inside`, a linear function of the homogeneous vertex, is at least 0.
fn cut(polygon: &[[Rational; 4]], inside: impl Fn(&[Rational; 4]) -> Rational) -> Vec<[Rational; 4]> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, a) in polygon.iter().enumerate() {
        let b = &polygon[(i + 1) % polygon.len()];
        let (at_a, at_b) = (inside(a), inside(b));
        if !at_a.is_negative() {
            kept.push(a.clone());
        }
        if at_a.is_negative() != at_b.is_negative() {
            let along = &at_a / (&at_a - &at_b);
            kept.push([0, 1, 2, 3].map(|k| &a[k] + (&b[k] - &a[k]) * &along));
        }
    }
    kept
}

/// The exact clip-space place of a position: `[x y z 1] M`, M row by row. `None` where a number is not finite.
pub fn to_clip(position: [f32; 3], matrix: &[f32; 16]) -> Option<[Rational; 4]> {
    let [x, y, z] = position;
    let point = [from_f32(x)?, from_f32(y)?, from_f32(z)?, from_f32(1.0)?];
    let column = |k: usize| {
        let mut sum = Rational::zero();
        for (row, coordinate) in point.iter().enumerate() {
            sum += coordinate * from_f32(matrix[4 * row + k])?;
        }
        Some(sum)
    };
    Some([column(0)?, column(1)?, column(2)?, column(3)?])
}

/// The rectangle of the window that clip space is mapped to, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Viewport {
    /// Left edge.
    pub x: i64,
    /// Top edge.
    pub y: i64,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

/// An exact window position: before snapping and before its depth is made an integer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WindowPoint {
    /// Position in pixels, y down.
    pub position: Point,
    /// Depth, 0 at the near plane and 1 at the far plane.
    pub z: Rational,
}

/// The exact window position of a homogeneous vertex:
/// `X = (x/w + 1) W/2 + x0`, `Y = (1 - y/w) H/2 + y0`, `Z = z/w` (rule R6). `None` unless `w > 0`.
pub fn to_window(vertex: &[Rational; 4], viewport: Viewport) -> Option<WindowPoint> {
    let [x, y, z, w] = vertex;
    if w.is_negative() || w.is_zero() {
        return None;
    }
    let one = Rational::from_integer(1.into());
    let half = |size: u32| Rational::new(size.into(), 2.into());
    let integer = |value: i64| Rational::from_integer(value.into());
    Some(WindowPoint {
        position: Point {
            x: (x / w + &one) * half(viewport.width) + integer(viewport.x),
            y: (&one - y / w) * half(viewport.height) + integer(viewport.y),
        },
        z: z / w,
    })
}

/// A coordinate in pixels as sub-pixel steps: nearest, ties to even (rule R4). Not saturated.
pub fn snap(pixels: &Rational, subpixel_bits: u32) -> BigInt {
    nearest_ties_even(&(pixels * Rational::from_integer(BigInt::from(1) << subpixel_bits)))
}

/// A depth as an unsigned normalized integer of so many bits: `z (2^bits - 1)`, nearest, ties up
/// (rule R30). Not clamped: a `z` outside 0 to 1 gives an integer outside the format.
pub fn unorm(z: &Rational, bits: u32) -> BigInt {
    nearest_ties_up(&(z * Rational::from_integer((BigInt::from(1) << bits) - 1)))
}
