//! Boxes against the frustum.

use crate::{
    geometry::Region,
    numbers::Standard,
    proof::{cover, prove},
    transform::{Frustum, Viewport, plane::Plane},
};

const IDENTITY: [[f32; 4]; 4] = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];

prove! {
    /// A box that is left out has its corners outside one plane of the frustum, and so whatever is in it:
    /// through the identity, for any box.
    [Frustum::new, Frustum::between, Frustum::excludes_box, greater]
    fn boxes_left_out_are_outside(low: [u32; 3], high: [u32; 3]) {
        let (low, high) = (low.map(f32::from_bits), high.map(f32::from_bits));
        let excluded = Frustum::new(&IDENTITY).excludes_box([low, high]);
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
        let contained = Frustum::new(&IDENTITY).contains_box(corners);
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

    /// A sphere that is left out is beyond a side of the frustum by more than its radius: through the identity, for any
    /// place along x.
    [Frustum::excludes_sphere]
    fn spheres_left_out_are_beside(bits: u32) {
        let (x, radius) = (f32::from_bits(bits), 3.0);
        let excluded = Frustum::new(&IDENTITY).excludes_sphere([x, 0.5, 0.5], radius);
        assert!(!excluded || f64::from(x.abs()) > 1.0 + f64::from(radius));
        cover!(excluded);
    }

    /// The same along z, of a small one.
    [Frustum::excludes_sphere]
    fn spheres_left_out_are_before_or_behind(bits: u32) {
        let (z, radius) = (f32::from_bits(bits), 0.25);
        let excluded = Frustum::new(&IDENTITY).excludes_sphere([0.5, 0.5, z], radius);
        assert!(!excluded || f64::from(z) < -f64::from(radius) || f64::from(z) > 1.0 + f64::from(radius));
        cover!(excluded);
    }

    /// What the frustum of an area leaves out is drawn beside the area: through the identity, for any point in the
    /// view and any columns.
    [Frustum::of_area, Frustum::between, Frustum::excludes_box]
    fn slow_points_left_out_are_beside_the_area(bits: u32, columns: [u32; 2] = [0; 2]..=[64; 2]) {
        let [x0, x1] = columns;
        let (Ok(region), Ok(area)) = (Region::<Standard>::of_size(64, 64), Region::new(x0, 0, x1, 64)) else { return };
        let (viewport, x) = (Viewport::new(region), f32::from_bits(bits));
        let excluded = Frustum::of_area(&IDENTITY, &viewport, area).excludes_box([[x, 0.0, 0.5]; 2]);
        let Some(vertex) = viewport.project([x, 0.0, 0.5, 1.0]) else { return };
        let [left, right] = [x0, x1].map(|x| (x << 8) as i32);
        let beside = vertex.x() < left || right < vertex.x();
        assert!(!excluded || !Plane::frustum_has([x, 0.0, 0.5, 1.0]) || beside);
        cover!(excluded && x.abs() < 1.0);
    }
}
