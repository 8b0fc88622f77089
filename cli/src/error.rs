//! What ends a run before its work is done, and the exit status it ends with.

use std::fmt;

use halfplane_report::ReportError;

use crate::camera::CameraError;
use crate::load::LoadError;
use crate::output::OutputError;
use crate::protocol::ProtocolError;
use crate::render::RenderError;
use crate::target::TargetError;

/// Any failure of a command. Its `Display` is one line: what, where, and what would be right.
#[derive(Debug)]
pub enum Error {
    /// The command line does not make sense.
    Usage(String),
    /// The mesh could not be read.
    Load(LoadError),
    /// The camera could not be made.
    Camera(CameraError),
    /// The picture could not be drawn.
    Render(RenderError),
    /// A protocol's standard input or output failed.
    Protocol(ProtocolError),
    /// There is no report.
    Report(ReportError),
    /// A result could not be written.
    Output(OutputError),
}

impl Error {
    /// The process's exit status: 77 for a request in good order that is beyond this program,
    /// 2 for bad input. (0 is success and 1 a verification that found a difference.)
    #[must_use]
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::Protocol(error) => error.exit_status(),
            _ => 2,
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(message) => f.write_str(message),
            Self::Load(error) => error.fmt(f),
            Self::Camera(error) => error.fmt(f),
            Self::Render(error) => error.fmt(f),
            Self::Protocol(error) => error.fmt(f),
            Self::Report(error) => error.fmt(f),
            Self::Output(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {}

macro_rules! from {
    ($($source:ident => $variant:ident),+ $(,)?) => {
        $(impl From<$source> for Error {
            fn from(error: $source) -> Self {
                Self::$variant(error)
            }
        })+
    };
}

from! {
    LoadError => Load,
    CameraError => Camera,
    RenderError => Render,
    ProtocolError => Protocol,
    ReportError => Report,
    OutputError => Output,
}

impl From<TargetError> for Error {
    fn from(error: TargetError) -> Self {
        Self::Render(error.into())
    }
}
