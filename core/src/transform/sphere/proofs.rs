//! What a sphere can cover at most.

use super::{Linear, confirmed, dot, ends_of_sphere};
use crate::{
    geometry::{Region, Sample},
    numbers::{Standard, unorm32},
    proof::{cover, prove, which},
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
    fn products_of_whole_numbers_are_exact(x: i32 = -64..=63) {
        assert!(dot([f64::from(x), 4.0, -2.0], [3.0, -5.0, 7.0]) == f64::from(3 * x - 34));
        assert!(dot([4.0, f64::from(x), -2.0], [3.0, -5.0, 7.0]) == f64::from(-5 * x - 2));
        assert!(dot([4.0, -2.0, f64::from(x)], [3.0, -5.0, 7.0]) == f64::from(7 * x + 22));
        cover!(x < 0);
    }

    /// A clip coordinate over a sphere: its value in the middle, its slope, and its size, the magnitudes of its terms
    /// where each is the largest. For whole numbers.
    [Linear::new]
    fn coordinates_over_spheres_are_exact(x: i32 = -8..=7, radius: i32 = 0..=7) {
        let found = Linear::new([2.0, -3.0, 1.0, 5.0], [x as f32, 4.0, -2.0], radius as f32);
        let value = 2 * x - 9;
        assert!(found.value == f64::from(value));
        assert!(found.slope == [2 * radius, -3 * radius, radius].map(f64::from));
        assert!(found.size == f64::from(2 * (x.abs() + radius) + 3 * (4 + radius) + (2 + radius) + 5));
        cover!(x == -3 && radius == 5);
    }

    /// What is confirmed as the most of v . u / (1 + b . u) is no less than that, wherever u is along an axis, or between
    /// the first two.
    [confirmed]
    fn slow_what_is_confirmed_is_the_most(t: i32 = 0..=7, v: [i32; 3] = [-3; 3]..=[3; 3]) {
        let (v, b) = (v.map(f64::from), [0.5, 0.0, -0.25]);
        let most = confirmed(f64::from(t), v, b);
        assert!(most >= f64::from(t));
        for axis in 0..3 {
            assert!(v[axis] <= most * (1.0 + b[axis]) && -v[axis] <= most * (1.0 - b[axis]));
        }
        for [p, q] in [[0.6, 0.8], [0.8, 0.6]] {
            assert!(p * v[0] + q * v[1] <= most * (1.0 + p * b[0] + q * b[1]));
        }
        cover!(t == 4 && v == [2.0, 3.0, 0.0] && most < 5.0);
        cover!(most == f64::INFINITY);
    }

    /// The ends hold the quotients in the middle and where the sphere is furthest along each axis.
    [Linear::quotients, confirmed, dot]
    fn quotients_of_spheres_lie_between_the_ends(value: u32 = 0..=15) {
        let found = which(16, |value| {
            let x = Linear { value: f64::from(value - 4), slope: [1.0, -2.0, 0.5], size: 16.0 };
            let [low, high] = x.quotients(W, 1.5).map(f64::from);
            let mut holds = high - low < 8.0;
            for side in [-1.0, 0.0, 1.0] {
                for axis in 0..3 {
                    let (x, w) = (x.value + side * x.slope[axis], W.value + side * W.slope[axis]);
                    holds &= low * w <= x && x <= high * w;
                }
            }
            holds
        });
        assert!(found >> value & 1 == 1);
        cover!(value == 7);
    }

    /// A sphere that reaches the eye's plane has no ends; others hold their middles, and in front and behind.
    [ends_of_sphere, Linear::new, Linear::quotients]
    fn spheres_with_ends_are_before_the_eye(number: u32 = 0..=31) {
        let found = which(32, |number| {
            let (z, radius) = (number / 4 - 2, number % 4);
            let ends = ends_of_sphere(&CAMERA, [1.0, -2.0, z as f32], radius as f32);
            let mut holds = ends.is_some() == (z > radius);
            if let Some([[left, right], [bottom, top], _]) = ends {
                for w in [z - radius, z, z + radius].map(f64::from) {
                    holds &= f64::from(left) * w <= 1.0 && 1.0 <= f64::from(right) * w;
                    holds &= f64::from(bottom) * w <= -2.0 && -2.0 <= f64::from(top) * w;
                }
            }
            holds
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 31);
    }

    /// A sphere whose radius is below 0, infinite or no number can cover anything.
    [Viewport::bound_sphere]
    fn spheres_without_radius_cover_anything(number: usize = 0..=4) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let found = [-1.0, -f32::MIN_POSITIVE, f32::NEG_INFINITY, f32::INFINITY, f32::NAN].map(|radius| {
            Viewport::new(region).bound_sphere(&moved(0.0, 0.0, 0.0), [0.0; 3], radius, Sample::CENTER)
        });
        assert!(found[number] == Bound::Anything);
        cover!(number == 4);
    }

    /// Depths in the sphere are between those of the bound, wherever it is moved to, by steps of 1/8.
    [Viewport::bound_sphere, Viewport::bound, ends_of_sphere, ends_of_box, Linear::new, Linear::quotients, confirmed]
    fn a_moved_sphere_has_no_other_depths(steps: i32 = -4..=3) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let viewport = Viewport::new(region);
        for known in -4..=3 {
            let z = known as f32 / 8.0;
            let found = viewport.bound_sphere(&moved(0.0, 0.0, z), [0.0, 0.0, 0.5], 0.25, Sample::CENTER);
            let holds = match found {
                Bound::Within { depths: [least, most], .. } => {
                    least <= unorm32(0.25 + z) && unorm32(0.75 + z) <= most && (known != 0 || most < 3 << 30 | 1 << 28)
                }
                Bound::Nothing | Bound::Anything => false,
            };
            assert!(known != steps || holds);
        }
        cover!(steps == 0);
    }
}
