//! Proofs of the fast path in registers of four lanes: plain arrays for a prover, the baseline's own for
//! tests. Other levels differ where the code asks for the width of the registers.

mod batch;
mod blocks;
mod bounds;
mod cluster;
mod crossings;
mod depth;
mod edges;
mod fetch;
mod meshlet;
mod ops;
mod queue;
mod rows;
mod setup;
mod sort;
#[cfg(test)]
mod tested;
mod vector_lanes;
mod verdict;
mod vertex;
mod window;
mod windows;
mod write;

use fearless_simd::{f32x16, f64x8, i32x16, mask32x16, prelude::*, u32x16, u64x8};

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
use fearless_simd::Fallback as Vectors;
#[cfg(target_arch = "aarch64")]
use fearless_simd::aarch64::Neon as Vectors;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::x86::Sse2 as Vectors;

/// The token of the registers.
#[inline(always)]
pub(super) fn simd() -> Vectors {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let found = fearless_simd::Level::baseline().as_sse2();
    #[cfg(target_arch = "aarch64")]
    let found = fearless_simd::Level::baseline().as_neon();
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
    let found = Some(Vectors::new());
    found.unwrap_or_else(|| unreachable!("every such processor has them"))
}

/// Lanes that stand for all: what is stated of them depends on no other, and every operation but the
/// shuffles does the same in each. Constants, so that a prover looks at these alone.
const LANES: [usize; 3] = [1, 6, 15];

type Floats = f32x16<Vectors>;
type Ints = i32x16<Vectors>;
type Words = u32x16<Vectors>;
type Mask = mask32x16<Vectors>;

/// The lanes of a vector.
macro_rules! lanes {
    ($($name:ident($vector:ty) -> [$lane:ty; $count:literal];)*) => {$(
        #[inline(always)]
        fn $name(vector: $vector) -> [$lane; $count] {
            let mut lanes = [<$lane>::default(); $count];
            vector.store_slice(&mut lanes);
            lanes
        }
    )*};
}

lanes! {
    ints(Ints) -> [i32; 16];
    words(Words) -> [u32; 16];
    floats(Floats) -> [f32; 16];
    doubles(f64x8<Vectors>) -> [f64; 8];
    longs(u64x8<Vectors>) -> [u64; 8];
}
