//! A model and the camera that sees it.

use std::error::Error;
use std::fmt;

use crate::scene::{MAX_SIDE, NO_ID};

/// Triangles of a model, seen through a matrix.
#[derive(Clone, Copy, Debug)]
pub struct Model<'m> {
    /// Vertices.
    pub positions: &'m [[f32; 3]],
    /// Three for each triangle, which has the number of its place as its id.
    pub indices: &'m [u32],
    /// Row by row: clip = `[x y z 1] M`, y up, `0 <= z <= w`.
    pub matrix: [f32; 16],
    /// Width of the target in pixels, 1 to [`MAX_SIDE`].
    pub width: u32,
    /// Height of the target in pixels, 1 to [`MAX_SIDE`].
    pub height: u32,
    /// Whether only triangles that are clockwise on the screen are drawn.
    pub clockwise_only: bool,
}

/// Why a model has no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelError {
    /// A side is 0 or larger than [`MAX_SIDE`].
    Size {
        /// The width given.
        width: u32,
        /// The height given.
        height: u32,
    },
    /// Indices that are not three for each triangle.
    IndexCount {
        /// The number given.
        given: usize,
    },
    /// More triangles than 2^32 - 2.
    TooManyTriangles {
        /// The number given.
        given: usize,
    },
    /// An index of a vertex that is not there.
    Index {
        /// Its place in the list.
        at: usize,
        /// The index given.
        given: u32,
    },
    /// A component of a vertex that is NaN or infinite.
    Position {
        /// The vertex.
        vertex: usize,
    },
    /// A number of the matrix that is NaN or infinite.
    Matrix {
        /// Its place, row by row.
        at: usize,
    },
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height } => {
                write!(f, "a target of {width} x {height} pixels: each side must be 1 to {MAX_SIDE}")
            }
            Self::IndexCount { given } => write!(f, "{given} indices are not three for each triangle"),
            Self::TooManyTriangles { given } => {
                write!(f, "{given} triangles are too many to number in 32 bits")
            }
            Self::Index { at, given } => write!(f, "index {at} names vertex {given}, which is not there"),
            Self::Position { vertex } => write!(f, "vertex {vertex} has a component that is not finite"),
            Self::Matrix { at } => write!(f, "number {at} of the matrix is not finite"),
        }
    }
}

impl Error for ModelError {}

impl Model<'_> {
    pub(super) fn check(&self) -> Result<(), ModelError> {
        let Self { width, height, .. } = *self;
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(ModelError::Size { width, height });
        }
        let given = self.indices.len();
        if !given.is_multiple_of(3) {
            return Err(ModelError::IndexCount { given });
        }
        if !u32::try_from(given / 3).is_ok_and(|count| count < NO_ID) {
            return Err(ModelError::TooManyTriangles { given: given / 3 });
        }
        if let Some(at) = self.indices.iter().position(|&index| index as usize >= self.positions.len()) {
            return Err(ModelError::Index { at, given: self.indices[at] });
        }
        let finite = |numbers: &[f32]| numbers.iter().all(|number| number.is_finite());
        if let Some(vertex) = self.positions.iter().position(|position| !finite(position)) {
            return Err(ModelError::Position { vertex });
        }
        match self.matrix.iter().position(|number| !number.is_finite()) {
            Some(at) => Err(ModelError::Matrix { at }),
            None => Ok(()),
        }
    }

    pub(super) fn corners(&self, triangle: u32) -> [[f32; 3]; 3] {
        let at = 3 * triangle as usize;
        [0, 1, 2].map(|k| self.positions[self.indices[at + k] as usize])
    }

    /// A pixel's centre as (x, y, w), times width and height: whole numbers up to 2^32 in magnitude.
    pub(super) fn sample(&self, x: u32, y: u32) -> [i64; 3] {
        let [width, height] = [self.width, self.height].map(i64::from);
        [(2 * i64::from(x) + 1 - width) * height, (height - 2 * i64::from(y) - 1) * width, width * height]
    }
}
