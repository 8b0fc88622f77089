//! The properties: plain functions of plain inputs, no engine in them.

pub mod clipping;
pub mod coverage;
pub mod crossing;
pub mod definition_path;
pub mod depth;
pub mod depth_test;
pub mod draws;
pub mod entry;
pub mod enumeration;
pub mod errors;
pub mod exhaustive;
pub mod fast_triangles;
pub mod lanes;
pub mod meshlets;
pub mod neighbours;
pub mod numbers;
pub mod outline;
pub mod scene;
pub mod shared_edge;
pub mod simd;
pub mod small_edge;
pub mod statistics;
pub mod storage;
pub mod transform;
pub mod watertight;
