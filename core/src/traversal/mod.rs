//! From a set-up triangle to the masks of the 4x4 blocks it covers.

mod mask;
mod square;
mod walk;

pub use mask::Mask;
pub use walk::{traverse, traverse_with};
