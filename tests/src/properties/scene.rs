//! Whole scenes: depths and ids equal the reference's picture.

use crate::{Failure, Frame, ensure, ensure_eq, failure::Verdict, oracle, strategies::Shot};
use halfplane::{Compare, Depth, DepthFormat, DepthTest, Format, Ids, Statistics, Vertex, draw, texels};
use halfplane_reference::{DepthSpec, Scene, SceneTriangle, render, verify};

/// A finished picture of a frame: rows of depths and ids.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Depths.
    pub depth: Vec<u32>,
    /// Ids.
    pub ids: Vec<u32>,
}

/// The window vertices of all triangles, three for each.
pub fn vertices<F: Format>(shots: &[Shot]) -> Result<Vec<Vertex<F>>, Failure> {
    let mut vertices = Vec::with_capacity(3 * shots.len());
    for shot in shots {
        vertices.extend(crate::frame::window_vertices::<F>(&shot.corners, shot.z)?);
    }
    Ok(vertices)
}

/// Draws triangles into depth and ids, cleared as the comparison wants it.
pub fn drawn<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    shots: &[Shot],
    compare: Compare,
) -> Result<(Statistics, Picture), Failure> {
    let size = texels(frame.width(), frame.height());
    let (mut depth_storage, mut id_storage) = (vec![D::NEAR; size], vec![0; size]);
    let region = frame.core_region()?;
    let test = DepthTest { compare, write: true };
    let mut depth = Depth::<F, D>::new(region, &mut depth_storage, test)?;
    let mut ids = Ids::<F>::new(region, &mut id_storage)?;
    let reversed = matches!(compare, Compare::Greater | Compare::GreaterEqual);
    depth.clear(if reversed { D::NEAR } else { D::FAR });
    ids.clear();
    let indices: Vec<u32> = (0..3 * shots.len() as u32).collect();
    let statistics = draw(&vertices(shots)?[..], &indices, 0, &frame.state()?, &mut (&mut depth, &mut ids))?;
    let mut rows = vec![D::NEAR; (frame.width() * frame.height()) as usize];
    depth.to_linear(&mut rows)?;
    let mut id_rows = vec![0; rows.len()];
    ids.to_linear(&mut id_rows)?;
    Ok((statistics, Picture { depth: rows.into_iter().map(Into::into).collect(), ids: id_rows }))
}

/// The picture of a frame at the origin equals the reference's, pixel by pixel, and its verifier says
/// so as well.
pub fn equals_reference<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    shots: &[Shot],
    compare: Compare,
    spec: DepthSpec,
) -> Verdict {
    let (statistics, picture) = drawn::<F, D>(frame, shots, compare)?;
    let [sample_x, sample_y] = frame.sample;
    let triangle = |(id, shot): (u32, &Shot)| SceneTriangle {
        xy: shot.corners,
        z: oracle::vertex_depths(shot.z, spec),
        id,
    };
    let scene = Scene {
        width: frame.width(),
        height: frame.height(),
        subpixel_bits: F::SUBPIXEL_BITS,
        sample: (sample_x, sample_y),
        triangles: (0..).zip(shots).map(triangle).collect(),
    };
    let compare = oracle::compare(compare);
    let expected = render(&scene, compare, spec, &|_| ())?;
    for (place, pixel) in frame.pixels().enumerate() {
        ensure_eq!(picture.ids[place], expected.ids[place], "id at pixel {pixel:?}");
        ensure_eq!(picture.depth[place], expected.depth[place], "depth at pixel {pixel:?}");
    }
    let report = verify(&scene, compare, spec, &picture.depth, Some(&picture.ids), &|_| ())?;
    ensure!(report.identical(), "the verifier finds a difference: {report}");
    ensure!(statistics.drawn as usize <= shots.len(), "more drawn than submitted: {statistics}");
    Ok(())
}
