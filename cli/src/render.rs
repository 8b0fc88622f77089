//! From a mesh and a matrix to depth and triangle ids, with the rasterizer's own transform, clip and draw.

use std::fmt;

use halfplane::simd::MeshletError;
use halfplane::{Cull, DrawError, Region, RegionError, Standard, State, Statistics, StorageError, Winding};
pub use halfplane_measure::clip;

use crate::args;
use crate::camera::Matrix;
use crate::level::Level;
use crate::mesh::Mesh;
use crate::target::TargetError;
use crate::way::{Rows, Way};

/// What one picture is drawn with.
#[derive(Debug, Clone, Copy)]
pub struct Settings {
    /// The whole target.
    pub region: Region<Standard>,
    /// Which faces are left out.
    pub cull: Cull,
    /// How front faces wind.
    pub front: Winding,
    /// The depth format.
    pub depth: args::DepthFormat,
    /// How the inner loops run; no pixel depends on it.
    pub level: Level,
}

/// Depth and ids of every pixel, in rows from the top.
#[derive(Debug)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Bits of a depth: 32 or 16.
    pub bits: u32,
    /// Depths; 2^bits - 1 where nothing was drawn.
    pub depth: Vec<u32>,
    /// Triangle ids; [`halfplane::NO_ID`] where nothing was drawn.
    pub ids: Vec<u32>,
    /// Whether, of triangles at the same depth, the id is the first one's.
    pub ordered: bool,
    /// What became of the triangles.
    pub statistics: Statistics,
}

/// A picture that cannot be drawn.
#[derive(Debug)]
pub enum RenderError {
    /// The size is none a target can have.
    Region(RegionError),
    /// The rasterizer refused its storage, the meshlets or the draw.
    Target(TargetError),
    /// The reference refused the scene.
    Verify(halfplane_reference::VerifyError),
}

impl Settings {
    /// The drawing state.
    #[must_use]
    pub fn state(&self) -> State<Standard> {
        State { cull: self.cull, front: self.front, ..State::new(self.region) }
    }
}

/// The [`clip`] of all positions of a mesh.
#[must_use]
pub fn to_clip(mesh: &Mesh, matrix: &Matrix) -> Vec<[f32; 4]> {
    mesh.positions.iter().map(|&position| clip(position, matrix)).collect()
}

/// Draws a mesh one way or another; no pixel depends on that.
///
/// # Errors
///
/// [`RenderError`] where the rasterizer refuses; not for any mesh that was loaded.
pub fn render(mesh: &Mesh, matrix: &Matrix, settings: &Settings, way: &Way) -> Result<Picture, RenderError> {
    let Rows { depth, ids, statistics } = way.draw(mesh, matrix, settings)?;
    Ok(Picture {
        width: settings.region.width(),
        height: settings.region.height(),
        bits: settings.depth.bits(),
        depth,
        ids,
        ordered: way.is_ordered(),
        statistics,
    })
}

impl Picture {
    /// The depth of a pixel where nothing was drawn.
    #[must_use]
    pub fn far(&self) -> u32 {
        u32::MAX >> (32 - self.bits)
    }
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Region(error) => error.fmt(f),
            Self::Target(error) => error.fmt(f),
            Self::Verify(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for RenderError {}

impl From<RegionError> for RenderError {
    fn from(error: RegionError) -> Self {
        Self::Region(error)
    }
}

macro_rules! from_target {
    ($($source:ty),+) => {
        $(impl From<$source> for RenderError {
            fn from(error: $source) -> Self {
                Self::Target(error.into())
            }
        })+
    };
}

from_target!(TargetError, StorageError, MeshletError, DrawError);

impl From<halfplane_reference::VerifyError> for RenderError {
    fn from(error: halfplane_reference::VerifyError) -> Self {
        Self::Verify(error)
    }
}
