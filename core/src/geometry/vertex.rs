//! Window vertices: the entry point that needs no float.

use crate::numbers::{Bounds, Coordinate, DEPTH32_MAX, DEPTH32_MIN, Format};
use core::{error::Error, fmt};

/// A vertex in window space: x and y in fixed point, depth as unorm32.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Vertex<F> {
    x: Coordinate<F>,
    y: Coordinate<F>,
    z: u32,
}

/// A window coordinate lies outside the guard band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutsideGuardBand {
    /// x as given, in steps.
    pub x: i32,
    /// y as given, in steps.
    pub y: i32,
    /// The largest magnitude allowed, in steps.
    pub limit: i32,
}

impl fmt::Display for OutsideGuardBand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { x, y, limit } = self;
        write!(f, "vertex ({x}, {y}) lies outside the guard band: coordinates from -{limit} to {limit} steps")
    }
}

impl Error for OutsideGuardBand {}

impl<F: Format> Vertex<F> {
    /// A vertex at (`x`, `y`) steps of 2^-S px from the target's top-left corner, y down, with depth
    /// `z` in units of 2^-32, 0 nearest.
    ///
    /// The depth is moved into `[2, 2^32 - 3]`, so that no interpolated depth leaves the range.
    ///
    /// # Errors
    ///
    /// [`OutsideGuardBand`] where x or y is.
    pub const fn new(x: i32, y: i32, z: u32) -> Result<Self, OutsideGuardBand> {
        match (Coordinate::from_steps(x), Coordinate::from_steps(y)) {
            (Some(x), Some(y)) => Ok(Self::at(x, y, z)),
            _ => Err(OutsideGuardBand { x, y, limit: Bounds::<F>::GUARD_BAND }),
        }
    }

    /// [`new`](Self::new) from coordinates that are inside the guard band by their type.
    #[must_use]
    pub const fn at(x: Coordinate<F>, y: Coordinate<F>, z: u32) -> Self {
        let z = if z < DEPTH32_MIN {
            DEPTH32_MIN
        } else if z > DEPTH32_MAX {
            DEPTH32_MAX
        } else {
            z
        };
        Self { x, y, z }
    }

    /// x in steps.
    #[must_use]
    pub const fn x(self) -> i32 {
        self.x.steps()
    }

    /// y in steps, downwards.
    #[must_use]
    pub const fn y(self) -> i32 {
        self.y.steps()
    }

    /// Depth in units of 2^-32, from 2 to 2^32 - 3.
    #[must_use]
    pub const fn z(self) -> u32 {
        self.z
    }
}
