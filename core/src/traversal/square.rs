//! A square of pixels with the edges that cross it.

use super::{
    mask::Mask,
    step::{Step, corner_steps},
};
use crate::{
    geometry::{Region, Triangle},
    lanes::Lanes,
    numbers::Format,
};

/// An aligned square of `side` pixels (4, 16 or 64) and the three edges over it.
#[derive(Clone, Copy)]
pub(super) struct Square {
    pub(super) x: u32,
    pub(super) y: u32,
    side: u32,
    edges: [Step; 3],
}

impl Square {
    /// The square at (`x`, `y`), multiples of `side`; `None` where an edge rejects all of it.
    #[inline]
    pub(super) fn new<F: Format>(triangle: &Triangle<F>, x: u32, y: u32, side: u32) -> Option<Self> {
        let [e0, e1, e2] = triangle.edges();
        let (sample, at, size) = (triangle.sample(), [x, y], [side as i32; 2]);
        let (e0, e1) = (Step::over(e0, sample, at, size)?, Step::over(e1, sample, at, size)?);
        Some(Self { x, y, side, edges: [e0, e1, Step::over(e2, sample, at, size)?] })
    }

    /// The inside samples of a square of 4 pixels.
    #[inline(always)]
    pub(super) fn samples<L: Lanes>(&self, token: L::Token) -> Mask {
        let [e0, e1, e2] = self.edges;
        let lanes = L::ramp(token, e0.value, e0.a, e0.b)
            .or(L::ramp(token, e1.value, e1.a, e1.b))
            .or(L::ramp(token, e2.value, e2.a, e2.b));
        Mask(!lanes.signs())
    }

    /// Calls `visit` with each of the sixteen children that lies in `region` and that no edge
    /// rejects, row by row; without edges where they accept the child.
    #[inline(always)]
    pub(super) fn children<L: Lanes, F: Format>(
        &self,
        token: L::Token,
        region: Region<F>,
        mut visit: impl FnMut(Self),
    ) {
        let side = self.side >> 2;
        let step = side as i32;
        // Per edge: the children that it rejects, those it accepts, and its values there.
        let mut rejected = 0;
        let mut accepted = [0; 3];
        let mut values = [[0; 16]; 3];
        for ((edge, accepted), values) in self.edges.iter().zip(&mut accepted).zip(&mut values) {
            let first = L::ramp(token, edge.value, step * edge.a, step * edge.b);
            let (lowest, highest) = corner_steps(edge.a, edge.b, step, step);
            rejected |= first.add(L::splat(token, highest as u32)).signs();
            *accepted = !first.add(L::splat(token, lowest as u32)).signs();
            first.store(values);
        }
        let touched = Mask(!rejected).and(self.cells_in(region));
        for (column, row) in touched.cells() {
            let lane = (4 * row + column) as usize & 15;
            let mut edges = self.edges;
            for ((edge, accepted), values) in edges.iter_mut().zip(accepted).zip(&values) {
                if accepted >> lane & 1 != 0 {
                    *edge = Step::DROPPED;
                } else {
                    edge.value = values[lane] as i32;
                }
            }
            visit(Self { x: self.x + column * side, y: self.y + row * side, side, edges });
        }
    }

    /// The cells (sixteenths of the square) that `region` touches.
    #[inline]
    pub(super) fn cells_in<F: Format>(&self, region: Region<F>) -> Mask {
        let shift = (self.side >> 2).trailing_zeros();
        let up = (1 << shift) - 1;
        let first = |edge: u32, origin: u32| edge.saturating_sub(origin) >> shift;
        let end = |edge: u32, origin: u32| (edge.saturating_sub(origin) + up) >> shift;
        Mask::rectangle(
            first(region.x0(), self.x),
            end(region.x1(), self.x),
            first(region.y0(), self.y),
            end(region.y1(), self.y),
        )
    }
}
