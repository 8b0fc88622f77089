//! What a sphere can cover at most.

use super::{Linear, confirmed, dot, ends_of_sphere};
use crate::{
    geometry::{Region, Sample},
    numbers::{Standard, unorm32},
    proof::{cover, prove},
    transform::{Bound, Viewport},
};

/// The matrix that moves object space.
fn moved(x: f32, y: f32, z: f32) -> [[f32; 4]; 4] {
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [x, y, z, 1.0]]
}

/// The matrix of an eye that looks along z.
const CAMERA: [[f32; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, -0.5, 0.0]];

/// A coordinate that is w, where it is.
const W: Linear = Linear { value: 4.0, slope: [0.5, 1.0, -2.0], size: 8.0 };

prove! {
    /// A sum of products is that of whole numbers.
    [dot]
    fn products_of_whole_numbers_are_exact(a: [i32; 3]) {
        let [x, y, z] = a.map(i64::from);
        assert!(dot(a.map(f64::from), [3.0, -5.0, 7.0]) == (3 * x - 5 * y + 7 * z) as f64);
        cover!(x < 0 && y > 0);
    }

    /// A clip coordinate over a sphere: its value in the middle, its slope, and a size that is no less than its
    /// magnitude anywhere. For whole numbers.
    [Linear::new]
    fn coordinates_over_spheres_are_exact(center: [i32; 3] = [-100; 3]..=[100; 3], radius: i32 = 0..=100) {
        let [x, y, z] = center;
        let found = Linear::new([2.0, -3.0, 1.0, 5.0], center.map(|v| v as f32), radius as f32);
        let value = 2 * x - 3 * y + z + 5;
        assert!(found.value == f64::from(value));
        assert!(found.slope == [2 * radius, -3 * radius, radius].map(f64::from));
        assert!(f64::from(value.abs() + 6 * radius) <= found.size);
        cover!(value.abs() + 6 * radius == 500);
    }

    /// What is confirmed as the most of v . u / (1 + b . u) is no less than that, wherever u is along an axis.
    [confirmed]
    fn what_is_confirmed_is_the_most(t: i32 = 0..=7, v: [i32; 3] = [-3; 3]..=[3; 3]) {
        let (v, b) = (v.map(f64::from), [0.5, 0.0, -0.25]);
        let most = confirmed(f64::from(t), v, b);
        assert!(most >= f64::from(t));
        for axis in 0..3 {
            assert!(v[axis] <= most * (1.0 + b[axis]) && -v[axis] <= most * (1.0 - b[axis]));
        }
        cover!(t == 3 && v == [2.0, 3.0, 0.0] && most < 4.0);
        cover!(most == f64::INFINITY);
    }

    /// The ends hold the quotients in the middle and where the sphere is furthest along each axis.
    [Linear::quotients, confirmed, dot]
    fn quotients_of_spheres_lie_between_the_ends(value: i32 = -8..=7) {
        let x = Linear { value: f64::from(value), slope: [1.0, -2.0, 0.5], size: 16.0 };
        let [low, high] = x.quotients(W, 1.5).map(f64::from);
        for axis in 0..3 {
            for side in [-1.0, 0.0, 1.0] {
                let (x, w) = (x.value + side * x.slope[axis], W.value + side * W.slope[axis]);
                assert!(low * w <= x && x <= high * w);
            }
        }
        cover!(low > 0.0 && high < 4.0);
    }

    /// A sphere that reaches the eye's plane has no ends; others hold their middles, and in front and behind.
    [ends_of_sphere, Linear::new, Linear::quotients]
    fn spheres_with_ends_are_before_the_eye(z: i32 = -8..=7, radius: i32 = 0..=7) {
        let ends = ends_of_sphere(&CAMERA, [1.0, -2.0, z as f32], radius as f32);
        assert!(ends.is_some() == (z > radius));
        if let Some([[left, right], [bottom, top], _]) = ends {
            for w in [z - radius, z, z + radius].map(f64::from) {
                assert!(f64::from(left) * w <= 1.0 && 1.0 <= f64::from(right) * w);
                assert!(f64::from(bottom) * w <= -2.0 && -2.0 <= f64::from(top) * w);
            }
        }
        cover!(ends.is_some() && radius == 5);
    }

    /// A sphere of which a coordinate is no number, or that has a radius below 0 or none, can cover anything.
    [Viewport::bound_sphere]
    fn spheres_without_numbers_cover_anything(radius: u32) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let (viewport, radius) = (Viewport::new(region), f32::from_bits(radius));
        let bound = viewport.bound_sphere(&moved(0.0, 0.0, 0.0), [0.0; 3], radius, Sample::CENTER);
        assert!(radius >= 0.0 && radius < f32::INFINITY || bound == Bound::Anything);
        cover!(bound != Bound::Anything);
    }

    /// Depths in the sphere are between those of the bound, wherever it is moved to, by steps of 1/64.
    [Viewport::bound_sphere, Viewport::bound, ends_of_sphere, ends_of_box, Linear::new, Linear::quotients, confirmed]
    fn a_moved_sphere_has_no_other_depths(steps: i32 = -32..=31) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let (viewport, z) = (Viewport::new(region), steps as f32 / 64.0);
        let bound = viewport.bound_sphere(&moved(0.0, 0.0, z), [0.0, 0.0, 0.5], 0.25, Sample::CENTER);
        let Bound::Within { depths: [least, most], .. } = bound else { unreachable!("it is in the viewport") };
        assert!(least <= unorm32(0.25 + z) && unorm32(0.75 + z) <= most);
        cover!(least > 0 && most < u32::MAX);
    }
}
