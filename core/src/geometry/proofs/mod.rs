//! Proofs of the set-up of triangles.

mod edge;
mod footprint;
mod pixels;
mod plane;
mod rule;
mod triangle;
mod vertex;

use super::{Sample, Vertex};
use crate::{
    Coordinate,
    numbers::{Bounds, Format},
};

/// The ends of the guard band of the ready formats, the ranges of a coordinate.
const STANDARD: i32 = Bounds::<crate::Standard>::GUARD_BAND;
const SMALL: i32 = Bounds::<crate::Small>::GUARD_BAND;

/// The last pixels of the largest targets.
const LAST_STANDARD: u32 = crate::Standard::MAX_TARGET - 1;
const LAST_SMALL: u32 = crate::Small::MAX_TARGET - 1;

/// A vertex from coordinates within the guard band.
#[inline(always)]
fn vertex<F: Format>([x, y]: [i32; 2], z: u32) -> Option<Vertex<F>> {
    Some(Vertex::at(Coordinate::from_steps(x)?, Coordinate::from_steps(y)?, z))
}

/// Any sample position, from two numbers below 2^8.
#[inline(always)]
fn sample<F: Format>([x, y]: [i32; 2]) -> Option<Sample<F>> {
    let pixel = Bounds::<F>::STEPS_PER_PIXEL;
    Sample::new(x & (pixel - 1), y & (pixel - 1))
}
