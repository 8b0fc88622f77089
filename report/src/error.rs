//! Why there is no report.

use std::fmt;

use halfplane::{DrawError, OutsideGuardBand, RegionError, StorageError};
use halfplane_measure::target::TargetError;
use halfplane_reference::{ModelError, SceneError, VerifyError};

/// What ended a report before it was written.
#[derive(Debug)]
pub enum ReportError {
    /// A scene's size is none a target can have.
    Region(RegionError),
    /// A vertex of the ladder is none that a window has.
    Vertex(OutsideGuardBand),
    /// The rasterizer refused its memory or a draw.
    Target(TargetError),
    /// The reference refused the scene.
    Reference(VerifyError),
    /// The reference refused the model.
    Model(ModelError),
    /// Nothing to report on.
    NoTriangles {
        /// The scene.
        scene: String,
    },
    /// Two of our own ways drew different pictures, so no time means anything.
    Differs {
        /// The scene.
        scene: String,
        /// Which way.
        way: String,
        /// In how many pixels.
        pixels: u64,
    },
    /// A plot could not be drawn.
    Plot(String),
}

impl fmt::Display for ReportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Region(error) => error.fmt(f),
            Self::Vertex(error) => error.fmt(f),
            Self::Target(error) => error.fmt(f),
            Self::Reference(error) => error.fmt(f),
            Self::Model(error) => error.fmt(f),
            Self::NoTriangles { scene } => {
                write!(f, "{scene} has no triangles, so there is nothing to report")
            }
            Self::Differs { scene, way, pixels } => {
                write!(f, "{scene}: {way} draws {pixels} pixels that are not as specified")
            }
            Self::Plot(reason) => write!(f, "a plot cannot be drawn: {reason}"),
        }
    }
}

impl std::error::Error for ReportError {}

macro_rules! from {
    ($($source:ty => $variant:ident),+ $(,)?) => {
        $(impl From<$source> for ReportError {
            fn from(error: $source) -> Self {
                Self::$variant(error.into())
            }
        })+
    };
}

from! {
    RegionError => Region,
    OutsideGuardBand => Vertex,
    TargetError => Target,
    StorageError => Target,
    DrawError => Target,
    VerifyError => Reference,
    SceneError => Reference,
    ModelError => Model,
}
