//! euc: a shader pipeline that evaluates every pixel of a triangle's box.

use euc::rasterizer::Triangles;
use euc::{Pipeline, Target as _, buffer::Buffer2d};
use halfplane_cli::camera::Matrix;

use super::Peer;
use crate::scenes::View;

/// A view for euc.
#[derive(Debug)]
pub struct Euc {
    corners: Vec<[f32; 3]>,
    /// Pixels of no size: colour costs nothing.
    colour: Buffer2d<()>,
    depth: Buffer2d<f32>,
}

/// The draw call's shaders.
struct DepthOnly {
    matrix: Matrix,
}

impl Pipeline for DepthOnly {
    type Vertex = [f32; 3];
    type VsOut = ();
    type Pixel = ();

    #[inline(always)]
    fn vert(&self, &[x, y, z]: &[f32; 3]) -> ([f32; 4], ()) {
        let m = &self.matrix;
        ([0, 1, 2, 3].map(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k]), ())
    }

    #[inline(always)]
    fn frag(&self, (): &()) {}
}

impl Euc {
    /// Leaves out triangles that reach behind the near plane or the eye.
    #[must_use]
    pub fn new(view: &View) -> Self {
        let mut corners = Vec::new();
        for &[a, b, c] in view.mesh.indices.as_chunks::<3>().0 {
            // Its front faces wind the other way.
            let triangle = [a, c, b].map(|index| view.mesh.positions[index as usize]);
            let before = |[_, _, z, w]: [f32; 4]| z >= 0.0 && w > 0.0;
            if triangle.into_iter().all(|position| before(view.clip(position))) {
                corners.extend(triangle);
            }
        }
        let size = [view.size.0 as usize, view.size.1 as usize];
        Self { corners, colour: Buffer2d::new(size, ()), depth: Buffer2d::new(size, 1.0) }
    }
}

impl Peer for Euc {
    fn name(&self) -> &'static str {
        "euc"
    }

    fn frame(&mut self, matrix: &Matrix) {
        self.depth.clear(1.0);
        let pipeline = DepthOnly { matrix: *matrix };
        pipeline.draw::<Triangles<'_, _>, _>(&self.corners, &mut self.colour, Some(&mut self.depth));
    }

    fn moves(&self) -> bool {
        true
    }

    fn triangles(&self) -> usize {
        self.corners.len() / 3
    }

    fn covered(&self) -> usize {
        let depths: &[f32] = self.depth.as_ref();
        depths.iter().filter(|depth| **depth != 1.0).count()
    }
}
