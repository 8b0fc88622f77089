//! Statistics add up, and each cause is the right one.

use halfplane::{Cull, Format, Small, Standard, Vertex, Winding};
use halfplane_tests::{
    Frame,
    frame::into_guard_band,
    properties::statistics,
    run::check,
    shapes::clip_bits,
    sizes,
    strategies::{numbers, scene},
    toy::Toy,
};
use proptest::{collection::vec, prelude::*, sample::select};

fn window<F: Format>() {
    let cull = select(vec![Cull::None, Cull::Back, Cull::Front]);
    let front = select(vec![Winding::Clockwise, Winding::CounterClockwise]);
    check(
        sizes::STATISTICS,
        (scene::<F>(40, 12), numbers::<12>(), cull, front),
        |((frame, shots), numbers, cull, front)| {
            // A scissor of the same size anywhere else, too: triangles beside it.
            statistics::equal_model::<F>(&frame, &shots, cull, front)?;
            statistics::equal_model::<F>(&Frame::from_numbers::<F>(numbers), &shots, cull, front)
        },
    );
}

fn clip_space<F: Format>() {
    check(
        sizes::STATISTICS,
        (vec(numbers::<13>().prop_map(clip_bits), 1..12), numbers::<12>()),
        |(triangles, place)| {
            statistics::of_clip_space_add_up::<F>(&triangles, Frame::from_numbers::<F>(place).region)
        },
    );
}

#[test]
fn statistics_equal_the_model_standard() {
    window::<Standard>();
}

#[test]
fn statistics_equal_the_model_small() {
    window::<Small>();
}

#[test]
fn statistics_equal_the_model_toy() {
    window::<Toy>();
}

#[test]
fn statistics_of_any_clip_space_bits_add_up_standard() {
    clip_space::<Standard>();
}

#[test]
fn statistics_of_any_clip_space_bits_add_up_small() {
    clip_space::<Small>();
}

#[test]
fn statistics_of_missing_vertices_add_up() {
    check(sizes::STATISTICS, (vec(any::<[i32; 2]>(), 0..5), 0usize..5), |(corners, more)| {
        let vertices = corners.into_iter().map(|[x, y]| {
            Vertex::<Standard>::new(
                into_guard_band::<Standard>(x.into()),
                into_guard_band::<Standard>(y.into()),
                5,
            )
        });
        statistics::of_missing_vertices_add_up(&vertices.collect::<Result<Vec<_>, _>>()?, more)
    });
}
