//! Sixteen 32-bit lanes: the 4x4 samples of a block, or the 4x4 children of a square.
//!
//! Lane 4 j + i is column i of row j. The inner loops are written over [`Lanes`] alone; plain arrays
//! are the implementation that is always there, and vector registers the one of the feature `simd`.

mod array;
#[cfg(any(kani, test))]
mod proofs;
#[cfg(feature = "simd")]
mod vector;

pub use array::{ArrayLanes, ArrayMask};
#[cfg(feature = "simd")]
pub use vector::VectorLanes;

/// Sixteen lanes of 32 bits, each an unsigned integer modulo 2^32 (or a signed one in two's
/// complement, where an operation says so).
///
/// A mask says of each lane whether it is meant. It is kept as the operations like it; as bits, lane 0
/// is in bit 0.
pub trait Lanes: Copy {
    /// Shows that the processor has what these lanes need; lanes come from it. Arrays need nothing.
    type Token: Copy;
    /// One truth value per lane.
    type Mask: Copy;

    /// Runs `f` where the compiler may use all instructions that the token stands for: in `f` and in
    /// what is inlined into it. Once for each triangle, not for each block.
    fn vectorize<R>(token: Self::Token, f: impl FnOnce() -> R) -> R;

    /// The same value in every lane.
    fn splat(token: Self::Token, value: u32) -> Self;

    /// `origin + column a + row b` in each lane, signed, modulo 2^32.
    fn ramp(token: Self::Token, origin: i32, a: i32, b: i32) -> Self;

    /// Lane by lane from memory.
    fn load(token: Self::Token, values: &[u32; 16]) -> Self;

    /// Lane by lane to memory.
    fn store(self, values: &mut [u32; 16]);

    /// Lane-wise sum modulo 2^32.
    fn add(self, other: Self) -> Self;

    /// Lane-wise or.
    fn or(self, other: Self) -> Self;

    /// Lane-wise and.
    fn and(self, other: Self) -> Self;

    /// A bit for each negative lane, as signed integers.
    fn signs(self) -> u16;

    /// The lanes where `self < other`, unsigned.
    fn less(self, other: Self) -> Self::Mask;

    /// The lanes of `self` that the mask has, of `other` elsewhere.
    fn select(self, other: Self, mask: Self::Mask) -> Self;

    /// The mask with these bits.
    fn mask(token: Self::Token, bits: u16) -> Self::Mask;

    /// The bits of a mask.
    fn bits(mask: Self::Mask) -> u16;

    /// The lanes in both masks.
    fn both(mask: Self::Mask, other: Self::Mask) -> Self::Mask;

    /// The lanes that are not in the mask.
    fn not(mask: Self::Mask) -> Self::Mask;
}
