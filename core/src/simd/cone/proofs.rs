//! What faces the culled way.

use super::{Cone, Face, Facing, LESS, Range, dot, middle, minor, minus, sum};
use crate::{
    draw::State,
    geometry::{Cull, Region},
    numbers::Standard,
    proof::{assume, cover, prove},
    transform::Viewport,
};

/// The matrix of an eye at the origin that looks along z: w is z.
const CAMERA: [[f32; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, -0.5, 0.0]];

/// What a draw to 64 x 64 pixels with a matrix culls.
#[inline(always)]
fn facing(matrix: &[[f32; 4]; 4], cull: Cull) -> Option<Facing> {
    let region = Region::<Standard>::of_size(64, 64).ok()?;
    Facing::new(matrix, &Viewport::new(region), &State { cull, ..State::new(region) })
}

/// A cone of triangles that face along z, or against it.
fn along_z(z: f32) -> Cone {
    Cone { axis: [0.0, 0.0, z], spread: 0.25, offset: 0.125, height: 0.5, area: 1.0 }
}

prove! {
    /// Differences and sums of whole numbers are exact.
    [minus, sum]
    fn sums_of_whole_numbers_are_exact(a: [i32; 3], b: [i32; 3], axis: usize = 0..=2) {
        let (x, y) = (a.map(f64::from), b.map(f64::from));
        assert!(minus(x, y)[axis] == (i64::from(a[axis]) - i64::from(b[axis])) as f64);
        let [u, v, w] = a.map(i64::from);
        assert!(sum(x) == (u + v + w) as f64);
        cover!(u < 0 && v > 0);
    }

    /// And sums of products.
    [dot]
    fn products_of_whole_numbers_are_exact(a: [i32; 3]) {
        let [x, y, z] = a.map(i64::from);
        assert!(dot(a.map(f64::from), [3.0, -5.0, 7.0]) == (3 * x - 5 * y + 7 * z) as f64);
        cover!(x < 0 && y > 0);
    }

    /// The middle lies between the ends: for all floats.
    [middle]
    fn middles_lie_between(ends: [u32; 2], axis: usize = 0..=2) {
        let [first, last] = ends.map(f32::from_bits);
        assume!(first <= last && first > f32::NEG_INFINITY && last < f32::INFINITY);
        let (mut low, mut high) = ([-1.0; 3], [2.0; 3]);
        (low[axis], high[axis]) = (first, last);
        let found = middle([low, high]);
        assert!(f64::from(first) <= found[axis] && found[axis] <= f64::from(last));
        assert!(found[(axis + 1) % 3] == 0.5);
        cover!(found[axis] == 7.0);
    }

    /// A determinant of whole numbers is exact, and no larger than the sum of magnitudes.
    [minor]
    fn determinants_of_whole_numbers_are_exact(row: [i32; 3] = [-1000; 3]..=[1000; 3]) {
        let [a, b, c] = row;
        let (value, size) = minor(row.map(f64::from), [2.0, -1.0, 3.0], [1.0, 4.0, -2.0]);
        assert!(value == f64::from(a * (2 - 12) + b * (3 + 4) + c * (8 + 1)));
        assert!(size == f64::from(a.abs() * (2 + 12) + b.abs() * (3 + 4) + c.abs() * (8 + 1)));
        cover!(value < 0.0 && a > 0);
    }

    /// The range of a clip coordinate has its values at every corner of a box, of which none is larger than the size.
    [Range::new, middle]
    fn ranges_have_all_corners(low: [i32; 3] = [-8; 3]..=[7; 3], high: [i32; 3] = [-8; 3]..=[7; 3], corner: usize = 0..=7) {
        assume!(low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2]);
        let range = Range::new([2.0, -3.0, 1.0, 5.0], [low.map(|v| v as f32), high.map(|v| v as f32)]);
        let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
        let value = f64::from(2 * at(0) - 3 * at(1) + at(2) + 5);
        assert!(range.middle - range.reach <= value && value <= range.middle + range.reach);
        assert!(value.abs() <= range.size);
        cover!(value == 26.0 && range.reach > 10.0);
    }

    /// The eye is what the columns of x, y and w take to 0, for whatever way is culled; and there is one where
    /// something is culled.
    [Facing::new, minor]
    fn eyes_are_taken_to_nothing(row: [i32; 3] = [-20; 3]..=[20; 3], cull: u8 = 0..=2) {
        let cull = [Cull::None, Cull::Back, Cull::Front][usize::from(cull)];
        let [x, y, w] = row.map(|v| v as f32);
        let matrix = [[2.0, -1.0, 9.0, 3.0], [1.0, 4.0, 9.0, -2.0], [x, y, 9.0, w], [5.0, 1.0, 9.0, 2.0]];
        let found = facing(&matrix, cull);
        assert!(found.is_some() == (cull != Cull::None));
        if let Some(Facing { columns, eye: [a, b, c, d], .. }) = found {
            for [x, y, z, w] in columns {
                assert!(a * x + b * y + c * z + d * w == 0.0);
            }
        }
        cover!(found.is_some_and(|facing| facing.eye[3] == 7.0));
    }

    /// A cone is culled where its triangles turn the culled way, and are before the eye.
    [Facing::culls_cone, Facing::stays, Facing::new, Range::new]
    fn cones_culled_face_the_culled_way(steps: i32 = -16..=15, up: bool, back: bool) {
        let Some(facing) = facing(&CAMERA, if back { Cull::Back } else { Cull::Front }) else { return };
        let z = steps as f32 * 0.5;
        let corners = [[-0.5, -0.5, z], [0.5, 0.5, z + 0.25]];
        let culled = facing.culls_cone(&along_z(if up { 1.0 } else { -1.0 }), corners);
        assert!(!culled || up == back && z > 0.0);
        cover!(culled && up);
        cover!(culled && !up);
    }

    /// Snapping can turn triangles whose determinants can be 0, and small ones: those of less than four steps².
    [Facing::stays]
    fn small_triangles_do_not_stay(factor: u64) {
        let Some(facing) = facing(&CAMERA, Cull::Back) else { return };
        let factor = f64::from_bits(factor);
        let stays = facing.stays(&along_z(1.0), factor, [[-0.5, -0.5, 1.0], [0.5, 0.5, 2.0]]);
        assert!(!stays || factor * (256.0 * 32.0 * 256.0 * 32.0 / 8.0) > 4.0);
        cover!(stays);
        cover!(!stays && factor > 0.0);
    }

    /// Nothing stays that reaches the eye's plane, whatever the factor.
    [Facing::stays, Range::new]
    fn nothing_at_the_eye_stays(factor: u64, z: i32 = -64..=63) {
        let Some(facing) = facing(&CAMERA, Cull::Back) else { return };
        let z = z as f32 / 16.0;
        let stays = facing.stays(&along_z(1.0), f64::from_bits(factor), [[-0.5, -0.5, z], [0.5, 0.5, 4.0]]);
        assert!(!stays || z > 0.5);
        cover!(stays);
    }

    /// A face's area and its longest side are a little more than they are, and its normal is of length 1.
    [Face::new]
    fn faces_are_measured(x: i32 = 1..=4, y: i32 = 1..=4) {
        let Some(face) = Face::new([[0.0; 3], [x as f32, 0.0, 0.0], [0.0, y as f32, 0.0]]) else {
            unreachable!("it is not thin")
        };
        let more = 1.0 + 2.0 / (1u64 << 38) as f64;
        let (area, square) = (f64::from(x * y), f64::from(x * x + y * y));
        assert!(area <= face.area && face.area <= area * more);
        assert!(square <= face.longest * face.longest && face.longest * face.longest <= square * more);
        let [across, down, z] = face.normal;
        assert!(across == 0.0 && down == 0.0 && LESS < z && z <= 1.0);
        assert!(face.size == f64::from(x.max(y)));
        cover!(x == 3 && y == 4);
    }

    /// Triangles without area have no cone, wherever their third corner is on the line through the others.
    #[kani::unwind(4)]
    [Cone::new, Face::new]
    fn lines_have_no_cone(at: i32 = -8..=7) {
        let at = at as f32;
        let flat = [[0.0; 3], [1.0, -2.0, 0.5], [at, -2.0 * at, 0.5 * at]];
        assert!(Cone::new([0.0; 3], [flat].into_iter()).is_none());
    }

    /// A cone has the normals of its triangles, and is no larger than their area: two that share a side, of which one
    /// is turned about it.
    #[kani::unwind(4)]
    [Cone::new, Face::new]
    fn cones_have_all_normals(turned: i32 = -4..=3) {
        let (a, b, c) = ([0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, turned as f32]);
        let triangles = [[a, b, [0.0, 4.0, 0.0]], [a, b, c]];
        let Some(cone) = Cone::new([2.0, 2.0, 0.0], triangles.into_iter()) else { unreachable!("they face one way") };
        let (axis, spread) = (cone.axis.map(f64::from), f64::from(cone.spread));
        // |n - axis| <= spread, for n of length 1 along (0, -turned, 4).
        let least = 1.0 + dot(axis, axis) - spread * spread;
        let (along, square) = (dot(axis, [0.0, f64::from(-turned), 4.0]), f64::from(turned * turned + 16));
        assert!(along > 0.0 && least * least * square <= 4.0 * along * along);
        assert!(least <= 2.0 * axis[2] && cone.area <= 16.0 && cone.offset > 0.0);
        cover!(turned == -4);
    }
}
