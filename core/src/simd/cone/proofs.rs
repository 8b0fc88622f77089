//! What faces the culled way.

use super::{Cone, Face, Facing, LESS, Range, dot, middle, minor, minus, sum};
use crate::{
    draw::State,
    geometry::{Cull, Region},
    numbers::Standard,
    proof::{cover, prove, which},
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
    fn sums_of_whole_numbers_are_exact(x: i32 = -64..=63) {
        let v = f64::from(x);
        let x = i64::from(x);
        let difference = minus([v, 7.0, v], [5.0, v, v]);
        assert!(difference == [(x - 5) as f64, (7 - x) as f64, 0.0]);
        assert!(sum([v, 5.0, -3.0]) == (x + 2) as f64 && sum([5.0, -3.0, v]) == (x + 2) as f64);
        cover!(x == -7);
    }

    /// And sums of products: that of whole numbers.
    [dot]
    fn products_of_whole_numbers_are_exact(x: i32 = -64..=63) {
        assert!(dot([f64::from(x), 4.0, -2.0], [3.0, -5.0, 7.0]) == f64::from(3 * x - 34));
        assert!(dot([4.0, f64::from(x), -2.0], [3.0, -5.0, 7.0]) == f64::from(-5 * x - 2));
        assert!(dot([4.0, -2.0, f64::from(x)], [3.0, -5.0, 7.0]) == f64::from(7 * x + 22));
        cover!(x < 0);
    }

    /// The middle lies between the ends, halfway.
    [middle]
    fn middles_lie_between(low: i32 = -8..=7, size: i32 = 0..=7, axis: usize = 0..=2) {
        let (mut first, mut last) = ([-1.0; 3], [2.0; 3]);
        (first[axis], last[axis]) = (low as f32, (low + size) as f32);
        let found = middle([first, last]);
        assert!(f64::from(low) <= found[axis] && found[axis] <= f64::from(low + size));
        assert!(2.0 * found[axis] == f64::from(2 * low + size) && found[(axis + 1) % 3] == 0.5);
        cover!(found[axis] == 3.5);
    }

    /// A determinant of whole numbers is exact, and so is the sum of magnitudes.
    [minor]
    fn determinants_of_whole_numbers_are_exact(a: i32 = -32..=31) {
        let (b, c) = (3, -5);
        let (value, size) = minor([a, b, c].map(f64::from), [2.0, -1.0, 3.0], [1.0, 4.0, -2.0]);
        assert!(value == f64::from(a * (2 - 12) + b * (3 + 4) + c * (8 + 1)));
        assert!(size == f64::from(a.abs() * (2 + 12) + b.abs() * (3 + 4) + c.abs() * (8 + 1)));
        cover!(value > 0.0);
    }

    /// The range of a clip coordinate has its values at every corner of a box, of which none is larger than the size.
    [Range::new, middle]
    fn ranges_have_all_corners(number: u32 = 0..=15) {
        let found = which(16, |number| {
            let (low, high) = ([number - 8, -2, 1], [9, 3, 5]);
            let range = Range::new([2.0, -3.0, 1.0, 5.0], [low.map(|v| v as f32), high.map(|v| v as f32)]);
            (0..8).all(|corner| {
                let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
                let value = f64::from(2 * at(0) - 3 * at(1) + at(2) + 5);
                let within = range.middle - range.reach <= value && value <= range.middle + range.reach;
                within && value.abs() <= range.size
            })
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 15);
    }

    /// The eye is what the columns of x, y and w take to 0, for whatever way is culled; and there is one where
    /// something is culled.
    [Facing::new, minor]
    fn eyes_are_taken_to_nothing(x: i32 = -8..=7, cull: u8 = 0..=2) {
        let cull = [Cull::None, Cull::Back, Cull::Front][usize::from(cull)];
        let matrix = [[2.0, -1.0, 9.0, 3.0], [1.0, 4.0, 9.0, -2.0], [x as f32, -2.0, 9.0, 3.0], [5.0, 1.0, 9.0, 2.0]];
        let found = facing(&matrix, cull);
        assert!(found.is_some() == (cull != Cull::None));
        if let Some(Facing { columns, eye: [a, b, c, d], .. }) = found {
            for [x, y, z, w] in columns {
                assert!(a * x + b * y + c * z + d * w == 0.0);
            }
        }
        cover!(found.is_some() && x == 5);
    }

    /// A cone is culled where its triangles turn the culled way, and are before the eye.
    [Facing::culls_cone, Facing::stays, Facing::new, Range::new]
    fn cones_culled_face_the_culled_way(number: u32 = 0..=7) {
        let Some(facing) = facing(&CAMERA, Cull::Back) else { return };
        let found = which(8, |number| {
            let (z, up) = ((number / 2 - 1) as f32, number % 2 == 1);
            let corners = [[-0.5, -0.5, z], [0.5, 0.5, z + 0.25]];
            facing.culls_cone(&along_z(if up { 1.0 } else { -1.0 }), corners) == (up && z > 0.5)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
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

    /// Nothing stays that reaches the eye's plane, or what is before the near one.
    [Facing::stays, Range::new]
    fn nothing_at_the_eye_stays(number: u32 = 0..=7) {
        let Some(facing) = facing(&CAMERA, Cull::Back) else { return };
        let found = which(8, |number| {
            let z = (number - 4) as f32 * 0.25;
            facing.stays(&along_z(1.0), 100.0, [[-0.5, -0.5, z], [0.5, 0.5, 4.0]]) == (z > 0.5)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
    }

    /// A face's area and its longest side are a little more than they are, and its normal is of length 1.
    [Face::new]
    fn faces_are_measured(number: u32 = 0..=15) {
        let more = 1.0 + 2.0 / (1u64 << 38) as f64;
        let found = which(16, |number| {
            let (x, y) = (1 + number % 4, 1 + number / 4);
            let Some(face) = Face::new([[0.0; 3], [x as f32, 0.0, 0.0], [0.0, y as f32, 0.0]]) else {
                return false;
            };
            let (area, square) = (f64::from(x * y), f64::from(x * x + y * y));
            let longest = face.longest * face.longest;
            let [across, down, z] = face.normal;
            area <= face.area
                && face.area <= area * more
                && square <= longest
                && longest <= square * more
                && (across, down, face.size) == (0.0, 0.0, f64::from(x.max(y)))
                && LESS < z
                && z <= 1.0
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 15);
    }

    /// Triangles without area have no face and no cone, wherever their third corner is on the line through the others.
    [Cone::new, Face::new]
    fn lines_have_no_cone(number: u32 = 0..=7) {
        let found = which(8, |number| {
            let at = (number - 4) as f32 * 0.75;
            let flat = [[0.0; 3], [1.0, -2.0, 0.5], [at, -2.0 * at, 0.5 * at]];
            Face::new(flat).is_none() && Cone::new([0.0; 3], [flat].into_iter()).is_none()
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
    }

    /// A cone has the normals of its triangles, and is no larger than their area: two that share a side, of which one
    /// is turned about it.
    [Cone::new, Face::new]
    fn cones_have_all_normals(number: u32 = 0..=1) {
        let found = which(2, |number| {
            let turned = f64::from(3 * number - 2);
            let (a, b, c) = ([0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, turned as f32]);
            let triangles = [[a, b, [0.0, 4.0, 0.0]], [a, b, c]];
            let Some(cone) = Cone::new([2.0, 2.0, 0.0], triangles.into_iter()) else { return false };
            let (axis, spread) = (cone.axis.map(f64::from), f64::from(cone.spread));
            // |n - axis| <= spread, for n of length 1 along (0, -turned, 4).
            let least = 1.0 + dot(axis, axis) - spread * spread;
            let (along, square) = (dot(axis, [0.0, -turned, 4.0]), turned * turned + 16.0);
            let has = along > 0.0 && least * least * square <= 4.0 * along * along && least <= 2.0 * axis[2];
            has && cone.area <= 16.0 && cone.offset > 0.0
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 1);
    }
}
