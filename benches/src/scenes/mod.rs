//! The views that are drawn: a mesh, a matrix and a size.

pub mod files;
pub mod growth;
pub mod micro;

use std::sync::Arc;

use halfplane_cli::camera::Matrix;
use halfplane_cli::mesh::Mesh;

pub use halfplane_cli::measure::motion::Motion;

/// A mesh seen by a camera. Front faces wind clockwise on the screen; the others are culled.
#[derive(Debug, Clone)]
pub struct View {
    /// Scene, camera and size, such as `castle main 1280x720`.
    pub name: String,
    /// What is drawn; positions and indices are all that is used of it.
    pub mesh: Arc<Mesh>,
    /// Object space to clip space, row vectors, row-major.
    pub matrix: Matrix,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Whether other crates are measured on it.
    pub peers: bool,
    /// Whether all attachments and a moving camera are measured, or the fastest depth only.
    pub detail: bool,
}

impl View {
    /// The matrix of this view's camera while it moves a little.
    #[must_use]
    pub fn motion(&self) -> Motion {
        Motion::new(&self.mesh.positions, &self.matrix, self.size)
    }

    /// The clip-space place of a position, as the rasterizer's own transform computes it.
    #[must_use]
    pub fn clip(&self, [x, y, z]: [f32; 3]) -> [f32; 4] {
        let m = &self.matrix;
        [0, 1, 2, 3].map(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k])
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
