//! See the module.

#![no_main]

#[path = "../../cli/tests/corpus/parsers.rs"]
mod parsers;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    if let Err(failure) = parsers::parsers(data) {
        panic!("{failure}");
    }
});
