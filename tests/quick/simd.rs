//! The vector code with few cases: the driver of mutation testing for `simd` (docs/mutants.md). It is compiled for
//! each mutant, for one vector level and plain arrays. `cargo test` does not run it, as it has the same properties
//! with more cases, at every level.

use halfplane_tests::{
    Failure,
    case::{Case, Numbers},
    ensure,
    failure::Verdict,
    properties::{
        batches, bins,
        cones::{self, Faced},
        definition_path, lanes, lists, meshlets, questions, simd,
    },
    shapes::{Kind, Patch, Random},
};

#[path = "../tests/queue.rs"]
mod queue;

#[path = "../tests/messages.rs"]
mod messages;

#[test]
fn beside_the_eye_is_outside() -> Verdict {
    questions::beside_the_eye_is_outside()
}

#[test]
fn levels_have_names() -> Verdict {
    simd::levels_have_names()
}

/// Every property in each round, so that most mutants fail in the first one.
#[test]
fn properties_hold() -> Verdict {
    let mut random = Random(1);
    let mut met = Faced::default();
    let mut answers = [0; 3];
    for round in 0..60 {
        let random = &mut random;
        let masks = [random.bits() as u16, random.bits() as u16];
        let ramp = random.words().map(|v: u32| v as i32);
        lanes::every_operation_at_every_level(random.words(), random.words(), masks, ramp)?;
        of_meshes(random, round)?;
        if round < 40 {
            let given = of_queries(random, round)?;
            answers.iter_mut().zip(given).for_each(|(sum, count)| *sum += count);
        }
        // Ordinary patches: most have a cone, and are left out where they face away.
        for _ in 0..2 {
            let patch = patch(random, [[-4, -1], [-3, 0], [-4, -2], [-2, 3], [4, 6]]);
            met = met.and(cones::patches_are_their_triangles(&patch, [64, 48])?);
        }
        for _ in 0..5 {
            let patch = patch(random, [[-6, 0], [-10, 0], [-6, -1], [-2, 8], [-9, 7]]);
            cones::patches_are_their_triangles(&patch, [64, 48])?;
        }
    }
    // Each answer is given.
    let asked = answers.iter().sum::<u32>();
    ensure!(answers.iter().all(|&count| count > asked / 50), "{answers:?}");
    ensure!(met.cones[0] > met.cones[1] / 2 && met.left_out > met.facing / 2, "{met:?}");
    batches::clusters_are_small(1000, random.bits())?;
    // Nothing hides anything: questions stop.
    let (_, occlusion) = batches::batches_are_the_mesh(&Case::grid(260))?;
    ensure!(occlusion.hidden_meshlets < 5 && occlusion.meshlets < 200, "{occlusion:?}");
    let (statistics, occlusion) = batches::batches_are_the_mesh(&Case::behind_a_wall(100))?;
    ensure!(statistics.culled.hidden > 10_000, "{statistics}");
    ensure!(occlusion.hidden_batches > 8 && occlusion.hidden_meshlets > 4, "{occlusion:?}");
    Ok(())
}

/// Pictures, of meshes and of meshlets, and errors.
fn of_meshes(random: &mut Random, round: usize) -> Verdict {
    let few = case(random, 40);
    simd::frame_is_the_scalar_one(&few)?;
    meshlets::meshlets_are_the_mesh(&few)?;
    definition_path::frame_is_the_one_of_arrays(&few)?;
    let around = few.around_the_eye(random.bits());
    simd::frame_is_the_scalar_one(&around)?;
    meshlets::meshlets_are_the_mesh(&around)?;
    if round % 10 == 1 {
        let many = case(random, 400);
        simd::frame_is_the_scalar_one(&many)?;
        meshlets::meshlets_are_the_mesh(&many)?;
        meshlets::meshlets_can_be_drawn_alone(1 + random.below(300), random.bits())?;
        meshlets::meshlet_errors(1 + random.below(300), random.bits())?;
        meshlets::single_triangles_are_the_mesh(1 + random.below(100), random.bits())?;
        meshlets::meshlets_say_what_they_hold(1 + random.below(300), random.bits())?;
    }
    let refused = simd::Refused {
        vertices: 3 + random.below(37),
        triangles: 1 + random.below(89),
        at: random.below(1000),
        beyond: random.bits() as u32,
    };
    simd::errors_are_the_scalar_ones(refused)?;
    for _ in 0..2 {
        let grazing = meshlets::Grazing {
            axis: random.below(3),
            upper: random.below(2) == 0,
            scale: random.between(-20, 19) as i32,
            shift: random.between(-10, 23) as i32,
            seed: random.bits(),
        };
        meshlets::grazing_meshlets_are_the_mesh(&grazing)?;
    }
    // Exact positions, all depths, both windings.
    let mut how: [u32; 10] = random.words();
    [how[0], how[1], how[2], how[7]] = [0, 10, 0, 1];
    let kinds = [Kind::Bezout, Kind::Sliver, Kind::Tiny, Kind::OnSamples, Kind::ThroughSamples];
    let case = Case::from_numbers(random.words(), how, &triangles(random, 24), &kinds);
    simd::depths_are_the_scalar_ones(&case)?;
    Ok(())
}

/// Batches, lists, boxes, spheres and cones; how often a box or a sphere was outside, hidden and visible.
fn of_queries(random: &mut Random, round: usize) -> Result<[u32; 3], Failure> {
    let case = if round % 20 == 9 { crowd(random) } else { case(random, 60) };
    let (region, state) = (case.frame.core_region()?, case.state()?);
    bins::binned_is_immediate(&case.positions()?, &case.indices, region, &state, random.bits())?;
    batches::batches_are_the_mesh(&case)?;
    batches::ids_of_batches_are_the_nearest(&case)?;
    let [of_boxes, of_spheres] =
        [questions::answers_are_certain(&case)?, questions::answers_about_spheres_are_certain(&case)?];
    let [outside, hidden, visible] = [0, 1, 2].map(|answer| of_boxes[answer] + of_spheres[answer]);
    batches::clusters_are_the_same_triangles(&case)?;
    batches::short_memory_is_refused(&case)?;
    lists::lists_out_of_sight_change_nothing(&case)?;
    lists::wrong_lists_are_refused(&case)?;
    lists::lists_of_window_triangles_are_asked_about(&case)?;
    cones::meshes_are_their_triangles(&case)?;
    questions::occluders_by_any_name_are_the_same(&case)?;
    Ok([outside, hidden, visible])
}

/// Many large triangles, the nearest wins.
fn crowd(random: &mut Random) -> Case {
    let all: Vec<Numbers> =
        (0..1500).map(|_| (random.bits() as u32, random.words(), random.words())).collect();
    let mut how: [u32; 10] = random.words();
    // Positions as they are wanted, no face culled, nothing drawn before.
    [how[0], how[1], how[2], how[3], how[5]] = [0, 0, 0, 1, 0];
    Case::from_numbers(random.words(), how, &all, &[Kind::Medium, Kind::AxisAligned, Kind::GuardBand])
}

/// A patch with powers between these.
fn patch(random: &mut Random, powers: [[i64; 2]; 5]) -> Patch {
    Patch {
        count: 1 + random.below(39),
        spread: random.below(5) as f64 / 10.0,
        powers: powers.map(|[from, to]| random.between(from, to) as i32),
        cosine: random.between(-1000, 1000) as f64 / 1000.0,
        orthographic: random.below(4) == 0,
        seed: random.bits(),
    }
}

fn triangles(random: &mut Random, most: usize) -> Vec<Numbers> {
    (0..random.below(most + 1)).map(|_| (random.bits() as u32, random.words(), random.words())).collect()
}

fn case(random: &mut Random, most: usize) -> Case {
    Case::from_numbers(random.words(), random.words(), &triangles(random, most), &Kind::ALL)
}
