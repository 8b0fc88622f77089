//! The transform against exact rationals.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{
    Frame,
    properties::transform::{Distance, any_bits_are_safe, model_is_its_clip_space, snapped_is_near_exact},
    run::check,
    shapes::clip_bits,
    sizes,
    strategies::numbers,
};
use proptest::prelude::*;
use std::cell::Cell;

fn vertex() -> impl Strategy<Value = [f32; 4]> {
    let w = prop_oneof![1e-3f32..1e3, Just(1.0), 0.9f32..1.1, 1e-30f32..1e30];
    (-1.5f32..1.5, -1.5f32..1.5, 0f32..1.0, w).prop_map(|(x, y, z, w)| [x * w, y * w, z * w, w])
}

fn near_exact<F: Format>(target: impl Fn(&Frame) -> [u32; 4]) -> Distance {
    let (largest, met) = (Cell::new(Distance::default()), Cell::new(0));
    check(sizes::TRANSFORM, (vertex(), numbers::<12>()), |(vertex, place)| {
        let target = target(&Frame::from_numbers::<F>(place));
        if let Some(distance) = snapped_is_near_exact::<F>(vertex, target)? {
            largest.set(largest.get().max(distance));
            met.set(met.get() + 1);
        }
        Ok(())
    });
    assert!(met.get() > sizes::TRANSFORM.scaled() / 2, "only {} vertices were compared", met.get());
    let Distance { steps, depth } = largest.get();
    println!("farthest from the exact position: {steps:.4} steps; depth {depth:.2} units of 2^-32");
    largest.get()
}

#[test]
fn snapped_vertices_are_near_the_exact_ones_anywhere() {
    near_exact::<Standard>(|frame| frame.region);
    near_exact::<Small>(|frame| frame.region);
}

/// The number that README and DESIGN can state: at 1280x720, vertices on screen or half a screen beside
/// it, 1/2 step and at most (3/4 W 2u + 5/4 W u) 2^8 = 0.054 steps of float error.
#[test]
fn snapped_vertices_are_near_the_exact_ones_at_1280x720() {
    let Distance { steps, .. } = near_exact::<Standard>(|_| [0, 0, 1280, 720]);
    assert!(steps <= 0.5 + (1.5 + 1.25) * 1280.0 * 256.0 / f64::from(1 << 24), "{steps}");
}

#[test]
fn any_bits_project_without_panic() {
    check(sizes::TRANSFORM, (numbers::<13>(), numbers::<12>()), |(bits, place)| {
        for vertex in clip_bits(bits) {
            any_bits_are_safe::<Standard>(vertex, Frame::from_numbers::<Standard>(place).region)?;
            any_bits_are_safe::<Small>(vertex, Frame::from_numbers::<Small>(place).region)?;
        }
        Ok(())
    });
}

#[test]
fn object_space_is_the_clip_space_of_its_matrix() {
    let bits = || (numbers::<13>(), numbers::<13>(), numbers::<12>());
    check(sizes::TRANSFORM, bits(), |(vertices, matrix, place)| {
        let vertices = clip_bits(vertices).map(|[x, y, z, _]| [x, y, z]);
        let [m0, m1, m2] = clip_bits(matrix);
        let target = Frame::from_numbers::<Standard>(place).region;
        model_is_its_clip_space::<Standard>(&vertices, [m0, m1, m2, [0.25, -0.5, 0.5, 1.0]], target)
    });
}
