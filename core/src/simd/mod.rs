//! The fast path: the same pictures from vector registers.
//!
//! Vertices are transformed and snapped eight at a time into records of the caller's; triangles are
//! culled eight at a time; survivors are collected and set up eight at a time; each is drawn row of
//! blocks by row of blocks, its edges solved for x. What that cannot do (clipping, large extents) goes
//! one by one through the same integers as [`draw`](crate::draw()). Whatever the level, the bits are
//! those of `draw` with [`ModelPositions`](crate::ModelPositions).
//!
//! Attachments or depth tests that rows are not written for, and positions of other kinds, take the way of
//! `draw` itself, with its sixteen lanes in vector registers: [`draw_any`].

mod any;
mod attachment;
mod blocks;
mod cull;
mod draw;
mod extent;
mod fetch;
mod frustum;
mod level;
mod meshlet;
mod ops;
mod pipeline;
mod queue;
mod rows;
mod setup;
mod source;
mod vertex;
mod window;
mod windows;

pub use any::draw_any;
pub use attachment::RowAttachment;
pub use draw::{Triangles, draw, draw_meshlets};
pub use level::Level;
pub use meshlet::{Meshlet, MeshletError, make_meshlets, max_meshlets};
pub use vertex::Snapped;
pub use window::MeshletScratch;
