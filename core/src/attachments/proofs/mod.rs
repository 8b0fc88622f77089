//! Proofs of the attachments.

mod depth;
mod hidden;
mod hierarchical;
mod one_lane;
#[cfg(feature = "simd")]
mod rows;
mod samples;
mod storage;
#[cfg(test)]
mod tested;
mod texels;
