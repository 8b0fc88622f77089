//! Meshlets in view, some at a time, as a small mesh that stays in the cache.

use super::{
    meshlet::{Meshlet, TRIANGLES, VERTICES},
    vertex::VertexLanes,
};
use fearless_simd::{Simd, f32x16, prelude::*};

/// Vertices and triangles of the meshlets that are drawn together.
const CAPACITY: usize = 2048;
/// Meshlets at most.
const MEMBERS: usize = 256;
const _: () = assert!(CAPACITY >= VERTICES && CAPACITY >= TRIANGLES && CAPACITY <= 1 << 16);

/// Scratch memory for drawing meshlets.
#[derive(Clone, Debug)]
pub struct MeshletScratch {
    places: [[u32; 2]; CAPACITY],
    depths: [u32; CAPACITY],
    triangles: [[u16; 3]; CAPACITY],
    /// Which of the meshlets here a triangle is of.
    members: [u8; CAPACITY],
    /// The meshlets' numbers, and where their triangles begin.
    meshlets: [(u32, u32); MEMBERS],
    pub(super) vertices: usize,
    pub(super) count: usize,
    pub(super) member: u8,
}

impl Default for MeshletScratch {
    fn default() -> Self {
        Self::NEW
    }
}

impl MeshletScratch {
    /// Scratch memory: about 26 KiB.
    pub const NEW: Self = Self {
        places: [[0; 2]; CAPACITY],
        depths: [0; CAPACITY],
        triangles: [[0; 3]; CAPACITY],
        members: [0; CAPACITY],
        meshlets: [(0, 0); MEMBERS],
        vertices: 0,
        count: 0,
        member: 0,
    };

    #[inline(always)]
    pub(super) const fn clear(&mut self) {
        (self.vertices, self.count, self.member) = (0, 0, 0);
    }

    /// Whether another meshlet fits.
    #[inline(always)]
    pub(super) const fn has_room(&self) -> bool {
        self.vertices + VERTICES <= CAPACITY
            && self.count + TRIANGLES <= CAPACITY
            && (self.member as usize) < MEMBERS - 1
    }

    /// Transforms a meshlet's vertices and adds its triangles; there is room.
    #[inline(always)]
    pub(super) fn add<S: Simd>(&mut self, simd: S, lanes: &VertexLanes<S>, meshlet: &Meshlet, number: u32) {
        let base = self.vertices as u16;
        let [x, y, z] = &meshlet.positions;
        let chunks = meshlet.vertices().div_ceil(16);
        let positions = x.as_chunks::<16>().0.iter().zip(y.as_chunks::<16>().0).zip(z.as_chunks::<16>().0);
        let places = self.places.get_mut(self.vertices..).unwrap_or(&mut []).as_chunks_mut::<16>().0;
        let depths = self.depths.get_mut(self.vertices..).unwrap_or(&mut []).as_chunks_mut::<16>().0;
        for (((x, y), z), (places, depths)) in positions.take(chunks).zip(places.iter_mut().zip(depths)) {
            let position =
                [f32x16::simd_from(simd, *x), f32x16::simd_from(simd, *y), f32x16::simd_from(simd, *z)];
            lanes.sixteen(simd, position, places, depths);
        }
        self.vertices += 16 * chunks;
        let corners = meshlet.corners();
        let to = self.triangles.get_mut(self.count..).unwrap_or(&mut []);
        for (to, from) in to.as_flattened_mut().iter_mut().zip(corners.as_flattened()) {
            *to = u16::from(*from).wrapping_add(base);
        }
        let members = self.members.get_mut(self.count..).unwrap_or(&mut []);
        members.get_mut(..corners.len()).unwrap_or(&mut []).fill(self.member);
        if let Some(to) = self.meshlets.get_mut(usize::from(self.member)) {
            *to = (number, self.count as u32);
        }
        self.member += 1;
        self.count += corners.len();
    }

    #[inline(always)]
    pub(super) fn places(&self) -> &[[u32; 2]] {
        &self.places
    }

    #[inline(always)]
    pub(super) fn depths(&self) -> &[u32] {
        &self.depths
    }

    #[inline(always)]
    pub(super) fn triangles(&self) -> &[[u16; 3]] {
        self.triangles.get(..self.count).unwrap_or(&[])
    }

    /// The meshlet that a triangle is of, and which of its triangles it is.
    #[inline(always)]
    pub(super) fn origin(&self, triangle: u32) -> (usize, usize) {
        let member = self.members.get(triangle as usize).copied().unwrap_or(0);
        let (meshlet, first) = self.meshlets.get(usize::from(member)).copied().unwrap_or((0, 0));
        (meshlet as usize, triangle.wrapping_sub(first) as usize)
    }
}
