//! What a rung costs beside triangles that are in good shape.

use std::time::Instant;

use halfplane::{
    ClipPositions, Depth, DepthTest, Positions, Region, Standard, State, Vertex, Viewport, draw, texels,
};
use halfplane_measure::clip;

use super::{Rung, Shapes, vertices};
use crate::error::ReportError;

/// Draws that are timed; the shortest counts.
const REPEATS: usize = 7;

/// Milliseconds of a draw of a rung into 32-bit depth with plain arrays for lanes, and that over the time of as
/// many right triangles that cover about as many samples.
///
/// # Errors
///
/// Where a rung cannot be drawn.
pub fn time(rung: &Rung, samples: u64) -> Result<(f64, f64), ReportError> {
    let state = State::<Standard>::new(Region::of_size(rung.size.0, rung.size.1)?);
    let mut times = [f64::INFINITY; 2];
    match &rung.shapes {
        Shapes::Window(triangles) => {
            let corners = triangles.iter().map(vertices).collect::<Result<Vec<_>, _>>()?.into_flattened();
            let others = good(triangles.len(), samples, rung.size)
                .into_iter()
                .map(|[x, y]| Vertex::new(x, y, 1 << 30))
                .collect::<Result<Vec<_>, _>>()?;
            for _ in 0..REPEATS {
                once(&corners[..], &state, &mut times[0])?;
                once(&others[..], &state, &mut times[1])?;
            }
        }
        Shapes::Model { positions, matrix } => {
            let vertices: Vec<_> = positions.iter().map(|&position| clip(position, matrix)).collect();
            let (width, height) = rung.size;
            let others: Vec<[f32; 4]> = good(positions.len() / 3, samples, rung.size)
                .into_iter()
                .map(|[x, y]| {
                    let at = |v: i32, side: u32| v as f32 / 128.0 / side as f32 - 1.0;
                    [at(x, width), -at(y, height), 0.5, 1.0]
                })
                .collect();
            let viewport = Viewport::new(state.scissor);
            for _ in 0..REPEATS {
                once(&ClipPositions::new(&vertices, viewport), &state, &mut times[0])?;
                once(&ClipPositions::new(&others, viewport), &state, &mut times[1])?;
            }
        }
    }
    Ok((times[0], times[0] / times[1]))
}

/// Draws some times and keeps the shortest time of one draw in milliseconds.
fn once<P: Positions<Standard> + ?Sized>(
    positions: &P,
    state: &State<Standard>,
    shortest: &mut f64,
) -> Result<(), ReportError> {
    let (width, height) = (state.scissor.width(), state.scissor.height());
    let mut storage = vec![u32::MAX; texels(width, height)];
    let mut depth = Depth::<Standard>::new(state.scissor, &mut storage, DepthTest::LESS)?;
    let indices: Vec<u32> = (0..positions.count() as u32).collect();
    // Long enough for the clock.
    let draws = 4 + 512 / (indices.len() / 3).max(1);
    let started = Instant::now();
    for _ in 0..draws {
        draw(positions, &indices, 0, state, &mut depth)?;
    }
    *shortest = shortest.min(started.elapsed().as_secs_f64() * 1e3 / draws as f64);
    Ok(())
}

/// The corners of right triangles with equal legs, spread over the target, that cover about so many samples.
fn good(count: usize, samples: u64, (width, height): (u32, u32)) -> Vec<[i32; 2]> {
    let leg = (2.0 * samples as f64 / count as f64).sqrt().clamp(0.5, f64::from(width.min(height)));
    let leg = (leg * 256.0) as i32;
    let mut corners = Vec::with_capacity(3 * count);
    for number in 0..count {
        // Evenly over the target by two irrational steps (Roberts's R2).
        let at = |step: f64, side: u32| {
            let room = f64::from(side) * 256.0 - f64::from(leg);
            (((number as f64 + 0.5) * step).fract() * room.max(1.0)) as i32
        };
        let (x, y) = (at(0.754_877_666_246_692_7, width), at(0.569_840_290_998_053_2, height));
        corners.extend([[x, y], [x + leg, y], [x, y + leg]]);
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_in_good_shape_have_the_area_that_is_asked_for() {
        let corners = good(10, 500, (64, 64));
        assert_eq!(corners.len(), 30);
        let area: f64 = corners
            .as_chunks::<3>()
            .0
            .iter()
            .map(|[a, b, c]| f64::from(b[0] - a[0]) * f64::from(c[1] - a[1]) / 2.0 / 65_536.0)
            .sum();
        assert!((area - 500.0).abs() < 10.0, "{area}");
        assert!(corners.as_flattened().iter().all(|v| (0..=64 * 256).contains(v)));
    }
}
