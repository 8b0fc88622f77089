//! See `halfplane_tests::fuzzing::bins`.

#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = halfplane_tests::fuzzing::bins(data) {
        panic!("{failure:?}");
    }
});
