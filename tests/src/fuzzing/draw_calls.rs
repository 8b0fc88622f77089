//! Whole draw calls, right and wrong ones.

use super::{
    check,
    input::{Faces, Place, Shape},
};
use crate::{
    case,
    failure::Verdict,
    properties::{
        definition_path::{frame_is_the_one_of_arrays, small_format_is_the_one_of_arrays},
        depth_test::COMPARISONS,
        draws::{Call, is_brute_force},
        errors,
        meshlets::{meshlet_errors, meshlets_are_the_mesh},
        simd::{self, errors_are_the_scalar_ones, frame_is_the_scalar_one},
        statistics::{Liar, of_missing_vertices_add_up},
    },
    shapes::{Kind, clip_bits},
};
use arbitrary::Arbitrary;
use halfplane::{ClipPositions, D16, D32, DepthTest, Format, Region, Small, Standard, Vertex, Viewport};
use halfplane_reference::DepthSpec;

/// Largest side of a frame that brute force is compared in.
const SIDE: u16 = 40;
/// Most triangles of a call.
const MOST_TRIANGLES: usize = 40;

#[derive(Debug, Arbitrary)]
enum Case {
    Window(How, Indices, Vec<(Shape, [u32; 4])>),
    Clip(How, Indices, Vec<[u32; 13]>),
    /// A mesh on the fast path, as meshlets or by the walk with vector lanes.
    Vector {
        place: Place,
        how: [u32; 10],
        path: u8,
        triangles: Vec<case::Numbers>,
    },
    Refused {
        size: [u8; 2],
        triangles: u8,
        at: u32,
        beyond: u32,
        region: [u32; 4],
        missing: u32,
    },
}

#[derive(Debug, Arbitrary)]
struct How {
    format: u8,
    place: Place,
    /// The frame's where there is none: [`beside`].
    scissor: Option<[i8; 4]>,
    faces: Faces,
    test: (u8, bool),
    first_id: Option<u32>,
    surplus: u8,
    contents: u64,
    /// How many vertices too many are counted.
    lies: u8,
    /// [`beside`].
    viewport: [i8; 4],
}

#[derive(Debug, Arbitrary)]
enum Indices {
    /// Each vertex in order.
    Ordered,
    Short(Vec<u8>),
    Wide(Vec<u32>),
}

/// Draw calls of arbitrary sizes, slices, indices and states: each does what brute force does or is
/// refused for the right reason, with nothing written; the fast path and meshlets do the same.
pub fn draw_calls(data: &[u8]) -> Verdict {
    check(data, |case: &Case| match case {
        Case::Window(how, indices, triangles) => match how.format % 3 {
            0 => window::<Standard, D32>(how, indices, triangles, DepthSpec::D32),
            1 => window::<Standard, D16>(how, indices, triangles, DepthSpec::D16),
            _ => window::<Small, D16>(how, indices, triangles, DepthSpec::SMALL),
        },
        Case::Clip(how, indices, triangles) => match how.format % 2 {
            0 => clip::<Standard, D32>(how, indices, triangles, DepthSpec::D32),
            _ => clip::<Small, D16>(how, indices, triangles, DepthSpec::SMALL),
        },
        Case::Vector { place, how, path, triangles } => vector(*place, *how, *path, triangles),
        Case::Refused { size, triangles, at, beyond, region, missing } => {
            let [width, height] = size.map(|side| 1 + u32::from(side % 40));
            let triangles = 1 + u32::from(*triangles);
            let refused = errors::Refused { size: [width, height], triangles, at: *at, beyond: *beyond };
            errors::of_draws::<Standard>(refused)?;
            errors::of_draws::<Small>(refused)?;
            errors::of_regions::<Standard>(*region)?;
            errors::of_regions::<Small>(*region)?;
            let [x, y, ..] = region.map(|v| v % 900);
            errors::of_storage::<Standard>(x, y, [width, height], *missing as usize)?;
            let [x, y] = [region[0], region[1]].map(|v| v as i32);
            errors::of_vertices::<Standard>(x, y)?;
            errors::of_vertices::<Small>(x, y)?;
            let at = *at as usize;
            let vertices = 3 + at % 64;
            let (count, beyond) = (triangles as usize, *beyond);
            errors_are_the_scalar_ones(simd::Refused { vertices, triangles: count, at, beyond })?;
            meshlet_errors(count, (*missing).into())
        }
    })
}

fn window<F: Format, D: halfplane::DepthFormat<F>>(
    how: &How,
    indices: &Indices,
    triangles: &[(Shape, [u32; 4])],
    spec: DepthSpec,
) -> Verdict
where
    D::Texel: TryFrom<u32>,
{
    let call = how.call::<F>();
    let mut vertices: Vec<Vertex<F>> = Vec::new();
    for (shape, z) in triangles.iter().take(MOST_TRIANGLES) {
        vertices.extend(crate::properties::scene::vertices::<F>(&[shape.shot::<F>(&call.frame, *z)])?);
    }
    of_missing_vertices_add_up(&vertices, usize::from(how.lies % 4))?;
    let positions = Liar(&vertices, vertices.len() + usize::from(how.lies % 4));
    match indices {
        Indices::Ordered => {
            let indices: Vec<u16> = (0..vertices.len() as u16).collect();
            is_brute_force::<F, D, _, _>(&call, &vertices[..], &indices, spec)
        }
        Indices::Short(indices) => {
            let indices = &indices[..indices.len().min(3 * MOST_TRIANGLES)];
            is_brute_force::<F, D, _, _>(&call, &positions, indices, spec)
        }
        Indices::Wide(indices) => {
            let indices = &indices[..indices.len().min(3 * MOST_TRIANGLES)];
            is_brute_force::<F, D, _, _>(&call, &vertices[..], indices, spec)
        }
    }
}

fn clip<F: Format, D: halfplane::DepthFormat<F>>(
    how: &How,
    indices: &Indices,
    triangles: &[[u32; 13]],
    spec: DepthSpec,
) -> Verdict
where
    D::Texel: TryFrom<u32>,
{
    let call = how.call::<F>();
    let triangles: Vec<_> =
        triangles.iter().take(MOST_TRIANGLES).map(|&numbers| clip_bits(numbers)).collect();
    let vertices = triangles.as_flattened();
    let [x0, y0, x1, y1] = beside::<F>(call.frame.region, how.viewport);
    let positions = ClipPositions::new(vertices, Viewport::new(Region::new(x0, y0, x1, y1)?));
    let indices: Vec<u32> = match indices {
        Indices::Ordered => (0..vertices.len() as u32).collect(),
        Indices::Short(indices) => indices.iter().copied().map(u32::from).collect(),
        Indices::Wide(indices) => indices.clone(),
    };
    let indices = &indices[..indices.len().min(3 * MOST_TRIANGLES)];
    is_brute_force::<F, D, _, _>(&call, &positions, indices, spec)
}

fn vector(place: Place, how: [u32; 10], path: u8, triangles: &[case::Numbers]) -> Verdict {
    let place = place.0.map(u32::from);
    let triangles = &triangles[..triangles.len().min(MOST_TRIANGLES)];
    let case = case::Case::from_numbers(place, how, triangles, &Kind::ALL);
    match path % 4 {
        0 | 1 => frame_is_the_scalar_one(&case)?,
        2 => meshlets_are_the_mesh(&case)?,
        _ if how[0].is_multiple_of(4) => small_format_is_the_one_of_arrays(place, how[1], triangles)?,
        _ => frame_is_the_one_of_arrays(&case)?,
    };
    Ok(())
}

impl How {
    fn call<F: Format>(&self) -> Call {
        let frame = self.place.small::<F>(SIDE);
        let (compare, write) = self.test;
        Call {
            frame,
            scissor: self.scissor.map_or(frame.scissor, |sides| beside::<F>(frame.region, sides)),
            cull: self.faces.cull(),
            front: self.faces.front(),
            test: DepthTest { compare: COMPARISONS[usize::from(compare) % COMPARISONS.len()], write },
            first_id: self.first_id.unwrap_or(7),
            surplus: usize::from(self.surplus % 20),
            contents: self.contents,
        }
    }
}

/// A rectangle with its sides moved by up to 16 pixels: never empty, and often not inside it.
fn beside<F: Format>([x0, y0, x1, y1]: [u32; 4], sides: [i8; 4]) -> [u32; 4] {
    let moved = |side: u32, by: i8, least: u32, most: u32| {
        side.saturating_add_signed(i32::from(by) / 8).clamp(least, most)
    };
    let [left, top, right, bottom] = sides;
    let (left, top) = (moved(x0, left, 0, F::MAX_TARGET - 1), moved(y0, top, 0, F::MAX_TARGET - 1));
    [left, top, moved(x1, right, left + 1, F::MAX_TARGET), moved(y1, bottom, top + 1, F::MAX_TARGET)]
}
