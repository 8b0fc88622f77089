//! Timing frames: the protocol, what the machine can do at best, and a camera that does not stand still.
//! `halfplane bench` and the comparison with other crates share it, so that their numbers mean the same.

pub mod buffer;
pub mod limits;
pub mod motion;
pub mod protocol;
