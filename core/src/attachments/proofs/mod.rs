//! Proofs of the attachments.

mod depth;
mod hierarchical;
mod one_lane;
mod samples;
mod storage;
mod texels;
