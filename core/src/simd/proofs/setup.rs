//! Depths and gradients of sixteen triangles.

use super::{
    super::{
        extent::SMALL_EXTENT,
        fetch::{Corner, Records},
        ops,
        setup::{Batch, DepthSetup, Plane, gradient, gradients, half, set_up, unorm16},
    },
    LANES, Vectors, Words, doubles, ints, longs, simd, words,
};
use crate::{
    draw::State,
    geometry::{self, Region, Vertex},
    numbers::{self, DEPTH16_MAX, DEPTH16_MIN, Standard},
    proof::{assume, cover, prove},
};
use fearless_simd::{f64x8, prelude::*};

#[inline(always)]
fn splat(value: f64) -> f64x8<Vectors> {
    f64x8::splat(simd(), value)
}

/// The gradient is the nearest to 2^32 N / D, ties upwards: 2^33 N + D - 2 D q is in [0, 2 D). Of numerators below
/// 2^29, so that 64 bits hold it.
#[inline(always)]
pub(super) fn gradient_is_nearest(numerator: i64, area: i32) {
    let divisor = f64::from(area);
    let word = longs(gradient(simd(), splat(numerator as f64), splat(divisor), splat(1.0 / divisor)))[0];
    let area = i64::from(area);
    let left = (numerator << 33) + area - 2 * area * (word as i64);
    assert!(0 <= left && left < 2 * area);
    cover!(numerator == -5);
}

/// Sixteen times the same corners.
#[inline(always)]
fn corners(places: [[i32; 2]; 3]) -> [Corner<Vectors>; 3] {
    places.map(|[x, y]| Corner { x: ops::splat(simd(), x), y: ops::splat(simd(), y) })
}

prove! {
    /// The depths are counted from the topmost, then leftmost corner.
    [Plane::new, Corner::select]
    fn slow_planes_begin_at_the_topmost_corner(
        places: [[i32; 2]; 3] = [[-SMALL_EXTENT; 2]; 3]..=[[SMALL_EXTENT; 2]; 3],
        depths: [u32; 3],
    ) {
        let depths = depths.map(|z| Words::splat(simd(), z));
        let plane = Plane::new(simd(), corners(places), depths, ops::splat(simd(), 1));
        let (x, y) = (ints(plane.anchor.x)[LANES[1]], ints(plane.anchor.y)[LANES[1]]);
        let mut found = false;
        for ([px, py], depth) in places.into_iter().zip(depths) {
            assert!((y, x) <= (py, px));
            found |= (y, x) == (py, px) && words(plane.depth)[LANES[1]] == words(depth)[LANES[1]];
        }
        assert!(found);
        cover!(places[2][1] == y && places[1][1] == y && places[2][0] < places[1][0]);
    }

    /// A plane's gradients are those of its corners: one step apart to the right and down, of 1024 depths.
    [Plane::new, gradients, gradient]
    fn slow_planes_have_the_gradient_of_their_corners(z: u32 = 0..=1023) {
        let depths = [5000, 5000 + z, 5000 + 2 * z].map(|z| Words::splat(simd(), z));
        let plane = Plane::new(simd(), corners([[0, 0], [1, 0], [0, 1]]), depths, ops::splat(simd(), 1));
        assert!(longs(plane.x[0])[3] == u64::from(z) << 32);
        assert!(longs(plane.y[0])[3] == u64::from(z) << 33);
        cover!(z == 1000);
    }

    /// The bounds of triangles that are set up are the scalar ones, and their pixels are counted from the first block's:
    /// with one corner anywhere near.
    #[kani::unwind(17)]
    [set_up_inline, set_up]
    fn slow_set_up_finds_the_pixels(corner: [i32; 2] = [-1000, 0]..=[3000, 2048]) {
        let Ok(region) = Region::<Standard>::new(4, 0, 12, 8) else { return };
        let places = [[1300, 0], [2048, 100], corner];
        let [Ok(a), Ok(b), Ok(c)] = places.map(|[x, y]| Vertex::<Standard>::new(x, y, 9)) else { return };
        let state = State::new(region);
        let records = Records { places: &places.map(|place| place.map(|v| v as u32)), depths: &[9; 3] };
        let mut batch = Batch::EMPTY;
        let known = set_up(simd(), records, &[[0_u16, 1, 2]; 16], region, &state, DepthSetup::None, &mut batch);
        assert!(known.is_some());
        if let Ok(expected) = geometry::Extent::of([a, b, c]).bounds(state.sample, region) {
            let found = batch.bounds.map(|lanes| lanes[LANES[1]] as u32);
            assert!(found == [expected.x0(), expected.x1(), expected.y0(), expected.y1()]);
            assert!(batch.crossings.first[LANES[1]] == (expected.x0() % 4) as f32);
            assert!(batch.small & batch.medium == 0 && (batch.small | batch.medium) >> LANES[1] & 1 == 1);
            cover!(expected.x0() == 5 && expected.y1() == 3);
        }
    }

    /// Small numerators and areas.
    [gradient]
    fn slow_gradients_of_small_areas(numerator: i64 = -15..=15, area: i32 = 1..=7) {
        gradient_is_nearest(numerator, area);
    }

    /// Each half of eight pairs.
    [half]
    fn halves_are_picked(low: u32, high: u32) {
        for (k, value) in [low, high].into_iter().enumerate() {
            let halves = half(k, [[splat(f64::from(low)), splat(f64::from(high))]; 8]);
            assert!(halves.into_iter().all(|half| doubles(half)[3] == f64::from(value)));
        }
    }

    /// Half a unit of the upper 32 or 16 bits.
    [DepthSetup::half]
    fn half_a_unit_rounds(word: u64) {
        let word = word >> 1;
        let (d32, d16) = (DepthSetup::D32.half(), DepthSetup::D16.half());
        assert!((word + d32) >> 32 == (word >> 32) + (word >> 31 & 1));
        assert!((word + d16) >> 48 == (word >> 48) + (word >> 47 & 1));
    }

    /// A level triangle has no gradient.
    [gradients, gradient]
    fn level_triangles_have_no_gradient(z: u32) {
        let z = splat(f64::from(z));
        let (x, y) = gradients(simd(), [z, z, z, splat(7.0), splat(-300.0), splat(-5.0), splat(2.0), splat(1486.0)]);
        assert!(longs(x)[0] == 0 && longs(y)[0] == 0);
    }

    /// The scalar unorm16, within the vertices' range, in the upper half: for every depth.
    [unorm16, numbers::unorm16]
    fn unorm16_is_the_scalar_one(depth: u32) {
        let expected = numbers::unorm16(depth).clamp(DEPTH16_MIN, DEPTH16_MAX) << 16;
        assert!(words(unorm16(simd(), Words::splat(simd(), depth)))[LANES[1]] == expected);
        cover!(expected == 3 << 16);
        assume!(expected != 2 << 16);
        cover!(depth % 65537 == 32768);
    }
}

/// What no prover finished: for tests alone.
#[cfg(test)]
mod tested {
    use super::*;

    prove! {
        /// Both numerators are exact: depths of 32 bits, differences of corners within the small extent, whose
        /// products are below 2^48. For an area of 1 and depths that differ by one product only.
        []
        fn numerators_are_exact(z: u32, dx: i32 = -15..=15, dy: i32 = -15..=15) {
            let plane = half(0, [0.0, f64::from(z), 0.0, 1.0, 2.0, f64::from(dx), f64::from(dy), 1.0].map(|v| [splat(v); 2]));
            let (x, y) = gradients(simd(), plane);
            let z = i64::from(z);
            assert!(longs(x)[0] == (z * i64::from(dy)).wrapping_shl(32) as u64);
            assert!(longs(y)[0] == (z * i64::from(-dx)).wrapping_shl(32) as u64);
            cover!(longs(y)[0] > 1 << 63);
        }
    }
}
