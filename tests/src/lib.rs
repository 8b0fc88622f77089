//! What `halfplane` promises, as properties that any engine can drive.
//!
//! | where | what |
//! |---|---|
//! | [`shapes`] | triangles, meshes and clip-space vertices by kind: total functions of plain numbers |
//! | [`case`] | a mesh and how it is drawn, made from any numbers |
//! | [`strategies`] | the same as proptest strategies, with shrinking |
//! | [`properties`] | the properties: plain functions `fn(inputs) -> Result<(), Failure>`, no engine in them |
//! | [`sizes`] | how many cases each property gets; the only place to change that |
//! | [`double`] | an attachment that fails on overdraw and prints pictures |
//! | [`fuzzing`] | the fuzzer's targets: any bytes, decoded into cases of properties |
//! | [`toy`] | formats small enough to enumerate |
//! | [`golden`] | the reader of third-party goldens |
//! | [`layers`] | the reader of the core's imports |
//! | [`proofs`] | the reader of the core's proofs |
//!
//! The drivers are in `tests/`: each calls properties with inputs from one engine.

pub mod case;
pub mod double;
pub mod failure;
pub mod frame;
#[cfg(feature = "simd")]
pub mod fuzzing;
pub mod golden;
pub mod layers;
pub mod oracle;
pub mod proofs;
pub mod properties;
pub mod run;
pub mod shapes;
pub mod sizes;
pub mod strategies;
pub mod toy;

pub use failure::Failure;
pub use frame::Frame;

/// The README's example is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
