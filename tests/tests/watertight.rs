//! Meshes are watertight, in every format.

use halfplane::{Bounds, Format, Small, Standard};
use halfplane_tests::{
    Frame,
    properties::watertight::each_sample_once,
    run::check,
    shapes::{Mesh, Random, fan, grid, triangulation},
    sizes,
    strategies::{frame, numbers},
    toy::{Middle, Toy},
};
use proptest::prelude::*;

/// A rectangle near the frame, or as large as the guard band.
fn outline<F: Format>(frame: &Frame, numbers: [u32; 4], random: &mut Random) -> [i32; 4] {
    let guard = Bounds::<F>::GUARD_BAND;
    if numbers[0].is_multiple_of(4) {
        return [-guard, -guard, guard, guard];
    }
    let step = i64::from(Bounds::<F>::STEPS_PER_PIXEL);
    let [x0, y0, x1, y1] = frame.region.map(|v| i64::from(v) * step);
    let mut near =
        |v: i64| random.between(v - step, v + step).clamp(i64::from(-guard), i64::from(guard)) as i32;
    let (left, top, right, bottom) = (near(x0), near(y0), near(x1), near(y1));
    [left, top, right.max(left + 1), bottom.max(top + 1)]
}

fn mesh<F: Format>(frame: &Frame, numbers: [u32; 4], seed: u64) -> Mesh {
    let mut random = Random(seed);
    let outline = outline::<F>(frame, numbers, &mut random);
    let [x0, y0, x1, y1] = outline.map(i64::from);
    if numbers[1].is_multiple_of(3) {
        return grid(outline, 1 + numbers[2] % 12, 1 + numbers[3] % 12, &mut random);
    }
    let count = numbers[2] % 60;
    // Some points anywhere, the others in a knot, and one on a sample.
    let [sx, sy] = frame.sample_at::<F>((frame.scissor[0], frame.scissor[1]));
    let knot = 2 + i64::from(numbers[3] % 1000);
    let points: Vec<_> = (0..count)
        .map(|k| {
            let (x, y) = match k % 3 {
                0 => (random.between(x0, x1), random.between(y0, y1)),
                1 => (sx + random.between(-knot, knot), sy + random.between(-knot, knot)),
                _ => {
                    let step = i64::from(Bounds::<F>::STEPS_PER_PIXEL);
                    (sx + random.between(0, 9) * step, sy + random.between(0, 9) * step)
                }
            };
            [x.clamp(x0, x1) as i32, y.clamp(y0, y1) as i32]
        })
        .collect();
    triangulation(outline, &points)
}

fn meshes<F: Format>() {
    check(sizes::MESH, (frame::<F>(), numbers::<4>(), any::<u64>()), |(frame, numbers, seed)| {
        each_sample_once::<F>(&frame, &mesh::<F>(&frame, numbers, seed), seed)
    });
}

fn fans<F: Format>() {
    check(sizes::FAN, (frame::<F>(), any::<u64>()), |(frame, seed)| {
        let mut random = Random(seed);
        let [x, y] = frame.sample_at::<F>((frame.scissor[0], frame.scissor[1])).map(|v| v as i32);
        let guard = Bounds::<F>::GUARD_BAND;
        let room = [guard - x, guard - y].into_iter().min().unwrap_or(guard);
        let half = random.between(i64::from(room / 8), i64::from(room)) as i32;
        let half = half.min(guard + x).min(guard + y);
        let hub_at_sample = seed.is_multiple_of(2);
        let mut fan = fan([x, y], half, 1000, &mut random);
        if hub_at_sample {
            fan.xy[0] = [x, y];
        }
        each_sample_once::<F>(&frame, &fan, seed)
    });
}

macro_rules! for_each_format {
    ($($format:ident $mesh:ident $fan:ident;)+) => {
        $(
            #[test]
            fn $mesh() {
                meshes::<$format>();
            }

            #[test]
            fn $fan() {
                fans::<$format>();
            }
        )+
    };
}

for_each_format! {
    Standard meshes_are_watertight_standard fans_are_watertight_standard;
    Small meshes_are_watertight_small fans_are_watertight_small;
    Middle meshes_are_watertight_middle fans_are_watertight_middle;
    Toy meshes_are_watertight_toy fans_are_watertight_toy;
}
