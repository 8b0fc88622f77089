//! Depth planes: no overflow, and the bound of their error.

use super::{LAST_SMALL, LAST_STANDARD, SMALL, STANDARD, sample, vertex};
use crate::{
    Format, Small, Standard, Triangle, Vertex,
    geometry::{Plane, doubled_area},
    numbers::{Bounds, DEPTH32_MAX, DEPTH32_MIN, Word, WordArithmetic, unorm16},
    proof::{assume, cover, prove},
};

#[inline(always)]
fn planes<F: Format>(given: [[i32; 2]; 3], depths: [u32; 3], at: [i32; 2], [column, row]: [u32; 2]) {
    let [a, b, c] = given;
    let [za, zb, zc] = depths;
    let (Some(a), Some(b), Some(c)) = (vertex(a, za), vertex(b, zb), vertex(c, zc)) else { return };
    let Some(sample) = sample::<F>(at) else { return };
    // In canonical order, as every triangle is.
    let key = |v: Vertex<F>| (v.y(), v.x());
    assume!(key(a) < key(b) && key(a) < key(c) && doubled_area([a, b, c]) > F::Wide::default());
    let Some(triangle) = Triangle::new([a, b, c], sample) else { return };
    let plane = Plane::new(&triangle, |z| if F::Word::HALF_BITS == 32 { z } else { unorm16(z) });
    let value = plane.at(column, row);
    cover!(value != F::Word::default());
}

/// The value of a depth at a sample: the plane's word at the block's first sample and the word that the
/// sample adds, each rounded to `bits` bits. Their sum is the exact depth but for `error`, in units of the
/// word's last place, modulo the word; the result is within one unit of `bits` bits and the error, and inside
/// the range, though both of its parts may have wrapped.
#[inline(always)]
fn two_roundings(exact: u64, error: i32, offset: u64, bits: u32, depths: [u64; 2]) {
    let unit = 1 << (64 - bits);
    let [least, greatest] = depths;
    assume!(least * unit <= exact && exact <= greatest * unit);
    let limit = 1 << 24;
    assume!(-limit <= error && error <= limit);
    let base = exact.wrapping_add(i64::from(error) as u64).wrapping_sub(offset);
    let depth = base.rounded(bits).wrapping_add(offset.rounded(bits)) & (u32::MAX >> (32 - bits));
    // No sample has the clear values, 0 and the largest.
    assert!(least - 2 < depth.into() && u64::from(depth) < greatest + 2);
    let distance = (u64::from(depth) * unit).wrapping_sub(exact) as i64;
    assert!(distance.unsigned_abs() <= unit + limit as u64);
    cover!(base > exact && distance < 0);
    cover!(u64::from(depth) + 1 == least);
}

prove! {
    /// No overflow in a plane and its value, for all vertices, depths, sample positions and pixels.
    [Plane::new, Plane::at]
    fn planes_of_standard(
        given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3],
        depths: [u32; 3],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_STANDARD; 2],
    ) {
        planes::<Standard>(given, depths, at, pixel);
    }

    /// For the small format, what a plane hands to the division and to its steps: deltas within MAX_DELTA.
    [Plane::new, Plane::at]
    fn steps_of_small_fit(
        given: [i32; 2] = [-SMALL; 2]..=[SMALL; 2],
        other: [i32; 2] = [-SMALL; 2]..=[SMALL; 2],
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: [u32; 2] = [0; 2]..=[LAST_SMALL; 2],
    ) {
        let (Some(a), Some(b)) = (vertex::<Small>(given, 0), vertex::<Small>(other, 0)) else { return };
        let Some(sample) = sample::<Small>(at) else { return };
        let (x, y) = sample.of_pixel(pixel[0], pixel[1]);
        let limit = Bounds::<Small>::MAX_DELTA;
        for delta in [a.x() - b.x(), a.y() - b.y(), x - a.x(), y - a.y()] {
            assert!(-limit <= delta && delta <= limit);
        }
        cover!(a.x() - b.x() == limit);
    }

    /// What a gradient's rounding costs: 2^32 N = g D + r with |r| <= D / 2 (`fraction64_is_nearest`), so one
    /// step more adds half a unit of the last place: after n steps |e| <= n D / 2. At most MAX_DELTA steps in x
    /// and in y make MAX_DELTA units: for `Standard` 2^24, 2^-8 of a depth unit.
    [Plane::at]
    fn a_step_is_off_by_half_a_place(
        error: i64 = -(1 << 62)..=1 << 62,
        residual: i64 = -(1 << 47)..=1 << 47,
        steps: i64 = 0..=i64::from(2 * Bounds::<Standard>::MAX_DELTA),
        area: i64 = 1..=1 << 48,
    ) {
        let (limit, more) = (i128::from(steps) * i128::from(area), i128::from(steps + 1) * i128::from(area));
        assume!(-limit <= 2 * i128::from(error) && 2 * i128::from(error) <= limit);
        assume!(-area <= 2 * residual && 2 * residual <= area);
        let twice = 2 * (i128::from(error) + i128::from(residual));
        assert!(-more <= twice && twice <= more);
        cover!(twice == more);
    }

    /// A covered sample's depth of 32 bits: at most 1 + 2^-8 units off, never a clear value. Its exact value is
    /// between those of the vertices.
    [u64::rounded, Depth::block_with]
    fn depth32_stays_in_range(exact: u64, error: i32, offset: u64) {
        two_roundings(exact, error, offset, 32, [DEPTH32_MIN.into(), DEPTH32_MAX.into()]);
    }

    /// The same of 16 bits.
    [u64::rounded, Depth::block_with]
    fn depth16_stays_in_range(exact: u64, error: i32, offset: u64) {
        two_roundings(exact, error, offset, 16, [2, 0xFFFF - 2]);
    }

    /// The offsets of a block's samples are the rounded multiples of the gradients.
    #[kani::unwind(5)]
    [Plane::offsets]
    fn offsets_are_multiples(
        given: [[i32; 2]; 3] = [[0; 2]; 3]..=[[3; 2]; 3],
        depths: [u32; 3] = [0; 3]..=[7; 3],
        lane: usize = 0..=15,
    ) {
        let [a, b, c] = given;
        let [za, zb, zc] = depths;
        let (Some(a), Some(b), Some(c)) = (vertex(a, za), vertex(b, zb), vertex(c, zc)) else { return };
        let Some(triangle) = Triangle::<Standard>::new([a, b, c], crate::Sample::CENTER) else { return };
        let plane = Plane::new(&triangle, |z| z);
        let (column, row) = (lane as u32 % 4, lane as u32 / 4);
        let above = plane.at(column, row).wrapping_sub(plane.at(0, 0));
        assert!(plane.offsets(32)[lane] == above.rounded(32));
        cover!(above != 0 && lane == 14);
    }
}
