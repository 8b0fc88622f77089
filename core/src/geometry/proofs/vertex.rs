//! Vertices, facing.

use crate::{
    Cull, Format, OutsideGuardBand, Small, Standard, Vertex, Winding,
    numbers::{Bounds, DEPTH32_MAX, DEPTH32_MIN},
    proof::{cover, prove},
};

fn constructs_vertices<F: Format>(x: i32, y: i32, z: u32) {
    let limit = Bounds::<F>::GUARD_BAND;
    let fits = -limit <= x && x <= limit && -limit <= y && y <= limit;
    match Vertex::<F>::new(x, y, z) {
        Ok(vertex) => {
            assert!(fits && vertex.x() == x && vertex.y() == y);
            assert!(DEPTH32_MIN <= vertex.z() && vertex.z() <= DEPTH32_MAX);
            assert!(vertex.z() == z || !(DEPTH32_MIN..=DEPTH32_MAX).contains(&z));
            cover!(vertex.z() != z);
        }
        Err(error) => {
            assert!(!fits && error == OutsideGuardBand { x, y, limit });
            cover!(y == limit + 1);
        }
    }
}

prove! {
    /// A vertex is made of exactly the coordinates within the guard band; its depth leaves room for the
    /// error of interpolation. The error tells what was given.
    [Vertex::new, Vertex::at, Coordinate::from_steps]
    fn vertices_are_within_the_guard_band(x: i32, y: i32, z: u32) {
        constructs_vertices::<Standard>(x, y, z);
        constructs_vertices::<Small>(x, y, z);
    }

    /// Of the two windings, `Back` culls the one that is not the front, `Front` the other, `None` neither.
    [Cull::culls]
    fn culling_is_by_facing(clockwise: bool, front_clockwise: bool) {
        let winding = |clockwise| if clockwise { Winding::Clockwise } else { Winding::CounterClockwise };
        let (winding, front) = (winding(clockwise), winding(front_clockwise));
        assert!(!Cull::None.culls(winding, front));
        assert!(Cull::Back.culls(winding, front) == (winding != front));
        assert!(Cull::Front.culls(winding, front) == (winding == front));
        cover!(clockwise && !front_clockwise);
    }
}
