//! What a target can refuse.

use std::fmt;

use halfplane::simd::MeshletError;
use halfplane::{DrawError, StorageError};

/// Nothing can be drawn.
#[derive(Debug)]
pub enum TargetError {
    /// The rasterizer refused its storage.
    Storage(StorageError),
    /// The rasterizer refused to make meshlets.
    Meshlets(MeshletError),
    /// The rasterizer refused the draw.
    Draw(DrawError),
    /// There are no threads, and why.
    Threads(String),
}

impl fmt::Display for TargetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Storage(error) => error.fmt(f),
            Self::Meshlets(error) => error.fmt(f),
            Self::Draw(error) => error.fmt(f),
            Self::Threads(why) => write!(f, "no threads: {why}"),
        }
    }
}

impl std::error::Error for TargetError {}

impl From<StorageError> for TargetError {
    fn from(error: StorageError) -> Self {
        Self::Storage(error)
    }
}

impl From<MeshletError> for TargetError {
    fn from(error: MeshletError) -> Self {
        Self::Meshlets(error)
    }
}

impl From<DrawError> for TargetError {
    fn from(error: DrawError) -> Self {
        Self::Draw(error)
    }
}
