//! Proofs of the traversal.

mod conservative;
mod mask;
mod scan;
mod step;
#[cfg(test)]
mod tested;
mod tile;
mod walk;
