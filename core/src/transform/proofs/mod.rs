//! Proofs of the way from clip space to the window.

mod clip;
mod cut;
mod plane;
mod triangulate;
mod viewport;
