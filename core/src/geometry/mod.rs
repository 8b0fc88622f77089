//! Vertices, regions, edges, planes, and one triangle's set-up.

mod edge;
mod facing;
mod plane;
mod positions;
mod region;
mod sample;
mod triangle;
mod vertex;

pub use edge::Edge;
pub use facing::{Cull, Culled, Winding};
pub(crate) use plane::Plane;
pub use positions::{Assembly, Positions};
pub use region::{Region, RegionError};
pub use sample::Sample;
pub use triangle::{Triangle, doubled_area, is_outside};
pub use vertex::{OutsideGuardBand, Vertex};
