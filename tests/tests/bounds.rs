//! The bounds of the ready formats are the numbers that their table gives.

use halfplane::{Bounds, Region, Sample, Small, Standard, State};

#[test]
fn bounds_of_the_standard_format() {
    type B = Bounds<Standard>;
    assert_eq!((B::STEPS_PER_PIXEL, B::GUARD_BAND, B::MAX_DELTA), (256, 1 << 23, 1 << 24));
    assert_eq!(B::MAX_AREA, 1 << 48);
    assert_eq!((B::MAX_TILE_VALUE, B::MAX_BLOCK_STEPS), (63 << 25, 3 << 25));
    assert_eq!(B::MAX_NUMERATOR, (1 << 25) * 0xFFFF_FFFF);
    // 31/32 of 32768 pixels; one unit and 2^-8.
    assert_eq!((B::CLIP_PIXELS, B::MAX_DEPTH_ERROR_2_16), (31_744, 0x1_0100));
}

#[test]
fn bounds_of_the_small_format() {
    type B = Bounds<Small>;
    assert_eq!((B::STEPS_PER_PIXEL, B::GUARD_BAND, B::MAX_DELTA), (16, 1 << 14, 1 << 15));
    assert_eq!(B::MAX_AREA, 1 << 30);
    assert_eq!((B::MAX_TILE_VALUE, B::MAX_BLOCK_STEPS), (63 << 16, 3 << 16));
    assert_eq!(B::MAX_NUMERATOR, (1 << 16) * 0xFFFF);
    // 31/32 of 1024 pixels; one unit and a half.
    assert_eq!((B::CLIP_PIXELS, B::MAX_DEPTH_ERROR_2_16), (992, 0x1_8000));
}

#[test]
fn samples_are_at_the_centre_by_default() {
    assert_eq!(Some(Sample::<Standard>::CENTER), Sample::new(128, 128));
    assert_eq!(Some(Sample::<Small>::default()), Sample::new(8, 8));
    assert_eq!(State::new(Region::<Small>::of_size(4, 4).unwrap()).sample, Sample::CENTER);
}
