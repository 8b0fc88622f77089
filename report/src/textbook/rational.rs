//! The exact depth, as a fraction of 128-bit integers at every pixel.

use halfplane::{Standard, Triangle};
use halfplane_reference::{ExactPlane, Grid};

use super::{Plane, pixels};

/// [`ExactPlane`], rounded to the nearest `u32`, ties up.
#[derive(Clone, Copy, Debug)]
pub struct ExactRational(Option<ExactPlane>);

impl Plane for ExactRational {
    type Depth = u32;
    const NAME: &'static str = "exact rational";
    const FAR: u32 = u32::MAX;

    fn new(triangle: &Triangle<Standard>) -> Self {
        Self(exact_plane(triangle))
    }

    #[inline]
    fn block(&self, x: u32, y: u32) -> [u32; 16] {
        let mut depths = [u32::MAX; 16];
        if let Some(plane) = &self.0 {
            for (lane, x, y) in pixels(x, y) {
                let depth = plane.at(x, y);
                let nearest =
                    (2 * depth.numerator() + depth.denominator()).div_euclid(2 * depth.denominator());
                depths[lane] = nearest.clamp(0, i128::from(u32::MAX)) as u32;
            }
        }
        depths
    }

    fn units(depth: u32) -> f64 {
        f64::from(depth)
    }
}

/// The exact plane of a triangle of the standard format, sampled at pixel centres.
#[must_use]
pub(crate) fn exact_plane(triangle: &Triangle<Standard>) -> Option<ExactPlane> {
    let vertices = triangle.vertices();
    let grid = Grid::new(8, (128, 128)).ok()?;
    ExactPlane::new(&vertices.map(|v| [v.x(), v.y()]), &vertices.map(|v| v.z()), grid)
}
