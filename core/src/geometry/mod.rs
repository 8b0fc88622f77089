//! Vertices, regions, edges, planes, and one triangle's set-up.

mod edge;
mod extent;
mod facing;
mod plane;
mod positions;
#[cfg(any(kani, test))]
mod proofs;
mod region;
mod sample;
mod triangle;
mod vertex;

pub use edge::Edge;
pub(crate) use extent::Extent;
pub use facing::{Cull, Culled, Winding};
pub(crate) use plane::Plane;
pub use positions::{Assembly, Positions};
pub use region::{Region, RegionError};
pub use sample::Sample;
pub(crate) use triangle::winding;
pub use triangle::{Triangle, doubled_area, is_outside};
pub use vertex::{OutsideGuardBand, Vertex};
