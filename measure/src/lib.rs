//! How frames are drawn and timed, once for everybody: the command, the benchmarks and the report draw
//! through the same target and time by the same protocol, so that their numbers mean the same.
//!
//! | module | what |
//! |---|---|
//! | [`protocol`] | warm-up, measured frames, rounds, and the numbers over them |
//! | [`limits`] | what the machine can do at best |
//! | [`machine`] | what was measured on |
//! | [`motion`] | a camera that does not stand still |
//! | [`buffer`] | memory whose place does not change from run to run |
//! | [`level`] | the vector levels of this machine |
//! | [`target`] | a mesh and its buffers, as the command draws them |
//! | [`view`] | what is drawn, as plain data |
//! | [`peers`] | other crates on the same triangles |

#![forbid(unsafe_code)]

pub mod buffer;
pub mod level;
pub mod limits;
pub mod machine;
pub mod motion;
pub mod peers;
pub mod protocol;
pub mod target;
pub mod view;

/// Model space to clip space, row by row: clip = [x y z 1] M, y up, z from 0 (near) to w (far).
pub type Matrix = [f32; 16];

/// A position in clip space: x m0 + y m1 + z m2 + m3, from left to right in `f32`, so that the bits are the
/// same everywhere.
#[must_use]
pub fn clip([x, y, z]: [f32; 3], m: &Matrix) -> [f32; 4] {
    std::array::from_fn(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k])
}
