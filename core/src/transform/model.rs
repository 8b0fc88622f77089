//! Object-space vertices and a matrix as a draw's positions.

use super::{plane::Plane, positions::assemble, viewport::Viewport};
use crate::{
    geometry::{Assembly, Positions, Region, Vertex},
    numbers::Format,
};

/// Object-space vertices (x, y, z), the matrix that takes them to clip space and the viewport they
/// are seen through.
///
/// Row vectors: clip = (x, y, z, 1) M with M in rows, each component x m0 + y m1 + z m2 + m3, from
/// left to right in `f32`, each operation rounded once.
#[derive(Clone, Copy, Debug)]
pub struct ModelPositions<'a, F> {
    vertices: &'a [[f32; 3]],
    matrix: [[f32; 4]; 4],
    viewport: Viewport<F>,
    planes: [Plane; 7],
}

impl<'a, F: Format> ModelPositions<'a, F> {
    /// Vertices (x, y, z) taken to clip space by `matrix` and seen through `viewport`.
    #[must_use]
    pub fn new(vertices: &'a [[f32; 3]], matrix: [[f32; 4]; 4], viewport: Viewport<F>) -> Self {
        Self { vertices, matrix, viewport, planes: Plane::clipping(viewport.guard_band()) }
    }

    /// The clip-space vertex of a place; `None` beyond the last.
    #[inline]
    #[must_use]
    pub fn clip(&self, at: usize) -> Option<[f32; 4]> {
        self.vertices.get(at).map(|&position| self.clip_point(position))
    }

    /// The clip-space vertex of an object-space one.
    #[inline]
    pub(crate) fn clip_point(&self, [x, y, z]: [f32; 3]) -> [f32; 4] {
        let [m0, m1, m2, m3] = self.matrix;
        let mut clip = m3;
        for (c, (((m0, m1), m2), m3)) in clip.iter_mut().zip(m0.into_iter().zip(m1).zip(m2).zip(m3)) {
            *c = x * m0 + y * m1 + z * m2 + m3;
        }
        clip
    }

    #[cfg(feature = "simd")]
    pub(crate) const fn vertices(&self) -> &'a [[f32; 3]] {
        self.vertices
    }

    #[cfg(feature = "simd")]
    pub(crate) const fn matrix(&self) -> &[[f32; 4]; 4] {
        &self.matrix
    }

    #[cfg(feature = "simd")]
    pub(crate) const fn viewport(&self) -> &Viewport<F> {
        &self.viewport
    }

    #[cfg(feature = "simd")]
    pub(crate) const fn planes(&self) -> &[Plane; 7] {
        &self.planes
    }
}

impl<F: Format> Positions<F> for ModelPositions<'_, F> {
    #[inline]
    fn count(&self) -> usize {
        self.vertices.len()
    }

    #[inline]
    fn window(&self) -> Option<Region<F>> {
        Some(self.viewport.region())
    }

    #[inline]
    fn assemble<E: FnMut([Vertex<F>; 3])>(&self, [i, j, k]: [usize; 3], emit: E) -> Assembly {
        match (self.clip(i), self.clip(j), self.clip(k)) {
            (Some(a), Some(b), Some(c)) => assemble([a, b, c], &self.viewport, &self.planes, emit),
            _ => Assembly::NoVertex,
        }
    }
}
