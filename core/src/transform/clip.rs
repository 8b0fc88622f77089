//! Clipping a triangle in clip space.

use super::plane::Plane;

/// Most vertices that a clipped triangle is given. Seven planes make at most 3 + 7; more can only
/// come of rounding, and vertices beyond the capacity are left out.
pub(super) const MAX_VERTICES: usize = 16;

/// A polygon of at most [`MAX_VERTICES`] vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polygon<T> {
    vertices: [T; MAX_VERTICES],
    len: usize,
}

impl<T: Copy> Polygon<T> {
    /// No vertex; `fill` is what unused places hold.
    pub(super) const fn empty(fill: T) -> Self {
        Self { vertices: [fill; MAX_VERTICES], len: 0 }
    }

    pub(super) fn push(&mut self, vertex: T) {
        if let Some(place) = self.vertices.get_mut(self.len) {
            *place = vertex;
            self.len += 1;
        }
    }

    pub(super) fn vertices(&self) -> &[T] {
        self.vertices.get(..self.len).unwrap_or(&[])
    }

    /// Removes the vertex at a place; the later ones move up.
    pub(super) fn remove(&mut self, at: usize) {
        if at < self.len && self.len <= MAX_VERTICES {
            self.vertices.copy_within(at + 1..self.len, at);
            self.len -= 1;
        }
    }
}

/// The part of a triangle inside all of the planes (Sutherland and Hodgman, Reentrant Polygon
/// Clipping, 1974). Its vertices are finite.
pub(super) fn clip(triangle: [[f32; 4]; 3], planes: &[Plane; 7]) -> Polygon<[f32; 4]> {
    let mut polygon = Polygon::empty([0.0; 4]);
    for vertex in triangle {
        polygon.push(vertex);
    }
    for plane in planes {
        if !polygon.vertices().iter().any(|&v| plane.excludes(v)) {
            continue;
        }
        let mut clipped = Polygon::empty([0.0; 4]);
        let Some(&last) = polygon.vertices().last() else { return polygon };
        let mut previous = last;
        for &vertex in polygon.vertices() {
            match (plane.excludes(previous), plane.excludes(vertex)) {
                (false, false) => clipped.push(vertex),
                (false, true) => clipped.push(plane.cut(previous, vertex)),
                (true, false) => {
                    clipped.push(plane.cut(vertex, previous));
                    clipped.push(vertex);
                }
                (true, true) => {}
            }
            previous = vertex;
        }
        polygon = clipped;
    }
    polygon
}
