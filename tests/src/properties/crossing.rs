//! Comparing a rounded crossing with whole pixels is exact.
//!
//! An edge with a change of `a` (not 0) for a pixel to the right and the value F = e + 1/2 at the first
//! one crosses a row at -F / a. The vector code computes that as F times the rounded -1 / a, cuts it off at
//! the first and the last pixel, and rounds up.
//!
//! For each `a` two F for each pixel stand for all. Multiplication by a fixed factor is monotone, and so is
//! the rounding of products and the rounding up. F are odd numbers of halves, so -F / a is no integer, and next
//! to the pixel k on either side are the crossings of F = -k a + 1/2 and F = -k a - 1/2. Where those of k are
//! given k and k + 1, and those of k + 1 likewise, then every crossing between k and k + 1 lies between the
//! second and the third of the four, is given k + 1 as they are, and that is exact. Crossings below the first
//! pixel are given at most that one, those beyond the last at least that one: cut off, they are exact. So with
//! all k from the first pixel to the end of the last, every F is exact that is an exact float.

use crate::{ensure_eq, failure::Verdict};

/// The smallest integer above -(2e + 1) / 2a, which is no integer itself.
fn exact(e: i64, a: i64) -> i64 {
    let (numerator, denominator) = if a > 0 { (-(2 * e + 1), 2 * a) } else { (2 * e + 1, -2 * a) };
    numerator.div_euclid(denominator) + 1
}

/// The e whose crossings lie nearest to the integer `k`, one on each side.
fn nearest(a: i64, k: i64) -> [i64; 2] {
    [-k * a, -k * a - 1]
}

/// In `f32`, for crossings next to each of the first 128 pixels and the end of the last.
pub fn is_exact_in_f32(a: i32) -> Verdict {
    let factor = -1.0 / a as f32;
    for k in 0..=128 {
        for e in nearest(a.into(), k) {
            let value = e as f32 + 0.5;
            let given = (value * factor).ceil();
            ensure_eq!(given as i64, exact(e, a.into()), "a {a}, F {value}");
        }
    }
    Ok(())
}

/// The pixels from 0 to `end` where the distances of floats change: the powers of two and their neighbours.
pub fn turns(end: i64) -> Vec<i64> {
    (0..=end).filter(|&k| (k - 1..=k + 1).any(|near| near > 0 && near & (near - 1) == 0)).collect()
}

/// In `f64`, for the crossings next to pixel `k`.
pub fn is_exact_in_f64(a: i32, k: i64) -> Verdict {
    let factor = -1.0 / f64::from(a);
    for e in nearest(a.into(), k) {
        let value = e as f64 + 0.5;
        let given = (value * factor).ceil();
        ensure_eq!(given as i64, exact(e, a.into()), "a {a}, F {value}");
    }
    Ok(())
}
