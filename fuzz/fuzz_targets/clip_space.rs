//! See `halfplane_tests::fuzzing::clip_space`.

#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = halfplane_tests::fuzzing::clip_space(data) {
        panic!("{failure:?}");
    }
});
