//! Triangles of a snapped polygon.

use super::clip::{MAX_VERTICES, Polygon};
use crate::{
    geometry::{Vertex, doubled_area},
    numbers::Format,
};
use core::cmp::Ordering;

/// Cuts a polygon into triangles of one winding by taking off ears, all decisions exact: the
/// triangles cover what the polygon covers, each sample once.
///
/// Snapping can turn a vertex of a convex polygon slightly inwards, so a fan from one vertex could
/// hold a piece of the other winding. A polygon so thin that snapping made its sides cross has no
/// such cut; its triangles are then those left over, in both windings.
pub(super) fn triangulate<F: Format>(mut polygon: Polygon<Vertex<F>>, mut emit: impl FnMut([Vertex<F>; 3])) {
    remove_flat(&mut polygon);
    let winding = winding(&polygon);
    for _ in 0..MAX_VERTICES {
        let count = polygon.vertices().len();
        if count < 3 {
            return;
        }
        let ear = (0..count)
            .find(|&at| is_ear(&polygon, at, winding))
            .or_else(|| (0..count).find(|&at| turn(corner(&polygon, at)) == winding))
            .unwrap_or(0);
        if let Some(triangle) = corner(&polygon, ear) {
            emit(triangle);
        }
        polygon.remove(ear);
        remove_flat(&mut polygon);
    }
}

/// The vertex at a place between its neighbours.
pub(super) fn corner<F: Format>(polygon: &Polygon<Vertex<F>>, at: usize) -> Option<[Vertex<F>; 3]> {
    let vertices = polygon.vertices();
    let previous = if at == 0 { vertices.last() } else { vertices.get(at - 1) };
    let next = vertices.get(at + 1).or(vertices.first());
    Some([*previous?, *vertices.get(at)?, *next?])
}

/// Greater for clockwise, less for counter-clockwise.
pub(super) fn turn<F: Format>(triangle: Option<[Vertex<F>; 3]>) -> Ordering {
    triangle.map_or(Ordering::Equal, |t| doubled_area(t).cmp(&F::Wide::default()))
}

/// The winding of a polygon without flat corners: that of its topmost, then leftmost corner.
pub(super) fn winding<F: Format>(polygon: &Polygon<Vertex<F>>) -> Ordering {
    let top = polygon.vertices().iter().enumerate().min_by_key(|(_, v)| (v.y(), v.x()));
    turn(top.and_then(|(at, _)| corner(polygon, at)))
}

/// Removes vertices on the line through their neighbours: they change no coverage.
pub(super) fn remove_flat<F: Format>(polygon: &mut Polygon<Vertex<F>>) {
    let mut at = 0;
    let mut left = MAX_VERTICES * MAX_VERTICES;
    while at < polygon.vertices().len() && left > 0 {
        left -= 1;
        if turn(corner(polygon, at)) == Ordering::Equal {
            polygon.remove(at);
            at = at.saturating_sub(1);
        } else {
            at += 1;
        }
    }
}

/// Whether the corner turns with the polygon and no vertex lies strictly inside it.
pub(super) fn is_ear<F: Format>(polygon: &Polygon<Vertex<F>>, at: usize, winding: Ordering) -> bool {
    let Some([a, b, c]) = corner(polygon, at) else { return false };
    turn(Some([a, b, c])) == winding
        && !polygon
            .vertices()
            .iter()
            .any(|&p| [[a, b, p], [b, c, p], [c, a, p]].into_iter().all(|t| turn(Some(t)) == winding))
}
