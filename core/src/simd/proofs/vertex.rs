//! The vertex stage.

use super::{
    super::vertex::{
        PLANES, SPECIAL, Snapped, VertexLanes, frustum_code, snap, snap_one, split, stage, transpose3,
        unorm32,
    },
    Floats, LANES, floats, ints, simd, words,
};
use crate::{
    geometry::Region,
    numbers::{self, Bounds, Coordinate, DEPTH32_MAX, DEPTH32_MIN, Standard},
    proof::{assume, cover, prove},
    transform::{ModelPositions, Plane, Viewport},
};
use fearless_simd::prelude::*;

prove! {
    /// The scalar snapping: for every float within the guard band.
    [snap, Coordinate::snap]
    fn snapping_is_the_scalar_one(bits: u32) {
        let pixels = f32::from_bits(bits);
        let in_the_band = pixels.abs() <= 32768.0;
        assume!(in_the_band);
        let steps = ints(snap(simd(), Floats::splat(simd(), pixels)))[LANES[1]];
        assert!(Coordinate::<Standard>::snap(pixels).is_some_and(|c| c.steps() == steps));
        cover!(steps == Bounds::<Standard>::GUARD_BAND);
        cover!(steps == -1);
    }

    /// A bit for each plane of the frustum that excludes a finite vertex; none for another.
    [frustum_code, bit, Plane::excludes]
    fn codes_are_planes(bits: [u32; 4]) {
        let vertex = bits.map(f32::from_bits);
        let code = ints(frustum_code(simd(), vertex.map(|v| Floats::splat(simd(), v))))[LANES[1]];
        let finite = vertex.iter().all(|v| v.is_finite());
        for (at, plane) in Plane::FRUSTUM.into_iter().enumerate() {
            assert!(code >> at & 1 == i32::from(finite && plane.excludes(vertex)));
        }
        assert!(code & !PLANES == SPECIAL && code >> Plane::FRUSTUM.len() & 1 == 0);
        cover!(finite && code & PLANES == 1);
    }

    /// The scalar path puts the same code where a vertex has no place, and places inside the guard band.
    [snap_one, Viewport::project]
    fn slow_places_and_codes_are_apart(bits: [u32; 4]) {
        let vertex = bits.map(f32::from_bits);
        let Ok(region) = Region::of_size(64, 64) else { return };
        let viewport = Viewport::new(region);
        let planes = Plane::clipping(viewport.guard_band());
        let ([x, y], z) = snap_one(vertex, &viewport, &planes);
        let finite = vertex.iter().all(|v| v.is_finite());
        if (x as i32) <= SPECIAL + PLANES {
            for (at, plane) in Plane::FRUSTUM.into_iter().enumerate() {
                assert!(x >> at & 1 == u32::from(finite && plane.excludes(vertex)));
            }
            assert!(y == 0 && z == 0);
        } else {
            let band = Bounds::<Standard>::GUARD_BAND as u32;
            assert!((x as i32).unsigned_abs() <= band && (y as i32).unsigned_abs() <= band);
            assert!((DEPTH32_MIN..=DEPTH32_MAX).contains(&z));
            assert!(finite && !planes.iter().any(|plane| plane.excludes(vertex)));
        }
        cover!(x == SPECIAL as u32 | 1);
        cover!(x == 256 && y == 512);
    }

    /// x, y and z of each position come to its lane.
    #[kani::unwind(17)]
    [transpose3, transpose4, load, join]
    fn positions_are_transposed(bits: [[u32; 3]; 16]) {
        let positions = bits.map(|bits| bits.map(f32::from_bits));
        let [x, y, z] = transpose3(simd(), &positions).map(floats);
        for (lane, bits) in bits.into_iter().enumerate() {
            assert!([x[lane].to_bits(), y[lane].to_bits(), z[lane].to_bits()] == bits);
        }
    }

    /// Depths are in the vertices' range, whatever the bits.
    [unorm32]
    fn depths_are_in_the_vertices_range(bits: u32) {
        let depth = words(unorm32(simd(), Floats::splat(simd(), f32::from_bits(bits))))[LANES[1]];
        assert!((DEPTH32_MIN..=DEPTH32_MAX).contains(&depth));
    }

    /// Vertices without a w have no place, whatever their coordinates.
    #[kani::unwind(17)]
    [VertexLanes::new, VertexLanes::sixteen]
    fn vertices_without_w_have_no_place(bits: [u32; 3]) {
        let Ok(region) = Region::of_size(64, 64) else { return };
        let source = ModelPositions::new(&[], [[0.0; 4]; 4], Viewport::new(region));
        let position = bits.map(|bits| Floats::splat(simd(), f32::from_bits(bits)));
        let (mut places, mut depths) = ([[0; 2]; 16], [0; 16]);
        VertexLanes::new(simd(), &source).sixteen(simd(), position, &mut places, &mut depths);
        for lane in LANES {
            assert!((places[lane][0] as i32) <= SPECIAL + PLANES);
            assert!((DEPTH32_MIN..=DEPTH32_MAX).contains(&depths[lane]));
        }
    }

    /// Of seventeen vertices the first sixteen and the last one are all staged, and the same where they are the same:
    /// without a w, whatever their coordinates.
    #[kani::unwind(18)]
    [stage, snap_one, VertexLanes::sixteen]
    fn slow_all_vertices_are_staged(bits: [u32; 3]) {
        let Ok(region) = Region::of_size(64, 64) else { return };
        let positions = [bits.map(f32::from_bits); 17];
        let source = ModelPositions::new(&positions, [[0.0; 4]; 4], Viewport::new(region));
        let (mut places, mut depths) = ([[0; 2]; 17], [0; 17]);
        stage(simd(), &source, &mut places, &mut depths);
        assert!((places[16][0] as i32) <= SPECIAL + PLANES);
        for lane in LANES {
            assert!(places[lane][0] == places[16][0]);
        }
        cover!(places[16][0] == SPECIAL as u32);
    }

    /// Scratch memory is split into a place and a depth for each vertex.
    [split]
    fn records_are_split(count: usize = 0..=4) {
        let mut records = [Snapped::default(); 4];
        let Some(records) = records.get_mut(..count) else { return };
        let (places, depths) = split(records);
        assert!(places.len() == count && depths.len() == count);
        cover!(count == 4);
    }
}

/// What no prover finished: for tests alone.
#[cfg(test)]
mod tested {
    use super::*;

    prove! {
        /// The scalar depth, within the vertices' range: for every float from 0 to 1.
        []
        fn unorm32_is_the_scalar_one(bits: u32) {
            let depth = f32::from_bits(bits);
            assume!((0.0..=1.0).contains(&depth));
            let expected = numbers::unorm32(depth).clamp(DEPTH32_MIN, DEPTH32_MAX);
            assert!(words(unorm32(simd(), Floats::splat(simd(), depth)))[LANES[1]] == expected);
            cover!(expected == DEPTH32_MAX);
            cover!(expected == 3);
        }

        /// Places, codes and depths are those of the scalar path: for vertices about the guard band, and about the
        /// planes of the frustum.
        []
        fn vertices_are_the_scalar_ones(
            places: [i32; 2] = [-40_000; 2]..=[40_000; 2],
            near: [i32; 2] = [-1100; 2]..=[1100; 2],
            far: bool,
            z: i32 = -20..=1100,
            w: i32 = -2..=1024,
        ) {
            let Ok(region) = Region::new(8, 16, 72, 48) else { return };
            let [x, y] = if far { places.map(|v| v as f32 / 16.0) } else { near.map(|v| v as f32 / 64.0) };
            let (z, w) = (z as f32 / 64.0, w as f32 / 64.0);
            let matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, w]];
            let viewport = Viewport::new(region);
            let source = ModelPositions::new(&[], matrix, viewport);
            let planes = Plane::clipping(viewport.guard_band());
            let ([expected_x, expected_y], expected_z) = snap_one([x, y, z, w], &viewport, &planes);
            let (mut places, mut depths) = ([[0; 2]; 16], [0; 16]);
            let position = [x, y, z].map(|v| Floats::splat(simd(), v));
            VertexLanes::new(simd(), &source).sixteen(simd(), position, &mut places, &mut depths);
            let special = (expected_x as i32) <= SPECIAL + PLANES;
            for lane in LANES {
                assert!(places[lane][0] == expected_x);
                assert!(special || (places[lane][1], depths[lane]) == (expected_y, expected_z));
            }
            cover!(special && far);
            cover!(!special && expected_z == 1 << 31);
        }
    }
}
