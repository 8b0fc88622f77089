//! Other crates, on the same triangles. None of them promises exact coverage or equal bits; each is given
//! its input in the form it likes best, prepared outside the time that is measured.
//!
//! All crates are built as this one is, for the processors that the Rust target names unless `RUSTFLAGS`
//! says more (`-C target-cpu=native` helps those that call `mul_add` and `floor`).

mod embedded_graphics;
mod euc;
mod retrofire;
mod tiny_skia;
pub mod visible;

use crate::Matrix;
use crate::view::View;
use visible::Visible;

pub use self::embedded_graphics::EmbeddedGraphics;
pub use self::euc::Euc;
pub use self::retrofire::Retrofire;
pub use self::tiny_skia::TinySkia;

/// Another crate, ready to draw one view.
pub trait Peer {
    /// The crate's name.
    fn name(&self) -> &'static str;

    /// Draws a frame: clear and all triangles. Peers that have no transform ignore the matrix.
    fn frame(&mut self, matrix: &Matrix);

    /// Whether it draws from object space, so that the camera can move.
    fn moves(&self) -> bool;

    /// Triangles it was given.
    fn triangles(&self) -> usize;

    /// The triangles it was given, by their vertices in the view.
    fn indices(&self) -> &[u32];

    /// Pixels that the last frame covered.
    fn covered(&self) -> usize;

    /// What the last frame left of each pixel, row by row from the top.
    fn shown(&self) -> Vec<Shown>;
}

/// What a pixel holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shown {
    /// Nothing was drawn there.
    Nothing,
    /// Something was.
    Something,
    /// A depth z/w.
    Depth(f32),
    /// A depth kept as 1/w.
    InverseW(f32),
}

/// What the rows of a table measure, for those who compare.
pub const WHAT: [(&str, &str); 4] = [
    (
        "euc",
        "clear of f32 depth, transform (three times per triangle: it has no indices), back-face culling, depth test \
         and write, no colour (of a type without size). It does not clip: triangles that reach behind the near plane \
         are left out beforehand",
    ),
    (
        "retrofire",
        "clear of f32 depth (of 1/w), transform, clipping to the frustum, back-face culling, depth test and write, \
         colour writes off; indexed; its per-frame allocations are its own",
    ),
    (
        "tiny-skia",
        "2D: no depth, transform, clipping or culling. Clear of 32-bit colour and one path fill per triangle without \
         anti-aliasing; paths are made beforehand from the window triangles wholly inside the view and facing it",
    ),
    (
        "embedded-graphics",
        "2D: no depth, transform, clipping or culling, whole-pixel corners. Clear and one filled triangle each into \
         32-bit colour with row fills; the same window triangles, made beforehand",
    ),
];

/// Everyone who can draw a view.
#[must_use]
pub fn all(view: &View<'_>, visible: &Visible) -> Vec<Box<dyn Peer>> {
    vec![
        Box::new(Euc::new(view)),
        Box::new(Retrofire::new(view)),
        Box::new(TinySkia::new(view, visible)),
        Box::new(EmbeddedGraphics::new(view, visible)),
    ]
}
