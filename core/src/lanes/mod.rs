//! Sixteen 32-bit lanes: the 4x4 samples of a block, or the 4x4 children of a square.
//!
//! Lane 4 j + i is column i of row j. The inner loops are written over [`Lanes`] alone; plain arrays
//! are the implementation that is always there.

mod array;

pub use array::ArrayLanes;

/// Sixteen lanes of 32 bits, each an unsigned integer modulo 2^32 (or a signed one in two's
/// complement, where an operation says so).
///
/// A mask holds one bit per lane, lane 0 in bit 0.
pub trait Lanes: Copy {
    /// The same value in every lane.
    fn splat(value: u32) -> Self;

    /// `origin + column a + row b` in each lane, signed, modulo 2^32.
    fn ramp(origin: i32, a: i32, b: i32) -> Self;

    /// Lane by lane from memory.
    fn load(values: &[u32; 16]) -> Self;

    /// Lane by lane to memory.
    fn store(self, values: &mut [u32; 16]);

    /// Lane-wise sum modulo 2^32.
    fn add(self, other: Self) -> Self;

    /// Lane-wise or.
    fn or(self, other: Self) -> Self;

    /// Lane-wise and.
    fn and(self, other: Self) -> Self;

    /// The mask of the negative lanes, as signed integers.
    fn signs(self) -> u16;

    /// The mask of the lanes where `self < other`, unsigned.
    fn less(self, other: Self) -> u16;

    /// The lanes of `self` where the mask has a bit, of `other` elsewhere.
    fn select(self, other: Self, mask: u16) -> Self;
}
