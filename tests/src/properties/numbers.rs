//! Conversions of single numbers.
//!
//! Each is held against exact rounding in integers, from a float's bits: fast enough for every bit pattern. That
//! rounding is itself held against the reference's rationals.

use crate::{Failure, ensure, ensure_eq, failure::Verdict};
use halfplane::{Bounds, Coordinate, Format, unorm16, unorm32};
use halfplane_reference::{from_f32, snap, unorm};
use num_bigint::BigInt;
use std::ops::RangeInclusive;

/// Sign, significand and exponent of a finite float: its magnitude is significand 2^exponent.
fn parts(bits: u32) -> (bool, u64, i32) {
    let (exponent, mantissa) = (bits >> 23 & 0xFF, u64::from(bits & 0x7F_FFFF));
    let (exponent, significand) = if exponent == 0 { (1, mantissa) } else { (exponent, mantissa | 1 << 23) };
    (bits >> 31 != 0, significand, exponent as i32 - 150)
}

fn is_finite(bits: u32) -> bool {
    bits >> 23 & 0xFF != 0xFF
}

fn is_nan(bits: u32) -> bool {
    !is_finite(bits) && bits & 0x7F_FFFF != 0
}

/// The step nearest to so many pixels, ties to even, or the guard band's end; `None` for NaN. In integers.
pub fn nearest_step<F: Format>(pixels: f32) -> Option<i32> {
    let bits = pixels.to_bits();
    let end = Bounds::<F>::GUARD_BAND;
    if is_nan(bits) {
        return None;
    }
    let (negative, significand, exponent) = parts(bits);
    let exponent = exponent + F::SUBPIXEL_BITS as i32;
    let magnitude = if !is_finite(bits) || exponent > 31 && significand != 0 {
        u64::MAX
    } else if exponent >= 0 {
        significand << exponent.min(31)
    } else if exponent < -25 {
        0 // significand < 2^24
    } else {
        let (whole, rest) = (significand >> -exponent, significand & ((1 << -exponent) - 1));
        let half = 1 << (-exponent - 1);
        whole + u64::from(rest > half || rest == half && whole % 2 == 1)
    };
    let steps = if magnitude > end as u64 { end } else { magnitude as i32 };
    Some(if negative { -steps } else { steps })
}

/// Snapping gives the [nearest step](nearest_step).
pub fn snap_is_nearest<F: Format>(pixels: f32) -> Verdict {
    let given = Coordinate::<F>::snap(pixels).map(Coordinate::steps);
    ensure_eq!(given, nearest_step::<F>(pixels), "snap of {pixels:e} ({:#010x})", pixels.to_bits());
    Ok(())
}

/// The nearest step is the reference's.
pub fn nearest_step_is_the_reference_s<F: Format>(pixels: f32) -> Verdict {
    let limit = BigInt::from(Bounds::<F>::GUARD_BAND);
    let expected = match from_f32(pixels) {
        Some(exact) => Some(snap(&exact, F::SUBPIXEL_BITS).clamp(-limit.clone(), limit)),
        None if pixels.is_nan() => None,
        None if pixels > 0.0 => Some(limit),
        None => Some(-limit),
    };
    let given = nearest_step::<F>(pixels).map(BigInt::from);
    ensure_eq!(given, expected, "nearest step to {pixels:e} ({:#010x})", pixels.to_bits());
    Ok(())
}

/// Whether `given` is the integer nearest to z (2^32 - 1), ties upwards, within its range: 0 for NaN. In
/// integers, from the definition.
pub fn is_nearest_unorm32(depth: f32, given: u32) -> bool {
    const ONE: u32 = 0x3F80_0000;
    let bits = depth.to_bits();
    let (negative, significand, exponent) = parts(bits);
    if negative || is_nan(bits) {
        return given == 0;
    }
    if bits >= ONE {
        return given == u32::MAX;
    }
    // Twice the product of z and 2^32 - 1 is doubled 2^exponent, and below 2^57 2^exponent.
    let doubled = i128::from(significand) * 2 * i128::from(u32::MAX);
    if exponent < -60 {
        return given == 0;
    }
    let scaled = |doubled: i128| doubled << -exponent;
    let doubled_given = 2 * i128::from(given);
    scaled(doubled_given - 1) <= doubled && doubled < scaled(doubled_given + 1)
}

/// `unorm32` is the [nearest integer](is_nearest_unorm32).
pub fn unorm32_is_nearest(depth: f32) -> Verdict {
    let given = unorm32(depth);
    ensure!(
        is_nearest_unorm32(depth, given),
        "unorm32 of {depth:e} ({:#010x}) is {given}, not the nearest",
        depth.to_bits()
    );
    Ok(())
}

/// The nearest integer is the reference's, and neither of its neighbours is the nearest.
pub fn nearest_unorm32_is_the_reference_s(depth: f32) -> Verdict {
    let expected = match from_f32(depth) {
        Some(exact) => {
            unorm(&exact, 32).clamp(BigInt::from(0), BigInt::from(u32::MAX)).try_into().unwrap_or(0)
        }
        None if depth == f32::INFINITY => u32::MAX,
        None => 0,
    };
    for (value, nearest) in
        [(Some(expected), true), (expected.checked_sub(1), false), (expected.checked_add(1), false)]
    {
        let given = value.map(|value| is_nearest_unorm32(depth, value));
        ensure!(given.is_none_or(|given| given == nearest), "{value:?} nearest to {depth:e}: {given:?}");
    }
    Ok(())
}

/// `unorm16` is the integer nearest to z 65535 / (2^32 - 1).
pub fn unorm16_is_nearest(depth: u32) -> Verdict {
    // Twice the distance to the integer before and after decides; ties cannot be.
    let (whole, scaled) = (u64::from(u32::MAX), u64::from(depth) * 65_535);
    let expected = ((2 * scaled + whole) / (2 * whole)) as u32;
    ensure_eq!(unorm16(depth), expected, "unorm16 of {depth}");
    Ok(())
}

/// The bits of the float of that number in the order of the numbers: negative NaNs, -inf, ..., -0, 0, ..., inf,
/// NaNs.
const fn ordered(number: u32) -> f32 {
    f32::from_bits(if number >> 31 != 0 { number ^ 1 << 31 } else { !number })
}

/// How many parts the 2^32 numbers are in.
pub const PARTS: u32 = 1 << 12;

fn numbers(part: u32) -> RangeInclusive<u32> {
    let first = part * (u32::MAX / PARTS + 1);
    first..=first + u32::MAX / PARTS
}

/// Every float of a part is snapped to the nearest step, and not below the one before it. Returns how many.
pub fn every_snap<F: Format>(part: u32) -> Result<u64, Failure> {
    let floats = numbers(part);
    let mut before = floats.start().checked_sub(1).and_then(|number| Coordinate::<F>::snap(ordered(number)));
    for number in floats.clone() {
        let pixels = ordered(number);
        snap_is_nearest::<F>(pixels)?;
        let snapped = Coordinate::<F>::snap(pixels);
        ensure!(
            before.is_none() || snapped.is_none() || before <= snapped,
            "snap of {pixels:e} is {snapped:?}, but {before:?} of the float before it"
        );
        before = snapped;
    }
    Ok(u64::from(floats.end() - floats.start()) + 1)
}

/// Every float of a part as unorm32, and not below the one before it. Returns how many.
pub fn every_unorm32(part: u32) -> Result<u64, Failure> {
    let floats = numbers(part);
    let mut before = 0;
    for number in floats.clone() {
        let depth = ordered(number);
        unorm32_is_nearest(depth)?;
        let given = unorm32(depth);
        ensure!(
            depth.is_nan() || before <= given,
            "unorm32 of {depth:e} is below that of the float before it"
        );
        before = given;
    }
    Ok(u64::from(floats.end() - floats.start()) + 1)
}

/// Every 32-bit depth of a part as unorm16. Returns how many.
pub fn every_unorm16(part: u32) -> Result<u64, Failure> {
    let depths = numbers(part);
    depths.clone().try_for_each(unorm16_is_nearest)?;
    Ok(u64::from(depths.end() - depths.start()) + 1)
}

/// Every exponent and sign with the mantissas where rounding turns: 0, 1, a single bit, all but one.
pub fn special_floats() -> impl Iterator<Item = f32> {
    let mantissas = (0..23).flat_map(|bit| {
        let one = 1u32 << bit;
        [one, one - 1, one + 1, 0x7F_FFFF ^ one, 0x40_0000 | one]
    });
    let mantissas: Vec<u32> = mantissas.map(|mantissa| mantissa & 0x7F_FFFF).collect();
    (0..512u32).flat_map(move |exponent| {
        mantissas.clone().into_iter().map(move |mantissa| f32::from_bits(exponent << 23 | mantissa))
    })
}

/// Floats at and about half steps of a format, where snapping ties: `k` halves of a step, and the
/// floats next to it.
pub fn about_half_steps<F: Format>(k: i32) -> [f32; 3] {
    let value = k as f32 / (2 * Bounds::<F>::STEPS_PER_PIXEL) as f32;
    [value, value.next_up(), value.next_down()]
}
