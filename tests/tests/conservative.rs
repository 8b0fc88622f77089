//! Conservative coverage equals the reference, in every format.

use halfplane::{
    Footprint, Format, Overlap, Region, Small, Standard, Uncertainty, Vertex, traverse_conservative,
};
use halfplane_tests::{
    Frame,
    frame::into_guard_band,
    properties::{
        conservative::{self, UNCERTAINTIES},
        enumeration::{Lattice, every_footprint_from},
    },
    run::check,
    shapes::{Kind, Random, triangle},
    sizes,
    strategies::{Shot, numbers, shot},
    toy::{Middle, Toy},
};
use proptest::{array, prelude::*, sample::select};

/// A triangle of any kind in a frame of a few pixels.
fn small_shot<F: Format>() -> impl Strategy<Value = Shot> {
    let numbers = numbers::<12>().prop_map(|mut numbers| {
        (numbers[1], numbers[2]) = (numbers[1] % 9, numbers[2] % 9);
        numbers
    });
    (numbers, select(Kind::ALL.to_vec()), array::uniform8(any::<u32>())).prop_map(|(frame, kind, numbers)| {
        let frame = Frame::from_numbers::<F>(frame);
        Shot { frame, kind, corners: triangle::<F>(kind, &frame, numbers), z: [9; 3] }
    })
}

fn equals_reference<F: Format>() {
    check(sizes::CONSERVATIVE, shot::<F>(), |Shot { frame, corners, .. }| {
        conservative::equals_reference::<F>(&frame, &corners)
    });
}

fn equals_definition<F: Format>() {
    check(sizes::DEFINITION, small_shot::<F>(), |Shot { frame, corners, .. }| {
        conservative::equals_definition::<F>(&frame, &corners)
    });
}

fn before_snapping<F: Format>() {
    let moved = any::<[[i8; 2]; 3]>();
    check(sizes::DEFINITION, (small_shot::<F>(), moved), |(Shot { frame, corners, .. }, moved)| {
        conservative::holds_before_snapping::<F>(&frame, &corners, moved)
    });
}

fn overlaps<F: Format>() {
    check(sizes::OVERLAP, shot::<F>(), |Shot { frame, corners, .. }| {
        conservative::overlaps::<F>(&frame, &corners)
    });
}

fn nested<F: Format>() {
    check(sizes::OVERLAP, shot::<F>(), |Shot { frame, corners, .. }| {
        conservative::is_nested::<F>(&frame, &corners)
    });
}

fn both_sides<F: Format>() {
    check(sizes::OVERLAP, (shot::<F>(), any::<[i16; 2]>()), |(Shot { frame, corners, .. }, near)| {
        let other = [0, 1].map(|axis| {
            let about =
                i64::from(corners[0][axis]) + i64::from(corners[1][axis]) - i64::from(corners[2][axis]);
            into_guard_band::<F>(about + i64::from(near[axis]))
        });
        conservative::an_edge_is_touched_from_both_sides::<F>(&frame, &corners, other)
    });
}

fn rectangles<F: Format>() {
    check(sizes::OVERLAP, shot::<F>(), |Shot { frame, corners: [p, q, _], .. }| {
        conservative::rectangles::<F>(&frame, [p, q])
    });
}

macro_rules! for_each_format {
    ($($format:ident: $($property:ident $name:ident,)+;)+) => {
        $($(
            #[test]
            fn $name() {
                $property::<$format>();
            }
        )+)+
    };
}

for_each_format! {
    Standard: equals_reference equals_reference_standard, equals_definition equals_definition_standard,
        before_snapping holds_before_snapping_standard, overlaps overlaps_standard, nested is_nested_standard,
        both_sides edges_are_touched_from_both_sides_standard, rectangles rectangles_standard,;
    Small: equals_reference equals_reference_small, equals_definition equals_definition_small,
        before_snapping holds_before_snapping_small, overlaps overlaps_small, nested is_nested_small,
        both_sides edges_are_touched_from_both_sides_small, rectangles rectangles_small,;
    Middle: equals_reference equals_reference_middle, overlaps overlaps_middle, nested is_nested_middle,;
    Toy: equals_reference equals_reference_toy, equals_definition equals_definition_toy,
        before_snapping holds_before_snapping_toy, overlaps overlaps_toy, nested is_nested_toy,
        both_sides edges_are_touched_from_both_sides_toy, rectangles rectangles_toy,;
}

/// Scissors of many tiles in one direction and a few pixels in the other.
#[test]
fn equals_reference_in_long_and_narrow_scissors() {
    check(sizes::LONG, (any::<u64>(), any::<bool>(), select(Kind::ALL.to_vec())), |(seed, tall, kind)| {
        conservative::equals_reference_in_a_long_scissor::<Standard>(&mut Random(seed), tall, kind)
    });
}

fn enumerate<F: Format>(frame: &Frame, lattice: Lattice) {
    let triangles: u64 =
        (0..lattice.points()).map(|first| every_footprint_from::<F>(frame, lattice, first).unwrap()).sum();
    let points = lattice.points() as u64;
    assert_eq!(triangles, points * points * (points + 1) / 2);
}

/// Steps of a pixel and a half each way from the corner of four blocks.
#[test]
fn every_triangle_of_a_toy_lattice() {
    let side = sizes::LATTICE.scaled_side() - 2;
    enumerate::<Toy>(
        &Frame::whole::<Toy>(64, 64),
        Lattice { origin: [4 * 4 - side / 2; 2], side, spacing: 1 },
    );
}

/// The ready formats: steps about a pixel's corner, and pixels' corners themselves, partly outside.
#[test]
fn every_triangle_about_corners_of_the_ready_formats() {
    let side = sizes::LATTICE.scaled_side() / 2 + 2;
    let small = Frame { scissor: [1, 2, 60, 61], ..Frame::whole::<Small>(64, 64) };
    enumerate::<Small>(&small, Lattice { origin: [8 * 16 - side / 2; 2], side, spacing: 1 });
    enumerate::<Small>(&small, Lattice { origin: [-16, -32], side, spacing: 8 });
    let standard = Frame::whole::<Standard>(64, 64);
    enumerate::<Standard>(&standard, Lattice { origin: [32 * 256 - side / 2; 2], side, spacing: 1 });
    enumerate::<Standard>(&standard, Lattice { origin: [-256, 256], side, spacing: 2560 });
}

/// Corners far apart, so that squares of all levels are crossed.
#[test]
fn every_triangle_of_a_wide_lattice() {
    let side = sizes::LATTICE.scaled_side() / 2 + 1;
    for spacing in [24, 37, 52] {
        let frame = Frame { scissor: [1, 2, 63, 61], ..Frame::whole::<Toy>(64, 64) };
        enumerate::<Toy>(&frame, Lattice { origin: [-5, 3], side, spacing });
    }
}

/// The pixels that a triangle touches, and those inside it, row by row, in a target of 8 x 8 pixels.
fn picture(corners: [[i32; 2]; 3], uncertainty: Uncertainty) -> [Vec<(u32, u32)>; 2] {
    let vertices = corners.map(|[x, y]| Vertex::<Small>::new(x, y, 9).unwrap());
    let footprint = Footprint::new(vertices, uncertainty);
    let mut pictures = [Vec::new(), Vec::new()];
    traverse_conservative(&footprint, Region::of_size(8, 8).unwrap(), |x, y, touched, inside| {
        for (picture, mask) in pictures.iter_mut().zip([touched, inside]) {
            picture.extend(mask.cells().map(|(column, row)| (y + row, x + column)));
        }
    });
    pictures.map(|mut picture| {
        picture.sort_unstable();
        picture.into_iter().map(|(y, x)| (x, y)).collect()
    })
}

/// Columns and rows, both ends included.
fn block([x0, x1]: [u32; 2], [y0, y1]: [u32; 2]) -> Vec<(u32, u32)> {
    (y0..=y1).flat_map(|y| (x0..=x1).map(move |x| (x, y))).collect()
}

/// A rectangle of two triangles, from (2, 1) to (5, 4) px: it touches its own pixels and those that begin where it
/// ends, right of it and below it; it holds its own that the diagonal does not cut, together.
#[test]
fn a_pixel_aligned_rectangle_touches_the_pixels_where_it_ends() {
    let [a, b, c, d] = [[32, 16], [80, 16], [80, 64], [32, 64]];
    let [upper, lower] = [[a, b, c], [a, c, d]].map(|corners| picture(corners, Uncertainty::None));
    let mut touched = [upper[0].clone(), lower[0].clone()].concat();
    touched.sort_unstable_by_key(|&(x, y)| (y, x));
    touched.dedup();
    assert_eq!(touched, block([2, 5], [1, 4]));
    assert_eq!(upper[1], [(3, 1), (4, 1), (4, 2)]);
    assert_eq!(lower[1], [(2, 2), (2, 3), (3, 3)]);
    // The pixels of the diagonal are touched by both, and so is the one at its end; those beside it by one, but
    // for those above it, which end at it: the lower triangle has none of their points.
    for (x, y) in [(2, 1), (3, 2), (4, 3), (5, 4)] {
        assert!(upper[0].contains(&(x, y)) && lower[0].contains(&(x, y)));
    }
    assert!(upper[0].contains(&(3, 1)) && !lower[0].contains(&(3, 1)));
    assert!(lower[0].contains(&(2, 2)) && !upper[0].contains(&(2, 2)));
    // Before snapping it may have reached the pixels left of it and above it.
    let [upper, lower] = [[a, b, c], [a, c, d]].map(|corners| picture(corners, Uncertainty::HalfStep));
    let mut touched = [upper[0].clone(), lower[0].clone()].concat();
    touched.sort_unstable_by_key(|&(x, y)| (y, x));
    touched.dedup();
    assert_eq!(touched, block([1, 5], [0, 4]));
    assert!(upper[1].is_empty() && lower[1].is_empty());
}

/// A point on the corner of four pixels is in the one below and to the right; before snapping it may have been in
/// any.
#[test]
fn a_point_on_a_corner_touches_one_pixel() {
    assert_eq!(picture([[48, 32]; 3], Uncertainty::None), [vec![(3, 2)], vec![]]);
    assert_eq!(picture([[48, 32]; 3], Uncertainty::HalfStep), [block([2, 3], [1, 2]), vec![]]);
    assert_eq!(picture([[47, 31]; 3], Uncertainty::None), [vec![(2, 1)], vec![]]);
    assert_eq!(picture([[47, 31]; 3], Uncertainty::HalfStep), [vec![(2, 1)], vec![]]);
    assert_eq!(picture([[49, 33]; 3], Uncertainty::HalfStep), [vec![(3, 2)], vec![]]);
}

/// A horizontal segment on the border of two rows is in the lower one; a vertical one in the right column.
#[test]
fn a_segment_on_a_border_touches_one_side() {
    assert_eq!(picture([[20, 32], [64, 32], [40, 32]], Uncertainty::None), [block([1, 4], [2, 2]), vec![]]);
    assert_eq!(picture([[20, 32], [63, 32], [63, 32]], Uncertainty::None), [block([1, 3], [2, 2]), vec![]]);
    assert_eq!(picture([[32, 20], [32, 64], [32, 40]], Uncertainty::None), [block([2, 2], [1, 4]), vec![]]);
    assert_eq!(
        picture([[20, 32], [63, 32], [63, 32]], Uncertainty::HalfStep),
        [block([1, 3], [1, 2]), vec![]]
    );
}

/// A diagonal segment through corners: from the top left it leaves a pixel at the corner that belongs to the next
/// one; from the bottom left it passes by the corners of pixels on both sides, one of which has them.
#[test]
fn a_diagonal_segment_passes_the_pixels_that_have_its_points() {
    let falling = [[16, 16], [64, 64], [64, 64]];
    assert_eq!(picture(falling, Uncertainty::None)[0], [(1, 1), (2, 2), (3, 3), (4, 4)]);
    let rising = [[16, 64], [64, 16], [64, 16]];
    let expected = [(4, 1), (3, 2), (2, 3), (1, 4), (3, 1), (2, 2), (1, 3)];
    let mut expected = expected.to_vec();
    expected.sort_unstable_by_key(|&(x, y)| (y, x));
    assert_eq!(picture(rising, Uncertainty::None)[0], expected);
}

/// A triangle that touches a tile with a corner only, one that covers it exactly, one step less, and one in it.
#[test]
fn a_triangle_and_a_tile() {
    let tile = Region::<Standard>::new(64, 64, 128, 128).unwrap();
    let overlap = |corners: [[i32; 2]; 3], uncertainty| {
        let vertices = corners.map(|[x, y]| Vertex::new(x, y, 9).unwrap());
        Footprint::new(vertices, uncertainty).overlap(tile)
    };
    let px = 256;
    // Two sides on the tile's left and top, the third through its far corner; then a step less.
    let exact = |by| [[64 * px, 64 * px], [192 * px - by, 64 * px], [64 * px, 192 * px - by]];
    assert_eq!(overlap(exact(0), Uncertainty::None), Overlap::Covers);
    assert_eq!(overlap(exact(0), Uncertainty::HalfStep), Overlap::Partial);
    assert_eq!(overlap(exact(1), Uncertainty::None), Overlap::Partial);
    let more = [[64 * px - 1, 64 * px - 1], [192 * px + 2, 64 * px - 1], [64 * px - 1, 192 * px + 2]];
    assert_eq!(overlap(more, Uncertainty::HalfStep), Overlap::Covers);
    // Left of the tile, with a corner on its left side; and right of it, on its right side.
    let left = |x| [[10 * px, 70 * px], [x, 90 * px], [10 * px, 110 * px]];
    assert_eq!(overlap(left(64 * px), Uncertainty::None), Overlap::Partial);
    assert_eq!(overlap(left(64 * px - 1), Uncertainty::None), Overlap::Outside);
    assert_eq!(overlap(left(64 * px - 1), Uncertainty::HalfStep), Overlap::Outside);
    let right = |x| [[200 * px, 70 * px], [x, 90 * px], [200 * px, 110 * px]];
    assert_eq!(overlap(right(128 * px), Uncertainty::None), Overlap::Outside);
    assert_eq!(overlap(right(128 * px), Uncertainty::HalfStep), Overlap::Partial);
    assert_eq!(overlap(right(128 * px - 1), Uncertainty::None), Overlap::Partial);
    // Past the far corner, which belongs to another tile: bounds overlap, nothing is touched.
    let past = |by| [[192 * px - by, 64 * px], [64 * px, 192 * px - by], [192 * px, 192 * px]];
    assert_eq!(overlap(past(0), Uncertainty::None), Overlap::Outside);
    assert_eq!(overlap(past(0), Uncertainty::HalfStep), Overlap::Partial);
    assert_eq!(overlap(past(1), Uncertainty::None), Overlap::Partial);
    for uncertainty in UNCERTAINTIES {
        assert_eq!(overlap([[65 * px, 65 * px]; 3], uncertainty), Overlap::Within);
    }
    assert_eq!(overlap([[64 * px, 64 * px]; 3], Uncertainty::None), Overlap::Within);
    assert_eq!(overlap([[64 * px, 64 * px]; 3], Uncertainty::HalfStep), Overlap::Partial);
    assert_eq!(overlap([[128 * px, 65 * px]; 3], Uncertainty::None), Overlap::Outside);
}
