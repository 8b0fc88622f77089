//! retrofire: a complete fixed pipeline of scanlines.

use retrofire_core::geom::{Tri, Vertex, tri, vertex};
use retrofire_core::math::{Color4, Mat4, ProjMat3, ProjVec3, pt3, rgba};
use retrofire_core::render::raster::Frag;
use retrofire_core::render::shader::Shader;
use retrofire_core::render::target::{Colorbuf, Framebuf};
use retrofire_core::render::{Context, Model, Ndc, Screen, render};
use retrofire_core::util::Buf2;
use retrofire_core::util::{Dims, pixfmt::Xrgb8888};

use super::{Peer, Shown};
use crate::Matrix;
use crate::view::View;

/// Columns and rows beyond the picture, for scanlines that rounding in its clipping carries too far.
const SPARE: u32 = 4;

/// A view for retrofire.
pub struct Retrofire {
    positions: Vec<[f32; 3]>,
    triangles: Vec<Tri<usize>>,
    indices: Vec<u32>,
    size: (u32, u32),
    to_screen: Mat4<Ndc, Screen>,
    context: Context,
    target: Framebuf<Colorbuf<Buf2<u32>, Xrgb8888>, Buf2<f32>>,
}

impl Retrofire {
    /// The whole mesh.
    #[must_use]
    pub fn new(view: &View<'_>) -> Self {
        let (width, height) = view.size;
        let (half_width, half_height) = (0.5 * width as f32, 0.5 * height as f32);
        // y downwards; the third component carries 1/w.
        let to_screen = Mat4::new([
            [half_width, 0.0, 0.0, half_width],
            [0.0, -half_height, 0.0, half_height],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        let dims = Dims(width + SPARE, height + SPARE);
        let triangles = view.indices.as_chunks::<3>().0;
        Self {
            positions: view.positions.to_vec(),
            triangles: triangles.iter().map(|&[a, b, c]| tri(a as usize, b as usize, c as usize)).collect(),
            indices: view.indices.to_vec(),
            size: view.size,
            to_screen,
            context: Context { color_write: false, ..Context::default() },
            target: Framebuf { color_buf: Colorbuf::new(Buf2::new(dims)), depth_buf: Buf2::new(dims) },
        }
    }
}

impl Peer for Retrofire {
    fn name(&self) -> &'static str {
        "retrofire"
    }

    fn frame(&mut self, matrix: &Matrix) {
        // Depths are 1/w, larger is nearer.
        self.target.depth_buf.fill(0.0);
        // Its clip space has -w <= z <= w, and column vectors.
        let m = matrix;
        let row = |k: usize| [m[k], m[4 + k], m[8 + k], m[12 + k]];
        let (z, w) = (row(2), row(3));
        let z = [0, 1, 2, 3].map(|k| 2.0 * z[k] - w[k]);
        let matrix: ProjMat3<Model> = ProjMat3::new([row(0), row(1), z, w]);
        let shader = Shader::new(
            |[x, y, z]: [f32; 3], m: &ProjMat3<Model>| -> Vertex<ProjVec3, ()> {
                vertex(m.apply(&pt3(x, y, z)), ())
            },
            |_: Frag<()>, _: &ProjMat3<Model>| -> Color4 { rgba(0, 0, 0, 0) },
        );
        let (triangles, positions) = (&self.triangles, &self.positions);
        render(triangles, positions, &shader, &matrix, self.to_screen, &mut self.target, &self.context);
    }

    fn moves(&self) -> bool {
        true
    }

    fn triangles(&self) -> usize {
        self.triangles.len()
    }

    fn indices(&self) -> &[u32] {
        &self.indices
    }

    fn covered(&self) -> usize {
        self.target.depth_buf.data().iter().filter(|depth| **depth != 0.0).count()
    }

    fn shown(&self) -> Vec<Shown> {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let rows = self.target.depth_buf.data().chunks_exact(width + SPARE as usize).take(height);
        let shown = |&depth: &f32| if depth == 0.0 { Shown::Nothing } else { Shown::InverseW(depth) };
        rows.flat_map(|row| row.iter().take(width).map(shown)).collect()
    }
}
