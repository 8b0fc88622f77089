//! Scenes of several triangles: depth tests against a model, and pictures against the reference.

use halfplane::{D16, D32, DepthFormat, DepthTest, Format, Small, Standard};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    properties::{depth_test, scene},
    run::check,
    sizes, strategies,
    toy::Toy,
};
use proptest::{prelude::*, sample::select};

fn depth_tests<F: Format, D: DepthFormat<F>>(spec: DepthSpec)
where
    D::Texel: TryFrom<u32>,
{
    for compare in depth_test::COMPARISONS {
        for write in [true, false] {
            check(
                sizes::DEPTH_TEST,
                (strategies::scene::<F>(24, 12), any::<u64>()),
                |((frame, shots), seed)| {
                    depth_test::equals_model::<F, D>(&frame, &shots, DepthTest { compare, write }, spec, seed)
                },
            );
        }
    }
}

fn scenes<F: Format, D: DepthFormat<F>>(spec: DepthSpec) {
    let compare = select(depth_test::COMPARISONS.to_vec());
    check(sizes::SCENE, (strategies::scene::<F>(60, 60), compare), |((frame, shots), compare)| {
        scene::equals_reference::<F, D>(&frame, &shots, compare, spec)
    });
}

#[test]
fn depth_tests_equal_the_model_standard_d32() {
    depth_tests::<Standard, D32>(DepthSpec::D32);
}

#[test]
fn depth_tests_equal_the_model_standard_d16() {
    depth_tests::<Standard, D16>(DepthSpec::D16);
}

#[test]
fn depth_tests_equal_the_model_small_d16() {
    depth_tests::<Small, D16>(DepthSpec::SMALL);
}

#[test]
fn scenes_equal_the_reference_standard_d32() {
    scenes::<Standard, D32>(DepthSpec::D32);
}

#[test]
fn scenes_equal_the_reference_standard_d16() {
    scenes::<Standard, D16>(DepthSpec::D16);
}

#[test]
fn scenes_equal_the_reference_small_d16() {
    scenes::<Small, D16>(DepthSpec::SMALL);
}

#[test]
fn scenes_equal_the_reference_toy_d16() {
    scenes::<Toy, D16>(DepthSpec::SMALL);
}
