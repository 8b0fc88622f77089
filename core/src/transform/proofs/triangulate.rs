//! Triangles of a polygon.

use crate::{
    geometry::Vertex,
    numbers::{Bounds, DEPTH32_MAX, DEPTH32_MIN, Format, Small, Standard},
    proof::{cover, prove},
    transform::{
        clip::Polygon,
        triangulate::{corner, is_ear, remove_flat, turn},
    },
};
use core::cmp::Ordering;

/// A polygon with vertices at these places; the depth is the number of the vertex, from 2 on.
pub(super) fn polygon<F: Format, const N: usize>(places: [[i32; 2]; N]) -> Option<Polygon<Vertex<F>>> {
    let mut polygon = Polygon::empty(Vertex::new(0, 0, 0).ok()?);
    for (number, [x, y]) in (2..).zip(places) {
        polygon.push(Vertex::new(x, y, number).ok()?);
    }
    Some(polygon)
}

/// Twice the area of a polygon.
pub(super) fn area<const N: usize>(places: [[i32; 2]; N]) -> i64 {
    let mut area = 0;
    for at in 0..N {
        let ([x0, y0], [x1, y1]) = (places[at].map(i64::from), places[(at + 1) % N].map(i64::from));
        area += x0 * y1 - x1 * y0;
    }
    area
}

/// The sign of the area, by the definition.
fn turns<F: Format>([ax, ay, bx, by, cx, cy]: [i32; 6]) {
    let (Ok(a), Ok(b), Ok(c)) = (Vertex::<F>::new(ax, ay, 0), Vertex::new(bx, by, 0), Vertex::new(cx, cy, 0))
    else {
        return;
    };
    assert!(turn(Some([a, b, c])) == area([[ax, ay], [bx, by], [cx, cy]]).cmp(&0));
    cover!(turn(Some([a, b, c])) == Ordering::Less);
}

/// Steps in the guard band.
const STANDARD: i32 = Bounds::<Standard>::GUARD_BAND;
/// The same of the small format.
const SMALL: i32 = Bounds::<Small>::GUARD_BAND;

prove! {
    /// A corner is a vertex between the one before and the one after, the first following on the last;
    /// there is none beyond the last.
    #[kani::unwind(6)]
    [corner]
    fn corners_are_between_neighbours(at: usize = 0..=6) {
        let places = [[0, 1], [2, 3], [4, 5], [6, 7], [8, 9]];
        let Some(polygon) = polygon::<Small, 5>(places) else { return };
        let found = corner(&polygon, at).map(|vertices| vertices.map(|v| [v.x(), v.y()]));
        let expected = (at < 5).then(|| [places[(at + 4) % 5], places[at % 5], places[(at + 1) % 5]]);
        assert!(found == expected);
        cover!(at == 4);
        cover!(found.is_none());
    }

    /// A turn is the sign of the exact area.
    [turn, doubled_area, i64::product]
    fn turn_is_the_sign_of_the_area(places: [i32; 6] = [-STANDARD; 6]..=[STANDARD; 6]) {
        turns::<Standard>(places);
    }

    /// The same for the small format.
    [turn, doubled_area, i32::product]
    fn small_turn_is_the_sign_of_the_area(places: [i32; 6] = [-SMALL; 6]..=[SMALL; 6]) {
        turns::<Small>(places);
    }

    /// Vertices on the line through their neighbours are taken out, one after another; the others stay, in their order,
    /// with their depths, whatever these are.
    #[kani::unwind(18)]
    [remove_flat, corner, turn]
    fn flat_corners_are_taken_out(depths: [u32; 5]) {
        let cases: [([[i32; 2]; 5], &[usize]); 4] = [
            ([[0, 0], [2, 1], [4, 2], [4, 4], [0, 4]], &[0, 2, 3, 4]),
            ([[0, 0], [2, 1], [4, 2], [6, 3], [0, 4]], &[0, 3, 4]),
            ([[2, 0], [4, 0], [4, 4], [0, 4], [0, 0]], &[1, 2, 3, 4]),
            ([[0, 0], [1, 1], [2, 2], [3, 3], [1, 1]], &[]),
        ];
        for (places, expected) in cases {
            let Ok(first) = Vertex::<Small>::new(0, 0, 0) else { return };
            let mut polygon = Polygon::empty(first);
            for ([x, y], z) in places.into_iter().zip(depths) {
                polygon.push(Vertex::new(x, y, z).unwrap_or(first));
            }
            remove_flat(&mut polygon);
            let left = polygon.vertices();
            assert!(left.len() == expected.len());
            for (vertex, &at) in left.iter().zip(expected) {
                assert!([vertex.x(), vertex.y()] == places[at] && vertex.z() == depths[at].clamp(DEPTH32_MIN, DEPTH32_MAX));
            }
        }
    }

    /// The corner of a quadrangle is an ear where it turns with it and does not hold the fourth vertex.
    #[kani::unwind(12)]
    [is_ear, corner, turn]
    fn ears_hold_no_vertex(places: [i32; 8] = [0; 8]..=[3; 8]) {
        let [ax, ay, bx, by, cx, cy, dx, dy] = places;
        let (a, b, c, d) = ([ax, ay], [bx, by], [cx, cy], [dx, dy]);
        let Some(polygon) = polygon::<Small, 4>([a, b, c, d]) else { return };
        let turns = area([a, b, c]) > 0;
        let holds = area([a, b, d]) > 0 && area([b, c, d]) > 0 && area([c, a, d]) > 0;
        assert!(is_ear(&polygon, 1, Ordering::Greater) == (turns && !holds));
        cover!(turns && holds);
    }
}
