//! From a set-up triangle to the masks of the 4x4 blocks it covers.

mod fill;
mod mask;
#[cfg(any(kani, test))]
mod proofs;
mod scan;
mod step;
mod tile;
mod walk;

pub use mask::Mask;
pub(crate) use fill::fill;
pub(crate) use tile::TILE;
pub(crate) use walk::walk;
pub use walk::{traverse, traverse_with};
