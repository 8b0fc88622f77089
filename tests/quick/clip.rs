//! Clip-space triangles with few cases: the driver of mutation testing for `transform` (docs/mutants.md). It is
//! compiled for each mutant, so it has few formats and no proptest. `cargo test` does not run it, as it has the
//! same properties with more cases.

use halfplane::{ClipPositions, Cull, D32, DepthTest, Region, Standard, Viewport, Winding};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    Failure, Frame,
    case::Case,
    failure::Verdict,
    properties::{boxes, clipping, draws, neighbours, points, spheres, statistics, transform},
    shapes::{Ground, Kind, Random, clip_bits, clip_triangle},
};

#[path = "../tests/named/camera.rs"]
mod camera;
#[path = "../tests/issues.rs"]
mod issues;
#[path = "../tests/messages.rs"]
mod messages;

/// What costs least comes first.
#[test]
fn properties_hold() -> Verdict {
    let mut random = Random(1);
    for _ in 0..300 {
        let region = viewport(&mut random, 100).region;
        let w = random.between(1, 4000) as f32 / 100.0;
        let [x, y, z] = [0; 3].map(|_: u32| random.between(-1500, 1500) as f32 / 1000.0);
        transform::snapped_is_near_exact::<Standard>([x * w, y * w, z.abs() / 1.5 * w, w], region)?;
        let triangles = [0; 6].map(|_: u32| clip_bits(random.words()));
        for vertex in triangles.as_flattened() {
            transform::any_bits_are_safe::<Standard>(*vertex, region)?;
        }
        statistics::of_clip_space_add_up::<Standard>(&triangles, region)?;
        let matrix = [triangles[0][0], triangles[0][1], triangles[0][2], [0.25, -0.5, 0.5, 1.0]];
        let vertices = triangles[1].map(|[x, y, z, _]| [x, y, z]);
        transform::model_is_its_clip_space::<Standard>(&vertices, matrix, region)?;
    }
    for _ in 0..1000 {
        let frame = viewport(&mut random, 24);
        let triangle = clip_triangle(random.words());
        clipping::pieces_have_one_winding::<Standard>(&frame, &triangle)?;
        neighbours::other_sides_cancel::<Standard>(&frame, &triangle)?;
    }
    for _ in 0..150 {
        let frame = viewport(&mut random, 24);
        clipping::triangle_is_where_the_exact_one_is::<Standard>(&frame, &clip_triangle(random.words()))?;
        let [a, b] = [0; 2].map(|_: u32| clip_bits(random.words()));
        neighbours::other_sides_cancel::<Standard>(&frame, &a)?;
        neighbours::closed_surfaces_cancel::<Standard>(&frame, &[a[0], a[1], a[2], b[0]])?;
        neighbours::closed_surfaces_cancel::<Standard>(&frame, &[a[0], a[1], a[2], b[0]])?;
    }
    thin(&mut random)?;
    volumes(&mut random)?;
    for _ in 0..50 {
        let ground = Ground::from_numbers(random.words(), random.bits());
        clipping::mesh_has_no_seam::<Standard>(&viewport(&mut random, 30), &ground)?;
        brute_force(&mut random)?;
    }
    Ok(())
}

/// Thin triangles of a few steps: after clipping, snapping turns a corner inwards now and then.
fn thin(random: &mut Random) -> Verdict {
    let frame = Frame::whole::<Standard>(32, 32);
    for _ in 0..2000 {
        let mut vertex = || {
            let [x, y] = [0; 2].map(|_: u32| random.between(-30, 29) as f32 / (16 << 8) as f32);
            [x, y, random.between(-5, 5) as f32 / 4.0, 1.0]
        };
        let triangle = [vertex(), vertex(), vertex()];
        clipping::pieces_have_one_winding::<Standard>(&frame, &triangle)?;
    }
    Ok(())
}

/// Boxes and spheres against what is in them.
fn volumes(random: &mut Random) -> Verdict {
    let unit = |random: &mut Random| random.between(-1 << 20, 1 << 20) as f32 / (1 << 20) as f32;
    for round in 0..400 {
        let triangles: Vec<_> =
            (0..random.below(10)).map(|_| (random.bits() as u32, random.words(), random.words())).collect();
        let case = Case::from_numbers(random.words(), random.words(), &triangles, &Kind::ALL);
        let center = [0; 3].map(|_: u32| 40.0 * unit(random));
        let radius = (random.between(-160, 96) as f32 / 16.0).exp2();
        boxes::boxes_bound_what_they_hold(&case)?;
        spheres::spheres_bound_what_they_hold(&case)?;
        spheres::points_of_spheres_are_in_their_bound(
            &case,
            center.map(|v| v / 10.0),
            radius,
            random.bits(),
        )?;
        spheres::spheres_left_out_are_outside(&case, center, radius, random.bits())?;
        points::points_are_in_their_bounds(random.bits())?;
        let low = [0; 3].map(|_: u32| 4.0 * unit(random));
        let extent = [0; 3].map(|_: u32| match random.below(3) {
            0 => 0.0,
            _ => (random.between(-128, 48) as f32 / 16.0).exp2(),
        });
        boxes::points_of_boxes_are_in_their_bound(&case, low, extent, random.bits())?;
        boxes::boxes_are_where_they_are_said_to_be(&case, low, extent, random.bits())?;
        let beside = [0; 4].map(|_: u32| random.between(-8, 8) as i32);
        boxes::rectangles_beside_samples_are_in_their_bound(random.words(), beside, random.words())?;
        let size = [0; 2].map(|_: u32| 1 + random.below(16384) as u32);
        let [x, y, z] = [0; 3].map(|_: u32| unit(random));
        boxes::bounds_of_points_are_tight([1.5 * x, 1.5 * y, z.abs()], size)?;
        let z = 1.0 + 200.0 * z.abs();
        let part = 0.001 + 0.799 * unit(random).abs();
        let turns = [0; 2].map(|_: u32| 4.0 * unit(random));
        spheres::bounds_of_spheres_are_tight([1.5 * x * z, 1.5 * y * z, z], z * part, turns)?;
        spheres::points_before_tiny_matrices_are_in_their_bound((-round as f32 / 20.0).exp2())?;
    }
    boxes::quotients_beyond_floats_are_anywhere()?;
    nowhere()
}

/// What is no sphere, or reaches the eye's plane.
fn nowhere() -> Result<(), Failure> {
    for radius in [1.0, 1.5, f32::INFINITY, f32::NAN, -1.0, -f32::MIN_POSITIVE] {
        spheres::bounds_of_no_spheres_are_anything([0.0, 0.0, 1.0], radius)?;
    }
    for center in [[0.0, 0.0, -3.0], [f32::NAN, 0.0, 1.0], [0.0, f32::INFINITY, 1.0], [0.0, 0.0, f32::NAN]] {
        spheres::bounds_of_no_spheres_are_anything(center, 0.25)?;
    }
    Ok(())
}

fn brute_force(random: &mut Random) -> Verdict {
    let frame = viewport(random, 30);
    let [x0, y0, x1, y1] = frame.region;
    let call = draws::Call {
        frame,
        scissor: frame.region,
        cull: Cull::None,
        front: Winding::Clockwise,
        test: DepthTest::LESS,
        first_id: 7,
        surplus: 0,
        contents: random.bits(),
    };
    let triangles = [0; 8].map(|_: u32| clip_triangle(random.words()));
    let viewport = Viewport::new(Region::new(x0, y0, x1, y1)?);
    let positions = ClipPositions::new(triangles.as_flattened(), viewport);
    let indices: Vec<u16> = (0..24).collect();
    draws::is_brute_force::<Standard, D32, _, _>(&call, &positions, &indices, DepthSpec::D32)
}

/// A viewport anywhere in the target, its scissor all of it, sampled at pixel centres.
fn viewport(random: &mut Random, side: u32) -> Frame {
    let mut numbers: [u32; 12] = random.words();
    (numbers[1], numbers[2]) = (numbers[1] % side, numbers[2] % side);
    let frame = Frame::from_numbers::<Standard>(numbers);
    Frame { scissor: frame.region, sample: [128; 2], ..frame }
}
