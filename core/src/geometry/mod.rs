//! Vertices, regions, edges, planes, one triangle's set-up, and what it touches and contains.

mod edge;
mod extent;
mod facing;
mod footprint;
mod plane;
mod positions;
#[cfg(any(kani, test))]
mod proofs;
mod rectangle;
mod region;
mod rule;
mod sample;
mod triangle;
mod vertex;

pub use edge::Edge;
pub(crate) use extent::Extent;
pub use facing::{Cull, Culled, Winding};
pub use footprint::{Footprint, Overlap};
pub(crate) use plane::Plane;
pub use positions::{Assembly, Positions};
pub use rectangle::Rectangle;
pub use region::{Region, RegionError};
pub use rule::Uncertainty;
pub(crate) use rule::{HalfPlanes, Rule};
#[cfg(any(kani, test))]
pub(crate) use rule::{Inside, Touched};
pub use sample::Sample;
pub(crate) use triangle::winding;
pub use triangle::{Triangle, doubled_area, is_outside};
pub use vertex::{OutsideGuardBand, Vertex};
