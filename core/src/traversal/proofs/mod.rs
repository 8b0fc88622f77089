//! Proofs of the traversal.

mod mask;
mod scan;
mod step;
mod tile;
mod walk;
