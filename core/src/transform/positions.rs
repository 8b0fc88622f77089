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

/// Whether no component is NaN or infinite.
#[inline]
pub(super) fn are_finite(corners: &[[f32; 4]; 3]) -> bool {
    let mut above = 0;
    for v in corners.as_flattened() {
        above |= u32::from(v.to_bits() << 1 >= f32::INFINITY.to_bits() << 1);
    }
    above == 0
}

/// Emits the window triangles of a clip-space triangle.
#[inline]
pub(crate) fn assemble<F: Format>(
    corners: [[f32; 4]; 3],
    viewport: &Viewport<F>,
    planes: &[Plane; 7],
    mut emit: impl FnMut([Vertex<F>; 3]),
) -> Assembly {
    let [a, b, c] = corners;
    if !(Plane::frustum_has(a) && Plane::frustum_has(b) && Plane::frustum_has(c)) {
        if !are_finite(&corners) {
            return Assembly::NonFinite;
        }
        let mut all = 0;
        let beside = Plane::beside_frustum;
        for ((a, b), c) in beside(a).into_iter().zip(beside(b)).zip(beside(c)) {
            all |= a & b & c;
        }
        if all != 0 {
            return Assembly::Outside;
        }
        let inside = |v: [f32; 4]| !planes.iter().any(|plane| plane.excludes(v));
        if !(inside(a) && inside(b) && inside(c)) {
            return assemble_clipped(corners, viewport, planes, emit);
        }
    }
    // The guard band lies around the frustum (`Bounds::CLIP_PIXELS`), so what is in there is in here.
    match (viewport.project(a), viewport.project(b), viewport.project(c)) {
        (Some(a), Some(b), Some(c)) => {
            emit([a, b, c]);
            Assembly::Whole
        }
        _ => Assembly::NonFinite,
    }
}

/// Emits the pieces of a finite clip-space triangle that reaches outside the planes.
#[inline(never)]
fn assemble_clipped<F: Format>(
    corners: [[f32; 4]; 3],
    viewport: &Viewport<F>,
    planes: &[Plane; 7],
    emit: impl FnMut([Vertex<F>; 3]),
) -> Assembly {
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
