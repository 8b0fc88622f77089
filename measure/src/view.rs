//! What is drawn: triangles of a mesh, a camera and a size, as plain data.

use crate::{Matrix, clip};

/// A mesh seen by a camera.
#[derive(Debug, Clone, Copy)]
pub struct View<'m> {
    /// Vertices in the mesh's own units.
    pub positions: &'m [[f32; 3]],
    /// Three for each triangle; all less than the number of positions.
    pub indices: &'m [u32],
    /// Model space to clip space.
    pub matrix: Matrix,
    /// Width and height in pixels.
    pub size: (u32, u32),
}

impl View<'_> {
    /// The clip-space place of a position, as the rasterizer's own transform computes it.
    #[must_use]
    pub fn clip(&self, position: [f32; 3]) -> [f32; 4] {
        clip(position, &self.matrix)
    }

    /// The window place of a clip-space point in front of the eye, in pixels.
    #[must_use]
    pub fn window(&self, [x, y, _, w]: [f32; 4]) -> [f32; 2] {
        let (width, height) = self.size;
        [(0.5 + 0.5 * x / w) * width as f32, (0.5 - 0.5 * y / w) * height as f32]
    }

    /// Pixels.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.size.0 as usize * self.size.1 as usize
    }
}
