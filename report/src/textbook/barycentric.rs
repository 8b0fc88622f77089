//! Weights of the corners at each pixel, in `f32`.

use halfplane::{Standard, Triangle};

use super::{Plane, UNIT_SCALE, corners32, pixels};

/// z0 + w1 (z1 - z0) + w2 (z2 - z0), with w1 and w2 from two cross products over the area, all in `f32`;
/// stored as `f32`, 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Barycentric32 {
    corners: [[f32; 3]; 3],
    inverse_area: f32,
}

impl Plane for Barycentric32 {
    type Depth = f32;
    const NAME: &'static str = "f32 barycentric";
    const FAR: f32 = 1.0;

    fn new(triangle: &Triangle<Standard>) -> Self {
        let corners @ [a, b, c] = corners32(triangle);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        Self { corners, inverse_area: 1.0 / area }
    }

    #[inline]
    fn block(&self, x: u32, y: u32) -> [f32; 16] {
        let [a, b, c] = self.corners;
        let mut depths = [0.0; 16];
        for (lane, x, y) in pixels(x, y) {
            let (px, py) = (x as f32 + 0.5 - a[0], y as f32 + 0.5 - a[1]);
            let second = (px * (c[1] - a[1]) - (c[0] - a[0]) * py) * self.inverse_area;
            let third = ((b[0] - a[0]) * py - px * (b[1] - a[1])) * self.inverse_area;
            depths[lane] = (a[2] + second * (b[2] - a[2]) + third * (c[2] - a[2])).clamp(0.0, 1.0);
        }
        depths
    }

    fn units(depth: f32) -> f64 {
        f64::from(depth) * UNIT_SCALE
    }
}
