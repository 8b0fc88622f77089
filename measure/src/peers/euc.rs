//! euc: a shader pipeline that evaluates every pixel of a triangle's box.

use euc::rasterizer::Triangles;
use euc::{Pipeline, Target as _, buffer::Buffer2d};

use super::{Peer, Shown};
use crate::Matrix;
use crate::view::View;

/// A view for euc.
#[derive(Debug)]
pub struct Euc {
    corners: Vec<[f32; 3]>,
    indices: Vec<u32>,
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
    pub fn new(view: &View<'_>) -> Self {
        let (mut corners, mut indices) = (Vec::new(), Vec::new());
        for &[a, b, c] in view.indices.as_chunks::<3>().0 {
            // Its front faces wind the other way.
            let triangle = [a, c, b].map(|index| view.positions[index as usize]);
            let before = |[_, _, z, w]: [f32; 4]| z >= 0.0 && w > 0.0;
            if triangle.into_iter().all(|position| before(view.clip(position))) {
                corners.extend(triangle);
                indices.extend([a, b, c]);
            }
        }
        let size = [view.size.0 as usize, view.size.1 as usize];
        Self { corners, indices, colour: Buffer2d::new(size, ()), depth: Buffer2d::new(size, 1.0) }
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

    fn indices(&self) -> &[u32] {
        &self.indices
    }

    fn covered(&self) -> usize {
        let depths: &[f32] = self.depth.as_ref();
        depths.iter().filter(|depth| **depth != 1.0).count()
    }

    fn shown(&self) -> Vec<Shown> {
        let depths: &[f32] = self.depth.as_ref();
        let shown = |&depth: &f32| if depth == 1.0 { Shown::Nothing } else { Shown::Depth(depth) };
        depths.iter().map(shown).collect()
    }
}
