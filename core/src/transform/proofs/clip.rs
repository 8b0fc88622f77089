//! The polygon that clipping fills, and how many vertices it gets.

#[cfg(test)]
use crate::transform::{clip::clip, plane::Plane};
use crate::{
    proof::{cover, prove},
    transform::clip::{MAX_VERTICES, Polygon},
};

/// A polygon of the first `count` numbers, as far as there is room.
fn numbered(count: usize) -> Polygon<u8> {
    let mut polygon = Polygon::empty(u8::MAX);
    for number in 0..count {
        polygon.push(number as u8);
    }
    polygon
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

    /// Removal moves the later vertices up; where there is no such vertex, nothing changes. Of polygons of up
    /// to five vertices.
    #[kani::unwind(8)]
    [Polygon::push, Polygon::remove, Polygon::vertices]
    fn removal_moves_up(count: usize = 0..=5, removed: usize, at: usize = 0..=5) {
        let mut polygon = numbered(count);
        polygon.remove(removed);
        let left = count - usize::from(removed < count);
        assert!(polygon.vertices().len() == left);
        let expected = at + usize::from(removed <= at);
        assert!(polygon.vertices().get(at).copied() == (at < left).then_some(expected as u8));
        cover!(removed == 0 && at == 3 && at < left);
        cover!(removed > count);
    }
}

/// A plane that excludes nothing.
#[cfg(test)]
const NOTHING: Plane = Plane::Left(f32::NAN);

/// Whichever vertices of a triangle a plane excludes, one vertex less leaves at most one more: what it cuts
/// off is one run of vertices, and two take its place. How many there are follows from what the plane excludes
/// alone, so one vertex inside and one outside stand for all.
#[test]
fn planes_add_one_vertex_at_most() {
    let inner = [0.0, 0.0, 1.0, 2.0];
    let planes = [
        (Plane::Near, [0.0, 0.0, -1.0, 2.0]),
        (Plane::Far, [0.0, 0.0, 3.0, 2.0]),
        (Plane::Eye, [0.0, 0.0, 1.0, -2.0]),
        (Plane::Left(-2.0), [-8.0, 0.0, 1.0, 2.0]),
        (Plane::Right(2.0), [8.0, 0.0, 1.0, 2.0]),
        (Plane::Top(2.0), [0.0, 8.0, 1.0, 2.0]),
        (Plane::Bottom(-2.0), [0.0, -8.0, 1.0, 2.0]),
    ];
    for (plane, outer) in planes {
        for set in 0..8_u32 {
            let triangle = [0, 1, 2].map(|k| if set >> k & 1 != 0 { outer } else { inner });
            let clipped = clip(triangle, &[plane, NOTHING, NOTHING, NOTHING, NOTHING, NOTHING, NOTHING]);
            // One vertex cut off leaves two in its place.
            assert_eq!(clipped.vertices().len(), [3, 4, 3, 0][set.count_ones() as usize], "{plane:?} {set}");
            assert!(!clipped.vertices().iter().any(|&v| plane.excludes(v)), "{plane:?} {set}");
        }
    }
}
