//! The lake, the land round it, and what stands there: island, mountains, village, woods, boats.

use glam::DVec3;

use super::build::{Builder, Frame};
use super::noise::{hills, ridges, smooth, unit};
use super::paint;

/// The height of the ground under the temple.
pub(super) const ISLAND_TOP: f64 = 6.2;

/// The middle of the island and its reach along x and z.
const ISLAND: (DVec3, f64, f64) = (DVec3::new(27.0, 0.0, 104.0), 44.0, 34.0);

/// How far the land reaches to the sides, as a part of how far it is away.
const FAN: f64 = 1.6;

/// Two triangles of eighteen kilometres: in front of the camera, under it and behind it.
pub(super) fn lake(scene: &mut Builder) {
    let far = 9000.0;
    let p = |x: f64, z: f64| DVec3::new(x, 0.0, z);
    scene.quad([p(-far, -far), p(-far, far), p(far, far), p(far, -far)], paint::WATER);
}

/// The height of the land round the lake; negative under water.
fn land(x: f64, z: f64) -> f64 {
    let distance = (x * x + z * z).sqrt();
    // A valley leads away from the camera, a little to the right; the lake fills its floor.
    let bend = 0.16 * z + 40.0 * hills(z / 420.0, 3.7, 2, 11);
    let side = (x - bend).abs() / (150.0 + 0.26 * z.max(0.0));
    let shore = smooth(0.72, 2.3, side).max(smooth(900.0, 2300.0, z));
    let steep = 55.0 + 620.0 * smooth(350.0, 3600.0, distance);
    let crests = ridges(x / 1250.0 + 1.3, z / 1250.0, 6, 21);
    let rough = hills(x / 90.0, z / 90.0, 4, 31);
    let rise = shore * steep * (0.12 + 1.3 * crests * crests) + shore * 12.0 * rough;
    -7.0 + rise + 3.0 * rough + 9.0 * smooth(0.55, 1.0, side)
}

/// Mountains on three sides: a fan of rows, each farther than the one before by the same factor, so
/// that the triangles shrink to a few pixels and, behind the crests, to none.
pub(super) fn mountains(scene: &mut Builder) {
    let (columns, rows) = (200, 150);
    let point = |i: u32, j: u32| {
        let across = f64::from(i) / f64::from(columns) * 2.0 - 1.0;
        let distance = 118.0 * power(1.0245, j);
        let (x, z) = (across * FAN * distance, distance);
        let jitter = distance * 0.006;
        let (a, b) = (unit(i as i32, j as i32, 41) - 0.5, unit(i as i32, j as i32, 42) - 0.5);
        let (x, z) = (x + a * jitter, z + b * jitter);
        DVec3::new(x, land(x, z), z)
    };
    scene.sheet((columns, rows), point, ground);
}

fn power(base: f64, exponent: u32) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * base)
}

/// What grows on a piece of ground, by its height and steepness.
fn ground(corners: [DVec3; 3]) -> u8 {
    let [a, b, c] = corners;
    let normal = (b - a).cross(c - a);
    let flat = normal.y / normal.length().max(1e-9);
    let middle = (a + b + c) / 3.0;
    let speckle = unit((middle.x * 3.0) as i32, (middle.z * 3.0) as i32, 51);
    let snow = 310.0 + 90.0 * hills(middle.x / 150.0, middle.z / 150.0, 3, 52);
    if middle.y > snow && flat > 0.52 {
        paint::SNOW
    } else if flat < 0.66 || middle.y > 230.0 + 60.0 * speckle {
        if speckle < 0.5 { paint::ROCK } else { paint::ROCK_DARK }
    } else if middle.y < 1.6 {
        paint::SAND
    } else if hills(middle.x / 60.0, middle.z / 60.0, 3, 53) > 0.08 {
        paint::WOOD
    } else if speckle < 0.6 {
        paint::GRASS
    } else {
        paint::GRASS_DRY
    }
}

/// The height of the island.
fn mound(x: f64, z: f64) -> f64 {
    let (middle, reach_x, reach_z) = ISLAND;
    let (dx, dz) = ((x - middle.x) / reach_x, (z - middle.z) / reach_z);
    let distance = (dx * dx + dz * dz).sqrt();
    let rough = hills(x / 9.0, z / 9.0, 4, 61);
    let slope = smooth(1.12, 0.52, distance + 0.13 * rough);
    -2.5 + (ISLAND_TOP + 2.45) * slope + 0.5 * rough * slope * (1.0 - slope) * 4.0
}

pub(super) fn island(scene: &mut Builder) {
    let (middle, reach_x, reach_z) = ISLAND;
    let cells = 84;
    let point = |i: u32, j: u32| {
        let at = |k: u32, reach: f64| (f64::from(k) / f64::from(cells) * 2.0 - 1.0) * reach * 1.3;
        let (x, z) = (middle.x + at(i, reach_x), middle.z + at(j, reach_z));
        DVec3::new(x, mound(x, z), z)
    };
    scene.sheet((cells, cells), point, |corners| {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
        let speckle = unit((a.x * 7.0) as i32, (a.z * 7.0) as i32, 62);
        match () {
            () if normal.y < 0.78 => paint::ROCK,
            () if a.y < 0.7 => paint::SAND,
            () if speckle < 0.72 => paint::GRASS,
            () => paint::GRASS_DRY,
        }
    });
    for k in 0..220 {
        let (dx, dz) = (unit(k, 0, 63) * 2.0 - 1.0, unit(k, 1, 63) * 2.0 - 1.0);
        let (x, z) = (middle.x + dx * reach_x, middle.z + dz * reach_z);
        let y = mound(x, z);
        // Not in the water and not in the temple.
        let clear = dx * dx + dz * dz > 0.42 && dx * dx + dz * dz < 0.86;
        if clear && y > 0.9 {
            let height = 4.0 + 5.0 * unit(k, 2, 63);
            cypress(scene, DVec3::new(x, y - 0.3, z), height, 10, k);
        }
    }
}

/// A cypress: a slim flame of ragged rings.
pub(super) fn cypress(scene: &mut Builder, base: DVec3, height: f64, sides: u32, seed: i32) {
    let radius = height * (0.095 + 0.04 * unit(seed, 3, 64));
    let rings = 9;
    let profile: Vec<(f64, f64)> = (0..=rings)
        .map(|k| {
            let t = f64::from(k) / f64::from(rings);
            let bulge = 4.0 * t * (1.0 - t) * (1.25 - 0.6 * t);
            let ragged = 0.88 + 0.24 * unit(seed, k, 65);
            (radius * (bulge * ragged + 0.1 * (1.0 - t)) + 0.01, height * t)
        })
        .collect();
    let paint = if unit(seed, 4, 64) < 0.6 { paint::CYPRESS } else { paint::CYPRESS_LIGHT };
    scene.turned(base, &profile, sides, 0.8, paint);
}

/// Houses with gable roofs and a few lit windows on the shores.
pub(super) fn village(scene: &mut Builder) {
    let mut houses = 0;
    for k in 0..9000 {
        let z = 170.0 + 620.0 * unit(k, 0, 71);
        let x = (unit(k, 1, 71) * 2.0 - 1.0) * (130.0 + 0.7 * z);
        let y = land(x, z);
        let slope = (land(x + 4.0, z) - y).abs() + (land(x, z + 4.0) - y).abs();
        // Close together in a few places.
        let place = hills(x / 130.0, z / 130.0, 2, 72);
        if !(2.0..34.0).contains(&y) || slope > 4.0 || place < 0.16 || x.abs() > FAN * z {
            continue;
        }
        let turn = unit(k, 2, 71) * 2.0 - 1.0;
        scene.at(Frame::new(DVec3::new(x, y - 1.5, z), (1.0, turn)));
        house(scene, k);
        houses += 1;
        if houses == 320 {
            break;
        }
    }
    scene.at(Frame::WORLD);
}

fn house(scene: &mut Builder, seed: i32) {
    let half_x = 3.0 + 2.5 * unit(seed, 0, 73);
    let half_z = 2.6 + 1.2 * unit(seed, 1, 73);
    let (eaves, ridge) = (5.5 + 3.5 * unit(seed, 2, 73), 2.4);
    let walls = DVec3::new(half_x, eaves, half_z);
    scene.block(DVec3::new(-half_x, 0.0, -half_z), walls, paint::PLASTER);
    let out = 0.5;
    let (rx, rz) = (half_x + out, half_z + out);
    let p = |x: f64, y: f64, z: f64| DVec3::new(x, eaves + y, z);
    let roof = if unit(seed, 3, 73) < 0.5 { paint::ROOF } else { paint::ROOF_OLD };
    scene.quad([p(-rx, -0.3, -rz), p(-rx, ridge, 0.0), p(rx, ridge, 0.0), p(rx, -0.3, -rz)], roof);
    scene.quad([p(rx, -0.3, rz), p(rx, ridge, 0.0), p(-rx, ridge, 0.0), p(-rx, -0.3, rz)], roof);
    scene.triangle([p(half_x, 0.0, -half_z), p(half_x, ridge, 0.0), p(half_x, 0.0, half_z)], paint::PLASTER);
    scene.triangle(
        [p(-half_x, 0.0, half_z), p(-half_x, ridge, 0.0), p(-half_x, 0.0, -half_z)],
        paint::PLASTER,
    );
    for window in 0..3 {
        if unit(seed, window, 74) < 0.55 {
            let x = half_x * (f64::from(window) - 1.0) * 0.6;
            let z = -half_z - 0.03;
            let q = |dx: f64, y: f64| DVec3::new(x + dx, eaves - 3.0 + y, z);
            scene.quad([q(-0.5, 0.0), q(-0.5, 1.5), q(0.5, 1.5), q(0.5, 0.0)], paint::WINDOW);
        }
    }
}

/// Trees on the slopes: eight triangles each, most of them a pixel or two.
pub(super) fn woods(scene: &mut Builder) {
    let mut trees = 0;
    for k in 0..40_000 {
        let z = 130.0 + 1100.0 * unit(k, 0, 81) * unit(k, 3, 81);
        let x = (unit(k, 1, 81) * 2.0 - 1.0) * (110.0 + 0.9 * z);
        let y = land(x, z);
        if !(1.8..150.0).contains(&y) || hills(x / 60.0, z / 60.0, 3, 53) < -0.08 || x.abs() > FAN * z {
            continue;
        }
        let height = 5.0 + 9.0 * unit(k, 2, 81);
        let tall = unit(k, 4, 81) < 0.25;
        let radius = height * if tall { 0.13 } else { 0.3 };
        let paint = if unit(k, 5, 81) < 0.5 { paint::CYPRESS } else { paint::WOOD };
        let base = DVec3::new(x, y - 1.0, z);
        scene.turned(base, &[(radius, 0.0), (radius * 0.85, height * 0.4), (0.0, height)], 5, 1.0, paint);
        trees += 1;
        if trees == 1700 {
            break;
        }
    }
}

/// Sailing boats on the lake.
pub(super) fn boats(scene: &mut Builder) {
    for (k, (x, z, turn)) in [(-22.0, 66.0, 0.3), (-64.0, 150.0, -0.4), (4.0, 205.0, 0.5), (78.0, 92.0, -0.2)]
        .into_iter()
        .enumerate()
    {
        scene.at(Frame::new(DVec3::new(x, 0.0, z), (1.0, turn)));
        let p = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let (bow, stern) = (p(4.2, 1.0, 0.0), p(-3.2, 0.8, 0.0));
        let (near, far, keel) = (p(-0.4, 0.7, -1.2), p(-0.4, 0.7, 1.2), p(0.0, -0.4, 0.0));
        for hull in [[keel, near, bow], [stern, near, keel], [bow, far, keel], [keel, far, stern]] {
            scene.triangle(hull, paint::ROOF_OLD);
        }
        scene.quad([stern, far, bow, near], paint::SANDSTONE);
        scene.block(p(0.3, 0.5, -0.07), p(0.44, 9.4, 0.07), paint::ROCK_DARK);
        let belly = if k % 2 == 0 { -0.8 } else { -0.5 };
        // Both sides of a sail show.
        for sail in [
            [p(0.2, 1.6, 0.0), p(0.25, 9.2, 0.0), p(-3.4, 1.7, belly)],
            [p(0.6, 8.2, 0.0), p(0.6, 1.5, 0.0), p(3.9, 1.3, belly * 0.6)],
        ] {
            let [a, b, c] = sail;
            scene.triangle([a, b, c], paint::SAIL);
            scene.triangle([a, c, b], paint::SAIL);
        }
    }
    scene.at(Frame::WORLD);
}
