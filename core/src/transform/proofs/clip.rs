//! The polygon that clipping fills, and how many vertices it gets.

use crate::{
    proof::{cover, prove},
    transform::{
        clip::{MAX_VERTICES, Polygon, clip},
        plane::Plane,
    },
};

/// A polygon of the first `count` numbers, as far as there is room.
fn numbered(count: usize) -> Polygon<u8> {
    let mut polygon = Polygon::empty(u8::MAX);
    for number in 0..count {
        polygon.push(number as u8);
    }
    polygon
}

/// A plane that excludes nothing.
const NOTHING: Plane = Plane::Left(f32::NAN);

/// Clips a triangle with those vertices outside a plane.
fn clips_at(plane: Plane, outside: [bool; 3], inner: [f32; 4], outer: [f32; 4]) {
    let triangle = outside.map(|outside| if outside { outer } else { inner });
    let clipped = clip(triangle, &[plane, NOTHING, NOTHING, NOTHING, NOTHING, NOTHING, NOTHING]);
    let [a, b, c] = outside.map(usize::from);
    // One vertex cut off leaves two in its place.
    assert!(clipped.vertices().len() == [3, 4, 3, 0][a + b + c]);
    assert!(!clipped.vertices().iter().any(|&v| plane.excludes(v)));
}

/// The same for each set of vertices, by its number: constants, which a prover folds.
fn clips_any_at(plane: Plane, outside: u8, inner: [f32; 4], outer: [f32; 4]) {
    match outside {
        0 => clips_at(plane, [false, false, false], inner, outer),
        1 => clips_at(plane, [true, false, false], inner, outer),
        2 => clips_at(plane, [false, true, false], inner, outer),
        3 => clips_at(plane, [true, true, false], inner, outer),
        4 => clips_at(plane, [false, false, true], inner, outer),
        5 => clips_at(plane, [true, false, true], inner, outer),
        6 => clips_at(plane, [false, true, true], inner, outer),
        _ => clips_at(plane, [true, true, true], inner, outer),
    }
}

prove! {
    /// A polygon holds what was pushed first, in order, and no more than its capacity.
    #[kani::unwind(20)]
    [Polygon::push, Polygon::vertices]
    fn polygon_keeps_what_fits(count: usize = 0..=MAX_VERTICES + 2, at: usize = 0..=MAX_VERTICES + 2) {
        let polygon = numbered(count);
        let kept = count.min(MAX_VERTICES);
        assert!(polygon.vertices().len() == kept);
        assert!(polygon.vertices().get(at).copied() == (at < kept).then_some(at as u8));
        cover!(count > MAX_VERTICES);
    }

    /// Removal moves the later vertices up; where there is no such vertex, nothing changes.
    #[kani::unwind(20)]
    [Polygon::push, Polygon::remove, Polygon::vertices]
    fn removal_moves_up(count: usize = 0..=MAX_VERTICES, removed: usize, at: usize = 0..=MAX_VERTICES) {
        let mut polygon = numbered(count);
        polygon.remove(removed);
        let left = count - usize::from(removed < count);
        assert!(polygon.vertices().len() == left);
        let expected = at + usize::from(removed <= at);
        assert!(polygon.vertices().get(at).copied() == (at < left).then_some(expected as u8));
        cover!(removed == 0 && at == MAX_VERTICES - 2 && at < left);
        cover!(removed > count);
    }

    /// Whichever vertices of a triangle the near plane excludes, one vertex less leaves at most one more:
    /// what it cuts off is one run of vertices, and two take its place. How many there are follows from
    /// what the plane excludes alone, so one vertex inside and one outside stand for all.
    #[kani::unwind(9)]
    [clip, Plane::cut, Plane::distance, Plane::excludes]
    fn near_adds_one_vertex_at_most(outside: u8 = 0..=7) {
        clips_any_at(Plane::Near, outside, [0.0, 0.0, 1.0, 2.0], [0.0, 0.0, -1.0, 2.0]);
    }

    /// The same for a plane of the guard band.
    #[kani::unwind(9)]
    [clip, Plane::cut, Plane::distance, Plane::excludes]
    fn left_adds_one_vertex_at_most(outside: u8 = 0..=7) {
        clips_any_at(Plane::Left(-2.0), outside, [0.0, 0.0, 1.0, 2.0], [-8.0, 0.0, 1.0, 2.0]);
    }
}
