//! Every triangle is counted once, under the right cause.

use crate::{
    Failure, Frame, ensure, ensure_eq, failure::Verdict, oracle, shapes::doubled_area, strategies::Shot,
};
use halfplane::{
    ClipPositions, Count, Cull, CulledCounts, Format, Region, RejectedCounts, State, Statistics, Viewport,
    Winding, draw,
};

/// The counts sum to the number of submitted triangles.
pub fn add_up(statistics: &Statistics, submitted: usize) -> Verdict {
    let Statistics { drawn, culled, rejected, clipped, .. } = *statistics;
    let CulledCounts { facing, zero_area, no_sample, outside, hidden } = culled;
    let RejectedCounts { non_finite, no_vertex } = rejected;
    let sum = [drawn, facing, zero_area, no_sample, outside, hidden, non_finite, no_vertex]
        .iter()
        .map(|&count| u64::from(count))
        .sum::<u64>();
    ensure_eq!(u64::from(statistics.submitted), submitted as u64, "submitted");
    ensure_eq!(sum, submitted as u64, "the sum of all causes in {statistics}");
    ensure_eq!(culled.total(), facing + zero_area + no_sample + outside + hidden, "culled in total");
    ensure_eq!(rejected.total(), non_finite + no_vertex, "rejected in total");
    ensure!(clipped as usize <= submitted, "more clipped than submitted: {statistics}");
    Ok(())
}

/// Window triangles are counted as drawn exactly where they cover a sample and are not culled by their
/// facing, and otherwise under a cause that is true of them; single draws, added, give the same.
pub fn equal_model<F: Format>(frame: &Frame, shots: &[Shot], cull: Cull, front: Winding) -> Verdict {
    let state = State { cull, front, ..frame.state::<F>()? };
    let vertices = super::scene::vertices::<F>(shots)?;
    let indices: Vec<u32> = (0..vertices.len() as u32).collect();
    let statistics = draw(&vertices[..], &indices, 0, &state, &mut ())?;
    add_up(&statistics, shots.len())?;
    let mut sum = Statistics::default();
    for (triangle, shot) in indices.chunks(3).zip(shots) {
        let one = draw(&vertices[..], triangle, 0, &state, &mut ())?;
        add_up(&one, 1)?;
        let is = Truth::of::<F>(frame, shot, cull, front)?;
        ensure_eq!(one.drawn == 1, is.drawn, "drawn, of {shot:?}: {one}");
        let wrong = [
            (one.culled.facing, is.facing),
            (one.culled.zero_area, is.zero_area),
            (one.culled.no_sample, is.no_sample),
            (one.culled.outside, is.outside),
            (one.rejected.total(), false),
            (one.clipped, false),
        ];
        ensure!(wrong.iter().all(|&(count, cause)| count == 0 || cause), "{is:?}, but {one}");
        sum += one;
    }
    ensure_eq!(sum, statistics, "the statistics of single draws, added");
    Ok(())
}

/// What is true of a triangle, by the definitions.
#[derive(Clone, Copy, Debug)]
struct Truth {
    drawn: bool,
    facing: bool,
    zero_area: bool,
    no_sample: bool,
    outside: bool,
}

impl Truth {
    fn of<F: Format>(frame: &Frame, shot: &Shot, cull: Cull, front: Winding) -> Result<Self, Failure> {
        let area = doubled_area(&shot.corners);
        let winding = if area > 0 { Winding::Clockwise } else { Winding::CounterClockwise };
        let facing = area != 0
            && match cull {
                Cull::None => false,
                Cull::Back => winding != front,
                Cull::Front => winding == front,
            };
        let [x0, y0, x1, y1] = frame.scissor.map(|v| i64::from(v) << F::SUBPIXEL_BITS);
        let apart = |axis: usize, low: i64, high: i64| {
            let values = shot.corners.map(|corner| i64::from(corner[axis]));
            values.iter().all(|&v| v <= low) || values.iter().all(|&v| v >= high)
        };
        let outside = apart(0, x0, x1) || apart(1, y0, y1);
        let covers = oracle::coverage::<F>(frame, &shot.corners)?.contains(&true);
        let no_sample = area != 0 && !covers && !outside;
        Ok(Self { drawn: covers && !facing, facing, zero_area: area == 0, no_sample, outside })
    }
}

/// Clip-space triangles of any bits: all are counted, those with a NaN or an infinity as such, and
/// nothing outside the viewport is covered.
pub fn of_clip_space_add_up<F: Format>(triangles: &[[[f32; 4]; 3]], target: [u32; 4]) -> Verdict {
    let [x0, y0, x1, y1] = target;
    let region = Region::<F>::new(x0, y0, x1, y1)?;
    let vertices = triangles.as_flattened();
    let positions = ClipPositions::new(vertices, Viewport::new(region));
    let indices: Vec<u32> = (0..vertices.len() as u32).collect();
    let mut count = Count::default();
    let statistics = draw(&positions, &indices, 9, &State::new(region), &mut count)?;
    add_up(&statistics, triangles.len())?;
    let finite = |triangle: &[[f32; 4]; 3]| triangle.as_flattened().iter().all(|v| v.is_finite());
    let non_finite = triangles.iter().filter(|triangle| !finite(triangle)).count();
    ensure_eq!(statistics.rejected.non_finite as usize, non_finite, "triangles with a NaN or an infinity");
    ensure_eq!(statistics.rejected.no_vertex, 0, "vertices that are not there");
    ensure!((statistics.drawn > 0) == (count.samples > 0), "{} samples, but {statistics}", count.samples);
    for (place, triangle) in triangles.iter().enumerate() {
        for (plane, outside) in frustum(*triangle) {
            if outside && finite(triangle) {
                let one = [3 * place as u32, 3 * place as u32 + 1, 3 * place as u32 + 2];
                let alone = draw(&positions, &one, 0, &State::new(region), &mut ())?;
                ensure_eq!(alone.culled.outside, 1, "triangle {place} is outside plane {plane}, but {alone}");
            }
        }
    }
    Ok(())
}

/// For each plane of the frustum, whether all three vertices are outside it.
fn frustum(triangle: [[f32; 4]; 3]) -> [(&'static str, bool); 6] {
    let all = |outside: fn([f32; 4]) -> bool| triangle.into_iter().all(outside);
    [
        ("near", all(|[_, _, z, _]| z < 0.0)),
        ("far", all(|[_, _, z, w]| z > w)),
        ("left", all(|[x, _, _, w]| x < -w)),
        ("right", all(|[x, _, _, w]| x > w)),
        ("top", all(|[_, y, _, w]| y > w)),
        ("bottom", all(|[_, y, _, w]| y < -w)),
    ]
}

/// A position whose count is wrong: some vertices are not there.
#[derive(Clone, Copy, Debug)]
pub struct Liar<'a, F>(pub &'a [halfplane::Vertex<F>], pub usize);

impl<F: Format> halfplane::Positions<F> for Liar<'_, F> {
    fn count(&self) -> usize {
        self.1
    }

    fn assemble<E: FnMut([halfplane::Vertex<F>; 3])>(
        &self,
        corners: [usize; 3],
        emit: E,
    ) -> halfplane::Assembly {
        self.0.assemble(corners, emit)
    }
}

/// Positions that count more vertices than they have lose no triangle: those without a vertex are
/// counted as such.
pub fn of_missing_vertices_add_up<F: Format>(vertices: &[halfplane::Vertex<F>], more: usize) -> Verdict {
    let count = vertices.len() + more;
    let indices: Vec<u32> = (0..count as u32).flat_map(|k| [0, k, k / 2]).collect();
    let state = State::new(Region::<F>::of_size(16, 16)?);
    let statistics = draw(&Liar(vertices, count), &indices, 0, &state, &mut ())?;
    add_up(&statistics, count)?;
    let missing = (0..count).filter(|&k| k >= vertices.len() || vertices.is_empty()).count();
    ensure_eq!(statistics.rejected.no_vertex as usize, missing, "triangles without a vertex");
    Ok(())
}
