//! The built-in scene: an evening at a lake, seen from a ruined arcade.
//!
//! It is made so that every part of a rasterizer has work: a lake of two triangles that reaches behind
//! the camera, a floor that crosses the near plane, tens of thousands of triangles of a few pixels or
//! none, long slivers in the flutes of the columns, and walls before all of it. It is the same to the
//! last bit on every machine.

mod build;
mod land;
mod masonry;
mod noise;
mod temple;
mod terrace;

use glam::DVec3;

use crate::camera::{Lens, Named};
use crate::mesh::{Finish, Mesh, Surface};

use build::{Builder, Frame};

/// What reports call it.
pub const NAME: &str = "the built-in scene";

/// The camera that is used when none is asked for.
pub const CAMERA: &str = "terrace";

/// From the scene towards the sun; not of length 1.
pub const SUN: DVec3 = DVec3::new(-0.80, 0.33, -0.50);

/// Surfaces, by their number in [`PALETTE`].
mod paint {
    pub(super) const WATER: u8 = 0;
    pub(super) const MARBLE: u8 = 1;
    pub(super) const MARBLE_WORN: u8 = 2;
    pub(super) const SANDSTONE: u8 = 3;
    pub(super) const SANDSTONE_DARK: u8 = 4;
    pub(super) const TILE_LIGHT: u8 = 5;
    pub(super) const TILE_DARK: u8 = 6;
    pub(super) const ROOF: u8 = 7;
    pub(super) const ROOF_OLD: u8 = 8;
    pub(super) const GRASS: u8 = 9;
    pub(super) const GRASS_DRY: u8 = 10;
    pub(super) const WOOD: u8 = 11;
    pub(super) const ROCK: u8 = 12;
    pub(super) const ROCK_DARK: u8 = 13;
    pub(super) const SNOW: u8 = 14;
    pub(super) const SAND: u8 = 15;
    pub(super) const CYPRESS: u8 = 16;
    pub(super) const CYPRESS_LIGHT: u8 = 17;
    pub(super) const PLASTER: u8 = 18;
    pub(super) const WINDOW: u8 = 19;
    pub(super) const SAIL: u8 = 20;
}

const fn matte(red: f32, green: f32, blue: f32) -> Surface {
    Surface { colour: [red, green, blue], finish: Finish::Matte }
}

/// Linear colours, in the order of [`paint`].
const PALETTE: [Surface; 21] = [
    Surface { colour: [0.012, 0.05, 0.07], finish: Finish::Water },
    matte(0.80, 0.74, 0.64),
    matte(0.66, 0.60, 0.51),
    matte(0.58, 0.44, 0.30),
    matte(0.46, 0.34, 0.23),
    matte(0.56, 0.48, 0.38),
    matte(0.30, 0.17, 0.12),
    matte(0.50, 0.17, 0.08),
    matte(0.40, 0.15, 0.09),
    matte(0.10, 0.16, 0.04),
    matte(0.22, 0.21, 0.07),
    matte(0.05, 0.10, 0.035),
    matte(0.30, 0.26, 0.23),
    matte(0.20, 0.18, 0.17),
    matte(0.85, 0.87, 0.92),
    matte(0.50, 0.42, 0.28),
    matte(0.025, 0.06, 0.025),
    matte(0.04, 0.085, 0.03),
    matte(0.70, 0.60, 0.46),
    Surface { colour: [1.0, 0.62, 0.22], finish: Finish::Glow },
    matte(0.85, 0.80, 0.70),
];

/// Builds the scene.
#[must_use]
pub fn evening() -> Mesh {
    let mut builder = Builder::new();
    let scene = &mut builder;
    land::lake(scene);
    land::mountains(scene);
    land::island(scene);
    temple::temple(scene, Frame::new(DVec3::new(27.0, land::ISLAND_TOP, 104.0), (4.0, -3.0)));
    masonry::bridge(scene, DVec3::new(62.0, 0.0, 118.0), DVec3::new(250.0, 0.0, 236.0));
    land::village(scene);
    land::woods(scene);
    land::boats(scene);
    terrace::terrace(scene);
    Mesh { surfaces: PALETTE.to_vec(), ..builder.finish() }
}

/// The scene's cameras; the first is [`CAMERA`].
#[must_use]
pub fn cameras() -> Vec<Named> {
    let camera = |name: &str, eye: DVec3, target: DVec3, fov: f64, near: f64| Named {
        name: name.to_owned(),
        eye: Some(eye),
        forward: Some(target - eye),
        up: Some(DVec3::Y),
        lens: Some(Lens { fov, near, far: 9000.0 }),
        matrices: Vec::new(),
    };
    vec![
        camera(CAMERA, DVec3::new(1.5, 9.4, -0.5), DVec3::new(10.0, 7.4, 60.0), 0.80, 0.25),
        camera("temple", DVec3::new(14.0, 12.0, 60.0), DVec3::new(27.0, 11.5, 104.0), 0.80, 0.25),
        camera("aerial", DVec3::new(-12.0, 62.0, -62.0), DVec3::new(30.0, 6.0, 125.0), 0.66, 1.0),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// FNV-1a over the bits of every position and index: a change here changes every picture.
    fn fingerprint(mesh: &Mesh) -> u64 {
        let words = mesh.positions.iter().flatten().map(|c| c.to_bits());
        words
            .chain(mesh.indices.iter().copied())
            .fold(0xcbf2_9ce4_8422_2325, |hash, word| (hash ^ u64::from(word)).wrapping_mul(0x100_0000_01b3))
    }

    #[test]
    fn the_scene_is_whole_and_the_same_everywhere() {
        let mesh = evening();
        assert!(mesh.positions.iter().flatten().all(|c| c.is_finite()));
        assert!(mesh.indices.iter().all(|&i| (i as usize) < mesh.positions.len()));
        assert_eq!(mesh.surface_of.len(), mesh.triangles());
        assert!(mesh.surface_of.iter().all(|&s| usize::from(s) < mesh.surfaces.len()));
        assert!((100_000..200_000).contains(&mesh.triangles()), "{}", mesh.triangles());
        assert_eq!(fingerprint(&mesh), FINGERPRINT, "{:#x}", fingerprint(&mesh));
    }

    const FINGERPRINT: u64 = 0x4fbf_08f6_14aa_553c;
}
