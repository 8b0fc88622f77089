//! The drivers: each test hands cases of one engine to properties of the library.

mod attachments;
#[cfg(feature = "simd")]
mod batches;
mod bins;
mod bounds;
mod clipping;
#[cfg(feature = "simd")]
mod cones;
mod conservative;
#[cfg(feature = "simd")]
mod corpus;
mod coverage;
mod depth;
mod entry;
mod enumeration;
mod errors;
mod goldens;
mod hierarchical;
mod instances;
mod issues;
mod lanes;
mod layers;
#[cfg(feature = "simd")]
mod lists;
#[cfg(feature = "simd")]
mod meshlets;
mod messages;
mod named;
mod numbers;
#[cfg(feature = "simd")]
mod queue;
mod scenes;
mod setup;
mod shapes;
#[cfg(feature = "simd")]
mod simd;
mod statistics;
mod storage;
mod transform;
mod volumes;
mod watertight;
