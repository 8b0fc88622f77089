//! Triangles that are near one another made neighbours in the list, once per mesh.

use super::sort::{select, sort};
use crate::draw::{self, DrawError, Index};

/// Triangles in a leaf: there, the order of their first corners is mostly that of the mesh, whose neighbours are often
/// alike, which processors predict well.
const LEAF: usize = 64;

/// Reorders a triangle list, three indices into `positions` each, so that any run of it lies close together:
/// halved at the median centre along the longest axis of the centres' box, again and again, down to 64
/// triangles, which are ordered by their first corners. Whoever needs the old numbers keeps a copy of the list.
///
/// [`make_meshlets`](super::make_meshlets) of such a list makes meshlets with small boxes.
///
/// # Errors
///
/// [`DrawError::IndexCount`] and [`DrawError::IndexOutOfRange`]; nothing is changed then.
pub fn cluster<I: Index>(positions: &[[f32; 3]], indices: &mut [I]) -> Result<(), DrawError> {
    draw::check_indices(indices, positions.len())?;
    halve(positions, indices.as_chunks_mut().0, LEAF);
    Ok(())
}

/// Down to leaves of so many triangles, at least one; as deep as their number has binary digits.
pub(super) fn halve<I: Index>(positions: &[[f32; 3]], triangles: &mut [[I; 3]], leaf: usize) {
    if triangles.len() <= leaf {
        sort(triangles, |[first, ..]| u64::from(first.to_u32()));
        return;
    }
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for triangle in &*triangles {
        for axis in 0..3 {
            let center = center(positions, triangle, axis);
            if let (Some(low), Some(high)) = (low.get_mut(axis), high.get_mut(axis)) {
                (*low, *high) = (low.min(center), high.max(center));
            }
        }
    }
    let mut longest = (0, f32::NEG_INFINITY);
    for (axis, (low, high)) in low.into_iter().zip(high).enumerate() {
        if high - low > longest.1 {
            longest = (axis, high - low);
        }
    }
    let (axis, half) = (longest.0, triangles.len() / 2);
    select(triangles, half, |triangle| center(positions, triangle, axis));
    let (first, second) = triangles.split_at_mut_checked(half).unwrap_or_default();
    halve(positions, first, leaf);
    halve(positions, second, leaf);
}

/// Three times the centre along an axis.
pub(super) fn center<I: Index>(positions: &[[f32; 3]], triangle: &[I; 3], axis: usize) -> f32 {
    triangle.iter().fold(0.0, |sum, corner| {
        let position = positions.get(corner.to_usize()).and_then(|position| position.get(axis));
        sum + position.copied().unwrap_or(0.0)
    })
}
