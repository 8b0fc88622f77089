//! A Doric temple: three steps, a ring of columns, the cella with its door alight, and a tiled roof.

use glam::DVec3;

use super::build::{Builder, Frame};
use super::masonry::column;
use super::paint;

/// Columns at the front and along the sides.
const FRONT: u32 = 6;
const SIDE: u32 = 11;
/// Distance between columns, in metres, and their size.
const SPACING: f64 = 2.9;
const RADIUS: f64 = 0.62;
const HEIGHT: f64 = 6.6;

/// The temple's long side runs along the frame's x axis; it stands on y = 0.
pub(super) fn temple(scene: &mut Builder, frame: Frame) {
    scene.at(frame);
    let length = SPACING * f64::from(SIDE - 1);
    let width = SPACING * f64::from(FRONT - 1);
    let (half_x, half_z) = (length * 0.5, width * 0.5);
    let floor = 1.2;
    for step in 0..3 {
        let (out, y) = (2.4 - 0.6 * f64::from(step), 0.4 * f64::from(step));
        scene.block(
            DVec3::new(-half_x - out, if step == 0 { -4.0 } else { y }, -half_z - out),
            DVec3::new(half_x + out, y + 0.4, half_z + out),
            paint::MARBLE_WORN,
        );
    }
    for i in 0..SIDE {
        for j in 0..FRONT {
            if (1..SIDE - 1).contains(&i) && (1..FRONT - 1).contains(&j) {
                continue;
            }
            let (x, z) = (SPACING * f64::from(i) - half_x, SPACING * f64::from(j) - half_z);
            column(scene, DVec3::new(x, floor, z), HEIGHT, RADIUS, 32, paint::MARBLE);
        }
    }
    cella(scene, half_x - 4.4, half_z - 2.6, floor);
    let top = entablature(scene, half_x + 0.75, half_z + 0.75, floor + HEIGHT);
    roof(scene, half_x + 1.2, half_z + 1.2, top);
    scene.at(Frame::WORLD);
}

/// The room inside, with an open door at each end from which light comes.
fn cella(scene: &mut Builder, half_x: f64, half_z: f64, floor: f64) {
    let top = floor + HEIGHT;
    scene.block(DVec3::new(-half_x, floor, -half_z), DVec3::new(half_x, top, half_z), paint::MARBLE_WORN);
    let (door, lintel) = (1.25, floor + 4.6);
    for (x, sign) in [(-half_x - 0.02, -1.0), (half_x + 0.02, 1.0)] {
        let p = |y: f64, z: f64| DVec3::new(x, y, z * sign);
        scene.quad(
            [p(floor, door), p(lintel, door * 0.9), p(lintel, -door * 0.9), p(floor, -door)],
            paint::WINDOW,
        );
    }
}

/// Architrave, frieze with triglyphs, cornice; returns the height of its top.
fn entablature(scene: &mut Builder, half_x: f64, half_z: f64, base: f64) -> f64 {
    let slab = |scene: &mut Builder, out: f64, low: f64, high: f64, stone: u8| {
        scene.block(
            DVec3::new(-half_x - out, base + low, -half_z - out),
            DVec3::new(half_x + out, base + high, half_z + out),
            stone,
        );
    };
    slab(scene, 0.0, 0.0, 0.85, paint::MARBLE);
    slab(scene, 0.06, 0.85, 0.95, paint::MARBLE_WORN);
    slab(scene, 0.0, 0.95, 1.85, paint::SANDSTONE);
    slab(scene, 0.4, 1.85, 2.15, paint::MARBLE);
    let (low, high) = (base + 0.95, base + 1.85);
    let bar = 0.11;
    for (half, other, across) in [(half_x, half_z, false), (half_z, half_x, true)] {
        let count = (half * 2.0 / (SPACING * 0.5)) as u32;
        for k in 0..=count {
            let middle = -half + half * 2.0 * f64::from(k) / f64::from(count);
            // Three upright bars make a triglyph.
            for offset in [-0.3, 0.0, 0.3] {
                let (a, b) = (middle + offset - bar, middle + offset + bar);
                for (inner, outer) in [(-other - 0.09, -other), (other, other + 0.09)] {
                    let (min, max) = if across {
                        (DVec3::new(inner, low, a), DVec3::new(outer, high, b))
                    } else {
                        (DVec3::new(a, low, inner), DVec3::new(b, high, outer))
                    };
                    scene.block(min, max, paint::MARBLE);
                }
            }
        }
    }
    base + 2.15
}

/// Two tiled slopes and the gables between them.
fn roof(scene: &mut Builder, half_x: f64, half_z: f64, base: f64) {
    let rise = half_z * 0.46;
    let (columns, rows) = (72, 12);
    for side in [-1.0, 1.0] {
        let point = |i: u32, j: u32| {
            let (s, t) = (f64::from(i) / f64::from(columns), f64::from(j) / f64::from(rows));
            // Ridges between the tiles.
            let relief = if i.is_multiple_of(2) { 0.09 } else { 0.0 };
            let along = -side * (s * 2.0 - 1.0) * half_x;
            DVec3::new(along, base + rise * t + relief, side * half_z * (1.0 - t))
        };
        let paint = |c: [DVec3; 3]| {
            let row = (c[0].y * 5.0) as i32;
            let tile = (c[0].x * 1.2) as i32;
            if super::noise::unit(tile, row, 7) < 0.3 { paint::ROOF_OLD } else { paint::ROOF }
        };
        scene.sheet((columns, rows), point, paint);
    }
    for (x, sign) in [(-half_x + 0.5, 1.0), (half_x - 0.5, -1.0)] {
        let p = |y: f64, z: f64| DVec3::new(x, y, z * sign);
        scene.triangle([p(base, half_z), p(base + rise, 0.0), p(base, -half_z)], paint::MARBLE_WORN);
        // The raking cornice stands out from the gable.
        let x = x - 0.25 * sign;
        let p = |y: f64, z: f64| DVec3::new(x, y, z * sign);
        let (crest, thick) = (base + rise, 0.42);
        scene.quad(
            [p(base, half_z), p(base + thick, half_z), p(crest + thick, 0.0), p(crest, 0.0)],
            paint::MARBLE,
        );
        scene.quad(
            [p(crest, 0.0), p(crest + thick, 0.0), p(base + thick, -half_z), p(base, -half_z)],
            paint::MARBLE,
        );
    }
}
