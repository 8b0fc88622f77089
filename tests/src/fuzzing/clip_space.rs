//! Any bits as clip-space vertices.

use super::{
    check,
    input::{Faces, Place},
};
use crate::{
    Frame, case,
    failure::Verdict,
    properties::{clipping, meshlets, neighbours, simd, statistics},
    shapes::{Model, Projection, clip_bits},
};
use arbitrary::Arbitrary;
use halfplane::{DepthTest, Format, Small, Standard};

/// Largest side of a frame.
const SIDE: u16 = 48;
/// Most triangles of a mesh.
const MOST_TRIANGLES: usize = 24;

#[derive(Debug, Arbitrary)]
struct Case {
    small: bool,
    place: Place,
    faces: Faces,
    attachments: u8,
    /// An object-space matrix of any bits; otherwise x and y as they are, and z as w.
    matrix: Option<[[u32; 4]; 4]>,
    /// Triangles of the vertices before.
    shared: Vec<[u8; 3]>,
    /// Three vertices each: [`clip_bits`].
    vertices: Vec<[u32; 13]>,
}

/// Meshes of NaN, infinities, denormals and ordinary numbers: every triangle is counted under a cause that
/// is true of it, neighbours have the same edges, and every vector level draws the same.
pub fn clip_space(data: &[u8]) -> Verdict {
    check(data, |case: &Case| if case.small { holds::<Small>(case) } else { holds::<Standard>(case) })
}

fn holds<F: Format>(case: &Case) -> Verdict {
    let mut triangles: Vec<_> =
        case.vertices.iter().take(MOST_TRIANGLES).map(|&numbers| clip_bits(numbers)).collect();
    let vertices = triangles.as_flattened().to_vec();
    let mut indices: Vec<u32> = (0..vertices.len() as u32).collect();
    if !vertices.is_empty() {
        for corners in case.shared.iter().take(MOST_TRIANGLES) {
            let corners = corners.map(|corner| usize::from(corner) % vertices.len());
            indices.extend(corners.map(|corner| corner as u32));
            triangles.push(corners.map(|corner| vertices[corner]));
        }
    }

    let frame = case.place.viewport::<F>(SIDE);
    statistics::of_clip_space_add_up::<F>(&triangles, frame.region)?;
    for triangle in triangles.iter().take(4) {
        neighbours::other_sides_cancel::<F>(&frame, triangle)?;
        clipping::pieces_have_one_winding::<F>(&frame, triangle)?;
    }
    for corners in vertices.windows(4).take(2) {
        neighbours::closed_surfaces_cancel::<F>(&frame, &[corners[0], corners[1], corners[2], corners[3]])?;
    }
    if !case.small {
        every_level(case, case.place.small::<Standard>(SIDE), &vertices, indices)?;
    }
    Ok(())
}

/// The same vertices, but for their w, through a matrix.
fn every_level(case: &Case, frame: Frame, vertices: &[[f32; 4]], indices: Vec<u32>) -> Verdict {
    let matrix = case
        .matrix
        .map_or([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.5, 1.0], [0.0; 4]], |rows| {
            rows.map(|row| row.map(f32::from_bits))
        });
    let drawn = case::Case {
        frame,
        viewport: frame.region,
        projection: Projection::Bits,
        wanted: Vec::new(),
        model: Model { vertices: vertices.iter().map(|&[x, y, z, _]| [x, y, z]).collect(), matrix },
        indices,
        first_id: 0,
        cull: case.faces.cull(),
        front: case.faces.front(),
        test: DepthTest::LESS,
        attachments: case.attachments.into(),
        contents: 0,
    };
    simd::frame_is_the_scalar_one(&drawn)?;
    meshlets::meshlets_are_the_mesh(&drawn)?;
    Ok(())
}
