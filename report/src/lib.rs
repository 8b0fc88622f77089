//! Error against run time: what each choice costs and what it gives, measured on a scene against the exact
//! reference, as one page.
//!
//! | module | what |
//! |---|---|
//! | [`scene`] | the scene, as plain data |
//! | [`truth`], [`snapped`] | what the reference says of it |
//! | [`choices`] | the choices that trade error for time |
//! | [`textbook`], [`doubles`] | what textbooks do instead, written for the comparison |
//! | [`formats`], [`plain`], [`vector`] | frames of this crate in every form that is compared |
//! | [`row`], [`pareto`], [`statistics`] | what is measured, and which of it nothing else beats |
//! | [`judge`] | all depth planes against the exact one |
//! | [`stiffness`] | triangles whose conditioning worsens by powers of two, orders and symmetries, accumulation |
//! | [`savings`], [`recommendation`] | what a scene did not need, and what to take for it |
//! | [`leaving_out`] | what a program does not have when it does not ask for it |
//! | [`run`] | a scene from its truth to its rows |
//! | [`page`], [`plots`] | the page, its tables and plots, CSV and the terminal's summary |
//!
//! It depends on the rasterizer and on the reference, never the other way.

#![forbid(unsafe_code)]

pub mod choices;
pub mod doubles;
pub mod error;
pub mod formats;
pub mod judge;
pub mod leaving_out;
pub mod page;
pub mod pareto;
pub mod plain;
pub mod plots;
pub mod recommendation;
pub mod row;
pub mod run;
pub mod savings;
pub mod scene;
pub mod snapped;
pub mod statistics;
pub mod stiffness;
pub mod textbook;
pub mod truth;
pub mod vector;

pub use error::ReportError;
