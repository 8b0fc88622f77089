//! Batches: runs of meshlets with a box round them, that are drawn or left out together.

use super::meshlet::{Meshlet, MeshletError};

/// Meshlets of a batch, at most.
const MEMBERS: usize = 8;

/// Consecutive meshlets and a box round them.
#[derive(Clone, Copy, Debug)]
pub struct Batch {
    /// The box round all vertices; not finite where a vertex is not.
    pub(super) corners: [[f32; 3]; 2],
    /// The first meshlet, and how many there are.
    pub(super) first: u32,
    pub(super) count: u32,
}

impl Batch {
    /// A batch of nothing, to fill arrays with.
    pub const EMPTY: Self =
        Self { corners: [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], first: 0, count: 0 };

    /// Two opposite corners of the box round it, in object space: the smallest x, y and z, and the largest.
    #[must_use]
    pub const fn corners(&self) -> [[f32; 3]; 2] {
        self.corners
    }

    /// The batch's meshlets among all that batches were made of.
    #[must_use]
    pub fn meshlets<'m>(&self, all: &'m [Meshlet]) -> &'m [Meshlet] {
        let rest = all.get(self.first as usize..).unwrap_or(&[]);
        rest.get(..rest.len().min(self.count as usize)).unwrap_or(&[])
    }

    /// The number of the first meshlet.
    pub(super) const fn first(&self) -> u32 {
        self.first
    }

    /// The smallest w of the box's corners, as far as rounding lets it be known: how far it is.
    #[inline(always)]
    pub(super) fn distance(&self, matrix: &[[f32; 4]; 4]) -> f32 {
        let [[.., m0], [.., m1], [.., m2], [.., m3]] = *matrix;
        let [low, high] = self.corners;
        let mut distance = m3;
        for ((low, high), m) in low.into_iter().zip(high).zip([m0, m1, m2]) {
            distance += (low * m).min(high * m);
        }
        distance
    }
}

/// How many batches so many meshlets make.
#[must_use]
pub const fn max_batches(meshlets: usize) -> usize {
    meshlets.div_ceil(MEMBERS)
}

/// Makes the batches of meshlets, in order; those that were made.
///
/// # Errors
///
/// [`MeshletError::TooFew`] where `batches` has fewer than [`max_batches`]; nothing is written then.
pub fn make_batches<'b>(
    meshlets: &[Meshlet],
    batches: &'b mut [Batch],
) -> Result<&'b mut [Batch], MeshletError> {
    let (needed, given) = (max_batches(meshlets.len()), batches.len());
    let batches = batches.get_mut(..needed).ok_or(MeshletError::TooFew { needed, given })?;
    for ((batch, members), first) in
        batches.iter_mut().zip(meshlets.chunks(MEMBERS)).zip((0..).step_by(MEMBERS))
    {
        *batch = Batch { first, count: members.len() as u32, ..Batch::EMPTY };
        let [low, high] = &mut batch.corners;
        for meshlet in members {
            for (to, value) in low.iter_mut().zip(meshlet.low) {
                *to = to.min(value);
            }
            for (to, value) in high.iter_mut().zip(meshlet.high) {
                *to = to.max(value);
            }
        }
    }
    Ok(batches)
}
