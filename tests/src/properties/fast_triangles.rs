//! All triangles with corners on a small lattice, drawn by the fast path at every vector level.
//!
//! The triangles of two corners are drawn at once, each in a cell of its own.

use super::{enumeration::Lattice, simd::levels};
use crate::{Failure, Frame, ensure, ensure_eq, shapes::Corners};
use halfplane::{
    Bounds, Coverage, ModelPositions, Region, Standard, State, Viewport, blocks,
    simd::{self, Snapped, Triangles},
};
use halfplane_reference::cover_rows;

/// Steps in a pixel.
const PIXEL: i32 = Bounds::<Standard>::STEPS_PER_PIXEL;

/// A lattice in the middle of a cell of pixels.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Points on a side of the lattice.
    pub side: i32,
    /// Steps between them.
    pub spacing: i32,
    /// Pixels on a side of the cell: a multiple of 4, more than the lattice's.
    pub pixels: i32,
}

impl Cell {
    /// The lattice of the cell in that column and row.
    fn lattice(self, [column, row]: [i32; 2]) -> Lattice {
        let Self { side, spacing, pixels } = self;
        // Whole pixels, so that some points are samples.
        let margin = ((pixels * PIXEL - (side - 1) * spacing) / 2) & !(PIXEL - 1);
        Lattice { origin: [column, row].map(|at| at * pixels * PIXEL + margin), side, spacing }
    }

    /// How many parts [`every_fast_triangle`] is in.
    pub const fn parts(self) -> u32 {
        (self.side * self.side) as u32
    }
}

/// Every ordered triple of points whose first is that point: at each level `simd::draw` covers what the
/// reference covers, and counts as drawn what covers something. Returns the number of triangles, at all levels.
pub fn every_fast_triangle(cell: Cell, first: i32) -> Result<u64, Failure> {
    // A power of two, so that clip coordinates are exact.
    let size = ((cell.side * cell.pixels) as u32).next_power_of_two();
    let (frame, region) = (Frame::whole::<Standard>(size, size), Region::of_size(size, size)?);
    let viewport = Viewport::<Standard>::new(region);
    let points = cell.side * cell.side;
    let indices: Vec<u32> = (0..3 * points as u32).collect();
    let mut records = vec![Snapped::default(); indices.len()];
    let (mut expected, mut masks) = (vec![0; blocks(size, size)], vec![0; blocks(size, size)]);
    let mut triangles = 0;
    for second in 0..points {
        expected.fill(0);
        let (mut vertices, mut drawn) = (Vec::with_capacity(indices.len()), 0);
        for third in 0..points {
            let lattice = cell.lattice([third % cell.side, third / cell.side]);
            let corners = [first, second, third].map(|point| lattice.point(point));
            drawn += u32::from(cover(&frame, &corners, &mut expected)?);
            vertices.extend(corners.map(|corner| clip(corner, size)));
        }
        let positions = ModelPositions::new(&vertices, IDENTITY, viewport);
        for level in levels() {
            masks.fill(0);
            let mut coverage = Coverage::new(region, &mut masks)?;
            let list = Triangles::new(&indices, vertices.len())?;
            let state = State::new(region);
            let statistics = simd::draw(level, &positions, &mut records, list, 0, &state, &mut coverage)?;
            let what = format_args!("{}, {cell:?}, points {first} and {second}", level.name());
            if let Some(at) = (0..masks.len()).find(|&at| masks[at] != expected[at]) {
                let pitch = (size / 4) as usize;
                let (x, y) = (4 * (at % pitch) as i32, 4 * (at / pitch) as i32);
                let third = y / cell.pixels * cell.side + x / cell.pixels;
                return Err(Failure::new(format_args!(
                    "{what} and {third}: block ({x}, {y}) is {:#018b}, expected {:#018b}",
                    masks[at], expected[at]
                )));
            }
            ensure_eq!(statistics.drawn, drawn, "{what}: drawn");
            triangles += points as u64;
        }
    }
    Ok(triangles)
}

const IDENTITY: [[f32; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// The clip-space position of a window position, exact.
fn clip([x, y]: [i32; 2], size: u32) -> [f32; 3] {
    let half = (size as i32 * PIXEL / 2) as f32;
    [(x as f32 - half) / half, (half - y as f32) / half, 0.5]
}

/// Adds what the reference covers to masks in the order of storage; whether that is anything.
fn cover(frame: &Frame, corners: &Corners, masks: &mut [u16]) -> Result<bool, Failure> {
    let pitch = frame.width() / 4;
    let (mut any, mut wrong) = (false, false);
    cover_rows(corners, frame.grid::<Standard>()?, frame.scissor_rect(), |y, columns| {
        any = true;
        for x in columns {
            let bit = 1 << (4 * (y % 4) + x % 4);
            let mask = &mut masks[(y / 4 * pitch + x / 4) as usize];
            wrong |= *mask & bit != 0;
            *mask |= bit;
        }
    });
    ensure!(!wrong, "{corners:?} reaches into another cell");
    Ok(any)
}
