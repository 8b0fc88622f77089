//! Proofs of the way from clip space to the window.

mod bound;
mod clip;
mod cut;
mod frustum;
mod model;
mod plane;
mod root;
#[cfg(test)]
mod tested;
mod triangulate;
mod viewport;
