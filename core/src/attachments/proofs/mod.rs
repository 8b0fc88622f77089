//! Proofs of the attachments.

mod depth;
mod samples;
mod storage;
mod texels;
