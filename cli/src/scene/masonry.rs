//! Columns, balustrades and a bridge: the parts that repeat.

use glam::DVec3;

use super::build::{Builder, Frame};
use super::paint;

/// A Doric column of a given height and lower radius; `detail` fluted edges (twice the flutes).
pub(super) fn column(scene: &mut Builder, base: DVec3, height: f64, radius: f64, detail: u32, stone: u8) {
    let shaft = height - 0.9 * radius;
    // Entasis: the taper grows towards the top.
    let profile: Vec<(f64, f64)> = (0..=6)
        .map(|k| {
            let t = f64::from(k) / 6.0;
            (radius * (1.0 - 0.06 * t - 0.14 * t * t), shaft * t)
        })
        .collect();
    scene.turned(base, &profile, detail, 0.93, stone);
    let neck = radius * 0.8;
    let echinus =
        [(neck, shaft), (radius * 1.02, shaft + 0.25 * radius), (radius * 1.18, shaft + 0.5 * radius)];
    scene.turned(base, &echinus, detail / 2, 1.0, stone);
    let half = radius * 1.22;
    scene.block(
        base + DVec3::new(-half, shaft + 0.5 * radius, -half),
        base + DVec3::new(half, height, half),
        stone,
    );
}

/// A column that broke off at `height`, with a slanting, ragged top.
pub(super) fn stump(scene: &mut Builder, base: DVec3, height: f64, radius: f64, stone: u8) {
    let profile = [
        (radius, 0.0),
        (radius * 0.985, height * 0.5),
        (radius * 0.97, height * 0.93),
        (radius * 0.62, height),
    ];
    scene.turned(base, &profile, 40, 0.93, stone);
}

/// A row of balusters under a rail, from `from` to `to` at the same height.
pub(super) fn balustrade(scene: &mut Builder, from: DVec3, to: DVec3) {
    let along = to - from;
    let length = along.length();
    scene.at(Frame::new(from, (along.x, along.z)));
    let posts = (length / 3.1) as u32;
    let spacing = length / f64::from(posts);
    for k in 0..=posts {
        let x = spacing * f64::from(k);
        scene.block(DVec3::new(x - 0.2, 0.0, -0.2), DVec3::new(x + 0.2, 1.12, 0.2), paint::SANDSTONE);
        scene.block(DVec3::new(x - 0.24, 1.12, -0.24), DVec3::new(x + 0.24, 1.2, 0.24), paint::MARBLE_WORN);
        if k == posts {
            break;
        }
        scene.block(
            DVec3::new(x + 0.2, 0.0, -0.15),
            DVec3::new(x + spacing - 0.2, 0.1, 0.15),
            paint::SANDSTONE,
        );
        scene.block(
            DVec3::new(x + 0.2, 0.9, -0.17),
            DVec3::new(x + spacing - 0.2, 1.04, 0.17),
            paint::MARBLE_WORN,
        );
        let count = 7;
        for b in 0..count {
            let x = x + 0.2 + (spacing - 0.4) * (f64::from(b) + 0.5) / f64::from(count);
            let profile = [
                (0.075, 0.1),
                (0.085, 0.16),
                (0.045, 0.22),
                (0.1, 0.42),
                (0.05, 0.68),
                (0.04, 0.78),
                (0.08, 0.84),
                (0.08, 0.9),
            ];
            scene.turned(DVec3::new(x, 0.0, 0.0), &profile, 10, 1.0, paint::SANDSTONE);
        }
    }
    scene.at(Frame::WORLD);
}

/// A bridge of round arches across the water.
pub(super) fn bridge(scene: &mut Builder, from: DVec3, to: DVec3) {
    let along = to - from;
    let length = along.length();
    scene.at(Frame::new(from, (along.x, along.z)));
    let arches = 14u32;
    let span = length / f64::from(arches);
    let (pier, depth, spring) = (span * 0.11, 5.0, 1.6);
    let radius = span * 0.5 - pier;
    let deck = spring + radius + 1.1;
    for k in 0..=arches {
        let x = span * f64::from(k);
        scene.block(DVec3::new(x - pier, -3.0, 0.0), DVec3::new(x + pier, spring, depth), paint::SANDSTONE);
        // The cutwater.
        let (tip, back) = (DVec3::new(x, 0.0, -1.6), DVec3::new(0.0, 0.0, 0.0));
        let (l, r) = (DVec3::new(x - pier, 0.0, 0.0), DVec3::new(x + pier, 0.0, 0.0));
        let (down, up) = (DVec3::new(0.0, -3.0, 0.0), DVec3::new(0.0, spring, 0.0));
        scene.quad([l + down, l + up, tip + up, tip + down], paint::SANDSTONE_DARK);
        scene.quad([tip + down, tip + up, r + up, r + down], paint::SANDSTONE_DARK);
        scene.triangle([l + up, back + DVec3::new(x, spring + 0.9, 0.0), tip + up], paint::SANDSTONE);
        scene.triangle([tip + up, back + DVec3::new(x, spring + 0.9, 0.0), r + up], paint::SANDSTONE);
    }
    for k in 0..arches {
        let middle = span * (f64::from(k) + 0.5);
        let centre = DVec3::new(middle, spring, 0.0);
        let ring = (radius, radius + 0.7);
        let stone = |k: u32| if k.is_multiple_of(2) { paint::MARBLE_WORN } else { paint::SANDSTONE };
        scene.arch(centre, ring, depth, (0.0, 1.0, 15), stone);
        spandrels(scene, centre, radius + 0.7, span * 0.5, deck, depth);
    }
    let end = DVec3::new(length + pier, deck + 0.35, depth + 0.3);
    scene.block(DVec3::new(-pier, deck, -0.3), end, paint::SANDSTONE);
    for z in [-0.3, depth] {
        let parapet = DVec3::new(length + pier, deck + 1.3, z + 0.3);
        scene.block(DVec3::new(-pier, deck + 0.35, z), parapet, paint::SANDSTONE);
    }
    scene.at(Frame::WORLD);
}

/// The wall beside and above an arch, up to `top`, on both faces.
pub(super) fn spandrels(scene: &mut Builder, centre: DVec3, radius: f64, half: f64, top: f64, depth: f64) {
    let steps = 16;
    let at = |k: u32| {
        // Evenly over the half circle, and on to the ends of the bay beyond its feet.
        let (sin, cos) = libm::sincos(core::f64::consts::PI * f64::from(k) / f64::from(steps));
        ((radius * cos).clamp(-half, half), radius * sin)
    };
    for (z, back) in [(0.12, false), (depth - 0.12, true)] {
        for k in 0..steps {
            let ((x0, y0), (x1, y1)) = (at(k), at(k + 1));
            if x0 <= x1 {
                continue;
            }
            let p = |x: f64, y: f64| DVec3::new(centre.x + x, y, centre.z + z);
            let mut wall = [p(x1, centre.y + y1), p(x1, top), p(x0, top), p(x0, centre.y + y0)];
            if back {
                wall.reverse();
            }
            scene.quad(wall, paint::SANDSTONE);
        }
    }
}
