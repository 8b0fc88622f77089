//! Each lane operation does to every lane what it says. Any implementation of `Lanes` can be put in.

use crate::{ensure_eq, failure::Verdict};
use halfplane::lanes::{ArrayLanes, Lanes};
#[cfg(feature = "simd")]
use {
    crate::Failure,
    fearless_simd::{Simd, dispatch},
    halfplane::{lanes::VectorLanes, simd::Level},
};

/// All operations on these values.
pub fn every_operation<L: Lanes>(
    token: L::Token,
    a: [u32; 16],
    b: [u32; 16],
    [mask, other]: [u16; 2],
    ramp: [i32; 3],
) -> Verdict {
    let stored = |lanes: L| {
        let mut values = [0; 16];
        lanes.store(&mut values);
        values
    };
    let mask_of =
        |bit: &dyn Fn(usize) -> bool| (0..16).fold(0u16, |m, lane| m | u16::from(bit(lane)) << lane);
    let (la, lb) = (L::load(token, &a), L::load(token, &b));
    let (lanes, others) = (L::mask(token, mask), L::mask(token, other));
    let each = |f: &dyn Fn(usize) -> u32| -> [u32; 16] { std::array::from_fn(f) };
    let chosen = |mask: u16| each(&|k| if mask >> k & 1 == 1 { a[k] } else { b[k] });
    ensure_eq!(stored(la), a, "load and store");
    ensure_eq!(stored(L::splat(token, a[0])), [a[0]; 16], "splat");
    ensure_eq!(stored(la.add(lb)), each(&|k| a[k].wrapping_add(b[k])), "add");
    ensure_eq!(stored(la.or(lb)), each(&|k| a[k] | b[k]), "or");
    ensure_eq!(stored(la.and(lb)), each(&|k| a[k] & b[k]), "and");
    ensure_eq!(la.signs(), mask_of(&|k| (a[k] as i32) < 0), "signs");
    ensure_eq!(L::bits(lanes), mask, "mask and bits");
    ensure_eq!(L::bits(L::both(lanes, others)), mask & other, "both");
    ensure_eq!(L::bits(L::not(lanes)), !mask, "not");
    ensure_eq!(stored(la.select(lb, lanes)), chosen(mask), "select");
    // Masks that were computed are masks like others.
    ensure_eq!(stored(la.select(lb, L::not(lanes))), chosen(!mask), "select by not");
    ensure_eq!(stored(la.select(lb, L::both(lanes, others))), chosen(mask & other), "select by both");
    let less = mask_of(&|k| a[k] < b[k]);
    ensure_eq!(L::bits(la.less(lb)), less, "less");
    ensure_eq!(stored(la.select(lb, la.less(lb))), chosen(less), "the smaller");
    ensure_eq!(L::bits(L::not(la.less(lb))), !less, "not less");
    ensure_eq!(L::bits(la.less(la)), 0, "less than itself");
    let [origin, x, y] = ramp.map(i64::from);
    let expected = each(&|k| (origin + (k % 4) as i64 * x + (k / 4) as i64 * y) as u32);
    ensure_eq!(stored(L::ramp(token, ramp[0], ramp[1], ramp[2])), expected, "ramp");
    ensure_eq!(L::vectorize(token, || stored(la.add(lb))), stored(la.add(lb)), "vectorize");
    Ok(())
}

/// [`every_operation`] of arrays.
pub fn every_operation_of_arrays(a: [u32; 16], b: [u32; 16], masks: [u16; 2], ramp: [i32; 3]) -> Verdict {
    every_operation::<ArrayLanes>((), a, b, masks, ramp)
}

/// [`every_operation`] of arrays, and of vectors at every level of this machine.
#[cfg(feature = "simd")]
pub fn every_operation_at_every_level(
    a: [u32; 16],
    b: [u32; 16],
    masks: [u16; 2],
    ramp: [i32; 3],
) -> Verdict {
    every_operation_of_arrays(a, b, masks, ramp).map_err(|failure| at("arrays", failure))?;
    let best = fearless_simd::Level::new();
    for level in [
        #[cfg(target_arch = "x86_64")]
        best.as_avx512().map(fearless_simd::Level::Avx512),
        #[cfg(target_arch = "x86_64")]
        best.as_avx2().map(fearless_simd::Level::Avx2),
        #[cfg(target_arch = "x86_64")]
        best.as_sse4_2().map(fearless_simd::Level::Sse4_2),
        #[cfg(target_arch = "x86_64")]
        best.as_sse2().map(fearless_simd::Level::Sse2),
        #[cfg(not(target_arch = "x86_64"))]
        Some(best),
    ]
    .into_iter()
    .flatten()
    {
        let verdict = dispatch!(level, simd => operations_of_vectors(simd, a, b, masks, ramp));
        verdict.map_err(|failure| at(Level::from(level).name(), failure))?;
    }
    Ok(())
}

#[cfg(feature = "simd")]
fn operations_of_vectors<S: Simd>(
    simd: S,
    a: [u32; 16],
    b: [u32; 16],
    masks: [u16; 2],
    ramp: [i32; 3],
) -> Verdict {
    every_operation::<VectorLanes<S>>(simd, a, b, masks, ramp)
}

#[cfg(feature = "simd")]
fn at(level: &str, failure: Failure) -> Failure {
    Failure::new(format_args!("{level}: {failure:?}"))
}
