//! Measurements of halfplane: whole frames on whole scenes, beside what else a user could take.
//!
//! | module | what |
//! |---|---|
//! | [`protocol`] | how frames are timed, and what is said of the times |
//! | [`options`] | what a run measures, and for how long |
//! | [`scenes`] | the views that are drawn |
//! | [`ours`] | the rasterizer on views |
//! | [`peers`] | other crates on the same triangles |
//! | [`limits`] | what the machine can do at best |
//! | [`contest`] | one view: everybody in turns |
//! | [`whole`] | one view in ways of drawing whole frames |
//! | [`quoted`] | figures of programs that are not crates, measured elsewhere |
//! | [`machine`] | what was measured on |
//! | [`report`], [`record`] | what was measured, as tables and as CSV |
//! | [`breakdown`] | stages of a frame, by instructions and by time |
//! | [`plots`] | plots as SVG, from plain numbers |
//! | [`document`] | the tables and plots of `docs/performance.md` |
//!
//! Programs: the benchmarks `compare`, `whole_frames`, `stages` and `micro`, and the examples `instructions`, whose
//! instructions are counted by `.ci/instructions`, `breakdown` and `document`.

#![forbid(unsafe_code)]

// Shared with the command, so that its numbers and these mean the same.
pub use halfplane_measure::{buffer, limits, machine, peers, protocol};
pub use halfplane_report::plots;

pub mod breakdown;
pub mod contest;
pub mod document;
pub mod options;
pub mod ours;
pub mod quoted;
pub mod record;
pub mod report;
pub mod scenes;
pub mod whole;
