//! Every implementation of the lanes.

use halfplane::lanes::ArrayLanes;
use halfplane_tests::{properties::lanes::every_operation, run::check, sizes, strategies::numbers};
use proptest::prelude::*;

#[test]
fn array_lanes_do_what_they_say() {
    let extremes = || prop_oneof![any::<u32>(), Just(0), Just(u32::MAX), Just(1 << 31), Just((1 << 31) - 1)];
    let lanes = || proptest::collection::vec(extremes(), 16).prop_map(|v| std::array::from_fn(|k| v[k]));
    check(sizes::LANES, (lanes(), lanes(), any::<u16>(), numbers::<3>()), |(a, b, mask, ramp)| {
        every_operation::<ArrayLanes>(a, b, mask, ramp.map(|v| v as i32))?;
        every_operation::<ArrayLanes>(a, a, mask, ramp.map(|v| v as i32))
    });
}
