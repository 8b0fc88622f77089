//! From clip space to the window: reject, clip, divide, viewport, snap.
//!
//! Clip space is (x, y, z, w) with x to the right, y up, 0 <= z <= w, w > 0 in front of the eye. All
//! of it is `f32` arithmetic in a fixed order, each operation rounded once, so the bits are the same
//! wherever IEEE 754 holds; the point where a plane cuts an edge is computed in `f64` and rounded.

mod bound;
mod clip;
mod frustum;
mod model;
mod plane;
mod positions;
#[cfg(any(kani, test))]
mod proofs;
mod root;
mod sphere;
mod triangulate;
mod viewport;

pub use bound::Bound;
pub use frustum::Frustum;
pub use model::ModelPositions;
#[cfg(feature = "simd")]
pub(crate) use plane::Plane;
pub use positions::ClipPositions;
#[cfg(feature = "simd")]
pub(crate) use positions::assemble;
#[cfg(feature = "simd")]
pub(crate) use root::root_above;
pub use viewport::Viewport;
