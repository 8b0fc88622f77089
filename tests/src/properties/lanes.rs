//! Each lane operation does to every lane what it says. Any implementation of `Lanes` can be put in.

use crate::{ensure_eq, failure::Verdict};
use halfplane::lanes::Lanes;

/// All operations on these values.
pub fn every_operation<L: Lanes>(a: [u32; 16], b: [u32; 16], mask: u16, ramp: [i32; 3]) -> Verdict {
    let stored = |lanes: L| {
        let mut values = [0; 16];
        lanes.store(&mut values);
        values
    };
    let mask_of =
        |bit: &dyn Fn(usize) -> bool| (0..16).fold(0u16, |m, lane| m | u16::from(bit(lane)) << lane);
    let (la, lb) = (L::load(&a), L::load(&b));
    let each = |f: &dyn Fn(usize) -> u32| -> [u32; 16] { std::array::from_fn(f) };
    ensure_eq!(stored(la), a, "load and store");
    ensure_eq!(stored(L::splat(a[0])), [a[0]; 16], "splat");
    ensure_eq!(stored(la.add(lb)), each(&|k| a[k].wrapping_add(b[k])), "add");
    ensure_eq!(stored(la.or(lb)), each(&|k| a[k] | b[k]), "or");
    ensure_eq!(stored(la.and(lb)), each(&|k| a[k] & b[k]), "and");
    ensure_eq!(
        stored(la.select(lb, mask)),
        each(&|k| if mask >> k & 1 == 1 { a[k] } else { b[k] }),
        "select"
    );
    ensure_eq!(la.signs(), mask_of(&|k| (a[k] as i32) < 0), "signs");
    ensure_eq!(la.less(lb), mask_of(&|k| a[k] < b[k]), "less");
    ensure_eq!(la.less(la), 0, "less than itself");
    let [origin, x, y] = ramp.map(i64::from);
    let expected = each(&|k| (origin + (k % 4) as i64 * x + (k / 4) as i64 * y) as u32);
    ensure_eq!(stored(L::ramp(ramp[0], ramp[1], ramp[2])), expected, "ramp");
    Ok(())
}
