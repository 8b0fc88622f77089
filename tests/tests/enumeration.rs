//! Lattices enumerated completely; slices of what the example `enumerate` runs whole.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{
    Frame,
    properties::enumeration::{Lattice, every_triangle},
    sizes,
    toy::Toy,
};
#[cfg(feature = "simd")]
use halfplane_tests::{properties::exhaustive::ALL, shapes::Random};

fn enumerate<F: Format>(frame: &Frame, lattice: Lattice) {
    let triangles = every_triangle::<F>(frame, lattice).unwrap();
    let points = (lattice.side * lattice.side) as u64;
    assert_eq!(triangles, points.pow(3));
}

/// Every step of two and a bit pixels, across the corner of four blocks.
#[test]
fn every_triangle_of_a_toy_lattice() {
    let side = sizes::LATTICE.scaled_side();
    let origin = [4 * 4 - side / 2; 2];
    enumerate::<Toy>(&Frame::whole::<Toy>(64, 64), Lattice { origin, side, spacing: 1 });
}

/// The same at every sample position and partly outside the target.
#[test]
fn every_triangle_of_a_toy_lattice_at_every_sample() {
    let side = sizes::LATTICE.scaled_side() / 2 + 1;
    for x in 0..4 {
        for y in 0..4 {
            let frame = Frame { sample: [x, y], ..Frame::whole::<Toy>(64, 64) };
            enumerate::<Toy>(&frame, Lattice { origin: [-2, 14], side, spacing: 1 });
        }
    }
}

/// Corners far apart, so that squares of all levels are crossed; a scissor at odd pixels.
#[test]
fn every_triangle_of_a_wide_lattice() {
    let side = sizes::LATTICE.scaled_side() / 2 + 1;
    let scissor = [1, 2, 63, 61];
    for spacing in [25, 37, 52] {
        let frame = Frame { scissor, ..Frame::whole::<Toy>(64, 64) };
        enumerate::<Toy>(&frame, Lattice { origin: [-5, 3], side, spacing });
    }
}

/// The two ready formats, round a sample.
#[test]
fn every_triangle_round_a_sample_of_the_ready_formats() {
    let side = sizes::LATTICE.scaled_side() / 2 + 2;
    let small = Frame::whole::<Small>(64, 64);
    enumerate::<Small>(&small, Lattice { origin: [15 * 16 + 8 - side / 2; 2], side, spacing: 1 });
    let standard = Frame::whole::<Standard>(64, 64);
    enumerate::<Standard>(&standard, Lattice { origin: [15 * 256 + 128 - side / 2; 2], side, spacing: 1 });
    enumerate::<Standard>(&standard, Lattice { origin: [-100, 700], side, spacing: 2560 });
}

/// The first part, the last, and as many others as there shall be, those with a case.
#[cfg(feature = "simd")]
#[test]
fn slices_of_the_long_enumerations() {
    for enumeration in ALL {
        let run = |part| {
            (enumeration.part)(part)
                .unwrap_or_else(|failure| panic!("{}, part {part}: {failure:?}", enumeration.name))
        };
        run(0);
        run(enumeration.parts - 1);
        let mut random = Random(sizes::seed());
        let others = (0..1000).map(|_| run(random.below(enumeration.parts as usize) as u32));
        let slices = sizes::ENUMERATION.scaled().min(1000) as usize;
        let cases: Vec<u64> = others.filter(|&cases| cases > 0).take(slices).collect();
        println!("{}: {cases:?} cases of {} parts", enumeration.name, enumeration.parts);
        assert_eq!(cases.len(), slices, "{}", enumeration.statement);
    }
}
