//! How far snapped vertices lie from where exact arithmetic puts them.

use halfplane_reference::{Rational, Viewport, from_f32, from_steps, to_clip, to_window};
use rayon::prelude::*;

use crate::camera::Matrix;
use crate::mesh::Mesh;

use super::Whole;

/// At most so many vertices are measured, evenly spread over those there are.
const SAMPLE: usize = 20_000;

/// Largest distances, along x or y, in sub-pixel steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displacement {
    /// Vertices measured.
    pub vertices: usize,
    /// From the exact image of the clip-space vertex: division, viewport and snapping. Snapping
    /// alone moves a vertex by half a step at most.
    pub from_clip: f64,
    /// From the exact image of the model's vertex: the matrix product in `f32` as well.
    pub from_model: f64,
}

/// Measures the vertices of triangles that needed no clipping.
#[must_use]
pub fn displacement(
    mesh: &Mesh,
    matrix: &Matrix,
    clip: &[[f32; 4]],
    whole: &[Whole],
    (width, height): (u32, u32),
    subpixel_bits: u32,
) -> Displacement {
    let viewport = Viewport { x: 0, y: 0, width, height };
    let mut seen = vec![false; clip.len()];
    let mut vertices: Vec<(usize, [i32; 2])> = Vec::new();
    for triangle in whole {
        for (vertex, xy) in triangle.corners.into_iter().zip(triangle.xy) {
            if !std::mem::replace(&mut seen[vertex], true) {
                vertices.push((vertex, xy));
            }
        }
    }
    let stride = vertices.len().div_ceil(SAMPLE).max(1);
    let measured: Vec<_> = vertices.iter().step_by(stride).collect();
    let distance = |point: &[Rational; 4], xy: [i32; 2]| -> f64 {
        let Some(exact) = to_window(point, viewport) else {
            return f64::INFINITY;
        };
        let axis = |exact: Rational, steps: i32| {
            let off = exact - from_steps(i64::from(steps), subpixel_bits);
            nearest_f64(&off).abs() * f64::from(1u32 << subpixel_bits)
        };
        axis(exact.position.x, xy[0]).max(axis(exact.position.y, xy[1]))
    };
    let (from_clip, from_model) = measured
        .par_iter()
        .map(|&&(vertex, xy)| {
            let from_clip = exact(clip[vertex]).map_or(f64::INFINITY, |p| distance(&p, xy));
            let model = to_clip(mesh.positions[vertex], matrix);
            (from_clip, model.map_or(f64::INFINITY, |p| distance(&p, xy)))
        })
        .reduce(|| (0.0, 0.0), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    Displacement { vertices: measured.len(), from_clip, from_model }
}

fn exact(point: [f32; 4]) -> Option<[Rational; 4]> {
    let [x, y, z, w] = point.map(from_f32);
    Some([x?, y?, z?, w?])
}

fn nearest_f64(value: &Rational) -> f64 {
    use num_traits::ToPrimitive;
    value.to_f64().unwrap_or(f64::INFINITY)
}
