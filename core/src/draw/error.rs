//! What is wrong with a draw's arguments.

use crate::attachments::OutsideAttachment;
use core::{error::Error, fmt};

/// A draw that was refused; nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawError {
    /// The number of indices is not a multiple of 3.
    IndexCount {
        /// Indices given.
        count: usize,
    },
    /// An index names no vertex.
    IndexOutOfRange {
        /// Its place in the index list.
        at: usize,
        /// The index.
        index: u32,
        /// How many vertices there are; indices are less than this.
        vertices: usize,
    },
    /// The ids `first_id..first_id + triangles` do not fit, with [`NO_ID`](crate::NO_ID) left free.
    TooManyIds {
        /// First id as given.
        first_id: u32,
        /// Triangles in the index list.
        triangles: usize,
    },
    /// Scratch memory for the vertex stage is shorter than the vertices.
    ScratchTooSmall {
        /// Records needed.
        needed: usize,
        /// Records given.
        given: usize,
    },
    /// Scissor and viewport reach beyond an attachment.
    OutsideAttachment(OutsideAttachment),
}

impl From<OutsideAttachment> for DrawError {
    fn from(error: OutsideAttachment) -> Self {
        Self::OutsideAttachment(error)
    }
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::IndexCount { count } => {
                write!(f, "{count} indices: a triangle list has a multiple of 3")
            }
            Self::IndexOutOfRange { at, index, vertices } => {
                write!(f, "index {index} at place {at} is out of range: there are {vertices} vertices")
            }
            Self::TooManyIds { first_id, triangles } => write!(
                f,
                "{triangles} triangles from id {first_id} on need ids above {}, the largest",
                u32::MAX - 1
            ),
            Self::ScratchTooSmall { needed, given } => {
                write!(f, "{given} records of scratch memory: one for each of {needed} vertices is needed")
            }
            Self::OutsideAttachment(error) => error.fmt(f),
        }
    }
}

impl Error for DrawError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::OutsideAttachment(error) => Some(error),
            _ => None,
        }
    }
}
