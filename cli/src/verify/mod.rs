//! A picture against the exact reference: every pixel, and the vertices of the transform.

mod transform;

use std::collections::BTreeMap;

use halfplane::NO_ID;
use halfplane_reference::{Compare, DepthSpec, Report, Scene, render as reference_render, verify};
use halfplane_report::snapped::{self, Whole};

use crate::args::DepthFormat;
use crate::render::{Picture, RenderError, Settings};

pub use transform::{Displacement, displacement};

/// The window triangles of a draw, in its order, as the reference takes them; and which triangles of
/// the mesh were drawn without clipping.
#[must_use]
pub fn assemble(clip: &[[f32; 4]], indices: &[u32], settings: &Settings) -> (Scene, Vec<Whole>) {
    let spec = match settings.depth {
        DepthFormat::D32 => DepthSpec::D32,
        DepthFormat::D16 => DepthSpec::D16,
    };
    snapped::assemble(clip, indices, &settings.state(), spec)
}

/// Compares every pixel; `progress` is called with the number of pixels newly done.
///
/// # Errors
///
/// [`RenderError::Verify`] where the reference refuses the scene.
pub fn compare(
    scene: &Scene,
    picture: &Picture,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Report, RenderError> {
    let ids = if picture.ordered { picture.ids.clone() } else { ordered(scene, picture)? };
    Ok(verify(scene, Compare::Less, spec(picture), &picture.depth, Some(&ids), progress)?)
}

/// The ids of a picture drawn in another order: where several triangles are at the same depth, whichever of them is
/// there becomes the one that came first.
fn ordered(scene: &Scene, picture: &Picture) -> Result<Vec<u32>, RenderError> {
    let exact = |scene: &Scene, compare| {
        reference_render(scene, compare, spec(picture), &|_| ())
            .map_err(|error| RenderError::Verify(error.into()))
    };
    let (first, last) = (exact(scene, Compare::Less)?, exact(scene, Compare::LessEqual)?);
    let mut ids = picture.ids.clone();
    // Those that are neither the first nor the last, by their ids.
    let mut between: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (at, (id, (&first, &last))) in ids.iter_mut().zip(first.ids.iter().zip(&last.ids)).enumerate() {
        if *id == last {
            *id = first;
        } else if *id != first && first != last {
            between.entry(*id).or_default().push(at);
        }
    }
    for (id, places) in between {
        let triangles = scene.triangles.iter().filter(|triangle| triangle.id == id).copied().collect();
        let &Scene { width, height, subpixel_bits, sample, .. } = scene;
        let alone = exact(&Scene { width, height, subpixel_bits, sample, triangles }, Compare::Less)?;
        for at in places {
            if alone.ids[at] == id && alone.depth[at] == first.depth[at] {
                ids[at] = first.ids[at];
            }
        }
    }
    Ok(ids)
}

/// A picture of the pixels that differ from the reference: red where the coverage does, yellow where
/// the id does, blue where only the depth does, on a dim picture of what was drawn.
///
/// # Errors
///
/// [`RenderError::Verify`] where the reference refuses the scene.
pub fn difference(scene: &Scene, picture: &Picture) -> Result<Vec<[u8; 3]>, RenderError> {
    let exact = reference_render(scene, Compare::Less, spec(picture), &|_| ())
        .map_err(|error| RenderError::Verify(error.into()))?;
    let drawn = picture.ids.iter().zip(&picture.depth);
    let specified = exact.ids.iter().zip(&exact.depth);
    Ok(drawn
        .zip(specified)
        .map(|((&id, &depth), (&exact_id, &exact_depth))| match () {
            () if (id == NO_ID) != (exact_id == NO_ID) => [255, 40, 40],
            () if id != exact_id => [255, 220, 0],
            () if depth != exact_depth => [60, 120, 255],
            () if id == NO_ID => [12, 12, 12],
            () => [48, 48, 48],
        })
        .collect())
}

fn spec(picture: &Picture) -> DepthSpec {
    if picture.bits == 32 { DepthSpec::D32 } else { DepthSpec::D16 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level::{self, Level};
    use crate::mesh::Mesh;
    use crate::render::{render, to_clip};
    use crate::target::Prepared;
    use crate::way::Way;
    use halfplane::{Cull, Region, Winding};

    fn settings(cull: Cull, depth: DepthFormat, level: Level) -> Settings {
        let region = Region::of_size(12, 10).unwrap();
        Settings { region, cull, front: Winding::Clockwise, depth, level }
    }

    /// Two overlapping triangles, of opposite windings, one of them through the near plane.
    const POSITIONS: [[f32; 3]; 6] = [
        [-0.9, -0.9, 0.3],
        [0.1, 0.9, 0.6],
        [0.8, -0.7, 0.2],
        [-2.0, 0.1, -0.5],
        [1.0, -0.8, 0.5],
        [0.9, 0.9, 0.7],
    ];

    /// w is 1 + z / 2.
    const MATRIX: [f32; 16] =
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.5, 0.0, 0.0, 0.0, 1.0];

    #[test]
    fn every_wrong_pixel_is_found_and_shown() {
        let mesh = Mesh::plain(POSITIONS.to_vec(), (0..6).collect());
        let clip = to_clip(&mesh, &MATRIX);
        let formats = [DepthFormat::D32, DepthFormat::D16];
        let meshlets = Way::Meshlets(Prepared::new(&mesh.positions, &mesh.indices).unwrap());
        let ways = [&Way::Triangles, &meshlets].into_iter().flat_map(|way| formats.map(|depth| (way, depth)));
        for (level, (way, depth)) in
            level::available().into_iter().flat_map(|l| ways.clone().map(move |w| (l, w)))
        {
            for cull in [Cull::None, Cull::Back, Cull::Front] {
                let settings = settings(cull, depth, level);
                let mut picture = render(&mesh, &MATRIX, &settings, way).unwrap();
                let (scene, whole) = assemble(&clip, &mesh.indices, &settings);
                assert_eq!(whole.len(), 1);
                let report = compare(&scene, &picture, &|_| ()).unwrap();
                assert!(report.identical() && report.covered > 0, "{report}");

                let drawn: Vec<usize> = (0..120).filter(|&at| picture.ids[at] != NO_ID).collect();
                picture.ids[drawn[0]] = NO_ID;
                picture.depth[drawn[0]] = picture.far();
                picture.depth[drawn[1]] += 1;
                picture.ids[drawn[2]] += 40;
                let report = compare(&scene, &picture, &|_| ()).unwrap();
                assert_eq!(report.mismatches.pixels, 3, "{report}");
                let colours = difference(&scene, &picture).unwrap();
                assert_eq!(colours[drawn[0]], [255, 40, 40]);
                assert_eq!(colours[drawn[1]], [60, 120, 255]);
                assert_eq!(colours[drawn[2]], [255, 220, 0]);
                assert_eq!(colours.iter().filter(|c| c[0] == c[1]).count(), 117);
            }
        }
    }

    #[test]
    fn of_triangles_at_one_depth_any_may_be_there() {
        // Four times the same triangle, and one behind.
        let (same, behind) = ([0, 1, 2].repeat(4), [3, 4, 5]);
        let mut positions = POSITIONS[..3].to_vec();
        positions.extend(POSITIONS[..3].iter().map(|&[x, y, z]| [x, y, z + 0.1]));
        let mesh = Mesh::plain(positions, [same, behind.to_vec()].concat());
        let clip = to_clip(&mesh, &MATRIX);
        for depth in [DepthFormat::D32, DepthFormat::D16] {
            let settings = settings(Cull::None, depth, Level::FALLBACK);
            let mut picture = render(&mesh, &MATRIX, &settings, &Way::Triangles).unwrap();
            let (scene, _) = assemble(&clip, &mesh.indices, &settings);
            let drawn: Vec<usize> = (0..120).filter(|&at| picture.ids[at] == 0).collect();
            for (given, wrong) in [([3, 0, 1, 2], 0), ([1, 2, 4, 3], 1)] {
                for (at, id) in drawn.iter().zip(given) {
                    picture.ids[*at] = id;
                }
                picture.ordered = false;
                let report = compare(&scene, &picture, &|_| ()).unwrap();
                assert_eq!(report.mismatches.pixels, wrong, "{given:?}: {report}");
            }
        }
    }

    #[test]
    fn displacement_of_vertices_that_are_exact_is_nought() {
        let settings = settings(Cull::None, DepthFormat::D32, Level::FALLBACK);
        let mesh = Mesh::plain(vec![[-0.5, -0.5, 0.5], [0.0, 0.5, 0.5], [0.5, -0.5, 0.5]], vec![0, 1, 2]);
        let mut matrix = [0.0; 16];
        (0..4).for_each(|k| matrix[5 * k] = 1.0);
        let clip = to_clip(&mesh, &matrix);
        let (_, mut whole) = assemble(&clip, &mesh.indices, &settings);
        let measure = |whole: &[Whole]| displacement(&mesh, &matrix, &clip, whole, (12, 10), 8);
        assert_eq!(measure(&whole), Displacement { vertices: 3, from_clip: 0.0, from_model: 0.0 });
        whole[0].xy[1][0] += 3;
        assert_eq!(measure(&whole).from_clip, 3.0);
    }
}
