//! All triangles with corners on a small lattice: coverage, and the ownership of shared edges.
//!
//! Nothing joins triangles with different first corners, so those of each are a part by themselves.

use crate::{Failure, Frame, ensure, failure::Verdict, frame::window_vertices, shapes::Corners};
use halfplane::{Footprint, Format, Region, Triangle, Uncertainty, traverse, traverse_conservative};
use halfplane_reference::{cover_rows, inside_rows, touch_rows};

/// Pixels on a side of the window that is looked at; one bit each in a [`Picture`].
const SIDE: u32 = 64;

/// Rows of 64 pixels.
type Picture = [u64; SIDE as usize];

/// A square lattice of points, in steps.
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    /// First point.
    pub origin: [i32; 2],
    /// Points on a side.
    pub side: i32,
    /// Steps between points.
    pub spacing: i32,
}

impl Lattice {
    /// How many points there are.
    pub fn points(self) -> i32 {
        self.side * self.side
    }

    /// The point of that number, row by row.
    pub(super) fn point(self, number: i32) -> [i32; 2] {
        let Self { origin: [x, y], side, spacing } = self;
        [x + number % side * spacing, y + number / side * spacing]
    }

    /// The pixels from the first row and column that a corner can be in: what has to be compared.
    fn window(self, frame: &Frame, steps: i32) -> [u32; 4] {
        let far = |axis: usize| {
            let end = self.origin[axis] + self.side * self.spacing;
            ((end / steps + 2).max(1) as u32).min(frame.region[2 + axis])
        };
        let near = |axis: usize| (self.origin[axis] / steps - 2).max(0) as u32 & !3;
        [near(0), near(1), far(0), far(1)]
    }
}

/// Every ordered triple of lattice points (so both windings, every first corner and the degenerate
/// ones): the core covers what the reference covers; and for every pair of points, the samples between
/// them belong to the triangles on exactly one side.
///
/// Returns the number of triangles.
pub fn every_triangle<F: Format>(frame: &Frame, lattice: Lattice) -> Result<u64, Failure> {
    (0..lattice.points()).map(|first| every_triangle_from::<F>(frame, lattice, first)).sum()
}

/// [`every_triangle`] whose first corner is that point.
pub fn every_triangle_from<F: Format>(frame: &Frame, lattice: Lattice, first: i32) -> Result<u64, Failure> {
    let window = lattice.window(frame, 1 << F::SUBPIXEL_BITS);
    let p = lattice.point(first);
    let mut triangles = 0;
    for b in 0..lattice.points() {
        let q = lattice.point(b);
        let mut owner = Owner::new::<F>(frame, window, p, q);
        for c in 0..lattice.points() {
            let corners = [p, q, lattice.point(c)];
            let drawn = drawn::<F>(frame, &corners)?;
            compare::<F>(frame, window, &corners, &drawn)?;
            owner.take(&corners, &drawn)?;
            triangles += 1;
        }
        owner.verdict(p, q)?;
    }
    Ok(triangles)
}

/// Every triple of lattice points that begins with that one, the other two in ascending order (over all first points
/// that is each triangle with both windings): the pixels that the closed triangle touches, and those that lie in it, are
/// the reference's, with and without uncertainty.
///
/// Returns the number of triangles.
pub fn every_footprint_from<F: Format>(frame: &Frame, lattice: Lattice, first: i32) -> Result<u64, Failure> {
    let [x0, y0, x1, y1] = frame.scissor;
    let region = Region::new(x0, y0, x1, y1)?;
    let p = lattice.point(first);
    let others = (0..lattice.points()).flat_map(|b| (b..lattice.points()).map(move |c| (b, c)));
    let mut triangles = 0;
    for (b, c) in others {
        let corners = [p, lattice.point(b), lattice.point(c)];
        for (uncertainty, half_steps) in [(Uncertainty::None, 0), (Uncertainty::HalfStep, 1)] {
            let footprint = Footprint::new(window_vertices::<F>(&corners, [9; 3])?, uncertainty);
            let mut drawn = [[0; SIDE as usize]; 2];
            traverse_conservative(&footprint, region, |x, y, touched, inside| {
                for (picture, mask) in drawn.iter_mut().zip([touched, inside]) {
                    for (column, row) in mask.cells() {
                        picture[(y + row) as usize % 64] |= 1 << ((x + column) % 64);
                    }
                }
            });
            let mut expected = [[0; SIDE as usize]; 2];
            let [touched, inside] = &mut expected;
            let row_of = |picture: &mut Picture, y: u32, columns: std::ops::Range<u32>| {
                columns.for_each(|x| picture[y as usize % 64] |= 1 << (x % 64));
            };
            let (bits, rect) = (F::SUBPIXEL_BITS, frame.scissor_rect());
            touch_rows(&corners, bits, half_steps, rect, |y, columns| row_of(touched, y, columns));
            inside_rows(&corners, bits, half_steps, rect, |y, columns| row_of(inside, y, columns));
            ensure!(
                drawn == expected,
                "{corners:?}, {uncertainty:?}: touched and inside {drawn:x?}, expected {expected:x?}"
            );
        }
        triangles += 1;
    }
    Ok(triangles)
}

/// The core's coverage, by the level below `draw`.
fn drawn<F: Format>(frame: &Frame, corners: &Corners) -> Result<Picture, Failure> {
    let mut picture = [0; SIDE as usize];
    let [x0, y0, x1, y1] = frame.scissor;
    let vertices = window_vertices::<F>(corners, [9; 3])?;
    if let Some(triangle) = Triangle::new(vertices, frame.core_sample()?) {
        traverse(&triangle, Region::new(x0, y0, x1, y1)?, |x, y, mask| {
            for (column, row) in mask.cells() {
                picture[(y + row) as usize % 64] |= 1 << ((x + column) % 64);
            }
        });
    }
    Ok(picture)
}

fn compare<F: Format>(
    frame: &Frame,
    [_, y0, _, y1]: [u32; 4],
    corners: &Corners,
    drawn: &Picture,
) -> Verdict {
    let mut expected = [0u64; SIDE as usize];
    cover_rows(corners, frame.grid::<F>()?, frame.scissor_rect(), |y, columns| {
        for x in columns {
            expected[y as usize % 64] |= 1 << (x % 64);
        }
    });
    for y in y0 as usize..y1 as usize {
        ensure!(
            drawn[y] == expected[y],
            "{corners:?}: row {y} is {:#b}, expected {:#b}, sample {:?}",
            drawn[y],
            expected[y],
            frame.sample
        );
    }
    Ok(())
}

/// Which side owns the samples between two points.
struct Owner {
    /// The pixels whose samples lie strictly between the points, on the line.
    between: Vec<(u32, u32)>,
    /// For the clockwise and the counter-clockwise side: the pixels covered by all triangles so far,
    /// and by any. Only rows with a sample in between are kept up to date.
    sides: [Option<(Picture, Picture)>; 2],
}

impl Owner {
    fn new<F: Format>(frame: &Frame, [x0, y0, x1, y1]: [u32; 4], p: [i32; 2], q: [i32; 2]) -> Self {
        let on_segment = |pixel: &(u32, u32)| {
            let [x, y] = frame.sample_at::<F>(*pixel);
            let [[px, py], [qx, qy]] = [p, q].map(|point| point.map(i64::from));
            let on_line = (qx - px) * (y - py) == (qy - py) * (x - px);
            let along = (x - px) * (qx - px) + (y - py) * (qy - py);
            on_line && along > 0 && along < (qx - px) * (qx - px) + (qy - py) * (qy - py)
        };
        let pixels = (y0..y1).flat_map(|y| (x0..x1).map(move |x| (x, y)));
        let inside = |pixel: &(u32, u32)| frame.scissor_has(*pixel);
        Self { between: pixels.filter(inside).filter(on_segment).collect(), sides: [None, None] }
    }

    fn take(&mut self, corners: &Corners, drawn: &Picture) -> Verdict {
        let side = match crate::shapes::doubled_area(corners) {
            0 => return Ok(()),
            1.. => 0,
            _ => 1,
        };
        let (all, any) = self.sides[side].get_or_insert(([u64::MAX; SIDE as usize], [0; SIDE as usize]));
        for &(_, y) in &self.between {
            all[y as usize % 64] &= drawn[y as usize % 64];
            any[y as usize % 64] |= drawn[y as usize % 64];
        }
        Ok(())
    }

    /// All triangles of one side have the samples in between, all of the other have not.
    fn verdict(&self, p: [i32; 2], q: [i32; 2]) -> Verdict {
        let [Some(left), Some(right)] = &self.sides else { return Ok(()) };
        let has = |picture: &Picture, (x, y): (u32, u32)| picture[y as usize % 64] >> (x % 64) & 1 != 0;
        for &pixel in &self.between {
            let owners = [left, right].map(|(all, any)| (has(all, pixel), has(any, pixel)));
            ensure!(
                matches!(owners, [(true, true), (false, false)] | [(false, false), (true, true)]),
                "edge {p:?} to {q:?}: the sample of pixel {pixel:?} belongs to {owners:?} (all, any; by side)"
            );
        }
        Ok(())
    }
}
