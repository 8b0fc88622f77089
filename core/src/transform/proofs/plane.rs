//! Which vertices planes exclude.

use crate::{
    proof::{cover, prove},
    transform::{plane::Plane, positions::are_finite},
};

/// The planes of the frustum by the definition.
const FRUSTUM: [Plane; 7] = [
    Plane::Near,
    Plane::Far,
    Plane::Eye,
    Plane::Left(-1.0),
    Plane::Right(1.0),
    Plane::Top(1.0),
    Plane::Bottom(-1.0),
];

prove! {
    /// What the frustum has is finite and excluded by none of its planes. For every bit pattern.
    [Plane::frustum_has, Plane::excludes]
    fn frustum_has_what_no_plane_excludes(bits: [u32; 4]) {
        let vertex = bits.map(f32::from_bits);
        let [x, y, z, w] = vertex;
        let finite = x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite();
        let [near, far, eye, left, right, top, bottom] = FRUSTUM.map(|plane| plane.excludes(vertex));
        let excluded = near | far | eye | left | right | top | bottom;
        assert!(Plane::frustum_has(vertex) == (finite & !excluded));
        cover!(Plane::frustum_has(vertex));
        cover!(!finite & !excluded);
    }

    /// Each bit beside the frustum is a plane that excludes the vertex: two planes for x, for y, for z, one
    /// for w. For every bit pattern.
    [Plane::beside_frustum, Plane::excludes]
    fn bits_beside_the_frustum_are_planes(bits: [u32; 4]) {
        let vertex = bits.map(f32::from_bits);
        let [near, far, eye, left, right, top, bottom] =
            FRUSTUM.map(|plane| u32::from(plane.excludes(vertex)));
        let beside = Plane::beside_frustum(vertex);
        assert!(beside == [left | right << 1, bottom | top << 1, near | far << 1, eye]);
        cover!(beside == [1, 2, 3, 1]);
    }

    /// Every component is looked at, and every NaN and infinity found.
    [are_finite]
    fn infinities_are_found(bits: [[u32; 4]; 3]) {
        let corners = bits.map(|bits| bits.map(f32::from_bits));
        let [a, b, c] = corners.map(|[x, y, z, w]| x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite());
        assert!(are_finite(&corners) == (a & b & c));
        cover!(a & b & c);
        cover!(a & b & !c);
    }
}
