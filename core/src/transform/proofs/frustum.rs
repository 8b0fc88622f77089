//! Boxes against the frustum.

use crate::{
    proof::{cover, prove},
    transform::{Frustum, plane::Plane},
};

prove! {
    /// A box that is left out has its corners outside one plane of the frustum, and so whatever is in it:
    /// through the identity, for any box.
    [Frustum::new, Frustum::between, Frustum::excludes_box, greater]
    fn boxes_left_out_are_outside(low: [u32; 3], high: [u32; 3]) {
        let (low, high) = (low.map(f32::from_bits), high.map(f32::from_bits));
        let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
        let excluded = Frustum::new(&identity).excludes_box([low, high]);
        let [[x0, y0, z0], [x1, y1, z1]] = [low, high];
        let ordered = x0 <= x1 && y0 <= y1 && z0 <= z1;
        let mut common = [u32::MAX; 4];
        for [x, y, z] in [[x0, y0, z0], [x1, y1, z1]] {
            for (common, beside) in common.iter_mut().zip(Plane::beside_frustum([x, y, z, 1.0])) {
                *common &= beside;
            }
        }
        assert!(!excluded || !ordered || common != [0; 4]);
        cover!(excluded && ordered && common == [2, 0, 0, 0]);
    }

    /// A box that is contained has its corners inside all planes of the frustum: through the identity, for any box.
    [Frustum::new, Frustum::between, Frustum::contains_box, greater]
    fn boxes_contained_are_inside(low: [u32; 3], high: [u32; 3]) {
        let corners = [low.map(f32::from_bits), high.map(f32::from_bits)];
        let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
        let contained = Frustum::new(&identity).contains_box(corners);
        for [x, y, z] in corners {
            assert!(!contained || Plane::frustum_has([x, y, z, 1.0]));
        }
        cover!(contained);
    }

    /// A box that is not finite is never left out, whatever the matrix.
    [Frustum::new, Frustum::between, Frustum::excludes_box, greater]
    fn infinite_boxes_stay(matrix: [[u32; 4]; 4], end: u32, axis: usize = 0..=2) {
        let matrix = matrix.map(|row| row.map(f32::from_bits));
        let mut low = [0.0; 3];
        low[axis] = f32::NEG_INFINITY;
        let mut high = [1.0; 3];
        high[axis] = f32::from_bits(end);
        let excluded = Frustum::new(&matrix).excludes_box([low, high]);
        assert!(!excluded);
    }
}
