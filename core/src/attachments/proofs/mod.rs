//! Proofs of the attachments.

mod depth;
mod one_lane;
mod samples;
mod storage;
mod texels;
