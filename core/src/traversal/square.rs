//! A square of pixels with the edges that cross it.

use super::mask::Mask;
use crate::{
    geometry::{Edge, Region, Sample, Triangle},
    lanes::Lanes,
    numbers::{Format, WideArithmetic},
};

/// What a reduced edge value is at a square's first pixel and how it steps, in 32 bits. An edge that
/// accepts the whole square is dropped: it is the constant 0, which accepts everything.
#[derive(Clone, Copy)]
struct Step {
    value: i32,
    a: i32,
    b: i32,
}

impl Step {
    const DROPPED: Self = Self { value: 0, a: 0, b: 0 };

    /// The edge over the square of `side` pixels at (x, y): `None` where it rejects the square.
    #[inline]
    fn over<F: Format>(edge: Edge<F>, sample: Sample<F>, x: u32, y: u32, side: i32) -> Option<Self> {
        let value = edge.reduced(sample, x, y);
        let (a, b) = (edge.a(), edge.b());
        let (lowest, highest) = corner_steps(a, b, side);
        let zero = F::Wide::default();
        if value + F::Wide::from(highest) < zero {
            None
        } else if value + F::Wide::from(lowest) >= zero {
            Some(Self::DROPPED)
        } else {
            // The edge crosses the square, which lies in one tile: `Bounds::MAX_TILE_VALUE`.
            Some(Self { value: value.low32(), a, b })
        }
    }
}

/// What the steps from a square's first pixel to the pixel where an edge is smallest, and to the one
/// where it is largest, add to it: the trivial-accept and the trivial-reject corner.
#[inline]
fn corner_steps(a: i32, b: i32, side: i32) -> (i32, i32) {
    let last = side - 1;
    (last * a.min(0) + last * b.min(0), last * a.max(0) + last * b.max(0))
}

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
        let over = |edge| Step::over(edge, triangle.sample(), x, y, side as i32);
        Some(Self { x, y, side, edges: [over(e0)?, over(e1)?, over(e2)?] })
    }

    /// The inside samples of a square of 4 pixels.
    #[inline]
    pub(super) fn samples<L: Lanes>(&self) -> Mask {
        let [e0, e1, e2] = self.edges.map(|e| L::ramp(e.value, e.a, e.b));
        Mask(!e0.or(e1).or(e2).signs())
    }

    /// Calls `visit` with each of the sixteen children that lies in `region` and that no edge
    /// rejects, row by row; without edges where they accept the child.
    #[inline]
    pub(super) fn children<L: Lanes, F: Format>(&self, region: Region<F>, mut visit: impl FnMut(Self)) {
        let side = self.side >> 2;
        let step = side as i32;
        // Per edge: the children that it rejects, those it accepts, and its values there.
        let mut rejected = 0;
        let mut accepted = [0; 3];
        let mut values = [[0; 16]; 3];
        for ((edge, accepted), values) in self.edges.iter().zip(&mut accepted).zip(&mut values) {
            let first = L::ramp(edge.value, step * edge.a, step * edge.b);
            let (lowest, highest) = corner_steps(edge.a, edge.b, step);
            rejected |= first.add(L::splat(highest as u32)).signs();
            *accepted = !first.add(L::splat(lowest as u32)).signs();
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
