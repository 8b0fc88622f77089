//! See `halfplane_tests::fuzzing::draw_calls`.

#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = halfplane_tests::fuzzing::draw_calls(data) {
        panic!("{failure:?}");
    }
});
