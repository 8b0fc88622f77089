//! Rectangles of pixels inside a target.

use crate::numbers::{Bounds, Format};
use core::{error::Error, fmt, marker::PhantomData};

/// A rectangle of whole pixels, `x0 <= x < x1` and `y0 <= y < y1`, in target coordinates: never
/// empty, never beyond the format's largest target. Targets, scissors, bands and dirty rectangles
/// are regions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Region<F> {
    x0: u32,
    y0: u32,
    x1: u32,
    y1: u32,
    format: PhantomData<F>,
}

/// A rectangle that is no [`Region`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegionError {
    /// The rectangle has no pixel.
    Empty {
        /// Width as given (0 where x1 <= x0).
        width: u32,
        /// Height as given (0 where y1 <= y0).
        height: u32,
    },
    /// The rectangle reaches beyond the largest target of the format.
    TargetTooLarge {
        /// Right end, exclusive, in pixels.
        x1: u32,
        /// Bottom end, exclusive, in pixels.
        y1: u32,
        /// The format's largest width and height.
        limit: u32,
    },
}

impl fmt::Display for RegionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { width, height } => {
                write!(f, "a region of {width} x {height} pixels is empty: both must be at least 1")
            }
            Self::TargetTooLarge { x1, y1, limit } => {
                write!(f, "a region up to ({x1}, {y1}) exceeds the largest target, {limit} x {limit} pixels")
            }
        }
    }
}

impl Error for RegionError {}

impl<F: Format> Region<F> {
    /// The region of a whole target of that size in pixels.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub const fn of_size(width: u32, height: u32) -> Result<Self, RegionError> {
        Self::new(0, 0, width, height)
    }

    /// The region `x0..x1`, `y0..y1`.
    ///
    /// # Errors
    ///
    /// [`RegionError::Empty`] and [`RegionError::TargetTooLarge`].
    pub const fn new(x0: u32, y0: u32, x1: u32, y1: u32) -> Result<Self, RegionError> {
        let () = Bounds::<F>::CHECKED;
        if x1 > F::MAX_TARGET || y1 > F::MAX_TARGET {
            return Err(RegionError::TargetTooLarge { x1, y1, limit: F::MAX_TARGET });
        }
        if x0 >= x1 || y0 >= y1 {
            return Err(RegionError::Empty { width: x1.saturating_sub(x0), height: y1.saturating_sub(y0) });
        }
        Ok(Self { x0, y0, x1, y1, format: PhantomData })
    }

    /// First column.
    #[must_use]
    pub const fn x0(self) -> u32 {
        self.x0
    }

    /// First row.
    #[must_use]
    pub const fn y0(self) -> u32 {
        self.y0
    }

    /// The column after the last.
    #[must_use]
    pub const fn x1(self) -> u32 {
        self.x1
    }

    /// The row after the last.
    #[must_use]
    pub const fn y1(self) -> u32 {
        self.y1
    }

    /// Columns.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.x1 - self.x0
    }

    /// Rows.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.y1 - self.y0
    }

    /// Whether every pixel of `other` is in this region.
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.x0 <= other.x0 && self.y0 <= other.y0 && other.x1 <= self.x1 && other.y1 <= self.y1
    }

    /// The pixels of the region that are in `x0..x1` and `y0..y1`; `None` where there are none.
    #[inline]
    pub(crate) fn cut(self, x0: u32, y0: u32, x1: u32, y1: u32) -> Option<Self> {
        let (x0, x1) = (x0.max(self.x0), x1.min(self.x1));
        let (y0, y1) = (y0.max(self.y0), y1.min(self.y1));
        ((x0 < x1) & (y0 < y1)).then_some(Self { x0, y0, x1, y1, format: PhantomData })
    }

    /// The 4x4 blocks that the region touches, as pixels: its ends rounded outwards to multiples of 4.
    #[inline]
    pub(crate) const fn blocks(self) -> Self {
        Self {
            x0: self.x0 & !3,
            y0: self.y0 & !3,
            x1: (self.x1 + 3) & !3,
            y1: (self.y1 + 3) & !3,
            format: PhantomData,
        }
    }

    /// The pixels in both regions; `None` where there are none.
    #[must_use]
    pub fn intersect(self, other: Self) -> Option<Self> {
        self.cut(other.x0, other.y0, other.x1, other.y1)
    }
}
