//! What faces the culled way.

use super::{Cone, Face, Facing, LESS, MORE, Range, dot, middle, minor, minus, sum};
use crate::{
    draw::State,
    geometry::{Cull, Region},
    numbers::Standard,
    proof::{cover, prove, which},
    transform::{Viewport, root_above},
};

/// The matrix of an eye at the origin that looks along z: w is z.
const CAMERA: [[f32; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, -0.5, 0.0]];

/// What a draw culls in a viewport of 96 x 32 pixels around (80, 32), with a matrix.
#[inline(always)]
fn facing(matrix: &[[f32; 4]; 4], cull: Cull) -> Option<Facing> {
    let region = Region::<Standard>::new(32, 16, 128, 48).ok()?;
    Facing::new(matrix, &Viewport::new(region), &State { cull, ..State::new(region) })
}

/// More and less than 1 by what `f32` and sums here are off.
const ABOVE: f64 = 1.0 + 1.0 / 4_194_304.0;
const BELOW: f64 = 1.0 - 1.0 / 4_194_304.0;

/// A cone of triangles that face along z, or against it.
fn along_z(z: f32) -> Cone {
    Cone { axis: [0.0, 0.0, z], spread: 0.25, offset: 0.125, height: 0.5, area: 1.0 }
}

/// The least value and the most of a clip coordinate at the corners of a box, and the most that the magnitudes of its
/// terms come to.
#[inline(always)]
fn at_corners([a, b, c, d]: [f64; 4], corners: [[f32; 3]; 2]) -> (f64, f64, f64) {
    let (mut least, mut most, mut size) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
    for corner in 0..8 {
        let at = |axis: usize| f64::from(corners[corner >> axis & 1][axis]);
        let terms = [a * at(0), b * at(1), c * at(2), d];
        let value: f64 = terms.iter().sum();
        (least, most) = (least.min(value), most.max(value));
        size = size.max(terms.iter().map(|v| v.abs()).sum());
    }
    (least, most, size)
}

/// The height and the area from which on triangles in a box stay as they face, in that viewport: determinants are their
/// areas times `factor`.
#[inline(always)]
fn least_sizes(matrix: &[[f32; 4]; 4], factor: f64, corners: [[f32; 3]; 2]) -> [f64; 2] {
    let columns = [0, 1, 3].map(|column| matrix.map(|row| f64::from(row[column])));
    let [x, y, (nearest, farthest, size_w)] = columns.map(|column| at_corners(column, corners));
    let length = |[a, b, c, _]: [f64; 4]| root_above(a * a + b * b + c * c);
    let near = nearest - size_w / 262_144.0;
    // Pixels that a vertex is off by, and pixels for length across the view.
    let of = |(least, most, size): (f64, f64, f64), column, half: f64, center: f64| {
        let quotient = most.max(-least) / near;
        let relative = size / near + quotient * (size_w / near) + quotient;
        let off = (half * relative + (center + half * quotient) / 2.0) / 2_097_152.0;
        (off, half * (length(column) + quotient * length(columns[2])) / near)
    };
    let (off_x, across) = of(x, columns[0], 48.0, 80.0);
    let (off_y, down) = of(y, columns[1], 16.0, 32.0);
    let moves = MORE / 2.0 + 256.0 * off_x.max(off_y);
    let areas = 256.0 * 256.0 * 48.0 * 16.0 * factor / (farthest * farthest * farthest);
    [4.0 * MORE * moves * 256.0 * (across + down) / areas, 16.0 * MORE * moves * moves / areas]
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
        assert!(!stays || factor * (256.0 * 48.0 * 256.0 * 16.0 / 8.0) > 4.0);
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
            Face::new(flat).is_none() && Cone::new([0.0; 3], [flat].iter().copied()).is_none()
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
    }

    /// A triangle has a face where its area is more than 2^-24 of the longest side times that side and the largest
    /// coordinate.
    [Face::new]
    fn slivers_have_no_face(number: u32 = 0..=7) {
        let found = which(8, |number| {
            // The longest side is 1 by less than 2^-40.
            let (at, off) = (number / 2 % 2 * 7 + number / 4 * -15, if number % 2 == 0 { -1 } else { 1 });
            let sum = (1 + (at + 1).max(-at)) as f32;
            let high = sum * ((64 + off) as f32 / (64.0 * 16_777_216.0));
            let [left, right] = [at, at + 1].map(|v| v as f32);
            let sliver = [[left, 0.0, 0.0], [right, 0.0, 0.0], [left, high, 0.0]];
            Face::new(sliver).is_some() == (off > 0)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
    }

    /// A cone has the normals and the planes of its triangles and is no larger than they are, by no more than the
    /// margins: of two that share a side, of which one is turned about it, in either order.
    [Cone::new, Face::new]
    fn cones_have_all_triangles(number: u32 = 0..=7) {
        let found = which(8, |number| {
            let turn = [-2, 1, 2, 3][number as usize % 4];
            let flat = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
            let turned = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, turn as f32]];
            let triangles = if number < 4 { [flat, turned] } else { [turned, flat] };
            let Some(cone) = Cone::new([2.0, 2.0, 0.0], triangles.iter().copied()) else { return false };
            let axis = cone.axis.map(f64::from);
            let turn = f64::from(turn);
            let length = root_above(turn * turn + 16.0);
            let normals = [[0.0, 0.0, 1.0], [0.0, -turn / length, 4.0 / length]];
            let [near, far] = normals.map(|normal| {
                let aside = minus(normal, axis);
                root_above(dot(aside, aside))
            });
            // By no more than 2^-18 of it.
            let is_above = |v: f32, least: f64| {
                let v = f64::from(v);
                least <= v && v <= least * (1.0 + 1.0 / 262_144.0)
            };
            let even = (near - far).abs() <= 1.0 / 8_388_608.0;
            let spread = near.max(far) + 1.0 / 4_194_304.0;
            // The corner at the origin is 4 away, added up.
            let offset = (2.0 * turn / length).abs() + 4.0 / 4_194_304.0;
            // The flat one's: the least of both.
            let (area, height) = (f64::from(cone.area), f64::from(cone.height));
            let (most, square) = (16.0 * (1.0 - 1.0 / 2_097_152.0), height * height);
            even && is_above(cone.spread, spread)
                && is_above(cone.offset, offset)
                && most * (1.0 - 1.0 / 1_048_576.0) <= area
                && area <= most
                && 8.0 * (1.0 - 1.0 / 262_144.0) <= square
                && square <= 8.0 * (1.0 - 1.0 / 1_048_576.0)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 7);
    }

    /// There is a cone where the normals are less than a right angle apart.
    [Cone::new, Face::new]
    fn cones_are_less_than_a_right_angle(number: u32 = 0..=3) {
        let found = which(4, |number| {
            let slope = 4.0 + (number - 2) as f32 / 1024.0;
            let side = |slope: f32| [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, slope]];
            let cone = Cone::new([2.0, 2.0, 0.0], [side(slope), side(-slope)].iter().copied());
            cone.is_some() == (slope < 4.0)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 3);
    }

    /// Triangles with two corners at one place have no part in a cone, whichever these are.
    [Cone::new, Face::new]
    fn triangles_without_three_corners_do_not_matter(number: u32 = 0..=5) {
        let found = which(6, |number| {
            let [a, b] = [[7.0, 5.0, 3.0], [-1.0, 9.0, 2.0]];
            let thin = [[a, a, b], [a, b, a], [b, a, a]][number as usize % 3];
            let flat = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
            let triangles = if number < 3 { [flat, thin] } else { [thin, flat] };
            let cone = Cone::new([2.0, 2.0, 0.0], triangles.iter().copied());
            cone.is_some_and(|cone| cone.axis == [0.0, 0.0, 1.0] && cone.area > 15.0)
                && Cone::new([0.0; 3], [thin].iter().copied()).is_none()
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 5);
    }

    /// The offset is at least 2^-40 of the largest coordinate, wherever the plane is.
    [Cone::new, Face::new]
    fn offsets_are_not_less_than_rounding(power: i32 = 0..=10) {
        let found = which(11, |power| {
            let at = (1 << power) as f32;
            let [a, b, c] = [[at; 3], [2.0 * at, at, at], [at, 2.0 * at, at]];
            let Some(cone) = Cone::new([f64::from(at); 3], [[a, b, c]].iter().copied()) else { return false };
            let least = 2.0 * f64::from(at) / (1u64 << 40) as f64;
            least <= f64::from(cone.offset) && f64::from(cone.offset) <= least * (1.0 + 1.0 / 262_144.0)
        });
        assert!(found >> power & 1 == 1);
        cover!(power == 10);
    }

    /// However small triangles are, the planes have an offset.
    [Cone::new, Face::new]
    fn smallest_triangles_have_an_offset(power: i32 = 0..=15) {
        let found = which(16, |power| {
            let least = f32::from_bits(2 << power);
            let triangle = [[0.0; 3], [least, 0.0, 0.0], [0.0, least, 0.0]];
            let cone = Cone::new([0.0; 3], [triangle].iter().copied());
            cone.is_some_and(|cone| cone.offset > 0.0 && cone.offset < 1e-37)
        });
        assert!(found >> power & 1 == 1);
        cover!(power == 15);
    }

    /// A cone is culled from the eyes that are behind all planes within its offset and its spread, and from no others:
    /// with d from the eye to the middle, where axis . d - offset is more than the spread times |d|. Determinants are
    /// areas times the difference.
    [Facing::culls_cone, Facing::stays, Facing::new, dot, sum, middle, minor]
    fn cones_are_culled_behind_their_planes(number: u32 = 0..=15) {
        let found = which(16, |number| {
            let eye = [number % 4 * 3 - 5, number / 4 * 2 - 3, -6];
            let [ex, ey, ez] = eye.map(|v| v as f32);
            let matrix =
                [[2.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0], [-2.0 * ex, -ey, -0.5 - ez, -ez]];
            let Some(facing) = facing(&matrix, Cull::Back) else { return false };
            let corners = [[1.0, -4.0, 3.0], [3.0, 2.0, 5.0]];
            let [x, y, z] = [2 - eye[0], -1 - eye[1], 4 - eye[2]];
            let (along, square) = (2 * x - 3 * y + 4 * z - 32, x * x + y * y + z * z);
            let expected = along > 0 && along * along > 4 * square;
            // x is doubled, and so are determinants.
            let factor = 2.0 * (f64::from(along) / 4.0 - root_above(f64::from(square)) / 2.0);
            let [height, area] = least_sizes(&matrix, factor, corners);
            let culls = |height: f64, area: f64| {
                let (height, area) = (height.abs() as f32, area.abs() as f32);
                facing.culls_cone(&Cone { axis: [0.5, -0.75, 1.0], spread: 0.5, offset: 8.0, height, area }, corners)
            };
            culls(height * ABOVE, area * ABOVE) == expected
                && !culls(height * BELOW, 1e30)
                && !culls(1e30, area * BELOW)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 15);
    }

    /// What is along the axis counts where it is more than 2^-40 of the terms that it is a sum of, and what the offset
    /// takes.
    [Facing::culls_cone, Facing::new, sum, minor]
    fn cones_at_the_eye_are_not_culled(number: u32 = 0..=15) {
        let found = which(16, |number| {
            // In units of 2^-48, of 256 for each of the terms of 23 + 2^-40 in all.
            let (more, offset) = (number % 8, number / 8);
            let beside = (23 * 256 + 64 * offset + 4 * (more - 4)) as f32 / (1u64 << 48) as f32;
            let matrix =
                [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0], [beside, -8.0, 1.5, 2.0]];
            let Some(facing) = facing(&matrix, Cull::Back) else { return false };
            let offset = (64 * offset) as f32 / (1u64 << 48) as f32;
            let cone = Cone { axis: [1.0, 0.0, 0.0], spread: 0.0, offset, height: f32::MAX, area: f32::MAX };
            facing.culls_cone(&cone, [[-1.0, 7.0, 1.0], [1.0, 9.0, 9.0]]) == (more > 4)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 15);
    }

    /// Triangles stay as they face from a height and an area on: the limits are those of what is said of `stays`, with
    /// clip coordinates that are sums of terms much larger than they are, and without.
    [Facing::stays, Facing::new, Range::new]
    fn slow_triangles_stay_from_a_size_on(number: u32 = 0..=31) {
        let found = which(32, |number| {
            let bit = |at: i32| (number >> at & 1) as f32;
            // Where the box begins, how fast w grows with x, and whether x does with y.
            let (at, slant, shear) = ([bit(0) * 16384.0, bit(1) * 8192.0], bit(2) * 0.5, bit(3));
            let [x, y] = at;
            let moved = bit(4);
            let matrix = [
                [2.0, moved, 0.0, slant],
                [shear, 3.0, 0.0, 0.0],
                [1.0, -1.0, 1.0, 1.0],
                [moved - 2.0 * x - shear * y, -3.0 * y - moved * x, -0.5, -slant * x],
            ];
            let corners = [[x, y, 2.0], [x + 1.0, y + 1.0, 3.0]];
            let Some(facing) = facing(&matrix, Cull::Back) else { return false };
            let factor = 0.125;
            let stays = |height: f64, area: f64| {
                let cone = Cone { height: height as f32, area: area as f32, ..along_z(1.0) };
                facing.stays(&cone, factor, corners)
            };
            let [height, area] = least_sizes(&matrix, factor, corners);
            stays(height * ABOVE, area * ABOVE) && !stays(height * BELOW, 1e30) && !stays(1e30, area * BELOW)
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 31);
    }
}
