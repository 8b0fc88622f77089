//! From a set-up triangle to the masks of the 4x4 blocks it covers.

mod conservative;
mod mask;
#[cfg(any(kani, test))]
mod proofs;
mod scan;
mod step;
mod tile;
mod walk;

pub use conservative::{traverse_conservative, traverse_conservative_with};
pub use mask::Mask;
pub(crate) use walk::walk;
pub use walk::{traverse, traverse_with};
