//! Storage layouts.

use halfplane::{Format, Small, Standard};
use halfplane_tests::{properties::storage, run::check, sizes, strategies::frame};
use proptest::prelude::*;

fn layouts<F: Format>() {
    check(sizes::STORAGE, (frame::<F>(), 0..40usize), |(frame, spare)| {
        storage::of_texels::<F>(&frame, spare)
    });
    check(sizes::STORAGE, (frame::<F>(), any::<u64>()), |(frame, seed)| storage::of_bits::<F>(&frame, seed));
}

#[test]
fn storage_is_laid_out_as_documented_standard() {
    layouts::<Standard>();
}

#[test]
fn storage_is_laid_out_as_documented_small() {
    layouts::<Small>();
}
