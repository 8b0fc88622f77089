//! Records to lanes.

use super::{super::fetch::Records, ints, simd, words};
use crate::proof::{cover, prove};

/// Triangle k has the corners k, k + 1 and 15 - k.
const TRIANGLES: [[u16; 3]; 16] = {
    let mut triangles = [[0; 3]; 16];
    let mut k = 0;
    while k < 16 {
        triangles[k as usize] = [k, (k + 1) & 15, 15 - k];
        k += 1;
    }
    triangles
};

prove! {
    /// Each lane has its own triangle's corners.
    #[kani::unwind(17)]
    [Records::corners, Records::place, Records::four, Records::corner, places]
    fn corners_come_to_their_lanes(places: [[u32; 2]; 16], lane: usize = 0..=15) {
        let records = Records { places: &places, depths: &[] };
        let Some(corners) = records.corners(simd(), &TRIANGLES) else { unreachable!("all are there") };
        for (corner, at) in corners.into_iter().zip(TRIANGLES[lane]) {
            let [x, y] = places[usize::from(at)];
            assert!(ints(corner.x)[lane] == x as i32 && ints(corner.y)[lane] == y as i32);
        }
    }

    /// The same for depths.
    #[kani::unwind(17)]
    [Records::corner_depths, Records::depths, places]
    fn depths_come_to_their_lanes(depths: [u32; 16], lane: usize = 0..=15) {
        let records = Records { places: &[], depths: &depths };
        let Some(corners) = records.corner_depths(simd(), &TRIANGLES) else { unreachable!("all are there") };
        for (corner, at) in corners.into_iter().zip(TRIANGLES[lane]) {
            assert!(words(corner)[lane] == depths[usize::from(at)]);
        }
    }

    /// An index that names no vertex is found in any lane.
    #[kani::unwind(17)]
    [Records::corners, Records::corner_depths]
    fn missing_vertices_are_found(index: u16, lane: usize = 0..=15, corner: usize = 0..=2) {
        let mut triangles = [[0_u16; 3]; 16];
        triangles[lane][corner] = index;
        let records = Records { places: &[[0; 2]; 3], depths: &[0; 3] };
        assert!(records.corners(simd(), &triangles).is_some() == (index < 3));
        assert!(records.corner_depths(simd(), &triangles).is_some() == (index < 3));
        cover!(index == 2);
        cover!(index == 3 && lane == 15);
    }

    /// The corners of one triangle are vertices where they are inside the guard band.
    [Records::vertices, Records::vertex, Vertex::new]
    fn records_are_vertices(place: [u32; 2], depth: u32, at: usize) {
        let records = Records { places: &[[0; 2], place], depths: &[9, depth] };
        let found = records.vertices([0, at, 0]).map(|[_, v, _]| (v.x(), v.y(), v.z()));
        let [x, y] = place.map(|v| v as i32);
        let inside = x.unsigned_abs() <= 1 << 23 && y.unsigned_abs() <= 1 << 23;
        let expected = match at {
            0 => Some((0, 0, 9)),
            1 if inside => Some((x, y, depth.clamp(2, u32::MAX - 2))),
            _ => None,
        };
        assert!(found == expected);
        cover!(found.is_none() && at == 1);
    }
}
