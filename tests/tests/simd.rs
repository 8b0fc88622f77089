//! The vector code at every level of this machine.

use halfplane::{CulledCounts, RejectedCounts, Standard, Statistics};
use halfplane_tests::{
    Frame,
    case::Case,
    properties::{
        crossing::{is_exact_in_f32, is_exact_in_f64},
        meshlets::meshlets_are_the_mesh,
        simd::{
            Refused, constant_depths_are_unorm32, depths_are_the_scalar_ones, errors_are_the_scalar_ones,
            frame_is_the_scalar_one, levels_have_names,
        },
    },
    run::check,
    shapes::{Kind, LARGE_EXTENT},
    sizes,
    strategies::{numbers, triangles},
};
use proptest::{collection::vec, prelude::*};
use std::cell::Cell;

/// What became of the triangles of all cases: a test that draws nothing finds nothing.
#[derive(Default)]
pub(crate) struct Met(Cell<Statistics>);

impl Met {
    pub(crate) fn count(&self, statistics: Statistics) {
        let mut sum = self.0.get();
        sum += statistics;
        self.0.set(sum);
    }

    /// One in so many triangles is drawn.
    pub(crate) fn assert_drawn(&self, one_in: u32) {
        let statistics = self.0.get();
        println!("{statistics}");
        assert!(statistics.drawn >= statistics.submitted / one_in, "{statistics}");
    }

    /// Each fate is met, often.
    pub(crate) fn assert_all(&self) {
        self.assert_drawn(5);
        let Statistics { submitted, culled, rejected, clipped, .. } = self.0.get();
        let CulledCounts { facing, zero_area, no_sample, outside, .. } = culled;
        let RejectedCounts { non_finite, .. } = rejected;
        for count in [facing, zero_area, no_sample, outside, non_finite, clipped] {
            assert!(count >= submitted / 200, "{}", self.0.get());
        }
    }
}

#[test]
fn levels_are_listed_from_the_best_down() {
    levels_have_names().unwrap();
}

#[test]
fn frames_are_the_scalar_ones() {
    let met = Met::default();
    check(
        sizes::SIMD_FRAME,
        (numbers::<12>(), numbers::<10>(), triangles(0..=40)),
        |(place, how, triangles)| {
            let case = Case::from_numbers(place, how, &triangles, &Kind::ALL);
            met.count(frame_is_the_scalar_one(&case)?);
            Ok(())
        },
    );
    met.assert_all();
}

/// Triangles that pass by the eye, as pictures and as meshlets.
#[test]
fn frames_around_the_eye_are_the_scalar_ones() {
    let met = Met::default();
    check(
        sizes::SIMD_FRAME,
        (numbers::<12>(), numbers::<10>(), triangles(0..=40), any::<u64>()),
        |(place, how, triangles, seed)| {
            let case = Case::from_numbers(place, how, &triangles, &Kind::ALL).around_the_eye(seed);
            met.count(frame_is_the_scalar_one(&case)?);
            meshlets_are_the_mesh(&case)?;
            Ok(())
        },
    );
    met.assert_drawn(10);
}

/// More triangles than are collected at a time, those for the slow path among the others.
#[test]
fn frames_of_many_triangles_are_the_scalar_ones() {
    let kinds = [Kind::Tiny, Kind::Small, Kind::Small, Kind::AxisAligned, Kind::Medium, Kind::GuardBand];
    let met = Met::default();
    check(
        sizes::SIMD_MANY,
        (numbers::<12>(), numbers::<10>(), triangles(60..=300)),
        |(place, how, triangles)| {
            let case = Case::from_numbers(place, how, &triangles, &kinds);
            met.count(frame_is_the_scalar_one(&case)?);
            Ok(())
        },
    );
    met.assert_drawn(10);
}

/// Doubled areas of 1 and 2 and other small ones, and depths from end to end: every digit of the
/// gradients is in use.
#[test]
fn steep_depths_are_the_scalar_ones() {
    let kinds = [Kind::Bezout, Kind::Sliver, Kind::Tiny, Kind::OnSamples, Kind::ThroughSamples];
    let met = Met::default();
    check(
        sizes::SIMD_STEEP,
        (numbers::<12>(), numbers::<10>(), triangles(1..=24)),
        |(place, mut how, triangles)| {
            // Exact positions, all depths, both windings.
            [how[0], how[1], how[2], how[7]] = [0, 10, 0, 1];
            met.count(depths_are_the_scalar_ones(&Case::from_numbers(place, how, &triangles, &kinds))?);
            Ok(())
        },
    );
    met.assert_drawn(3);
}

/// At the far end of the largest target a float's last bit is a quarter of a step: any other order of
/// operations moves vertices. Depths show where they are.
#[test]
fn vertices_are_the_scalar_ones_to_the_last_bit() {
    let kinds = [Kind::Tiny, Kind::Small, Kind::Medium, Kind::Sliver, Kind::OnSamples];
    let met = Met::default();
    check(
        sizes::SIMD_VERTEX,
        (numbers::<12>(), numbers::<10>(), triangles(1..=16)),
        |(mut place, mut how, triangles)| {
            // The far end of both axes, seen through a viewport of the whole target.
            place[0] = 10;
            [how[0], how[1]] = [4, 2 + how[1] % 3];
            // Matrices that are not far from the identity; any depths.
            [how[2], how[7]] = [16 * (10 + how[2] % 10), 1];
            met.count(depths_are_the_scalar_ones(&Case::from_numbers(place, how, &triangles, &kinds))?);
            Ok(())
        },
    );
    met.assert_drawn(20);
}

/// Doubled areas that are powers of two, up to the largest, and primes.
#[test]
fn depths_of_chosen_areas_are_the_scalar_ones() {
    let frame = Frame::whole::<Standard>(128, 128);
    let sides = (0..=14).map(|k| 1 << k).chain([3, 5, 7, 127, 257, 8191, 16381, 30707, 30719]);
    let sides: Vec<i32> = sides.collect();
    for &width in &sides {
        for &height in &sides {
            for z in [[2, u32::MAX - 2, 77], [u32::MAX - 2, 2, 1 << 31], [1 << 8, 3 << 8, u32::MAX]] {
                // The right angle on a sample, so that something is covered.
                for corners in [
                    [[128, 128], [128 + width, 128], [128, 128 + height]],
                    [[129 + width, 128], [128 + width, 129 + height], [128, 128]],
                ] {
                    depths_are_the_scalar_ones(&Case::single(frame, corners, z)).unwrap();
                }
            }
        }
    }
}

/// The extents about the limit of the fast path, at each place within a block and both ways round.
#[test]
fn extents_about_the_limit_are_the_scalar_ones() {
    let frame = Frame::whole::<Standard>(256, 256);
    let limit = LARGE_EXTENT as i32;
    for extent in [limit - 1, limit, limit + 1] {
        for offset in (0..4 * 256).step_by(97).chain([4 * 256 - 1]) {
            let [x, y] = [1024 + offset, 2048 + offset / 2];
            for corners in [
                [[x, y], [x + extent, y + extent], [x + 1, y + extent]],
                [[x, y + extent], [x + extent, y], [x, y]],
                [[x, y], [x + extent, y + 1], [x + 5, y + 300]],
                [[x, y], [x + 1, y + extent], [x + 300, y + 7]],
            ] {
                let [a, b, c] = corners;
                frame_is_the_scalar_one(&Case::single(frame, [a, b, c], [1 << 31, 1, u32::MAX])).unwrap();
                frame_is_the_scalar_one(&Case::single(frame, [a, c, b], [1 << 31, 1, u32::MAX])).unwrap();
            }
        }
    }
}

/// Every exponent, both ends and the middle of its range, and the neighbours.
#[test]
fn constant_depths_of_every_exponent_are_unorm32() {
    let mut depths = Vec::new();
    for exponent in 0..=0x7Fu32 {
        for mantissa in [0, 1, 2, 3, 0x40_0000, 0x3F_FFFF, 0x7F_FFFE, 0x7F_FFFF] {
            depths.push(f32::from_bits(exponent << 23 | mantissa));
        }
    }
    for center in [0.5f32, 0.25, 1.0, 1.0 / 65536.0, 1.5 / 4_294_967_296.0, 0.5 / 4_294_967_296.0] {
        depths.extend((-20..=20).map(|ulps| f32::from_bits(center.to_bits().wrapping_add_signed(ulps))));
    }
    depths.retain(|depth| *depth <= 1.0);
    for depths in depths.chunks(256) {
        constant_depths_are_unorm32(depths).unwrap();
    }
}

#[test]
fn constant_depths_are_unorm32_everywhere() {
    let ties = (0..u32::MAX).prop_map(|k| ((f64::from(k) + 0.5) / f64::from(u32::MAX)) as f32);
    let small = (0..2000u32).prop_map(|k| ((f64::from(k) + 0.5) / f64::from(u32::MAX)) as f32);
    let near = (small, -2i32..=2).prop_map(|(z, ulps)| f32::from_bits(z.to_bits().wrapping_add_signed(ulps)));
    let depth = prop_oneof![0f32..=1.0, ties, near, (0..=0x3F80_0000u32).prop_map(f32::from_bits)];
    check(sizes::SIMD_DEPTH, vec(depth, 1..=64), |depths| constant_depths_are_unorm32(&depths));
}

#[test]
fn errors_are_the_scalar_ones_at_every_level() {
    let case = (3usize..40, 1usize..90, any::<usize>(), any::<u32>())
        .prop_map(|(vertices, triangles, at, beyond)| Refused { vertices, triangles, at, beyond });
    check(sizes::SIMD_ERRORS, case, errors_are_the_scalar_ones);
}

/// Every edge of the fast path, every crossing nearest to a pixel: 16 million, exhaustively.
#[test]
fn crossings_of_small_triangles_are_exact() {
    for a in 1..LARGE_EXTENT as i32 {
        is_exact_in_f32(a).unwrap();
        is_exact_in_f32(-a).unwrap();
    }
}

/// The bound is not idle: somewhat steeper edges are no longer exact in `f32`.
#[test]
fn crossings_of_large_triangles_are_not_exact_in_f32() {
    let failing = (LARGE_EXTENT as i32..1 << 18).find(|&a| is_exact_in_f32(a).is_err());
    println!("first failing a: {failing:?}");
    assert!(failing.is_some());
}

/// Every edge that a triangle in the guard band can have, by samples and at the ends.
#[test]
fn crossings_of_large_triangles_are_exact_in_f64() {
    for a in [1, 2, 3, (1 << 24) - 3, (1 << 24) - 1, 1 << 24] {
        for k in 0..=i64::from(1 << 15) {
            is_exact_in_f64(a, k).unwrap();
            is_exact_in_f64(-a, k).unwrap();
        }
    }
    check(sizes::CROSSINGS, (1i32..=1 << 24, 0u32..24, 0i64..1 << 15), |(a, shift, start)| {
        let a = (a >> shift).max(1);
        for k in (start..start + 64).chain((1 << 15) - 64..=1 << 15) {
            is_exact_in_f64(a, k)?;
            is_exact_in_f64(-a, k)?;
        }
        Ok(())
    });
}
