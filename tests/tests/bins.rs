//! Bins of any size against immediate drawing.

use halfplane::{ClipPositions, Cull, Format, Region, Small, Standard, State, Viewport, bins::TileOrder};
use halfplane_tests::{
    Failure, Frame,
    properties::{
        bin_lists::{
            a_diagonal_needs_few_tiles, rounds_are_counted, samples_do_not_mix, tiles_come_in_order,
            what_did_not_fit_is_gone, what_waits_comes_first,
        },
        bins::{Met, binned_is_immediate, errors_change_nothing},
        scene::vertices,
    },
    run::check,
    shapes::clip_bits,
    sizes,
    strategies::{Shot, frame, numbers, scene},
    toy::Toy,
};
use proptest::{collection::vec, prelude::*, sample::select};
use std::cell::Cell;

fn assert_met(met: &Cell<Met>) {
    println!("{:?}", met.get());
    let Met { more_rounds, unbinned, drawn } = met.get();
    assert!(more_rounds > drawn / 100 && unbinned > drawn / 100, "{:?}", met.get());
}

/// Frames of several tiles.
fn large<F: Format>() -> impl Strategy<Value = (Frame, Vec<Shot>)> {
    (scene::<F>(F::MAX_TARGET.min(300), 24), numbers::<12>()).prop_map(|((mut frame, shots), place)| {
        // A scissor, half of the time.
        if place[0] % 2 == 0 {
            let [_, _, width, height] = frame.region;
            let (x, y) = (place[1] % width, place[2] % height);
            frame.scissor = [x, y, x + 1 + place[3] % (width - x), y + 1 + place[4] % (height - y)];
        }
        (frame, shots)
    })
}

fn window<F: Format>() {
    let met = Cell::default();
    let cull = select(vec![Cull::None, Cull::Back, Cull::Front]);
    check(sizes::BINS, (large::<F>(), cull, any::<u64>()), |((frame, shots), cull, seed)| {
        let state = State { cull, ..frame.state::<F>()? };
        let vertices = vertices::<F>(&shots)?;
        let indices: Vec<u32> = (0..vertices.len() as u32).collect();
        let more = binned_is_immediate(&vertices[..], &indices, frame.core_region()?, &state, seed)?;
        met.set(Met::and(met.get(), more));
        Ok(())
    });
    assert_met(&met);
}

#[test]
fn bins_of_window_triangles_are_immediate_standard() {
    window::<Standard>();
}

#[test]
fn bins_of_window_triangles_are_immediate_small() {
    window::<Small>();
}

#[test]
fn bins_of_window_triangles_are_immediate_toy() {
    window::<Toy>();
}

/// Any bits in clip space: what is clipped comes in pieces.
#[test]
fn bins_of_clip_space_are_immediate() {
    let met = Cell::default();
    let triangles = vec(numbers::<13>().prop_map(clip_bits), 1..24);
    check(sizes::BINS, (triangles, frame::<Standard>(), any::<u64>()), |(triangles, frame, seed)| {
        let region = frame.core_region::<Standard>()?;
        let vertices = triangles.as_flattened();
        let positions = ClipPositions::new(vertices, Viewport::new(region));
        let indices: Vec<u32> = (0..vertices.len() as u32).collect();
        let more = binned_is_immediate(&positions, &indices, region, &frame.state()?, seed)?;
        met.set(Met::and(met.get(), more));
        Ok(())
    });
    assert_met(&met);
}

/// Pieces of clipped triangles in view, large ones, over several tiles.
#[test]
fn bins_of_clipped_triangles_are_immediate() {
    let met = Cell::default();
    let corner = (-3.0..3.0f32, -3.0..3.0f32, -0.5..1.5f32, 0.2..2.0f32);
    let vertices = vec(corner.prop_map(|(x, y, z, w)| [x, y, z, w]), 3..30);
    check(sizes::BINS, (vertices, 1..300u32, 1..300u32, any::<u64>()), |(vertices, width, height, seed)| {
        let region = Region::<Standard>::of_size(width, height)?;
        let positions = ClipPositions::new(&vertices, Viewport::new(region));
        let indices: Vec<u32> = (0..vertices.len() as u32 / 3 * 3).collect();
        let more = binned_is_immediate(&positions, &indices, region, &State::new(region), seed)?;
        met.set(Met::and(met.get(), more));
        Ok::<(), Failure>(())
    });
    assert_met(&met);
}

/// Nothing is added, and everything is counted.
#[test]
fn bins_beside_the_viewport_hold_nothing() -> Result<(), Failure> {
    let (region, window) = (Region::<Standard>::of_size(100, 32)?, Region::new(0, 0, 8, 8)?);
    let vertices = [[-0.5, -0.5, 0.5, 1.0], [0.5, -0.5, 0.5, 1.0], [0.0, 0.5, 0.5, 1.0], [f32::NAN; 4]];
    let positions = ClipPositions::new(&vertices, Viewport::new(window));
    let state = State { scissor: Region::new(16, 0, 90, 24)?, ..State::new(region) };
    (0..20).try_for_each(|seed| {
        binned_is_immediate(&positions, &[0, 1, 2, 1, 2, 3], region, &state, seed).map(|_| ())
    })
}

#[test]
fn refused_draws_change_nothing() {
    check(sizes::ERRORS, (frame::<Standard>(), any::<u64>()), |(frame, seed)| {
        errors_change_nothing::<Standard>(frame.core_region()?, seed)
    });
}

#[test]
fn sample_positions_do_not_mix() {
    check(sizes::ERRORS, frame::<Standard>(), |frame| {
        samples_do_not_mix::<Standard>(frame.core_region()?, frame.core_sample()?)
    });
}

#[test]
fn triangles_that_did_not_fit_leave_nothing_behind() {
    check(sizes::BINS, (1..60usize, 1..10usize, 0..60usize), |(small, chunks, between)| {
        what_did_not_fit_is_gone(small, chunks, between)
    });
}

#[test]
fn waiting_triangles_come_first() -> Result<(), Failure> {
    what_waits_comes_first(Region::of_size(130, 70)?)
}

#[test]
fn rounds_are_as_many_as_the_memory_makes_them() -> Result<(), Failure> {
    (0..10).try_for_each(|triangles| (0..6).try_for_each(|room| rounds_are_counted(triangles, room)))
}

#[test]
fn thin_triangles_need_few_tiles() -> Result<(), Failure> {
    (2..20).try_for_each(a_diagonal_needs_few_tiles)
}

#[test]
fn tiles_come_once_and_in_order() -> Result<(), Failure> {
    for order in [TileOrder::Rows, TileOrder::Hilbert] {
        for (columns, rows) in (1..10).flat_map(|x| (1..10).map(move |y| (x, y))).chain([(16, 16)]) {
            tiles_come_in_order(columns, rows, order)?;
        }
    }
    Ok(())
}
