//! Number formats: how wide every quantity is, and why none can overflow.

mod bounds;
mod coordinate;
mod format;
#[cfg(any(kani, test))]
mod proofs;
mod unorm;
mod wide;
mod word;

pub use bounds::Bounds;
pub use coordinate::Coordinate;
pub use format::{Format, Small, Standard};
pub use unorm::{DEPTH16_MAX, DEPTH16_MIN, DEPTH32_MAX, DEPTH32_MIN, unorm16, unorm32};
pub use wide::Wide;
pub(crate) use wide::arithmetic::WideArithmetic;
pub use word::Word;
pub(crate) use word::arithmetic::WordArithmetic;
