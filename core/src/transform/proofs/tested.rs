//! Properties that no prover finished: for tests alone.

use super::{
    cut::{cuts, keeps_sign_of_w},
    triangulate::{area, polygon},
    viewport::{stays_in_the_columns, stays_in_the_rows},
};
use crate::{
    numbers::{Format, Small, Standard},
    proof::{assume, cover, prove},
    transform::{
        bound::Corners,
        plane::Plane,
        triangulate::{corner, remove_flat, triangulate, turn, winding},
    },
};
use core::cmp::Ordering;

/// What a vertex inside and one outside are, and x of both.
fn near(z: [u32; 2], x: [f32; 2]) -> Option<f32> {
    let [x0, x1] = x.map(f32::to_bits);
    cuts(Plane::Near, [x0, 0, z[0], 0], [x1, 0, z[1], 0]).map(|[_, _, [x, ..]]| x)
}

/// Triangles of vertices that the polygon has, at most N - 2, their areas adding up to its own.
fn is_cut_into_triangles<const N: usize>(places: [[i32; 2]; N]) {
    let Some(polygon) = polygon::<Small, N>(places) else { return };
    let (mut count, mut sum, mut known) = (0, 0, true);
    triangulate(polygon, |triangle| {
        count += 1;
        sum += area(triangle.map(|v| [v.x(), v.y()]));
        for v in triangle {
            known &= places.get((v.z() - 2) as usize) == Some(&[v.x(), v.y()]);
        }
    });
    assert!(count <= N - 2);
    assert!(sum == area(places));
    assert!(known);
    cover!(count == N - 2);
    cover!(count == 0);
}

prove! {
    /// The size of a clip coordinate is no less than its magnitude at any corner, and none where one is no number.
    []
    fn sizes_are_the_largest(low: u32, high: u32, at: usize = 0..=7) {
        let (low, high) = (f32::from_bits(low), f32::from_bits(high));
        let found = Corners::new([-1.0, 1.0, 1.0, 0.5], [low, -3.0, 1.0], [high, 2.0, 7.0]);
        assert!(!found.size.is_finite() || found.values[at].abs() <= found.size);
        cover!(found.size == 1000.0);
    }

    /// The same to the right.
    []
    fn right_cut_keeps_signs(inside: [u32; 2], outside: [u32; 2]) {
        keeps_sign_of_w(Plane::Right(31.066_668), inside, outside);
    }

    /// The cut is finite: at the largest components. Products, sums and quotients grow with the magnitudes of
    /// the components, so no smaller ones make a larger cut.
    []
    fn cut_of_the_largest_is_finite(z: [u32; 2]) {
        if let Some(cut) = near(z, [f32::MAX; 2]) {
            assert!(cut.is_finite());
            cover!(cut == f32::MAX);
        }
    }

    /// The cut lies between the ends: at a quarter of the edge, for all finite components.
    []
    fn cut_is_between_the_ends(x: [u32; 2]) {
        let [a, b] = x.map(f32::from_bits);
        assume!(a.is_finite() && b.is_finite());
        let [inside, outside] = [1.0_f32, -3.0].map(f32::to_bits);
        let Some(cut) = near([inside, outside], [a, b]) else { unreachable!("it crosses the plane") };
        assert!(a.min(b) <= cut && cut <= a.max(b));
        cover!(a < cut && cut < b);
    }

    /// Weights are not negative: an inner end that the exact distance puts outside, as k w was rounded, is the
    /// cut itself.
    []
    fn rounded_end_is_the_cut(y: u32) {
        let y = f32::from_bits(y);
        assume!(y.is_finite());
        let w = 1.0 + 2500.0 * f32::EPSILON;
        let plane = Plane::Left(-w);
        // -w w, rounded away from 0, is before the exact plane.
        let (inner, outer) = ([-w * w, y, 0.0, w], [-2.0 * w, 0.0, 0.0, w]);
        assert!(!plane.excludes(inner) && plane.excludes(outer));
        assert!(plane.cut(inner, outer) == inner);
        cover!(y == 3.0);
    }

    /// A triangle is emitted as it is, one without area is not.
    []
    fn triangles_stay(places: [i32; 6] = [-2; 6]..=[2; 6]) {
        let [ax, ay, bx, by, cx, cy] = places;
        is_cut_into_triangles([[ax, ay], [bx, by], [cx, cy]]);
    }

    /// A quadrangle is cut into two triangles at most.
    []
    fn quadrangles_are_cut(places: [i32; 8] = [-16; 8]..=[16; 8]) {
        let [ax, ay, bx, by, cx, cy, dx, dy] = places;
        is_cut_into_triangles([[ax, ay], [bx, by], [cx, cy], [dx, dy]]);
    }

    /// The winding of a quadrangle is the way that most of its corners turn, three at least: two and two
    /// where it crosses itself.
    []
    fn winding_is_that_of_most_corners(places: [i32; 8] = [0; 8]..=[3; 8]) {
        let [ax, ay, bx, by, cx, cy, dx, dy] = places;
        let (a, b, c, d) = ([ax, ay], [bx, by], [cx, cy], [dx, dy]);
        let Some(polygon) = polygon::<Small, 4>([a, b, c, d]) else { return };
        let turns = [area([d, a, b]), area([a, b, c]), area([b, c, d]), area([c, d, a])];
        assume!(turns.iter().all(|&turn| turn != 0));
        let clockwise = turns.iter().filter(|&&turn| turn > 0).count();
        let found = winding(&polygon);
        assert!(clockwise < 3 || found == Ordering::Greater);
        assert!(clockwise > 1 || found == Ordering::Less);
        cover!(clockwise == 3);
        cover!(clockwise == 0);
    }

    /// Of a quadrangle no flat corner is left.
    []
    fn flat_corners_are_removed(places: [i32; 8] = [0; 8]..=[1; 8]) {
        let [ax, ay, bx, by, cx, cy, dx, dy] = places;
        let Some(mut polygon) = polygon::<Small, 4>([[ax, ay], [bx, by], [cx, cy], [dx, dy]]) else { return };
        remove_flat(&mut polygon);
        let left = polygon.vertices().len();
        for at in 0..4 {
            assert!(at >= left || turn(corner(&polygon, at)) != Ordering::Equal);
        }
        cover!(left == 3);
        cover!(left == 0);
    }

    /// What the frustum has lies in the viewport's columns, ends included, where w is 1. In the standard
    /// format.
    []
    fn frustum_projects_into_the_columns(x: u32, columns: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET; 2]) {
        stays_in_the_columns::<Standard>(x, columns);
    }

    /// The same for the rows.
    []
    fn frustum_projects_into_the_rows(y: u32, rows: [u32; 2] = [0; 2]..=[Standard::MAX_TARGET; 2]) {
        stays_in_the_rows::<Standard>(y, rows);
    }
}
