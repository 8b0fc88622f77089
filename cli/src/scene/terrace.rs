//! Where the camera stands: a tiled floor that crosses the near plane, a ruined arcade before the
//! view, a balustrade at the edge.

use glam::DVec3;

use super::build::{Builder, Frame};
use super::land::cypress;
use super::masonry::{balustrade, column, spandrels, stump};
use super::noise::unit;
use super::paint;

/// The height of the floor.
const FLOOR: f64 = 5.6;

/// The edge of the terrace towards the lake, and its half width.
const EDGE: f64 = 15.0;
const HALF: f64 = 21.0;

/// The line of the arcade and the distance between its columns.
const ARCADE: f64 = 10.6;
const BAY: f64 = 5.4;

pub(super) fn terrace(scene: &mut Builder) {
    floor(scene);
    arcade(scene);
    fallen(scene);
    let rail = |x: f64, z: f64| DVec3::new(x, FLOOR, z);
    balustrade(scene, rail(-HALF, EDGE - 0.5), rail(HALF, EDGE - 0.5));
    for (k, (x, z)) in [(-19.0, 22.0), (-15.8, 24.5), (24.0, 19.5), (27.5, 23.0)].into_iter().enumerate() {
        cypress(scene, DVec3::new(x, 0.0, z), 15.5 + 1.5 * k as f64, 26, 900 + k as i32);
    }
}

fn floor(scene: &mut Builder) {
    scene.block(
        DVec3::new(-HALF - 0.6, -3.0, -30.0),
        DVec3::new(HALF + 0.6, FLOOR - 0.02, EDGE),
        paint::SANDSTONE,
    );
    scene.block(
        DVec3::new(-HALF - 0.8, FLOOR - 0.35, -30.0),
        DVec3::new(HALF + 0.8, FLOOR - 0.015, EDGE + 0.2),
        paint::MARBLE_WORN,
    );
    let size = 1.2;
    let (columns, rows) = ((HALF / size) as i32, (EDGE / size) as i32);
    // Brass strips between the tiles: slivers from behind the camera to the edge.
    for i in -columns..=columns {
        let (x, half) = (f64::from(i) * size, 0.014);
        let p = |dx: f64, z: f64| DVec3::new(x + dx, FLOOR + 0.006, z);
        scene.quad([p(-half, -9.0), p(-half, EDGE), p(half, EDGE), p(half, -9.0)], paint::SAND);
    }
    // Square tiles with a smaller one set in every other.
    for j in -6..rows {
        for i in -columns..columns {
            let (x, z) = (f64::from(i) * size, f64::from(j) * size);
            let gap = 0.02;
            // Worn tiles have sunk a little, each its own way.
            let sink = |k: u32| FLOOR - 0.012 * unit(i, j, 100 + k);
            let p = |dx: f64, dz: f64, k: u32| DVec3::new(x + dx, sink(k), z + dz);
            let far = size - gap;
            let paint = if (i + j) % 2 == 0 { paint::TILE_LIGHT } else { paint::TILE_DARK };
            if unit(i, j, 110) > 0.04 {
                scene.quad([p(gap, gap, 0), p(gap, far, 1), p(far, far, 2), p(far, gap, 3)], paint);
            }
            if (i + j) % 2 == 0 {
                let (a, b, m) = (size * 0.3, size * 0.7, size * 0.5);
                let q = |dx: f64, dz: f64| DVec3::new(x + dx, FLOOR + 0.004, z + dz);
                scene.quad([q(a, m), q(m, b), q(b, m), q(m, a)], paint::ROOF_OLD);
            }
        }
    }
}

/// Arches on the left, columns without them further right, a stump at the end.
fn arcade(scene: &mut Builder) {
    let height = 4.3;
    let spring = FLOOR + 0.35 + height;
    let (radius, depth) = (BAY * 0.5 - 0.55, 1.3);
    let top = spring + radius + 1.35;
    let foot = |k: i32| DVec3::new(-2.2 + BAY * f64::from(k), FLOOR, ARCADE);
    for k in -4..=3 {
        let base = foot(k);
        let plinth = 0.78;
        scene.block(
            base - DVec3::new(plinth, 0.0, plinth),
            base + DVec3::new(plinth, 0.35, plinth),
            paint::MARBLE_WORN,
        );
        let base = base + DVec3::new(0.0, 0.35, 0.0);
        match k {
            ..=0 => column(scene, base, height, 0.5, 40, paint::MARBLE),
            1 => {}
            2 => stump(scene, base, 1.7, 0.5, paint::MARBLE),
            _ => column(scene, base, height, 0.5, 40, paint::MARBLE),
        }
    }
    let stone = |k: u32| if k.is_multiple_of(2) { paint::SANDSTONE } else { paint::MARBLE_WORN };
    let front = ARCADE - depth * 0.5;
    for k in -4..0 {
        let centre = DVec3::new(foot(k).x + BAY * 0.5, spring, front);
        scene.arch(centre, (radius, radius + 0.62), depth, (0.0, 1.0, 17), stone);
        spandrels(scene, centre, radius + 0.62, BAY * 0.5, top, depth);
    }
    // The arch that broke: its left foot still stands out from the last column.
    let centre = DVec3::new(foot(0).x + BAY * 0.5, spring, front);
    scene.arch(centre, (radius, radius + 0.62), depth, (0.70, 1.0, 5), stone);
    let end = foot(0).x + 0.55;
    scene.block(
        DVec3::new(foot(-4).x - 0.6, top, front - 0.16),
        DVec3::new(end - 0.3, top + 0.42, front + depth + 0.16),
        paint::MARBLE_WORN,
    );
    // The wall's broken end, a stair of courses.
    let courses = 7;
    for c in 0..courses {
        let y = spring + (top - spring) * f64::from(c) / f64::from(courses);
        let ragged = 0.5 * unit(c, 0, 120) + 0.75 * (1.0 - f64::from(c) / f64::from(courses));
        scene.block(
            DVec3::new(foot(0).x - 0.05, y, front + 0.1),
            DVec3::new(foot(0).x + ragged, y + (top - spring) / f64::from(courses), front + depth - 0.1),
            paint::SANDSTONE,
        );
    }
}

/// A drum and blocks that lie where they fell.
fn fallen(scene: &mut Builder) {
    for (k, (x, z, size)) in
        [(4.2, 9.2, 0.62), (5.5, 10.3, 0.4), (6.3, 8.6, 0.3), (2.9, 11.4, 0.34), (-9.5, 7.2, 0.45)]
            .into_iter()
            .enumerate()
    {
        let turn = unit(k as i32, 0, 130) * 2.0 - 1.0;
        scene.at(Frame::new(DVec3::new(x, FLOOR, z), (1.0, turn)));
        let long = size * (1.2 + unit(k as i32, 1, 130));
        scene.block(DVec3::new(-long, 0.0, -size), DVec3::new(long, size * 1.1, size), paint::MARBLE_WORN);
    }
    scene.at(Frame::WORLD);
    let drum = DVec3::new(8.6, FLOOR, 6.6);
    scene.turned(drum, &[(0.5, 0.0), (0.49, 1.05)], 40, 0.93, paint::MARBLE);
    scene.turned(drum + DVec3::new(1.5, 0.0, 0.9), &[(0.52, 0.0), (0.51, 0.7)], 40, 0.93, paint::MARBLE);
}
