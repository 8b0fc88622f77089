//! A triangle rasterizer that can be trusted: `no_std`, allocation-free, free of `unsafe`, integer
//! inside, the same bits on every machine.
//!
//! A draw takes window vertices (fixed-point x and y, unorm32 depth) or, with the feature
//! `transform`, clip-space vertices, and a list of indices; it writes the attachments that were
//! asked for (coverage, depth, triangle ids, or a type of yours) into slices that the caller owns.
//!
//! ```
//! use halfplane::{Cull, Depth, DepthTest, Ids, Region, Standard, State, Vertex, draw, texels};
//!
//! const WIDTH: u32 = 64;
//! const HEIGHT: u32 = 48;
//! let region = Region::<Standard>::of_size(WIDTH, HEIGHT)?;
//! let mut depth_storage = [0; texels(WIDTH, HEIGHT)];
//! let mut id_storage = [0; texels(WIDTH, HEIGHT)];
//! let mut depth: Depth<'_, Standard> = Depth::new(region, &mut depth_storage, DepthTest::LESS)?;
//! let mut ids = Ids::new(region, &mut id_storage)?;
//! depth.clear(Depth::<Standard>::FAR);
//! ids.clear();
//!
//! // x and y in 1/256 px, z in units of 2^-32: a right triangle over the whole target.
//! let vertices = [
//!     Vertex::new(0, 0, 1 << 30)?,
//!     Vertex::new(128 * 256, 0, 1 << 30)?,
//!     Vertex::new(0, 96 * 256, 1 << 30)?,
//! ];
//! let state = State { cull: Cull::Back, ..State::new(region) };
//! let statistics = draw(&vertices[..], &[0u16, 1, 2], 7, &state, &mut (&mut depth, &mut ids))?;
//!
//! assert_eq!(statistics.drawn, 1);
//! assert_eq!(depth.get(63, 47), Some(1 << 30));
//! assert_eq!(ids.get(0, 0), Some(7));
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # Layers
//!
//! Imports run one way: [`numbers`] → [`geometry`] → [`lanes`] → [`traversal`] → [`attachments`] →
//! [`mod@draw`]; `transform` stands beside `draw` and knows `numbers` and `geometry` only. A caller
//! can stop at any level: set up one [`Triangle`] by hand, [`traverse`] its blocks with a closure,
//! or hand a whole mesh to [`draw()`].
//!
//! [`traverse_conservative`] visits what a [`Footprint`], a closed triangle, touches and what lies wholly in it;
//! [`Footprint::overlap`] compares it with a tile.
//!
//! With the feature `simd`, `simd::draw` stands above them all and draws the same bits from vector
//! registers; `simd::draw_meshlets` draws them from a mesh divided once; `simd::draw_any` takes whatever `draw`
//! takes.
//!
//! # Features
//!
//! * `transform` (default): clip-space vertices. Without it the crate holds no float arithmetic but
//!   [`Coordinate::snap`] and [`unorm32`], which are linked only when called.
//! * `simd`: the fast path, for [`Standard`]; brings the crate `fearless_simd`.
//! * `std`: detection of the processor's vector level.

#![no_std]
#![forbid(unsafe_code)]
// Proofs write definitions out.
#![cfg_attr(
    any(kani, test),
    allow(clippy::manual_range_contains, clippy::manual_div_ceil, clippy::manual_is_multiple_of)
)]

pub mod attachments;
pub mod draw;
pub mod geometry;
pub mod lanes;
pub mod numbers;
#[cfg(any(kani, test))]
mod proof;
#[cfg(feature = "simd")]
pub mod simd;
#[cfg(feature = "transform")]
pub mod transform;
pub mod traversal;

pub use attachments::{
    Attachment, Block, Compare, Count, Coverage, D16, D32, Depth, DepthFormat, DepthTest, Ids, NO_ID,
    OutsideAttachment, StorageError, Tiled, blocks, texels,
};
pub use draw::{CulledCounts, DrawError, Index, RejectedCounts, State, Statistics, draw};
pub use geometry::{
    Assembly, Cull, Culled, Footprint, OutsideGuardBand, Overlap, Positions, Rectangle, Region, RegionError,
    Sample, Triangle, Uncertainty, Vertex, Winding,
};
pub use numbers::{Bounds, Coordinate, Format, Small, Standard, unorm16, unorm32};
#[cfg(feature = "transform")]
pub use transform::{ClipPositions, ModelPositions, Viewport};
pub use traversal::{Mask, traverse, traverse_conservative};
