//! Meshes are watertight: each sample inside belongs to exactly one triangle.

use crate::{
    Failure, Frame,
    double::Overdraw,
    failure::Verdict,
    shapes::{Mesh, Random},
};
use halfplane::{Format, Vertex, draw};

/// Every sample in the mesh's outline is covered exactly once and no other, whatever the order of the
/// triangles, the corner that each begins at and its winding.
///
/// The outline is a rectangle, so its samples are known without any edge function: those from the left
/// and top sides, included, to the right and bottom ones, excluded.
pub fn each_sample_once<F: Format>(frame: &Frame, mesh: &Mesh, order: u64) -> Verdict {
    let triangles = mesh.shuffled(&mut Random(order));
    let [x0, y0, x1, y1] = mesh.outline.map(i64::from);
    let counts = counted::<F>(frame, mesh, &triangles)?;
    counts.verdict()?;
    counts.matches(|pixel| {
        let [x, y] = frame.sample_at::<F>(pixel);
        u16::from(frame.scissor_has(pixel) && x0 <= x && x < x1 && y0 <= y && y < y1)
    })
}

/// How often each sample is covered.
pub fn counted<F: Format>(frame: &Frame, mesh: &Mesh, triangles: &[[u32; 3]]) -> Result<Overdraw, Failure> {
    let vertices: Vec<Vertex<F>> =
        mesh.xy.iter().map(|&[x, y]| Vertex::new(x, y, 1 << 20)).collect::<Result<_, _>>()?;
    let mut counts = Overdraw::new(*frame);
    draw(&vertices[..], triangles.as_flattened(), 0, &frame.state()?, &mut counts)?;
    Ok(counts)
}
