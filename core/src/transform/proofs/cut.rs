//! Where planes cut edges.

use crate::{
    proof::{cover, prove},
    transform::plane::Plane,
};

/// The ends of an edge and the cut, where a plane cuts it and all is finite.
pub(super) fn cuts(plane: Plane, inside: [u32; 4], outside: [u32; 4]) -> Option<[[f32; 4]; 3]> {
    let (a, b) = (inside.map(f32::from_bits), outside.map(f32::from_bits));
    let [finite_a, finite_b] =
        [a, b].map(|[x, y, z, w]| x.is_finite() & y.is_finite() & z.is_finite() & w.is_finite());
    if !finite_a | !finite_b | plane.excludes(a) | !plane.excludes(b) {
        return None;
    }
    Some([a, b, plane.cut(a, b)])
}

/// A component keeps the sign that both ends have, and is a number.
fn keeps_sign(a: f32, b: f32, cut: f32) {
    assert!(!cut.is_nan());
    assert!(cut >= 0.0 || a < 0.0 || b < 0.0);
    assert!(cut <= 0.0 || a > 0.0 || b > 0.0);
    cover!(cut == 1.0);
}

/// The cut at a plane of the guard band, of which the other component is set.
pub(super) fn keeps_sign_of_w(plane: Plane, [v0, w0]: [u32; 2], [v1, w1]: [u32; 2]) {
    if let Some([[.., a], [.., b], [.., cut]]) = cuts(plane, [v0, 0, 0, w0], [v1, 0, 0, w1]) {
        keeps_sign(a, b, cut);
    }
}

prove! {
    /// At the near plane a component keeps the sign that both ends have, and z is 0: for all finite vertices.
    [Plane::cut, Plane::distance]
    fn near_cut_keeps_signs(x: [u32; 2], z: [u32; 2]) {
        if let Some([[a, ..], [b, ..], [cut, _, depth, _]]) =
            cuts(Plane::Near, [x[0], 0, z[0], 0], [x[1], 0, z[1], 0])
        {
            keeps_sign(a, b, cut);
            assert!(depth == 0.0);
        }
    }

    /// At the far plane w keeps its sign, and z is w: for all finite vertices.
    [Plane::cut, Plane::distance]
    fn far_cut_keeps_signs(inside: [u32; 2], outside: [u32; 2]) {
        let ([z0, w0], [z1, w1]) = (inside, outside);
        if let Some([[.., a], [.., b], [_, _, depth, cut]]) = cuts(Plane::Far, [0, 0, z0, w0], [0, 0, z1, w1]) {
            keeps_sign(a, b, cut);
            assert!(depth.to_bits() == cut.to_bits());
        }
    }

    /// At the plane of the eye w is the smallest that is divided by: for all finite vertices.
    [Plane::cut, Plane::distance]
    fn eye_cut_is_at_the_smallest_w(inside: u32, outside: u32) {
        if let Some([_, _, cut]) = cuts(Plane::Eye, [0, 0, 0, inside], [0, 0, 0, outside]) {
            assert!(cut[3] == f32::MIN_POSITIVE);
            assert!(!Plane::Eye.excludes(cut));
            cover!(cut[0] == 0.0);
        }
    }

    /// At a plane of the guard band w keeps its sign: with a factor of one bit, for all finite vertices. Other
    /// factors are left to tests.
    [Plane::cut, Plane::distance]
    fn slow_left_cut_keeps_signs(inside: [u32; 2], outside: [u32; 2]) {
        keeps_sign_of_w(Plane::Left(-32.0), inside, outside);
    }
}
