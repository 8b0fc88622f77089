//! The proptest engine, set up the same way for every property.

use crate::{
    failure::Verdict,
    sizes::{Cases, seed},
};
use proptest::{
    strategy::Strategy,
    test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner},
};

/// Runs a property over a strategy's cases, and shrinks what fails.
///
/// The cases are the same in every run of the same seed and scale; a failing one belongs into
/// `tests/issues.rs`, so nothing is persisted.
///
/// # Panics
///
/// With the smallest failing case that was found.
pub fn check<S: Strategy>(cases: Cases, strategy: S, property: impl Fn(S::Value) -> Verdict) {
    let config = Config {
        cases: cases.scaled(),
        failure_persistence: None,
        max_shrink_time: 15_000,
        ..Config::default()
    };
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed().to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let outcome = TestRunner::new_with_rng(config, rng)
        .run(&strategy, |case| property(case).map_err(|failure| TestCaseError::fail(failure.0)));
    if let Err(error) = outcome {
        panic!("{error}");
    }
}
