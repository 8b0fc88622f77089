//! Where the samples are, and rectangles of pixels.

use std::error::Error;
use std::fmt;

/// The finest sub-pixel grid: 2^-16 px.
pub const MAX_SUBPIXEL_BITS: u32 = 16;

/// A sub-pixel grid with one sample per pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    subpixel_bits: u32,
    sample: (u32, u32),
}

/// Why there is no such grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GridError {
    /// More sub-pixel bits than [`MAX_SUBPIXEL_BITS`].
    TooManySubpixelBits {
        /// What was asked for.
        given: u32,
    },
    /// The sample does not lie in its pixel.
    SampleOutsidePixel {
        /// What was asked for, in steps from the pixel's top-left corner.
        given: (u32, u32),
        /// Steps in a pixel, 2^S; both coordinates must be smaller.
        steps: u32,
    },
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GridError::TooManySubpixelBits { given } => {
                write!(f, "{given} sub-pixel bits are more than the {MAX_SUBPIXEL_BITS} supported")
            }
            GridError::SampleOutsidePixel { given: (x, y), steps } => {
                write!(f, "sample ({x}, {y}) lies outside its pixel of {steps} x {steps} steps")
            }
        }
    }
}

impl Error for GridError {}

impl Grid {
    /// Steps of `2^-subpixel_bits` px and the sample so many steps from its pixel's top-left corner.
    ///
    /// # Errors
    /// [`GridError`] for more than [`MAX_SUBPIXEL_BITS`] or a sample outside its pixel.
    pub fn new(subpixel_bits: u32, sample: (u32, u32)) -> Result<Grid, GridError> {
        if subpixel_bits > MAX_SUBPIXEL_BITS {
            return Err(GridError::TooManySubpixelBits { given: subpixel_bits });
        }
        let steps = 1 << subpixel_bits;
        if sample.0 >= steps || sample.1 >= steps {
            return Err(GridError::SampleOutsidePixel { given: sample, steps });
        }
        Ok(Grid { subpixel_bits, sample })
    }

    /// S, at most [`MAX_SUBPIXEL_BITS`].
    pub fn subpixel_bits(self) -> u32 {
        self.subpixel_bits
    }

    /// The sample in steps from its pixel's top-left corner, each below 2^S.
    pub fn sample(self) -> (u32, u32) {
        self.sample
    }

    /// The sample of a pixel in steps: below 2^48 for every pixel.
    pub fn sample_at(self, x: u32, y: u32) -> (i64, i64) {
        (
            (i64::from(x) << self.subpixel_bits) + i64::from(self.sample.0),
            (i64::from(y) << self.subpixel_bits) + i64::from(self.sample.1),
        )
    }

    /// The rows of `y0..y1` whose samples lie at or below `top` and above `bottom` (steps, y down).
    pub(crate) fn rows(self, top: i64, bottom: i64, y0: u32, y1: u32) -> std::ops::Range<u32> {
        let first_from = |edge: i64| {
            let pixel = ceil_div(i128::from(edge) - i128::from(self.sample.1), 1 << self.subpixel_bits);
            clamp_to(pixel, y0, y1)
        };
        first_from(top)..first_from(bottom)
    }
}

/// A half-open rectangle of pixels; empty where a start is not below its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// One past the last column.
    pub x1: u32,
    /// One past the last row.
    pub y1: u32,
}

/// The smallest integer not below `n / d`, for positive `d`.
pub(crate) fn ceil_div(n: i128, d: i128) -> i128 {
    n.div_euclid(d) + i128::from(n.rem_euclid(d) != 0)
}

/// The value moved into `low..=high`; `high` may be below `low`, which gives `low`.
pub(crate) fn clamp_to(value: i128, low: u32, high: u32) -> u32 {
    u32::try_from(value.min(i128::from(high)).max(i128::from(low))).unwrap_or(low)
}
