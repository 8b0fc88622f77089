//! A plane by its two gradients, set up once for each triangle.

use halfplane::{Standard, Triangle};
use num_traits::Float;

use super::{Plane, UNIT_SCALE, corners32, pixels};

/// z0 + dz/dx (x - x0) + dz/dy (y - y0).
#[derive(Clone, Copy, Debug)]
pub struct Gradient<T> {
    origin: [T; 3],
    slope: [T; 2],
}

/// All in `f32`; stored as `f32`, 0 to 1.
pub type Gradient32 = Gradient<f32>;
/// The same in `f64`, in units of 2^-32, stored as the nearest `u32`.
pub type Gradient64 = Gradient<f64>;

impl<T: Float> Gradient<T> {
    /// Through three corners: x and y in pixels, z.
    fn through([a, b, c]: [[T; 3]; 3]) -> Self {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let (second, third) = (b[2] - a[2], c[2] - a[2]);
        let x = (second * (c[1] - a[1]) - third * (b[1] - a[1])) / area;
        let y = (third * (b[0] - a[0]) - second * (c[0] - a[0])) / area;
        Self { origin: a, slope: [x, y] }
    }

    /// The depth at a place in pixels.
    #[inline(always)]
    fn at(&self, x: T, y: T) -> T {
        let Self { origin: [ax, ay, az], slope } = *self;
        az + slope[0] * (x - ax) + slope[1] * (y - ay)
    }
}

impl Plane for Gradient32 {
    type Depth = f32;
    const NAME: &'static str = "f32 gradient";
    const FAR: f32 = 1.0;

    fn new(triangle: &Triangle<Standard>) -> Self {
        Self::through(corners32(triangle))
    }

    #[inline]
    fn block(&self, x: u32, y: u32) -> [f32; 16] {
        let mut depths = [0.0; 16];
        for (lane, x, y) in pixels(x, y) {
            depths[lane] = self.at(x as f32 + 0.5, y as f32 + 0.5).clamp(0.0, 1.0);
        }
        depths
    }

    fn units(depth: f32) -> f64 {
        f64::from(depth) * UNIT_SCALE
    }
}

impl Plane for Gradient64 {
    type Depth = u32;
    const NAME: &'static str = "f64 gradient";
    const FAR: u32 = u32::MAX;

    fn new(triangle: &Triangle<Standard>) -> Self {
        Self::through(
            triangle
                .vertices()
                .map(|v| [f64::from(v.x()) / 256.0, f64::from(v.y()) / 256.0, f64::from(v.z())]),
        )
    }

    #[inline]
    fn block(&self, x: u32, y: u32) -> [u32; 16] {
        let mut depths = [0; 16];
        for (lane, x, y) in pixels(x, y) {
            // The cast keeps it in the range.
            depths[lane] = (self.at(f64::from(x) + 0.5, f64::from(y) + 0.5) + 0.5) as u32;
        }
        depths
    }

    fn units(depth: u32) -> f64 {
        f64::from(depth)
    }
}
