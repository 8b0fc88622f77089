//! Conversions of single numbers against exact rationals.

use crate::{ensure_eq, failure::Verdict};
use halfplane::{Bounds, Coordinate, Format, unorm16, unorm32};
use halfplane_reference::{from_f32, snap, unorm};
use num_bigint::BigInt;

/// `unorm32` is the nearest integer to z (2^32 - 1), ties upwards, within its range.
pub fn unorm32_is_nearest(value: f32) -> Verdict {
    let expected = match from_f32(value) {
        Some(exact) => {
            unorm(&exact, 32).clamp(BigInt::from(0), BigInt::from(u32::MAX)).try_into().unwrap_or(0)
        }
        None if value == f32::INFINITY => u32::MAX,
        None => 0,
    };
    ensure_eq!(unorm32(value), expected, "unorm32 of {value:e} ({:#010x})", value.to_bits());
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

/// Snapping gives the nearest step, ties to even, or the guard band's end.
pub fn snap_is_nearest<F: Format>(pixels: f32) -> Verdict {
    let limit = BigInt::from(Bounds::<F>::GUARD_BAND);
    let expected = match from_f32(pixels) {
        Some(exact) => Some(snap(&exact, F::SUBPIXEL_BITS).clamp(-limit.clone(), limit)),
        None if pixels.is_nan() => None,
        None if pixels > 0.0 => Some(limit),
        None => Some(-limit),
    };
    let given = Coordinate::<F>::snap(pixels).map(|coordinate| BigInt::from(coordinate.steps()));
    ensure_eq!(given, expected, "snap of {pixels:e} ({:#010x})", pixels.to_bits());
    Ok(())
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
