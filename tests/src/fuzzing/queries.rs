//! What is said to be hidden, is.

use super::{
    check,
    input::{Place, Shape},
};
use crate::{
    Failure, case,
    failure::Verdict,
    properties::{batches, boxes, cones, depth_test::COMPARISONS, hierarchical, lists, questions, spheres},
    shapes::{Kind, Patch},
};
use arbitrary::Arbitrary;
use halfplane::{D16, D32, DepthFormat, DepthTest, Format, Small, Standard};
use halfplane_reference::DepthSpec;

/// Largest side of a frame of which every pixel is asked for.
const SIDE: u16 = 90;
/// Most triangles of a scene, and of a mesh.
const MOST: [usize; 2] = [12, 300];

#[derive(Debug, Arbitrary)]
enum Case {
    /// Questions between draws.
    Pixels { format: u8, place: Place, test: (u8, bool), seed: u64, triangles: Vec<(Shape, [u32; 4])> },
    /// Boxes, spheres, lists and batches of a mesh.
    Mesh { place: Place, how: [u32; 10], what: u8, center: [i8; 3], triangles: Vec<case::Numbers> },
    /// Meshlets whose triangles face much the same way.
    Patch { size: [u8; 2], count: u8, spread: u8, powers: [i8; 5], cosine: i8, orthographic: bool, seed: u64 },
}

/// Hierarchical depth against every pixel; boxes and spheres against what is in them; lists and batches against their
/// triangles.
pub fn queries(data: &[u8]) -> Verdict {
    check(data, |case: &Case| match case {
        Case::Pixels { format, .. } => match format % 3 {
            0 => pixels::<Standard, D32>(case, DepthSpec::D32),
            1 => pixels::<Standard, D16>(case, DepthSpec::D16),
            _ => pixels::<Small, D16>(case, DepthSpec::SMALL),
        },
        Case::Mesh { place, how, what, center, triangles } => {
            let triangles = &triangles[..triangles.len().min(MOST[1])];
            let case = case::Case::from_numbers(place.0.map(u32::from), *how, triangles, &Kind::ALL);
            let radius = (f32::from(what / 8) - 16.0).exp2();
            let center = center.map(f32::from);
            let seed = u64::from(how[0]);
            match what % 8 {
                0 => batches::batches_are_the_mesh(&case).map(|_| ()),
                1 => boxes::boxes_bound_what_they_hold(&case).map(|_| ()),
                2 => questions::answers_are_certain(&case).map(|_| ()),
                3 => spheres::spheres_left_out_are_outside(&case, center, radius, seed).map(|_| ()),
                4 => spheres::spheres_bound_what_they_hold(&case).map(|_| ()),
                5 => spheres::points_of_spheres_are_in_their_bound(&case, center, radius, seed).map(|_| ()),
                6 => lists::lists_out_of_sight_change_nothing(&case).map(|_| ()),
                _ => cones::meshes_are_their_triangles(&case).map(|_| ()),
            }
        }
        Case::Patch { size, count, spread, powers, cosine, orthographic, seed } => {
            let patch = Patch {
                count: usize::from(count % 50),
                spread: f64::from(*spread) / 100.0,
                powers: powers.map(|power| i32::from(power) / 4),
                cosine: f64::from(*cosine) / 128.0,
                orthographic: *orthographic,
                seed: *seed,
            };
            let size = size.map(|side| u32::from(side % 90) + 1);
            cones::patches_are_their_triangles(&patch, size).map(|_| ())
        }
    })
}

fn pixels<F: Format, D: DepthFormat<F>>(case: &Case, spec: DepthSpec) -> Verdict {
    let Case::Pixels { place, test, seed, triangles, .. } = case else {
        return Err(Failure::new("not a case of pixels"));
    };
    let frame = place.small::<F>(SIDE);
    let shots: Vec<_> =
        triangles.iter().take(MOST[0]).map(|(shape, z)| shape.shot::<F>(&frame, *z)).collect();
    let compare = COMPARISONS[usize::from(test.0) % COMPARISONS.len()];
    let test = DepthTest { compare, write: test.1 };
    hierarchical::answers_are_those_of_the_pixels::<F, D>(&frame, &shots, test, spec, *seed)?;
    hierarchical::hidden_triangles_change_nothing::<F, D>(&frame, &shots, test).map(|_| ())
}
