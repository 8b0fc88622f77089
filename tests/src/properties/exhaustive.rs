//! The enumerations: what is true of all of something, each in parts that run in any order.
//!
//! The example `enumerate` runs them whole, the tests a slice of each.

use super::{
    crossing::{is_exact_in_f32, is_exact_in_f64, turns},
    enumeration::{Lattice, every_footprint_from, every_triangle_from},
    fast_triangles::{Cell, every_fast_triangle},
    numbers::{self, every_snap, every_unorm16, every_unorm32},
    shared_edge::every_pair_from,
    small_edge::every_line_along,
};
use crate::{
    Failure, Frame,
    shapes::{LARGE_EXTENT, Random},
    toy::Toy,
};
use halfplane::{Bounds, Format, Small, Standard};

/// Something enumerated completely.
#[derive(Clone, Copy, Debug)]
pub struct Enumeration {
    /// What the command calls it; enumerations that belong together share it.
    pub name: &'static str,
    /// What is true of every case.
    pub statement: &'static str,
    /// How many parts it is in.
    pub parts: u32,
    /// Tries every case of a part; returns how many there were.
    pub part: fn(u32) -> Result<u64, Failure>,
}

/// Points on a side of the lattices.
const SIDE: i32 = 16;

/// Parts of lattices: one for each first point.
const POINTS: u32 = (SIDE * SIDE) as u32;

/// Largest |A| and |B| of the lines that cross one pixel, and of those that cross a whole tile.
const PIXEL_LIMIT: i32 = 64;
const TILE_LIMIT: i32 = 24;
/// The latter for the standard format, whose pixels have 256 times as many lines.
const STANDARD_LIMIT: i32 = 5;

/// Largest |A| of an edge in the guard band.
const MAX_DELTA: i32 = Bounds::<Standard>::MAX_DELTA;

/// Random slopes with which all crossings of the largest target are tried.
const SLOPES: u32 = 1 << 12;

/// Slopes in a part.
const PART: i32 = 1 << 12;

/// All there are.
pub const ALL: &[Enumeration] = &[
    Enumeration {
        name: "triangles",
        statement: "Toy, 16x16 sub-pixel positions: coverage is the oracle's; shared edges have one owner",
        parts: POINTS,
        part: |part| triangles::<Toy>(1, part),
    },
    Enumeration {
        name: "triangles",
        statement: "Small, 16x16 positions 6 steps apart: the same",
        parts: POINTS,
        part: |part| triangles::<Small>(6, part),
    },
    Enumeration {
        name: "triangles",
        statement: "Standard, 16x16 positions 64 steps apart: the same",
        parts: POINTS,
        part: |part| triangles::<Standard>(64, part),
    },
    Enumeration {
        name: "footprints",
        statement: "Toy, 16x16 sub-pixel positions: what is touched and inside is the oracle's",
        parts: POINTS,
        part: |part| footprints::<Toy>(1, part),
    },
    Enumeration {
        name: "footprints",
        statement: "Small, 16x16 positions half a pixel apart: the same",
        parts: POINTS,
        part: |part| footprints::<Small>(8, part),
    },
    Enumeration {
        name: "footprints",
        statement: "Standard, 16x16 positions about a pixel's corner, a step apart: the same",
        parts: POINTS,
        part: |part| footprints::<Standard>(1, part),
    },
    Enumeration {
        name: "edges",
        statement: "Toy, 10x10 positions: pairs at an edge cover each sample of their union once, none twice",
        parts: 100,
        part: |part| pairs::<Toy>(10, 1, part),
    },
    Enumeration {
        name: "edges",
        statement: "Toy, 16x16 positions: the same",
        parts: POINTS,
        part: |part| pairs::<Toy>(SIDE, 1, part),
    },
    Enumeration {
        name: "edges",
        statement: "Standard, 16x16 positions 64 steps apart: the same",
        parts: POINTS,
        part: |part| pairs::<Standard>(SIDE, 64, part),
    },
    Enumeration {
        name: "snapping",
        statement: "Standard, every f32: the nearest step, ties to even; monotone",
        parts: numbers::PARTS,
        part: every_snap::<Standard>,
    },
    Enumeration {
        name: "snapping",
        statement: "Small, every f32: the same",
        parts: numbers::PARTS,
        part: every_snap::<Small>,
    },
    Enumeration {
        name: "unorm",
        statement: "every f32: unorm32 is the nearest integer, ties upwards; monotone",
        parts: numbers::PARTS,
        part: every_unorm32,
    },
    Enumeration {
        name: "unorm",
        statement: "every u32: unorm16 is the nearest integer",
        parts: numbers::PARTS,
        part: every_unorm16,
    },
    Enumeration {
        name: "small-edges",
        statement: "Small, |A|, |B| <= 64, every line through a pixel: a tile's masks are the signs",
        parts: directions(PIXEL_LIMIT),
        part: |part| every_line_along::<Small>(direction(PIXEL_LIMIT, part), [31, 32]),
    },
    Enumeration {
        name: "small-edges",
        statement: "Small, |A|, |B| <= 24, every line through a tile: the same",
        parts: directions(TILE_LIMIT),
        part: |part| every_line_along::<Small>(direction(TILE_LIMIT, part), [0, 64]),
    },
    Enumeration {
        name: "small-edges",
        statement: "Standard, |A|, |B| <= 5, every line through a tile: the same",
        parts: directions(STANDARD_LIMIT),
        part: |part| every_line_along::<Standard>(direction(STANDARD_LIMIT, part), [0, 64]),
    },
    Enumeration {
        name: "crossings",
        statement: "f32, every |A| < 30720, every F with a crossing in 0..=128: exact",
        parts: (LARGE_EXTENT as u32).div_ceil(PART as u32),
        part: |part| slopes(part, LARGE_EXTENT as i32 - 1, 129, is_exact_in_f32_both_ways),
    },
    Enumeration {
        name: "crossings",
        statement: "f64, every |A| < 2^24, F next to powers of two up to 16384 and their neighbours: exact",
        parts: (MAX_DELTA as u32).div_ceil(PART as u32),
        part: |part| {
            let pixels = turns(i64::from(Standard::MAX_TARGET));
            slopes(part, MAX_DELTA - 1, pixels.len() as u64, |a| exact_in_f64(a, pixels.iter().copied()))
        },
    },
    Enumeration {
        name: "crossings",
        statement: "f64, 4096 random |A| and the largest: every F with a crossing in 0..=16384: exact",
        parts: SLOPES,
        part: |part| {
            let pixels = 0..=i64::from(Standard::MAX_TARGET);
            let random = Random(part.into()).between(1, MAX_DELTA.into()) as i32;
            let a = if part < 64 { MAX_DELTA - part as i32 } else { random };
            exact_in_f64(a, pixels.clone()).map(|()| 4 * pixels.count() as u64)
        },
    },
    Enumeration {
        name: "fast-triangles",
        statement: "every level, 16x16 positions in windows of 2x2 blocks: coverage is the oracle's",
        parts: TINY.parts(),
        part: |part| every_fast_triangle(TINY, part as i32),
    },
    Enumeration {
        name: "fast-triangles",
        statement: "every level, 16x16 positions in windows of 7x7 blocks: the same",
        parts: MEDIUM.parts(),
        part: |part| every_fast_triangle(MEDIUM, part as i32),
    },
    Enumeration {
        name: "fast-triangles",
        statement: "every level, 9x9 positions over 116 pixels (rows in f32): the same",
        parts: LARGE.parts(),
        part: |part| every_fast_triangle(LARGE, part as i32),
    },
    Enumeration {
        name: "fast-triangles",
        statement: "every level, 7x7 positions over 250 pixels (rows in f64): the same",
        parts: HUGE.parts(),
        part: |part| every_fast_triangle(HUGE, part as i32),
    },
];

// Multiples of 16 steps, so that points and edges meet samples, and no two rows lie alike.
const TINY: Cell = Cell { side: SIDE, spacing: 48, pixels: 8 };
const MEDIUM: Cell = Cell { side: SIDE, spacing: 416, pixels: 28 };
const LARGE: Cell = Cell { side: 9, spacing: 3696, pixels: 124 };
const HUGE: Cell = Cell { side: 7, spacing: 10_656, pixels: 256 };

/// Across the corner of four blocks.
fn lattice<F: Format>(side: i32, spacing: i32) -> Lattice {
    Lattice { origin: [(16 << F::SUBPIXEL_BITS) - side / 2 * spacing; 2], side, spacing }
}

fn triangles<F: Format>(spacing: i32, part: u32) -> Result<u64, Failure> {
    every_triangle_from::<F>(&Frame::whole::<F>(64, 64), lattice::<F>(SIDE, spacing), part as i32)
}

/// In the pixels of the lattice and those next to it.
fn footprints<F: Format>(spacing: i32, part: u32) -> Result<u64, Failure> {
    let lattice = lattice::<F>(SIDE, spacing);
    let end = lattice.origin[0] + (SIDE - 1) * spacing;
    let (first, end) = ((lattice.origin[0] >> F::SUBPIXEL_BITS) - 1, (end >> F::SUBPIXEL_BITS) + 2);
    let scissor = [first as u32, first as u32, end as u32, end as u32];
    every_footprint_from::<F>(&Frame { scissor, ..Frame::whole::<F>(64, 64) }, lattice, part as i32)
}

fn pairs<F: Format>(side: i32, spacing: i32, part: u32) -> Result<u64, Failure> {
    every_pair_from::<F>(lattice::<F>(side, spacing), [12, 12], part as i32)
}

/// How many directions have numbers up to a limit.
const fn directions(limit: i32) -> u32 {
    ((2 * limit + 1) * (2 * limit + 1)) as u32
}

fn direction(limit: i32, number: u32) -> [i32; 2] {
    let side = 2 * limit + 1;
    [number as i32 % side - limit, number as i32 / side - limit]
}

/// Every slope of a part, both signs, two F next to each of so many pixels.
fn slopes(
    part: u32,
    last: i32,
    pixels: u64,
    exact: impl Fn(i32) -> Result<(), Failure>,
) -> Result<u64, Failure> {
    let first = part as i32 * PART;
    let slopes = first.max(1)..=(first + PART - 1).min(last);
    slopes.clone().try_for_each(exact)?;
    Ok(4 * pixels * slopes.count() as u64)
}

fn is_exact_in_f32_both_ways(a: i32) -> Result<(), Failure> {
    is_exact_in_f32(a)?;
    is_exact_in_f32(-a)
}

fn exact_in_f64(a: i32, mut pixels: impl Iterator<Item = i64>) -> Result<(), Failure> {
    pixels.try_for_each(|k| {
        is_exact_in_f64(a, k)?;
        is_exact_in_f64(-a, k)
    })
}
