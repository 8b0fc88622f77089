//! See `halfplane_tests::fuzzing::meshes`.

#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = halfplane_tests::fuzzing::meshes(data) {
        panic!("{failure:?}");
    }
});
