//! Proofs of the number formats.

use super::{Bounds, Coordinate, Format, Small, Standard};
use crate::proof::{cover, prove};

/// 2^S times a pixel coordinate to the nearest step by the definition, ties to even: in integers, from
/// the float's bits.
fn nearest_step(bits: u32, subpixel_bits: u32, limit: i64) -> Option<i64> {
    let (exponent, fraction) = (bits >> 23 & 0xFF, i64::from(bits & 0x7F_FFFF));
    if exponent == 0xFF && fraction != 0 {
        return None;
    }
    // |pixels| = significand 2^(exponent - 150); a subnormal is nothing here.
    let significand = fraction | i64::from(exponent != 0) << 23;
    let shift = exponent as i32 - 150 + subpixel_bits as i32;
    let magnitude = match shift {
        0.. => {
            if shift > 23 {
                limit
            } else {
                significand << shift
            }
        }
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
    let expected = nearest_step(bits, F::SUBPIXEL_BITS, i64::from(Bounds::<F>::GUARD_BAND));
    let snapped = Coordinate::<F>::snap(f32::from_bits(bits)).map(|c| i64::from(c.steps()));
    assert!(snapped == expected);
    cover!(snapped.is_none());
    cover!(snapped == Some(i64::from(Bounds::<F>::GUARD_BAND)));
    cover!(snapped == Some(-3));
}

prove! {
    /// Snapping is rounding to the nearest step, ties to even, for every bit pattern.
    [Coordinate::snap]
    fn snapping_to_standard_is_exact(bits: u32) {
        snaps_to_nearest::<Standard>(bits);
    }

    /// The same for the small format.
    [Coordinate::snap]
    fn snapping_to_small_is_exact(bits: u32) {
        snaps_to_nearest::<Small>(bits);
    }
}
