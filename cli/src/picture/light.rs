//! Light and air: what falls on a surface, what the sky is, what distance does to colours.
//!
//! All of it is made of additions, multiplications, divisions and square roots in `f64`, so the
//! preview is the same picture on every machine.

use glam::DVec3;

use crate::scene;

/// How a preview is lit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// For any model: light over the viewer's left shoulder, a plain background.
    Studio,
    /// For the built-in scene: a low sun with shadows, a sky, haze, and water that mirrors.
    Evening,
}

/// A look's light for one camera.
#[derive(Debug, Clone, Copy)]
pub(super) struct Light {
    look: Look,
    /// Towards the sun or the lamp.
    pub(super) sun: DVec3,
    /// What is up for the light of the sky.
    up: DVec3,
    /// The direction of sight in the middle of the picture.
    forward: DVec3,
    /// Distances between which the studio's air thickens.
    range: (f64, f64),
}

impl Light {
    pub(super) fn new(look: Look, [right, up, forward]: [DVec3; 3], range: (f64, f64)) -> Self {
        match look {
            Look::Studio => {
                let sun = (up * 0.8 - right * 0.55 - forward * 0.75).normalize_or(DVec3::Y);
                Self { look, sun, up, forward, range }
            }
            Look::Evening => {
                let sun = scene::SUN.normalize_or(DVec3::Y);
                Self { look, sun, up: DVec3::Y, forward, range }
            }
        }
    }

    /// The background in a direction.
    pub(super) fn sky(&self, towards: DVec3) -> DVec3 {
        let height = towards.dot(self.up);
        match self.look {
            Look::Studio => {
                let tilt = height - self.forward.dot(self.up);
                let t = (0.5 + 0.9 * tilt).clamp(0.0, 1.0);
                DVec3::new(0.16, 0.19, 0.23).lerp(DVec3::new(0.42, 0.50, 0.60), t)
            }
            Look::Evening => {
                let t = height.max(0.0);
                let low = DVec3::new(0.98, 0.50, 0.26);
                let middle = DVec3::new(0.60, 0.44, 0.50);
                let high = DVec3::new(0.10, 0.18, 0.40);
                let sky = low.lerp(middle, ramp(0.0, 0.34, t)).lerp(high, ramp(0.12, 0.72, t));
                // Warmer towards the side where the sun is.
                let side = (towards.dot(self.sun) * 0.5 + 0.5).max(0.0);
                let glow = side * side * side;
                sky + DVec3::new(0.75, 0.34, 0.10) * glow * (1.0 - ramp(0.0, 0.5, t))
            }
        }
    }

    /// Light that reaches a surface; `open` is how much of the sun is not in shadow.
    pub(super) fn on(&self, normal: DVec3, open: f64) -> DVec3 {
        let direct = normal.dot(self.sun).max(0.0) * open;
        let above = normal.dot(self.up) * 0.5 + 0.5;
        match self.look {
            Look::Studio => {
                let sky = DVec3::new(0.16, 0.15, 0.15).lerp(DVec3::new(0.42, 0.46, 0.52), above);
                DVec3::new(1.45, 1.36, 1.22) * direct + sky
            }
            Look::Evening => {
                let sky = DVec3::new(0.20, 0.13, 0.11).lerp(DVec3::new(0.26, 0.32, 0.50), above);
                DVec3::new(3.1, 1.75, 0.85) * direct + sky
            }
        }
    }

    /// A colour seen through `distance` of air.
    pub(super) fn through_air(&self, colour: DVec3, towards: DVec3, distance: f64) -> DVec3 {
        match self.look {
            Look::Studio => {
                let (near, far) = self.range;
                let t = if far > near { ((distance - near) / (far - near)).clamp(0.0, 1.0) } else { 0.0 };
                colour.lerp(self.sky(towards), 0.45 * t * t)
            }
            Look::Evening => {
                let thickness = distance / 2600.0;
                let haze = thickness / (1.0 + thickness);
                let flat = DVec3::new(towards.x, 0.045, towards.z).normalize_or(towards);
                colour.lerp(self.sky(flat) * DVec3::new(0.80, 0.82, 0.95), haze)
            }
        }
    }
}

/// From linear light to the byte of a screen: brightness rolled off, then a gamma of 2.
pub(super) fn to_byte(light: f64) -> u8 {
    let light = light.max(0.0);
    // Straight up to about a half, then ever flatter towards 1.
    let rolled = light * (1.0 + 0.16 * light) / (1.0 + 0.62 * light * light.sqrt());
    (rolled.min(1.0).sqrt() * 255.0 + 0.5) as u8
}

/// 0 below `low`, 1 above `high`, smooth between.
fn ramp(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
