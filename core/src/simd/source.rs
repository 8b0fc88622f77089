//! Where a draw's triangles come from, for what the lanes do not keep of them.

use super::{
    meshlet::{Meshlet, MeshletPositions},
    window::MeshletScratch,
};
use crate::{
    draw::Index,
    geometry::{Assembly, Positions, Vertex},
    numbers::Standard,
    transform::ModelPositions,
};

/// The triangles by their places in the list that the lanes read.
pub(super) trait Source: Copy {
    /// The id of a triangle.
    fn id(&self, triangle: u32) -> u32;

    /// Emits the window triangles of one triangle, from its vertices in object space.
    fn assemble(&self, triangle: u32, emit: impl FnMut([Vertex<Standard>; 3])) -> Assembly;
}

/// A mesh and its triangle list.
#[derive(Clone, Copy)]
pub(super) struct Listed<'a, I> {
    pub(super) positions: &'a ModelPositions<'a, Standard>,
    pub(super) triangles: &'a [[I; 3]],
    pub(super) first_id: u32,
}

impl<I: Index> Source for Listed<'_, I> {
    #[inline(always)]
    fn id(&self, triangle: u32) -> u32 {
        self.first_id.wrapping_add(triangle)
    }

    fn assemble(&self, triangle: u32, emit: impl FnMut([Vertex<Standard>; 3])) -> Assembly {
        match self.triangles.get(triangle as usize) {
            Some(corners) => self.positions.assemble(corners.map(Index::to_usize), emit),
            None => Assembly::NoVertex,
        }
    }
}

/// Meshlets in view.
#[derive(Clone, Copy)]
pub(super) struct InView<'a> {
    pub(super) scratch: &'a MeshletScratch,
    pub(super) meshlets: &'a [Meshlet],
    pub(super) camera: &'a ModelPositions<'a, Standard>,
    pub(super) first_id: u32,
}

impl Source for InView<'_> {
    #[inline(always)]
    fn id(&self, triangle: u32) -> u32 {
        let (meshlet, at) = self.scratch.origin(triangle);
        let first = self.meshlets.get(meshlet).map_or(0, Meshlet::first);
        self.first_id.wrapping_add(first).wrapping_add(at as u32)
    }

    fn assemble(&self, triangle: u32, emit: impl FnMut([Vertex<Standard>; 3])) -> Assembly {
        let (meshlet, at) = self.scratch.origin(triangle);
        let Some(meshlet) = self.meshlets.get(meshlet) else { return Assembly::NoVertex };
        let Some(corners) = meshlet.corners().get(at) else { return Assembly::NoVertex };
        MeshletPositions { meshlet, camera: self.camera }.assemble(corners.map(usize::from), emit)
    }
}
