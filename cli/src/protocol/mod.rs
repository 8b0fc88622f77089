//! Binary protocols on standard input and output, for conformance kits. All numbers little endian.

mod coverage;
mod depth;
mod input;

use std::fmt;
use std::io;

use halfplane::{Format, Standard};

pub use coverage::coverage;
pub use depth::depth;

/// A request that is wrong or beyond this program.
#[derive(Debug)]
pub struct ProtocolError {
    /// The protocol's name, as in its first eight bytes.
    protocol: &'static str,
    problem: Problem,
}

#[derive(Debug)]
enum Problem {
    /// The input does not begin with the protocol's name.
    Magic,
    /// The input ends too early.
    Truncated { part: String, given: u64, needed: u64 },
    /// The input cannot be read.
    Read(io::Error),
    /// The output cannot be written.
    Write(io::Error),
    /// The picture is empty or larger than a target can be.
    Size { width: u32, height: u32 },
    /// No sample positions.
    NoSamples,
    /// More sub-pixel bits than the protocol has.
    SubpixelBits(u32),
    /// More sub-pixel bits than this program has.
    Finer { bits: u32, limit: u32 },
    /// A sample position outside its pixel.
    Sample { at: usize, x: u32, y: u32 },
    /// A coordinate outside the guard band.
    GuardBand { triangle: usize, vertex: usize },
}

impl ProtocolError {
    /// 77 for what the protocol allows but this program cannot do, 2 for what is wrong.
    #[must_use]
    pub fn exit_status(&self) -> u8 {
        match self.problem {
            Problem::Finer { .. } | Problem::Sample { .. } | Problem::GuardBand { .. } => 77,
            _ => 2,
        }
    }
}

impl fmt::Display for ProtocolError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let protocol = self.protocol;
        match &self.problem {
            Problem::Magic => {
                write!(
                    f,
                    "standard input is no {protocol} request: it must begin with the bytes \"{protocol}\""
                )
            }
            Problem::Truncated { part, given, needed } => write!(
                f,
                "standard input ends within the {part} of a {protocol} request: {given} bytes of {needed}"
            ),
            Problem::Read(error) => {
                write!(f, "cannot read the {protocol} request from standard input: {error}")
            }
            Problem::Write(error) => {
                write!(f, "cannot write the {protocol} answer to standard output: {error}")
            }
            Problem::Size { width, height } => write!(
                f,
                "a {protocol} picture of {width}x{height}: both sides must be 1 to {}",
                Standard::MAX_TARGET
            ),
            Problem::NoSamples => {
                write!(f, "a {protocol} request with 0 sample positions: it needs at least 1")
            }
            Problem::SubpixelBits(bits) => {
                write!(f, "a {protocol} request with {bits} sub-pixel bits: it must be at most 8")
            }
            Problem::Finer { bits, limit } => write!(
                f,
                "a {protocol} request with {bits} sub-pixel bits: this program takes at most {limit}"
            ),
            Problem::Sample { at, x, y } => write!(
                f,
                "sample position {at} of the {protocol} request is ({x}, {y}): this program takes 0 to 255 (1/256 px)"
            ),
            Problem::GuardBand { triangle, vertex } => write!(
                f,
                "vertex {vertex} of triangle {triangle} of the {protocol} request lies outside this program's guard band of 32768 px"
            ),
        }
    }
}

impl std::error::Error for ProtocolError {}
