//! What a verification found, for programs and for people.

use std::fmt;
use std::ops::AddAssign;

use crate::{DepthSpec, Fraction, decimal};

/// How many pixels differ, by what is wrong with them; one pixel can count in several kinds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mismatches {
    /// Pixels with at least one mismatch.
    pub pixels: u64,
    /// Covered by the specification, not drawn.
    pub missing: u64,
    /// Drawn, not covered by the specification.
    pub extra: u64,
    /// Another id than that of the specified winner.
    pub id: u64,
    /// Another depth than the specified one.
    pub depth: u64,
    /// Depth further than the bound from the exact depth of the triangle given as the winner.
    pub bound: u64,
    /// The triangle given as the winner is worse than the exact best by more than twice the bound: no
    /// quantisation explains it.
    pub winner: u64,
}

impl Mismatches {
    /// The kinds in words, with their counts.
    fn kinds(&self) -> [(&'static str, u64); 6] {
        [
            ("missing", self.missing),
            ("extra", self.extra),
            ("id", self.id),
            ("depth", self.depth),
            ("depth bound", self.bound),
            ("winner", self.winner),
        ]
    }
}

impl AddAssign for Mismatches {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.missing += other.missing;
        self.extra += other.extra;
        self.id += other.id;
        self.depth += other.depth;
        self.bound += other.bound;
        self.winner += other.winner;
    }
}

impl fmt::Display for Mismatches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let present: Vec<String> =
            self.kinds().iter().filter(|(_, n)| *n > 0).map(|(kind, n)| format!("{kind} {n}")).collect();
        f.write_str(if present.is_empty() { "none" } else { "" })?;
        f.write_str(&present.join(", "))
    }
}

/// One side of a comparison at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// The triangle's id; `None` where nothing was drawn, or if ids were not compared.
    pub id: Option<u32>,
    /// The stored depth.
    pub depth: u32,
    /// The exact depth of that triangle here, in stored units; `None` if no triangle of that id covers
    /// the pixel.
    pub exact: Option<Fraction>,
}

/// A pixel that differs, with the exact numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// What is wrong with it, each kind 0 or 1.
    pub kinds: Mismatches,
    /// By the specification.
    pub specified: Outcome,
    /// By the rasterizer.
    pub given: Outcome,
    /// Id and exact depth of the best triangle by the exact depths.
    pub best: Option<(u32, Fraction)>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "pixel (x {}, y {}): {}", self.x, self.y, self.kinds)?;
        let id = |id: Option<u32>| id.map_or_else(|| "none".to_owned(), |id| id.to_string());
        for (name, outcome) in [("specified", &self.specified), ("given", &self.given)] {
            write!(f, "  {name:<10} triangle {}, depth {}", id(outcome.id), outcome.depth)?;
            match outcome.exact {
                Some(exact) => writeln!(f, ", exact depth {}", exactly(exact))?,
                None => writeln!(f)?,
            }
        }
        match self.best {
            Some((id, exact)) => {
                write!(f, "  {:<10} triangle {id}, exact depth {}", "exact best", exactly(exact))
            }
            None => write!(f, "  {:<10} none", "exact best"),
        }
    }
}

/// The fraction in lowest terms and in decimal.
fn exactly(depth: Fraction) -> String {
    let rational = depth.to_rational();
    format!("{rational} = {}", decimal(&rational, 6))
}

/// The outcome of [`verify`](crate::verify()).
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Pixels compared: all of the target.
    pub pixels: u64,
    /// Pixels that some triangle wins by the specification.
    pub covered: u64,
    /// Pixels that differ, by kind.
    pub mismatches: Mismatches,
    /// The first pixel that differs, in row-major order.
    pub first: Option<Difference>,
    /// Pixels whose depth was measured against the exact rational: drawn by a triangle that covers them.
    pub measured: u64,
    /// Largest distance of a given depth from the exact depth of the triangle it was drawn by, in stored
    /// units (2^-K). Found exactly, then given as the nearest floats allow.
    pub max_error: f64,
    /// The mean of those distances, summed in 64-bit floats, in row-major order.
    pub mean_error: f64,
    /// The format that was verified.
    pub spec: DepthSpec,
}

impl Report {
    /// Whether every pixel is as specified.
    pub fn identical(&self) -> bool {
        self.mismatches == Mismatches::default()
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} pixels compared, {} of them covered", self.pixels, self.covered)?;
        match &self.first {
            None => writeln!(f, "identical: every pixel is as specified")?,
            Some(first) => {
                writeln!(f, "NOT identical: {} pixels differ ({})", self.mismatches.pixels, self.mismatches)?;
                writeln!(f, "first difference at {first}")?;
            }
        }
        let (numerator, denominator) = self.spec.bound();
        write!(
            f,
            "depth against the exact rational, in units of 2^-{}: max {:.6}, mean {:.6}, bound {} ({} pixels)",
            self.spec.bits(),
            self.max_error,
            self.mean_error,
            numerator as f64 / denominator as f64,
            self.measured
        )
    }
}
