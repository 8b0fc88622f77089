//! What the fuzzer drives: each target decodes any bytes into a structured case and holds
//! [`properties`](crate::properties) against it.
//!
//! | target | what it holds |
//! |---|---|
//! | [`window_triangles`] | coverage, bounds and statistics of one triangle against the reference |
//! | [`conservative`] | what one triangle touches and contains, against the reference |
//! | [`meshes`] | each sample of a mesh exactly once, in the window and clipped |
//! | [`depths`] | depth as specified and within its interval, tests against a model |
//! | [`clip_space`] | any bits as clip-space vertices: accounting, neighbours, every vector level |
//! | [`bins`] | triangles through bins of any size against immediate drawing |
//! | [`queries`] | what is said to be hidden against every pixel; boxes, spheres, batches |
//! | [`draw_calls`] | whole draw calls, wrong ones too, against brute force; the fast path and meshlets |
//!
//! The drivers are `fuzz/fuzz_targets/` for libFuzzer and `tests/corpus.rs`, which replays the seeds
//! `fuzz/seeds/`. What the fuzzer found is in `tests/issues.rs`.

mod bins;
mod clip_space;
mod conservative;
mod depths;
mod draw_calls;
mod input;
mod meshes;
mod queries;
mod window_triangles;

pub use bins::bins;
pub use clip_space::clip_space;
pub use conservative::conservative;
pub use depths::depths;
pub use draw_calls::draw_calls;
pub use meshes::meshes;
pub use queries::queries;
pub use window_triangles::window_triangles;

use crate::{Failure, failure::Verdict};
use arbitrary::{Arbitrary, Unstructured};
use std::fmt::Debug;

/// A target: it decodes any bytes, and they hold or they do not.
pub type Target = fn(&[u8]) -> Verdict;

/// All targets by name, as `fuzz/fuzz_targets/` and `fuzz/seeds/` call them.
pub const TARGETS: &[(&str, Target)] = &[
    ("window_triangles", window_triangles),
    ("conservative", conservative),
    ("meshes", meshes),
    ("depths", depths),
    ("clip_space", clip_space),
    ("draw_calls", draw_calls),
    ("bins", bins),
    ("queries", queries),
];

/// Holds a property against what the bytes decode to; a failure tells what that was.
fn check<T: for<'a> Arbitrary<'a> + Debug>(data: &[u8], property: impl FnOnce(&T) -> Verdict) -> Verdict {
    let Ok(case) = T::arbitrary_take_rest(Unstructured::new(data)) else { return Ok(()) };
    property(&case).map_err(|failure| Failure(format!("{}\nof {case:?}", failure.0)))
}
