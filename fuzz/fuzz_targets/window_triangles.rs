//! See `halfplane_tests::fuzzing::window_triangles`.

#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = halfplane_tests::fuzzing::window_triangles(data) {
        panic!("{failure:?}");
    }
});
