//! Meshes for watertightness.

use super::{
    check,
    input::{Place, near},
};
use crate::{
    Frame,
    failure::Verdict,
    properties::{clipping::mesh_has_no_seam, watertight::each_sample_once},
    shapes::{Ground, Mesh, Random, fan, grid, triangulation},
};
use arbitrary::Arbitrary;
use halfplane::{Bounds, Format, Small, Standard};

/// Most points of a triangulation: each costs a search through all triangles.
const MOST_POINTS: usize = 80;
/// Largest side of a frame that a clipped mesh is drawn in: the exact outline costs.
const CLIPPED_SIDE: u16 = 40;

#[derive(Debug, Arbitrary)]
struct Case {
    small: bool,
    place: Place,
    /// Of the triangles and their corners.
    order: u64,
    mesh: Shape,
}

#[derive(Debug, Arbitrary)]
enum Shape {
    Fan {
        half: u32,
        count: u8,
        hub_at_sample: bool,
    },
    Grid {
        outline: Outline,
        columns: u8,
        rows: u8,
    },
    /// In clip space.
    Ground([u32; 12]),
    Triangulation {
        outline: Outline,
        points: Vec<Point>,
    },
}

#[derive(Clone, Copy, Debug, Arbitrary)]
enum Outline {
    /// The guard band.
    Whole,
    /// So many steps beside the frame's region: left, top, right, bottom.
    Beside([i16; 4]),
}

#[derive(Clone, Copy, Debug, Arbitrary)]
enum Point {
    /// Steps from the scissor's first pixel.
    Near([i16; 2]),
    /// Anywhere in the outline.
    Anywhere([u32; 2]),
    /// A sample.
    Sample([u8; 2]),
}

/// Each sample of a mesh exactly once: triangulations, grids and fans in the window; planes that the near
/// plane and the guard band cut.
pub fn meshes(data: &[u8]) -> Verdict {
    check(data, |case: &Case| if case.small { holds::<Small>(case) } else { holds::<Standard>(case) })
}

fn holds<F: Format>(case: &Case) -> Verdict {
    let frame = case.place.frame::<F>();
    let mut random = Random(case.order);
    let mesh = match &case.mesh {
        Shape::Ground(numbers) => {
            let frame = case.place.viewport::<F>(CLIPPED_SIDE);
            let frame = Frame { sample: Frame::whole::<F>(1, 1).sample, ..frame };
            return mesh_has_no_seam::<F>(&frame, &Ground::from_numbers(*numbers, case.order));
        }
        Shape::Fan { half, count, hub_at_sample } => {
            let [x, y] = frame.sample_at::<F>((frame.scissor[0], frame.scissor[1])).map(|v| v as i32);
            let room = Bounds::<F>::GUARD_BAND - x.max(y);
            let mut fan = fan([x, y], 4 + (half % room as u32) as i32 / 2, (*count).into(), &mut random);
            if *hub_at_sample {
                fan.xy[0] = [x, y];
            }
            fan
        }
        Shape::Grid { outline, columns, rows } => {
            grid(outline.of::<F>(&frame), 1 + u32::from(columns % 12), 1 + u32::from(rows % 12), &mut random)
        }
        Shape::Triangulation { outline, points } => cut::<F>(&frame, outline.of::<F>(&frame), points),
    };
    each_sample_once::<F>(&frame, &mesh, case.order)
}

fn cut<F: Format>(frame: &Frame, outline: [i32; 4], points: &[Point]) -> Mesh {
    let [x0, y0, x1, y1] = outline;
    let place = |point: &Point| {
        let [x, y] = match *point {
            Point::Near(point) => near::<F>(frame, point),
            Point::Anywhere([x, y]) => {
                let within = |v: u32, from: i32, to: i32| from + (v % (to - from) as u32) as i32;
                [within(x, x0, x1), within(y, y0, y1)]
            }
            Point::Sample([x, y]) => {
                let pixel = (frame.region[0] + u32::from(x), frame.region[1] + u32::from(y));
                frame.sample_at::<F>(pixel).map(|v| v as i32)
            }
        };
        [x.clamp(x0, x1), y.clamp(y0, y1)]
    };
    triangulation(outline, &points.iter().take(MOST_POINTS).map(place).collect::<Vec<_>>())
}

impl Outline {
    /// `[x0, y0, x1, y1]` in steps, never empty.
    fn of<F: Format>(self, frame: &Frame) -> [i32; 4] {
        let guard = Bounds::<F>::GUARD_BAND;
        let Self::Beside(beside) = self else { return [-guard, -guard, guard, guard] };
        let [x0, y0, x1, y1] = std::array::from_fn(|side| {
            let end = (frame.region[side] as i32) << F::SUBPIXEL_BITS;
            (end + i32::from(beside[side])).clamp(-guard, guard)
        });
        let first = |low: i32, high: i32| low.min(high).min(guard - 1);
        [first(x0, x1), first(y0, y1), x1.max(first(x0, x1) + 1), y1.max(first(y0, y1) + 1)]
    }
}
