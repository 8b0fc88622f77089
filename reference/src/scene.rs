//! A scene: triangles in sub-pixel steps and depths in integers, as a rasterizer receives them.

use std::error::Error;
use std::fmt;

use crate::{DepthSpec, Grid, GridError, Rect};

/// The value of a pixel of an id picture that no triangle won; no triangle may have it.
pub const NO_ID: u32 = u32::MAX;

/// The largest width and height of a target, in pixels.
pub const MAX_SIDE: u32 = 1 << 16;

/// One triangle of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneTriangle {
    /// Corners in sub-pixel steps, x right, y down, from the target's top-left corner. Any values.
    pub xy: [[i32; 2]; 3],
    /// Depths at the corners, unsigned normalized integers of as many bits as the depth picture.
    /// Values outside `2..=2^K - 3` are moved there, as for every vertex of this rasterizer.
    pub z: [u32; 3],
    /// What the id picture shows; pieces of one clipped triangle share it. Not [`NO_ID`].
    pub id: u32,
}

/// Triangles in the order in which they are drawn, and the target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// Width of the target in pixels, 1 to [`MAX_SIDE`].
    pub width: u32,
    /// Height of the target in pixels, 1 to [`MAX_SIDE`].
    pub height: u32,
    /// S: coordinates are multiples of 2^-S px.
    pub subpixel_bits: u32,
    /// The sample's place in its pixel, in steps from the top-left corner; 2^(S-1) twice is the centre.
    pub sample: (u32, u32),
    /// In the order of submission.
    pub triangles: Vec<SceneTriangle>,
}

/// Why a scene cannot be rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SceneError {
    /// A side is 0 or larger than [`MAX_SIDE`].
    Size {
        /// The width given.
        width: u32,
        /// The height given.
        height: u32,
    },
    /// The sub-pixel bits or the sample are not a grid.
    Grid(GridError),
    /// More triangles than 2^32 - 2.
    TooManyTriangles {
        /// The number given.
        given: usize,
    },
    /// A triangle has the id that says "none".
    ReservedId {
        /// Position of the triangle in the scene.
        triangle: usize,
    },
    /// A corner's depth has more bits than the depth picture.
    DepthTooWide {
        /// Position of the triangle in the scene.
        triangle: usize,
        /// The depth given.
        z: u32,
        /// Bits of the depth picture.
        bits: u32,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneError::Size { width, height } => {
                write!(f, "a target of {width} x {height} pixels: each side must be 1 to {MAX_SIDE}")
            }
            SceneError::Grid(error) => error.fmt(f),
            SceneError::TooManyTriangles { given } => {
                write!(f, "{given} triangles are too many to number in 32 bits")
            }
            SceneError::ReservedId { triangle } => {
                write!(f, "triangle {triangle} has the id {NO_ID}, which means that there is none")
            }
            SceneError::DepthTooWide { triangle, z, bits } => {
                write!(f, "triangle {triangle} has a corner of depth {z}, which does not fit {bits} bits")
            }
        }
    }
}

impl Error for SceneError {}

impl From<GridError> for SceneError {
    fn from(error: GridError) -> Self {
        SceneError::Grid(error)
    }
}

impl Scene {
    /// The grid of samples; checks everything about the scene but its depths.
    ///
    /// # Errors
    /// [`SceneError`], naming the first thing that is wrong.
    pub fn grid(&self) -> Result<Grid, SceneError> {
        let (width, height) = (self.width, self.height);
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(SceneError::Size { width, height });
        }
        if u32::try_from(self.triangles.len()).is_ok_and(|count| count < NO_ID) {
            if let Some(triangle) = self.triangles.iter().position(|triangle| triangle.id == NO_ID) {
                return Err(SceneError::ReservedId { triangle });
            }
            Ok(Grid::new(self.subpixel_bits, self.sample)?)
        } else {
            Err(SceneError::TooManyTriangles { given: self.triangles.len() })
        }
    }

    /// The whole target.
    pub fn rect(&self) -> Rect {
        Rect { x0: 0, y0: 0, x1: self.width, y1: self.height }
    }

    /// As [`Scene::grid`], and checks that all depths fit the format.
    pub(crate) fn check(&self, spec: DepthSpec) -> Result<Grid, SceneError> {
        let grid = self.grid()?;
        for (triangle, &SceneTriangle { z, .. }) in self.triangles.iter().enumerate() {
            if let Some(&z) = z.iter().find(|&&z| z > spec.farthest()) {
                return Err(SceneError::DepthTooWide { triangle, z, bits: spec.bits() });
            }
        }
        Ok(grid)
    }
}

/// When a new depth replaces the stored one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compare {
    /// If smaller: nearer wins, earlier wins a tie.
    Less,
    /// If not larger: nearer wins, later wins a tie.
    LessEqual,
    /// If larger.
    Greater,
    /// If not smaller.
    GreaterEqual,
    /// Always: the last triangle wins.
    Always,
}

impl Compare {
    /// Whether `new` replaces `old`.
    pub fn passes<T: Ord>(self, new: &T, old: &T) -> bool {
        match self {
            Compare::Less => new < old,
            Compare::LessEqual => new <= old,
            Compare::Greater => new > old,
            Compare::GreaterEqual => new >= old,
            Compare::Always => true,
        }
    }

    /// What the depth picture holds before anything is drawn: the farthest for this comparison.
    pub fn clear_value(self, spec: DepthSpec) -> u32 {
        match self {
            Compare::Less | Compare::LessEqual | Compare::Always => spec.farthest(),
            Compare::Greater | Compare::GreaterEqual => 0,
        }
    }
}
