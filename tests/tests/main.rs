//! The drivers: each test hands cases of one engine to properties of the library.

mod clipping;
mod corpus;
mod coverage;
mod depth;
mod entry;
mod enumeration;
mod errors;
mod goldens;
mod issues;
mod lanes;
mod layers;
mod meshlets;
mod messages;
mod named;
mod numbers;
mod queue;
mod scenes;
mod shapes;
mod simd;
mod statistics;
mod storage;
mod transform;
mod watertight;
