//! Window triangles with few cases: the driver of mutation testing for all layers but `transform`
//! (docs/mutants.md). It is compiled for each mutant, so it has few formats and no proptest. `cargo test` does
//! not run it, as it has the same properties with more cases.

use halfplane::{
    Bounds, ClipPositions, Compare, Cull, D16, D32, DepthFormat, DepthTest, Format, Region, Small, Standard,
    State, Vertex, Viewport, Winding, bins::TileOrder,
};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    Frame,
    failure::Verdict,
    properties::{
        bin_lists, bins, boxes, conservative, coverage, depth, depth_test::COMPARISONS, draws, enumeration,
        errors, hierarchical, lanes, numbers, scene, setup, statistics, storage, watertight,
    },
    shapes::{Kind, Random, clip_bits, depths, triangle, triangulation},
    strategies::Shot,
    toy::Toy,
};

#[path = "../tests/attachments.rs"]
mod attachments;
#[path = "../tests/bounds.rs"]
mod bounds;
#[path = "../tests/instances.rs"]
mod instances;
#[path = "../tests/messages.rs"]
mod messages;

/// What costs least comes first.
#[test]
fn properties_hold() -> Verdict {
    let mut random = Random(1);
    of_numbers(&mut random)?;
    of_lanes(&mut random)?;
    of_errors(&mut random)?;
    of_storage::<Standard>(&mut random)?;
    of_bounds::<Standard>(&mut random)?;
    of_bounds::<Small>(&mut random)?;
    for _ in 0..60 {
        let beside = [0; 4].map(|_: u32| random.between(-8, 8) as i32);
        boxes::rectangles_beside_samples_are_in_their_bound(random.words(), beside, random.words())?;
    }
    of_statistics(&mut random)?;
    for kind in Kind::ALL {
        coverage::equals_reference_in_a_long_scissor::<Standard>(&mut random, false, kind)?;
        coverage::equals_reference_in_a_long_scissor::<Standard>(&mut random, true, kind)?;
    }
    of_footprints::<Standard>(&mut random)?;
    of_footprints::<Small>(&mut random)?;
    for kind in Kind::ALL {
        conservative::equals_reference_in_a_long_scissor::<Standard>(&mut random, false, kind)?;
        conservative::equals_reference_in_a_long_scissor::<Standard>(&mut random, true, kind)?;
    }
    of_depth::<Small, D16>(&mut random, DepthSpec::SMALL)?;
    of_depth::<Standard, D32>(&mut random, DepthSpec::D32)?;
    for size in 14..=23 {
        depth::of_a_power_of_two::<Standard, D32>([size, 36 - size], [2, u32::MAX - 2, 77], DepthSpec::D32)?;
    }
    of_draws::<Small, D16>(&mut random, DepthSpec::SMALL, 40)?;
    of_draws::<Standard, D16>(&mut random, DepthSpec::D16, 10)?;
    of_draws::<Standard, D32>(&mut random, DepthSpec::D32, 60)?;
    of_bins(&mut random)?;
    of_hierarchies::<Small, D16>(&mut random, DepthSpec::SMALL)?;
    of_hierarchies::<Standard, D32>(&mut random, DepthSpec::D32)?;
    of_hierarchies::<Standard, D16>(&mut random, DepthSpec::D16)?;
    of_lattices()?;
    of_meshes(&mut random)
}

fn of_numbers(random: &mut Random) -> Verdict {
    for value in numbers::special_floats().chain((0..2000).map(|_| f32::from_bits(random.bits() as u32))) {
        numbers::snap_is_nearest::<Standard>(value)?;
        numbers::snap_is_nearest::<Small>(value)?;
        numbers::unorm32_is_nearest(value)?;
    }
    let end = 2 * Bounds::<Standard>::GUARD_BAND;
    for k in (-600..600).chain(end - 60..end + 60).chain(-end - 60..60 - end) {
        let k = [k, random.between(i64::from(-end), i64::from(end)) as i32];
        for value in k.into_iter().flat_map(numbers::about_half_steps::<Standard>) {
            numbers::snap_is_nearest::<Standard>(value)?;
        }
    }
    for multiple in (0..=u32::MAX).step_by(65_537) {
        for offset in [-32_770, -32_769, -32_768, -1, 0, 1, 32_767, 32_768, 32_769] {
            multiple.checked_add_signed(offset).map_or(Ok(()), numbers::unorm16_is_nearest)?;
        }
    }
    Ok(())
}

fn of_lanes(random: &mut Random) -> Verdict {
    for _ in 0..500 {
        let (a, b) = (random.words(), random.words());
        let masks = [random.bits() as u16, random.bits() as u16];
        let some_equal = std::array::from_fn(|k| if masks[0] >> k & 1 == 0 { a[k] } else { b[k] });
        lanes::every_operation_of_arrays(a, b, masks, random.words().map(|v: u32| v as i32))?;
        lanes::every_operation_of_arrays(a, some_equal, masks, random.words().map(|v: u32| v as i32 % 99))?;
    }
    Ok(())
}

fn of_errors(random: &mut Random) -> Verdict {
    for _ in 0..50 {
        let size = [0; 2].map(|_: u32| 1 + random.below(30) as u32);
        let [triangles, at, beyond] = random.words();
        errors::of_draws::<Small>(errors::Refused { size, triangles: 1 + triangles % 8, at, beyond })?;
        let side = |random: &mut Random| match random.below(3) {
            0 => random.below(5) as u32,
            1 => Small::MAX_TARGET - 2 + random.below(5) as u32,
            _ => random.bits() as u32,
        };
        errors::of_regions::<Small>([0; 4].map(|_: u32| side(random)))?;
        let (x, y) = (random.below(20) as u32, random.below(20) as u32);
        errors::of_storage::<Standard>(x, y, size, at as usize)?;
        errors::of_storage::<Standard>(x & !3, y & !3, size, at as usize)?;
        let coordinate = |random: &mut Random| match random.below(3) {
            0 => random.between(-9, 9) as i32,
            1 => {
                (Bounds::<Small>::GUARD_BAND + random.below(5) as i32 - 2) * (1 - 2 * random.below(2) as i32)
            }
            _ => random.bits() as i32,
        };
        errors::of_vertices::<Small>(coordinate(random), coordinate(random))?;
    }
    (0..4).try_for_each(errors::of_last_ids::<Standard>)
}

fn of_storage<F: Format>(random: &mut Random) -> Verdict {
    for _ in 0..20 {
        let frame = small_frame::<F>(random, 20);
        storage::of_texels::<F>(&frame, random.below(40))?;
        storage::of_bits::<F>(&frame, random.bits())?;
    }
    Ok(())
}

fn of_bounds<F: Format>(random: &mut Random) -> Verdict {
    for _ in 0..300 {
        let frame = small_frame::<F>(random, 40);
        let (_, corners) = random.triangle::<F>(&frame);
        coverage::bounds_are_half_open::<F>(&frame, &corners)?;
        setup::of_triangle::<F>(&frame, &corners, depths(random.words()))?;
        setup::of_regions::<F>([frame.region, frame.scissor])?;
        setup::of_regions::<F>([frame.scissor, small_frame::<F>(random, 40).region])?;
        setup::of_mask(random.bits() as u16, random.bits() as u16)?;
    }
    Ok(())
}

fn of_statistics(random: &mut Random) -> Verdict {
    for _ in 0..40 {
        let frame = small_frame::<Small>(random, 30);
        let shots: Vec<Shot> = (0..8).map(|_| shot::<Small>(random, &frame)).collect();
        let (cull, front) = faces(random);
        statistics::equal_model::<Small>(&frame, &shots, cull, front)?;
        statistics::of_missing_vertices_add_up(&scene::vertices::<Small>(&shots)?, random.below(5))?;
    }
    Ok(())
}

fn of_depth<F: Format, D: DepthFormat<F>>(random: &mut Random, spec: DepthSpec) -> Verdict {
    for _ in 0..100 {
        let frame = small_frame::<F>(random, 20);
        let shot = shot::<F>(random, &frame);
        depth::is_specified_and_bounded::<F, D>(&frame, &shot.corners, shot.z, spec)?;
    }
    Ok(())
}

/// Every texel of coverage, depths and ids.
fn of_draws<F: Format, D: DepthFormat<F>>(random: &mut Random, spec: DepthSpec, cases: u32) -> Verdict
where
    D::Texel: TryFrom<u32>,
{
    for case in 0..cases {
        // Some frames are larger than a tile.
        let frame = small_frame::<F>(random, if case % 4 == 0 { 100 } else { 30 });
        let triangles = 1 + random.below(if case % 4 == 0 { 6 } else { 20 });
        let shots: Vec<Shot> = (0..triangles).map(|_| shot::<F>(random, &frame)).collect();
        let vertices: Vec<Vertex<F>> = scene::vertices::<F>(&shots)?;
        let indices: Vec<u16> = (0..vertices.len() as u16).collect();
        let (cull, front) = faces(random);
        let test = DepthTest { compare: COMPARISONS[random.below(5)], write: random.below(3) > 0 };
        let call = draws::Call {
            frame,
            scissor: frame.scissor,
            cull,
            front,
            test: if random.below(2) == 0 { DepthTest::LESS } else { test },
            first_id: 7,
            surplus: random.below(20),
            contents: random.bits(),
        };
        draws::is_brute_force::<F, D, _, _>(&call, &vertices[..], &indices, spec)?;
    }
    Ok(())
}

fn of_bins(random: &mut Random) -> Verdict {
    bin_lists::what_waits_comes_first(Region::of_size(130, 70)?)?;
    for [triangles, room] in [[0, 3], [1, 0], [7, 0], [7, 3], [7, 7]] {
        bin_lists::rounds_are_counted(triangles, room)?;
    }
    for small in 1..60 {
        for chunks in 1..6 {
            bin_lists::what_did_not_fit_is_gone(small, chunks, small / 2)?;
        }
    }
    for tiles in 2..12 {
        bin_lists::a_diagonal_needs_few_tiles(tiles)?;
    }
    for order in [TileOrder::Rows, TileOrder::Hilbert] {
        for [columns, rows] in [[1, 1], [1, 4], [3, 2], [5, 7], [8, 3], [16, 16]] {
            bin_lists::tiles_come_in_order(columns, rows, order)?;
        }
    }
    for _ in 0..30 {
        let frame = small_frame::<Standard>(random, 90);
        let region = frame.core_region::<Standard>()?;
        bins::errors_change_nothing(region, random.bits())?;
        bin_lists::samples_do_not_mix(region, frame.core_sample()?)?;
        let triangles = [0; 10].map(|_: u32| clip_bits(random.words()));
        let positions = ClipPositions::new(triangles.as_flattened(), Viewport::new(region));
        let indices: Vec<u32> = (0..30).collect();
        bins::binned_is_immediate(
            &positions,
            &indices,
            frame.core_region()?,
            &frame.state()?,
            random.bits(),
        )?;
    }
    for _ in 0..40 {
        // Pieces of clipped triangles in view.
        let mut number = |from: i64, to: i64| random.between(from, to) as f32 / 1000.0;
        let corners = [0; 15]
            .map(|_: u32| [number(-3000, 3000), number(-3000, 3000), number(-500, 1500), number(200, 2000)]);
        let region = Region::<Standard>::of_size(1 + random.below(300) as u32, 1 + random.below(300) as u32)?;
        let positions = ClipPositions::new(&corners, Viewport::new(region));
        let indices: Vec<u32> = (0..15).collect();
        bins::binned_is_immediate(&positions, &indices, region, &State::new(region), random.bits())?;
    }
    for _ in 0..40 {
        let size = [0; 2].map(|_: u32| 1 + random.below(300) as u32);
        let mut frame = Frame::whole::<Standard>(size[0], size[1]);
        let shots: Vec<Shot> = (0..24).map(|_| shot::<Standard>(random, &frame)).collect();
        if random.below(2) == 0 {
            let [x, y] = size.map(|side| random.below(side as usize) as u32);
            frame.scissor = [x, y, x + 1 + random.below((size[0] - x) as usize) as u32, size[1]];
        }
        let vertices = scene::vertices::<Standard>(&shots)?;
        let indices: Vec<u32> = (0..vertices.len() as u32).collect();
        let state = State { cull: faces(random).0, ..frame.state()? };
        bins::binned_is_immediate(&vertices[..], &indices, frame.core_region()?, &state, random.bits())?;
    }
    Ok(())
}

/// Answers about triangles and rectangles against every pixel, and pictures without what is hidden.
fn of_hierarchies<F: Format, D: DepthFormat<F>>(random: &mut Random, spec: DepthSpec) -> Verdict {
    for case in 0..60 {
        let test = DepthTest { compare: COMPARISONS[random.below(5)], write: random.below(4) > 0 };
        let side = if case % 4 == 0 { 150 } else { 40 };
        let frame = small_frame::<F>(random, side);
        let shots: Vec<Shot> = (0..24).map(|_| shot::<F>(random, &frame)).collect();
        hierarchical::answers_are_those_of_the_pixels::<F, D>(
            &frame,
            &shots[..6],
            test,
            spec,
            random.bits(),
        )?;
        hierarchical::hidden_triangles_change_nothing::<F, D>(&frame, &shots, test)?;
        hierarchical::short_memory_is_refused(1 + random.below(200) as u32, 9, random.bits() as usize)?;
    }
    for _ in 0..400 {
        let compare = [Compare::Less, Compare::GreaterEqual][random.below(2)];
        hierarchical::holes_are_found::<F, D>(compare, random.bits())?;
    }
    Ok(())
}

/// Triangles with corners on samples and between them, at all of a toy's sample positions.
fn of_footprints<F: Format>(random: &mut Random) -> Verdict {
    for kind in Kind::ALL.into_iter().chain(Kind::ALL) {
        for side in [9, 40, 99] {
            let frame = small_frame::<F>(random, side);
            let corners = triangle::<F>(kind, &frame, random.words());
            conservative::equals_reference::<F>(&frame, &corners)?;
            conservative::overlaps::<F>(&frame, &corners)?;
            conservative::is_nested::<F>(&frame, &corners)?;
            conservative::rectangles::<F>(&frame, [corners[0], corners[1]])?;
            if side == 9 {
                conservative::equals_definition::<F>(&frame, &corners)?;
            }
        }
    }
    Ok(())
}

fn of_lattices() -> Verdict {
    let frame = Frame { scissor: [1, 2, 63, 61], ..Frame::whole::<Toy>(64, 64) };
    for (origin, spacing) in [([14, 14], 1), ([-4, 4], 4), ([-3, 3], 25)] {
        let lattice = enumeration::Lattice { origin, side: 4, spacing };
        for first in 0..lattice.points() {
            enumeration::every_footprint_from::<Toy>(&frame, lattice, first)?;
        }
    }
    for sample in [[0, 0], [2, 2], [3, 1], [1, 3]] {
        let frame = Frame { sample, scissor: [1, 2, 63, 61], ..Frame::whole::<Toy>(64, 64) };
        for (origin, spacing) in [([14, 14], 1), ([-3, 3], 25), ([-5, -7], 67)] {
            enumeration::every_triangle::<Toy>(&frame, enumeration::Lattice { origin, side: 4, spacing })?;
        }
    }
    Ok(())
}

fn of_meshes(random: &mut Random) -> Verdict {
    for _ in 0..20 {
        let frame = small_frame::<Standard>(random, 90);
        let guard = Bounds::<Standard>::GUARD_BAND;
        let [x, y] = frame.sample_at::<Standard>((frame.scissor[0], frame.scissor[1])).map(|v| v as i32);
        let near = |random: &mut Random| random.between(-2000, 2000) as i32;
        let points: Vec<[i32; 2]> = (0..20).map(|_| [x + near(random), y + near(random)]).collect();
        let mesh = triangulation([-guard, -guard, guard, guard], &points);
        watertight::each_sample_once::<Standard>(&frame, &mesh, random.bits())?;
    }
    Ok(())
}

fn small_frame<F: Format>(random: &mut Random, side: u32) -> Frame {
    let mut numbers: [u32; 12] = random.words();
    (numbers[1], numbers[2]) = (numbers[1] % side, numbers[2] % side);
    Frame::from_numbers::<F>(numbers)
}

fn shot<F: Format>(random: &mut Random, frame: &Frame) -> Shot {
    let kind = Kind::ALL[random.below(Kind::ALL.len())];
    let corners = triangle::<F>(kind, frame, random.words());
    Shot { frame: *frame, kind, corners, z: depths(random.words()) }
}

fn faces(random: &mut Random) -> (Cull, Winding) {
    (
        [Cull::None, Cull::None, Cull::Back, Cull::Front][random.below(4)],
        [Winding::Clockwise, Winding::CounterClockwise][random.below(2)],
    )
}
