//! A rung's errors: ours and the textbooks', against the exact reference.

use halfplane::{
    Attachment, Block, ClipPositions, Mask, Positions, Region, Standard, State, Vertex, Viewport, draw,
};
use halfplane_measure::clip;
use halfplane_reference::{Grid, Model, NO_ID, Rect, cover_rows, unsnapped};

use super::homogeneous::Homogeneous;
use super::{Rung, Shapes, edges, vertices};
use crate::error::ReportError;
use crate::judge::Judge;
use crate::statistics::Errors;

/// What was found.
#[derive(Debug, Clone, Copy)]
pub struct Judged {
    /// Samples that the triangles cover, each as often as it is covered: exact.
    pub samples: u64,
    /// Samples that are covered and should not be or the reverse: by this crate, and by edge functions in `f32`
    /// and `f64`.
    pub wrong: [u64; 3],
    /// Errors of depth, as [`Judge::errors`].
    pub depth: [Errors; 6],
}

/// A sample of a triangle.
type Cover = (u32, u32, u32);

/// Measures a rung.
///
/// # Errors
///
/// Where it cannot be drawn.
pub fn judge(rung: &Rung) -> Result<Judged, ReportError> {
    let state = State::<Standard>::new(Region::of_size(rung.size.0, rung.size.1)?);
    let mut collector = Collector { covers: Vec::new(), judge: Judge::new(state) };
    let pixels = || (0..rung.size.1).flat_map(|y| (0..rung.size.0).map(move |x| (x, y)));
    let (exact, single, double) = match &rung.shapes {
        Shapes::Window(triangles) => {
            let corners: Vec<Vertex<Standard>> =
                triangles.iter().map(vertices).collect::<Result<Vec<_>, _>>()?.into_flattened();
            draw_all(&corners[..], &state, &mut collector)?;
            let grid = Grid::new(8, (128, 128)).map_err(halfplane_reference::SceneError::from)?;
            let rect = Rect { x0: 0, y0: 0, x1: rung.size.0, y1: rung.size.1 };
            let mut found = (Vec::new(), Vec::new(), Vec::new());
            for (id, triangle) in (0..).zip(triangles) {
                cover_rows(&triangle.0, grid, rect, |y, columns| {
                    found.0.extend(columns.map(|x| (id, y, x)));
                });
                let [x0, y0, x1, y1] = bounds(&triangle.0, rung.size);
                for (y, x) in (y0..y1).flat_map(|y| (x0..x1).map(move |x| (y, x))) {
                    if edges::covers::<f32>(triangle, (x, y)) {
                        found.1.push((id, y, x));
                    }
                    if edges::covers::<f64>(triangle, (x, y)) {
                        found.2.push((id, y, x));
                    }
                }
            }
            found
        }
        Shapes::Model { positions, matrix } => {
            let vertices: Vec<_> = positions.iter().map(|&position| clip(position, matrix)).collect();
            draw_all(&ClipPositions::new(&vertices, Viewport::new(state.scissor)), &state, &mut collector)?;
            let mut found = (Vec::new(), Vec::new(), Vec::new());
            for (id, corners) in (0..).zip(positions.as_chunks::<3>().0) {
                let (width, height) = rung.size;
                let model = Model {
                    positions: corners,
                    indices: &[0, 1, 2],
                    matrix: *matrix,
                    width,
                    height,
                    clockwise_only: false,
                };
                let picture = unsnapped(&model, &|_| ())?;
                let single = Homogeneous::<f32>::new(*corners, matrix, rung.size);
                let double = Homogeneous::<f64>::new(*corners, matrix, rung.size);
                for ((x, y), seen) in pixels().zip(picture.ids) {
                    if seen != NO_ID {
                        found.0.push((id, y, x));
                    }
                    if single.covers((x, y)) {
                        found.1.push((id, y, x));
                    }
                    if double.covers((x, y)) {
                        found.2.push((id, y, x));
                    }
                }
            }
            found
        }
    };
    let Collector { mut covers, judge } = collector;
    covers.sort_unstable();
    Ok(Judged {
        samples: exact.len() as u64,
        wrong: [&covers, &single, &double].map(|given| differing(given, &exact)),
        depth: judge.errors(),
    })
}

fn draw_all<P: Positions<Standard> + ?Sized>(
    positions: &P,
    state: &State<Standard>,
    collector: &mut Collector,
) -> Result<(), ReportError> {
    let indices: Vec<u32> = (0..positions.count() as u32).collect();
    draw(positions, &indices, 0, state, collector)?;
    Ok(())
}

/// Pixels that a triangle's box touches, with one more each way, in the target.
fn bounds(xy: &[[i32; 2]; 3], (width, height): (u32, u32)) -> [u32; 4] {
    let axis = |k: usize, side: u32| {
        let [a, b, c] = [xy[0][k], xy[1][k], xy[2][k]];
        let inside = |steps: i32, more: i32| ((steps >> 8) + more).clamp(0, side as i32) as u32;
        [inside(a.min(b).min(c), -1), inside(a.max(b).max(c), 2)]
    };
    let ([x0, x1], [y0, y1]) = (axis(0, width), axis(1, height));
    [x0, y0, x1, y1]
}

/// How many members of two sorted lists are in one of them only, repetitions counted.
fn differing(given: &[Cover], expected: &[Cover]) -> u64 {
    let (mut given, mut expected) = (given.iter().peekable(), expected.iter().peekable());
    let mut count = 0;
    loop {
        match (given.peek(), expected.peek()) {
            (Some(a), Some(b)) if a == b => {
                given.next();
                expected.next();
                continue;
            }
            (Some(a), Some(b)) if a < b => given.next(),
            (_, Some(_)) => expected.next(),
            (Some(_), None) => given.next(),
            (None, None) => return count,
        };
        count += 1;
    }
}

/// Notes every covered sample, and judges depths.
struct Collector {
    covers: Vec<Cover>,
    judge: Judge,
}

impl Attachment<Standard> for Collector {
    fn begin(&mut self, triangle: &halfplane::Triangle<Standard>) {
        self.judge.begin(triangle);
    }

    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        let cells = block.mask.cells();
        self.covers.extend(cells.map(|(column, row)| (block.id, block.y + row, block.x + column)));
        self.judge.block(block)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_differ_where_one_has_more() {
        let of = |list: &[u32]| -> Vec<Cover> { list.iter().map(|&x| (0, 0, x)).collect() };
        assert_eq!(differing(&of(&[1, 2, 4]), &of(&[1, 3, 4, 5])), 3);
        // Drawn twice is wrong.
        assert_eq!(differing(&of(&[1, 1]), &of(&[1])), 1);
        assert_eq!(differing(&[], &[]), 0);
    }
}
