//! Where a draw's triangles come from.

use super::{region::Region, vertex::Vertex};
use crate::numbers::Format;

/// Vertices that indices refer to, and how three of them become window triangles.
///
/// Implemented for slices of window vertices, which become one triangle each, and by
/// `ClipPositions` (feature `transform`), whose triangles are clipped into none or several.
pub trait Positions<F: Format> {
    /// How many vertices there are.
    fn count(&self) -> usize;

    /// The only pixels that may be drawn, besides the scissor: a viewport. Default: no limit.
    fn window(&self) -> Option<Region<F>> {
        None
    }

    /// Emits the window triangles of the triangle with these vertices, all of one winding, and says
    /// what became of it.
    fn assemble<E: FnMut([Vertex<F>; 3])>(&self, corners: [usize; 3], emit: E) -> Assembly;
}

/// What became of a submitted triangle on its way to the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Assembly {
    /// Emitted as it is.
    Whole,
    /// Clipped, and emitted in pieces.
    Clipped,
    /// Outside the view frustum: nothing emitted.
    Outside,
    /// A coordinate is NaN or infinite: nothing emitted.
    NonFinite,
    /// There is no such vertex: nothing emitted. Not for indices below
    /// [`count`](Positions::count).
    NoVertex,
}

impl<F: Format> Positions<F> for [Vertex<F>] {
    #[inline]
    fn count(&self) -> usize {
        self.len()
    }

    #[inline]
    fn assemble<E: FnMut([Vertex<F>; 3])>(&self, [i, j, k]: [usize; 3], mut emit: E) -> Assembly {
        match (self.get(i), self.get(j), self.get(k)) {
            (Some(&a), Some(&b), Some(&c)) => {
                emit([a, b, c]);
                Assembly::Whole
            }
            _ => Assembly::NoVertex,
        }
    }
}
