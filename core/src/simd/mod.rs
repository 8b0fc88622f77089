//! The fast path: the same pictures from vector registers.
//!
//! Vertices are transformed and snapped, triangles are culled and survivors set up sixteen at a time. Small
//! and medium triangles stay together: row by row of their windows, each lane solves its own triangle's
//! edges for x, and the rows' bits are sorted into the masks of 4x4 blocks. Larger triangles are drawn one
//! by one, sixteen rows at a time. What needs clipping goes through the same integers as
//! [`draw`](crate::draw()). Whatever the level, the bits are those of `draw` with
//! [`ModelPositions`](crate::ModelPositions).
//!
//! Depth and coverage do not depend on the order of triangles, so those of one size are drawn together;
//! with ids the order is the submitted one.
//!
//! A mesh that is drawn often can be divided into [`Meshlet`]s once: [`draw_meshlets`] looks at nothing of
//! those outside the view frustum, and needs no scratch memory for all vertices.
//!
//! ```
//! use halfplane::{simd::*, *};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let region = Region::<Standard>::of_size(64, 64)?;
//! let mut depths = [u32::MAX; texels(64, 64)];
//! let mut depth: Depth<'_, Standard> = Depth::new(region, &mut depths, DepthTest::LESS)?;
//! let vertices = [[-1.0, -1.0, 0.5], [0.0, 1.0, 0.5], [1.0, -1.0, 0.5]];
//! let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
//! let (viewport, state) = (Viewport::new(region), State::new(region));
//! // With the feature `std`, `Level::detect()` asks the processor.
//! let level = Level::baseline();
//!
//! // A mesh as it is: indices checked once, a record of scratch memory for each vertex.
//! let triangles = Triangles::new(&[0u16, 1, 2], vertices.len())?;
//! let positions = ModelPositions::new(&vertices, identity, viewport);
//! let mut records = [Snapped::default(); 3];
//! let drawn = draw(level, &positions, &mut records, triangles, 0, &state, &mut depth)?;
//!
//! // The same mesh, divided once.
//! let mut memory = [Meshlet::EMPTY; max_meshlets(1)];
//! let meshlets = make_meshlets(&vertices, &[0u16, 1, 2], &mut memory)?;
//! let mut scratch = MeshletScratch::NEW;
//! let again = draw_meshlets(level, meshlets, identity, viewport, &mut scratch, 0, &state, &mut depth)?;
//! assert_eq!(drawn, again);
//! # Ok(())
//! # }
//! ```
//!
//! Attachments or depth tests that rows are not written for, and positions of other kinds, take the way of
//! `draw` itself, with its sixteen lanes in vector registers: [`draw_any`].

mod any;
mod attachment;
mod batch;
mod binned;
mod blocks;
mod cluster;
mod cone;
mod cull;
mod draw;
mod extent;
mod fetch;
mod hierarchical;
mod level;
mod lists;
mod meshlet;
mod occluded;
mod ops;
mod pipeline;
#[cfg(any(kani, test))]
mod proofs;
mod questions;
mod queue;
mod rows;
mod setup;
mod sort;
mod source;
mod vertex;
mod volume;
mod window;
mod windows;

pub use any::draw_any;
pub use attachment::RowAttachment;
pub use batch::{Batch, make_batches, max_batches};
pub use binned::{draw_binned, draw_bins};
pub use cluster::cluster;
pub use draw::{Triangles, draw, draw_meshlets};
pub use hierarchical::Occluder;
pub use level::Level;
pub use lists::ask_triangles;
pub use meshlet::{Meshlet, MeshletError, make_meshlets, max_meshlets};
pub use occluded::{BatchOrder, Occlusion, draw_batches};
pub use questions::{Visibility, ask};
pub use vertex::Snapped;
pub use volume::Volume;
pub use window::MeshletScratch;
