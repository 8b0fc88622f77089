//! Proofs of the number formats.

use super::{
    Bounds, Coordinate, DEPTH16_MAX, Format, Small, Standard, Wide, WideArithmetic, WordArithmetic, unorm16,
    unorm32,
    word::arithmetic::{
        binary_digit, digit, floor_division32, floor_division64, fraction32, fraction64, numerator32,
        numerator64,
    },
};
use crate::proof::{assume, cover, prove};
use core::num::NonZero;

/// 2^`subpixel_bits` times a pixel coordinate to the nearest step by the definition, ties to even: in
/// integers, from the float's bits.
fn nearest_step(bits: u32, subpixel_bits: u32, limit: i64) -> Option<i64> {
    let (exponent, fraction) = (bits >> 23 & 0xFF, i64::from(bits & 0x7F_FFFF));
    if exponent == 0xFF && fraction != 0 {
        return None;
    }
    // |pixels| = significand 2^(exponent - 150); subnormals are less than half a step in any case.
    let significand = fraction | i64::from(exponent != 0) << 23;
    let shift = exponent as i32 - 150 + subpixel_bits as i32;
    let magnitude = match shift {
        24.. => limit,
        0.. => significand << shift,
        -30..0 => {
            let (whole, rest) = (significand >> -shift, significand & ((1 << -shift) - 1));
            let half = 1 << (-shift - 1);
            whole + i64::from(rest > half || (rest == half && whole & 1 != 0))
        }
        _ => 0,
    };
    let magnitude = magnitude.min(limit);
    Some(if bits >> 31 != 0 { -magnitude } else { magnitude })
}

fn snaps_to_nearest<F: Format>(bits: u32) {
    let limit = i64::from(Bounds::<F>::GUARD_BAND);
    let expected = nearest_step(bits, F::SUBPIXEL_BITS, limit);
    let snapped = Coordinate::<F>::snap(f32::from_bits(bits)).map(|c| i64::from(c.steps()));
    assert!(snapped == expected);
    cover!(snapped.is_none());
    cover!(snapped == Some(limit));
    cover!(snapped == Some(-3));
}

fn snaps_in_order<F: Format>(a: f32, b: f32) {
    assume!(a <= b);
    let (a, b) = (Coordinate::<F>::snap(a), Coordinate::<F>::snap(b));
    assert!(a.is_some() && a <= b);
    cover!(a < b);
    cover!(a == b);
}

fn constructs_coordinates<F: Format>(steps: i32) {
    let limit = i64::from(Bounds::<F>::GUARD_BAND);
    match Coordinate::<F>::from_steps(steps) {
        Some(coordinate) => {
            assert!(coordinate.steps() == steps && i64::from(steps).abs() <= limit);
            cover!(i64::from(steps) == -limit);
        }
        None => {
            assert!(i64::from(steps).abs() > limit);
            cover!(true);
        }
    }
}

prove! {
    /// Snapping is rounding to the nearest step, ties to even, for every bit pattern; beyond the guard
    /// band it is the band's end.
    [Coordinate::snap]
    fn snapping_to_standard_is_exact(bits: u32) {
        snaps_to_nearest::<Standard>(bits);
    }

    /// The same for the small format.
    [Coordinate::snap]
    fn snapping_to_small_is_exact(bits: u32) {
        snaps_to_nearest::<Small>(bits);
    }

    /// Snapping keeps the order, saturation and infinities included.
    [Coordinate::snap]
    fn snapping_to_standard_is_monotone(a: u32, b: u32) {
        snaps_in_order::<Standard>(f32::from_bits(a), f32::from_bits(b));
    }

    /// The same for the small format.
    [Coordinate::snap]
    fn snapping_to_small_is_monotone(a: u32, b: u32) {
        snaps_in_order::<Small>(f32::from_bits(a), f32::from_bits(b));
    }

    /// A coordinate is made of exactly the steps within the guard band.
    [Coordinate::from_steps]
    fn coordinates_are_within_the_guard_band(steps: i32) {
        constructs_coordinates::<Standard>(steps);
        constructs_coordinates::<Small>(steps);
    }

    /// Nothing overflows in unorm32, for every bit pattern, and the ends are right. That it is the nearest
    /// integer is enumerated: all 2^32 floats.
    [unorm32]
    fn unorm32_does_not_overflow(bits: u32) {
        let depth = f32::from_bits(bits);
        let unorm = unorm32(depth);
        assert!(depth < 1.0 || depth.is_nan() || unorm == u32::MAX);
        assert!(depth > 0.0 || unorm == 0);
        cover!(unorm == 1);
        cover!(depth.is_nan());
    }

    /// unorm16 is z / 65537 to the nearest integer: no distance is larger than 32768, half of 65537.
    [unorm16]
    fn unorm16_is_exact(depth: u32) {
        let unorm = unorm16(depth);
        assert!(unorm <= 0xFFFF);
        assert!((i64::from(depth) - i64::from(unorm) * 65537).abs() <= 32768);
        cover!(unorm == DEPTH16_MAX);
    }

    /// Products of two factors within `MAX_DELTA` and their sum, and what is left of it in 32 bits where
    /// it fits.
    [i64::product, i64::low32]
    fn wide_products_of_standard_fit(
        a: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
        b: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
        value: i32,
    ) {
        let product = <i64 as WideArithmetic>::product(a, b);
        assert!(i128::from(product).abs() <= Bounds::<Standard>::MAX_AREA && <i64 as Wide>::MAX >= product.into());
        assert!(i64::from(value).low32() == value);
        cover!(i128::from(product) == Bounds::<Standard>::MAX_AREA);
    }

    /// The same for the small format, whose products are 32 bits wide.
    [i32::product, i32::low32]
    fn wide_products_of_small_fit(
        a: i32 = -Bounds::<Small>::MAX_DELTA..=Bounds::<Small>::MAX_DELTA,
        b: i32 = -Bounds::<Small>::MAX_DELTA..=Bounds::<Small>::MAX_DELTA,
        value: i32,
    ) {
        let product = <i32 as WideArithmetic>::product(a, b);
        assert!(i64::from(product) == i64::from(a) * i64::from(b));
        assert!(i128::from(product).abs() <= Bounds::<Small>::MAX_AREA && value.low32() == value);
        cover!(i128::from(product) == Bounds::<Small>::MAX_AREA);
    }

    /// The numerator of a gradient fits, for all depths and deltas that a triangle has.
    [numerator64]
    fn numerators64_fit(
        depths: [u32; 3],
        d1: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
        d2: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
    ) {
        let numerator = numerator64(depths, d1, d2);
        assert!(i128::from(numerator).abs() <= Bounds::<Standard>::MAX_NUMERATOR && numerator.abs() < 1 << 57);
        cover!(numerator < -(1 << 56));
    }

    /// The same for 16 bits of depth.
    [numerator32]
    fn numerators32_fit(
        depths: [u32; 3] = [0; 3]..=[0xFFFF; 3],
        d1: i32 = -Bounds::<Small>::MAX_DELTA..=Bounds::<Small>::MAX_DELTA,
        d2: i32 = -Bounds::<Small>::MAX_DELTA..=Bounds::<Small>::MAX_DELTA,
    ) {
        let (negative, magnitude) = numerator32(depths, d1, d2);
        let [z0, z1, z2] = depths.map(i64::from);
        let exact = (z1 - z0) * i64::from(d1) - (z2 - z0) * i64::from(d2);
        assert!(exact == if negative { -i64::from(magnitude) } else { i64::from(magnitude) });
        assert!(i128::from(magnitude) <= Bounds::<Small>::MAX_NUMERATOR);
        cover!(negative && magnitude > 1 << 31);
    }

    /// No overflow in a gradient of 32.32 words, its parts put together.
    [u64::gradient, fraction64, digit, floor_division64]
    fn gradient64_does_not_overflow(
        depths: [u32; 3],
        d1: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
        d2: i32 = -Bounds::<Standard>::MAX_DELTA..=Bounds::<Standard>::MAX_DELTA,
        area: i64 = 0..=1 << 48,
    ) {
        let word = <u64 as WordArithmetic>::gradient(depths, d1, d2, area);
        assert!(area != 0 || word == 0);
        cover!(word == 1);
        cover!(area == 1 << 48);
    }

    /// Rounding down: n = q d + r with 0 <= r < d.
    [floor_division64]
    fn floor_division64_of_positive(n: u64 = 0..=1 << 57, d: u64 = 1..=1 << 48) {
        let Some(divisor) = NonZero::new(d) else { return };
        let (quotient, remainder) = floor_division64(false, n, divisor);
        assert!(remainder < d && u128::from(quotient) * u128::from(d) + u128::from(remainder) == u128::from(n));
        cover!(remainder == d - 1);
    }

    /// The same of -n: the quotient is negative, modulo 2^64.
    [floor_division64]
    fn floor_division64_of_negative(n: u64 = 0..=1 << 57, d: u64 = 1..=1 << 48) {
        let Some(divisor) = NonZero::new(d) else { return };
        let (quotient, remainder) = floor_division64(true, n, divisor);
        let negated = quotient.wrapping_neg();
        assert!(remainder < d && negated <= n);
        assert!(u128::from(negated) * u128::from(d) == u128::from(n) + u128::from(remainder));
        cover!(n > 0 && remainder == 0);
    }

    /// The same in 32 bits.
    [floor_division32]
    fn floor_division32_of_positive(n: u32, d: u32 = 1..=1 << 30) {
        let Some(divisor) = NonZero::new(d) else { return };
        let (quotient, remainder) = floor_division32(false, n, divisor);
        assert!(remainder < d && u64::from(quotient) * u64::from(d) + u64::from(remainder) == u64::from(n));
        cover!(remainder == d - 1);
    }

    /// The same of -n: the quotient is modulo 2^32.
    [floor_division32]
    fn floor_division32_of_negative(n: u32, d: u32 = 1..=1 << 30) {
        let Some(divisor) = NonZero::new(d) else { return };
        let (quotient, remainder) = floor_division32(true, n, divisor);
        let negated = quotient.wrapping_neg();
        assert!(remainder < d && negated <= n);
        assert!(u64::from(negated) * u64::from(d) == u64::from(n) + u64::from(remainder));
        cover!(n > 0 && remainder == 0);
    }

    /// A fraction of 32 bits is the nearest: f with -d <= 2 (2^32 r - f d) < d; where it is found at once.
    [fraction64]
    fn fraction64_is_nearest_for_small_divisors(r: u64 = 0..=(1 << 32) - 1, d: u64 = 1..=(1 << 32) - 1) {
        assume!(r < d);
        let Some(divisor) = NonZero::new(d) else { return };
        let fraction = fraction64(r, divisor);
        assert!(fraction <= 1 << 32);
        let residual = (i128::from(r) << 32) - i128::from(fraction) * i128::from(d);
        assert!(-i128::from(d) <= 2 * residual);
        assert!(2 * residual < i128::from(d));
        cover!(fraction == 1 << 31);
    }

    /// A digit of 16 bits: 2^16 r = q d + r' with 0 <= r' < d. So after two of them, q and q',
    /// 2^32 r = (2^16 q + q') d + r'.
    [digit]
    fn a_digit_is_exact(r: u64 = 0..=(1 << 48) - 1, d: u64 = 1..=1 << 48) {
        assume!(r < d);
        let Some(divisor) = NonZero::new(d) else { return };
        let (quotient, rest) = digit(r, divisor, 16);
        assert!(quotient < 1 << 16 && rest < d && r << 16 == quotient * d + rest);
        cover!(quotient == (1 << 16) - 1);
    }

    /// One binary digit: 2 r = b d + r' with 0 <= r' < d. So after k digits f, by induction, 2^k r = f d + r'.
    [binary_digit]
    fn a_binary_digit_is_exact(r: u32 = 0..=(1 << 30) - 1, d: u32 = 1..=1 << 30) {
        assume!(r < d);
        let Some(divisor) = NonZero::new(d) else { return };
        let (bit, rest) = binary_digit(r, divisor);
        assert!(rest < d && 2 * u64::from(r) == u64::from(bit) * u64::from(d) + u64::from(rest));
        cover!(bit && rest == d - 2);
    }

    /// Sixteen of them and the rounding: nothing overflows, and the fraction is at most 1.
    #[kani::unwind(17)]
    [fraction32]
    fn fraction32_does_not_overflow(r: u32 = 0..=(1 << 30) - 1, d: u32 = 1..=1 << 30) {
        assume!(r < d);
        let Some(divisor) = NonZero::new(d) else { return };
        let fraction = fraction32(r, divisor);
        assert!(fraction <= 1 << 16);
        cover!(fraction == 1 << 16);
    }

    /// A gradient of 16.16 words of a level axis: its parts put together.
    #[kani::unwind(17)]
    [u32::gradient]
    fn gradient32_does_not_overflow(
        depth: u32 = 0..=0xFFFF,
        d1: i32 = -Bounds::<Small>::MAX_DELTA..=Bounds::<Small>::MAX_DELTA,
        area: i64 = 0..=1,
    ) {
        let word = <u32 as WordArithmetic>::gradient([0, depth, 0], d1, 0, area);
        let expected = if area == 0 { 0 } else { (i64::from(depth) * i64::from(d1)) << 16 };
        assert!(word == expected as u32);
        cover!(word != 0);
    }

    /// Words of 32.32: a depth is its integer part, steps and sums are modulo 2^64, rounding is to the
    /// nearest number of leading bits, modulo its range.
    [u64::from_depth, u64::step, u64::plus, u64::rounded]
    fn words64_are_modular(word: u64, gradient: u64, steps: i32, depth: u32, bits: u32 = 1..=32) {
        let modulus = 1_i128 << 64;
        let sum = i128::from(word) + i128::from(gradient);
        assert!(i128::from(word.plus(gradient)) == sum.rem_euclid(modulus));
        let stepped = word.step(gradient, steps).wrapping_sub(word);
        assert!(stepped == gradient.wrapping_mul(i64::from(steps) as u64));
        assert!(<u64 as WordArithmetic>::from_depth(depth) == u64::from(depth) * (1 << 32));
        let rounded = word.rounded(bits);
        assert!(u64::from(rounded) < 1 << bits);
        // The word lies within half a unit of the number, going round.
        let distance = word.wrapping_sub(u64::from(rounded) << (64 - bits)) as i64;
        let half = 1 << (63 - bits);
        assert!(-half <= distance && distance < half);
        cover!(rounded == 0 && word > 1 << 63);
    }

    /// Words of 16.16: the same.
    [u32::from_depth, u32::step, u32::plus, u32::rounded]
    fn words32_are_modular(word: u32, gradient: u32, steps: i32, depth: u32 = 0..=0xFFFF, bits: u32 = 1..=31) {
        let sum = i64::from(word) + i64::from(gradient);
        assert!(i64::from(word.plus(gradient)) == sum.rem_euclid(1 << 32));
        assert!(word.step(gradient, steps).wrapping_sub(word) == gradient.wrapping_mul(steps as u32));
        assert!(<u32 as WordArithmetic>::from_depth(depth) == depth * (1 << 16));
        let rounded = word.rounded(bits);
        assert!(rounded < 1 << bits);
        let distance = word.wrapping_sub(rounded << (32 - bits)) as i32;
        let half = 1 << (31 - bits);
        assert!(-half <= distance && distance < half);
        cover!(rounded == 0 && word > 1 << 31);
    }
}

/// Every fraction of 16 bits of small divisors is the nearest, ties upwards.
#[cfg(test)]
#[test]
fn every_fraction32_of_small_divisors_is_nearest() {
    for d in 1..=600 {
        for r in 0..d {
            let Some(divisor) = NonZero::new(d) else { continue };
            let exact = (i64::from(r) << 17) + i64::from(d);
            assert_eq!(i64::from(fraction32(r, divisor)), exact.div_euclid(2 * i64::from(d)));
        }
    }
}
