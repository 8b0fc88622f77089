//! Families of window triangles.

use super::{Corners, Family, Promise, Rung, Shapes};

const SIZE: (u32, u32) = (64, 64);

/// Steps in a pixel.
const PIXEL: i32 = 256;

/// The nearest and the farthest depth that a vertex keeps.
const NEAR: u32 = 2;
const FAR: u32 = u32::MAX - 2;

/// All families of window triangles.
#[must_use]
pub fn families() -> Vec<Family> {
    vec![needles(), thin(), collinear(), tiny(), missed(), steep(), fans(), far()]
}

fn family(
    id: &'static str,
    title: &'static str,
    about: &'static str,
    exponents: std::ops::RangeInclusive<i32>,
    shapes: impl Fn(i32) -> Vec<Corners>,
) -> Family {
    let rung = |k| Rung { k, size: SIZE, shapes: Shapes::Window(shapes(k)) };
    Family { id, title, about, promise: Promise::Exact, rungs: exponents.map(rung).collect() }
}

/// Depths that look like none in particular, the same every time.
fn depths(number: i32) -> [u32; 3] {
    let mix = |salt: u32| {
        let mut x = (number as u32).wrapping_mul(0x9e37_79b9).wrapping_add(salt.wrapping_mul(0x85eb_ca6b));
        x = (x ^ x >> 15).wrapping_mul(0x2c1b_3c6d);
        x = (x ^ x >> 12).wrapping_mul(0x297a_2d39);
        (x ^ x >> 15).clamp(NEAR, FAR)
    };
    [mix(1), mix(2), mix(3)]
}

/// 256 needles of width 1/256 px side by side, of which the middle lies in the target.
fn needles() -> Family {
    family("needles", "Needles", "Length 2^k px, width 1/256 px; 256 of them side by side.", 3..=15, |k| {
        let half = PIXEL << (k - 1);
        // A slope that no sample lies along.
        let rise = half / 64 + 37;
        let middle = [32 * PIXEL, 32 * PIXEL];
        let needle = |at: i32| {
            let y = middle[1] + at - 128;
            let xy = [
                [middle[0] - half, y - rise],
                [middle[0] + half, y + rise],
                [middle[0] + half, y + rise + 1],
            ];
            (xy.map(clamped), depths(at))
        };
        (0..256).map(needle).collect()
    })
}

/// Inside the guard band: the longest needle ends on it.
fn clamped([x, y]: [i32; 2]) -> [i32; 2] {
    let limit = 1 << 23;
    [x.clamp(-limit, limit), y.clamp(-limit, limit)]
}

/// A rectangle of 16 x 64 px in slats that lean, each of two triangles.
fn slats(width: i32, z: impl Fn(i32) -> [u32; 2]) -> Vec<Corners> {
    let lean = 37;
    let (left, top, bottom) = (8 * PIXEL + 11, 0, 64 * PIXEL);
    let mut triangles = Vec::new();
    for number in 0..16 * PIXEL / width {
        let (x0, x1) = (left + number * width, left + (number + 1) * width);
        let [z0, z1] = z(number);
        let corners = [[x0, top], [x1, top], [x1 + lean, bottom], [x0 + lean, bottom]];
        let depth = [z0, z1, z1, z0];
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
            triangles.push(([corners[a], corners[b], corners[c]], [depth[a], depth[b], depth[c]]));
        }
    }
    triangles
}

fn thin() -> Family {
    let about = "A rectangle of 1024 px cut into slats of width 2^-k px and length 64 px, depths at random.";
    family("slats", "Slats", about, 0..=8, |k| {
        slats(PIXEL >> k, |number| [depths(number)[0], depths(number)[1]])
    })
}

fn steep() -> Family {
    let about = "The whole range of depth across 2^-k px: slats whose one side is nearest and whose other is farthest.";
    family("steep-depth", "Steep depth", about, 0..=8, |k| slats(PIXEL >> k, |_| [NEAR, FAR]))
}

/// One sample of each of 32 pixels on a diagonal.
fn samples() -> impl Iterator<Item = (i32, [i32; 2])> {
    (0..32).map(|number| (number, [(16 + number) * PIXEL + 128, (8 + number * 3 / 2) * PIXEL + 128]))
}

/// Corners on two rows above and below a sample and one beside it: doubled area 2^k square steps, with the
/// sample in the middle of the long edge.
fn collinear() -> Family {
    let about = "Doubled area 2^(17 - k) square steps between corners 256 px apart: at k = 16 an area of 1/65536 px².";
    family("collinear", "Nearly collinear", about, 1..=16, |k| {
        let doubled = 1 << (17 - k);
        let long = 1 << 15;
        let shape = |(number, [x, y]): (i32, [i32; 2])| {
            ([[x - long, y - 1], [x + long, y + 1], [x + doubled / 2, y]], depths(number))
        };
        samples().map(shape).collect()
    })
}

fn tiny() -> Family {
    let about = "Legs of 2^-k px, the right angle on a sample: at k = 8 an area of 1/131072 px².";
    family("tiny", "Tiny", about, 0..=8, |k| {
        let leg = PIXEL >> k;
        samples().map(|(number, [x, y])| ([[x, y], [x + leg, y], [x, y + leg]], depths(number))).collect()
    })
}

/// Three triangles at each sample: a long edge through it, and one that misses it by one unit on either side.
fn missed() -> Family {
    let about =
        "An edge of 2^k steps whose value at a sample is 0, 1 and -1 square steps: the least there is.";
    family("missed", "Edges through samples", about, 4..=22, |k| {
        // The direction (long, wide) is primitive, and (long/2 - 1, long/4) lies at the least distance from it:
        // long (long/4) - wide (long/2 - 1) = 1.
        let long = 1 << k;
        let wide = long / 2 + 1;
        let shape = |(number, [x, y]): (i32, [i32; 2])| {
            let edge = |by: i32| {
                let (u, v) = (by * (long / 2 - 1), by * (long / 4));
                let (from, to) = ([x - long + u, y - wide + v], [x + long + u, y + wide + v]);
                ([from, to, [x, y + 64]].map(clamped), depths(number))
            };
            [edge(0), edge(1), edge(-1)]
        };
        samples().take(8).flat_map(shape).collect()
    })
}

fn fans() -> Family {
    let about = "2^k triangles round one point; every sample of the fan belongs to exactly one.";
    family("fans", "Fans", about, 2..=13, |k| {
        let count = 1 << k;
        let centre = [32 * PIXEL + 77, 32 * PIXEL - 91];
        // Round a square: whole steps, so that neighbours share their corners.
        let side = 60 * PIXEL;
        let rim = |number: i32| {
            let along = (i64::from(number) * 4 * i64::from(side) / i64::from(count)) as i32;
            let (edge, at) = (along / side % 4, along % side);
            let low = 2 * PIXEL + 3;
            match edge {
                0 => [low + at, low],
                1 => [low + side, low + at],
                2 => [low + side - at, low + side],
                _ => [low, low + side - at],
            }
        };
        let depth = |number: i32| depths(number % count)[0];
        let triangle = |number: i32| {
            ([centre, rim(number), rim(number + 1)], [1 << 31, depth(number), depth(number + 1)])
        };
        (0..count).map(triangle).collect()
    })
}

/// The same shape ever farther from the origin, in a target that reaches there.
fn far() -> Family {
    let about =
        "Triangles of 12 px whose third corner is 2^k px away, beyond the target, up to the guard band.";
    family("far-corners", "Corners far away", about, 4..=14, |k| {
        let away = PIXEL << k;
        let shape = |number: i32| {
            let (x, y) = (4 * PIXEL + number * 7 * PIXEL + 31, 6 * PIXEL + number * 5 * PIXEL + 19);
            ([[x, y], [x + away, y + away - 3], [x, y + 12 * PIXEL]].map(clamped), depths(number))
        };
        (0..8).map(shape).collect()
    })
}
