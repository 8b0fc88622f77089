//! Clip-space vertices as a draw's positions.

use super::{
    clip::{Polygon, clip},
    plane::Plane,
    triangulate::triangulate,
    viewport::Viewport,
};
use crate::{
    geometry::{Assembly, Positions, Region, Vertex},
    numbers::Format,
};

/// Clip-space vertices and the viewport they are seen through.
///
/// A triangle with vertices all outside one plane of the view frustum is dropped. One that crosses
/// the near or the far plane, or that would leave the guard band, is clipped there; any other is
/// drawn as it is, wherever its vertices are.
#[derive(Clone, Copy, Debug)]
pub struct ClipPositions<'a, F> {
    vertices: &'a [[f32; 4]],
    viewport: Viewport<F>,
    planes: [Plane; 7],
}

impl<'a, F: Format> ClipPositions<'a, F> {
    /// Vertices (x, y, z, w) seen through `viewport`.
    #[must_use]
    pub fn new(vertices: &'a [[f32; 4]], viewport: Viewport<F>) -> Self {
        Self { vertices, viewport, planes: Plane::clipping(viewport.guard_band()) }
    }
}

impl<F: Format> Positions<F> for ClipPositions<'_, F> {
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
        match (self.vertices.get(i), self.vertices.get(j), self.vertices.get(k)) {
            (Some(&a), Some(&b), Some(&c)) => assemble([a, b, c], &self.viewport, &self.planes, emit),
            _ => Assembly::NoVertex,
        }
    }
}

/// Emits the window triangles of a clip-space triangle.
#[inline]
pub(crate) fn assemble<F: Format>(
    corners: [[f32; 4]; 3],
    viewport: &Viewport<F>,
    planes: &[Plane; 7],
    mut emit: impl FnMut([Vertex<F>; 3]),
) -> Assembly {
    if !corners.as_flattened().iter().all(|v| v.is_finite()) {
        return Assembly::NonFinite;
    }
    if Plane::FRUSTUM.into_iter().any(|plane| corners.into_iter().all(|v| plane.excludes(v))) {
        return Assembly::Outside;
    }
    let inside = |v: [f32; 4]| !planes.iter().any(|plane| plane.excludes(v));
    if corners.into_iter().all(inside) {
        let [a, b, c] = corners.map(|v| viewport.project(v));
        return match (a, b, c) {
            (Some(a), Some(b), Some(c)) => {
                emit([a, b, c]);
                Assembly::Whole
            }
            _ => Assembly::NonFinite,
        };
    }
    let clipped = clip(corners, planes);
    let first = clipped.vertices().first().and_then(|&v| viewport.project(v));
    let Some(mut polygon) = first.map(Polygon::empty) else { return Assembly::Outside };
    for vertex in clipped.vertices() {
        match viewport.project(*vertex) {
            Some(vertex) => polygon.push(vertex),
            None => return Assembly::NonFinite,
        }
    }
    triangulate(polygon, emit);
    Assembly::Clipped
}
