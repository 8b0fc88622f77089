//! A sub-pixel format for each number of bits that the rasterizer has, alike in everything else, and the
//! grid of whole pixels, which it has not.

use std::marker::PhantomData;

use halfplane::{Assembly, Format, Positions, Region, Standard, Vertex};

macro_rules! formats {
    ($($name:ident $bits:literal),+) => {
        $(
            #[doc = concat!("As [`Standard`], with ", $bits, " sub-pixel bits.")]
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub struct $name;

            impl Format for $name {
                const SUBPIXEL_BITS: u32 = $bits;
                // The same guard band in pixels.
                const GUARD_BAND_BITS: u32 = 15 + $bits;
                const MAX_TARGET: u32 = Standard::MAX_TARGET;
                type Wide = <Standard as Format>::Wide;
                type Word = <Standard as Format>::Word;
            }
        )+
    };
}

formats!(Bits1 1, Bits2 2, Bits3 3, Bits4 4, Bits5 5, Bits6 6, Bits7 7);

/// What becomes of a snapped vertex before it is drawn.
pub trait Grid<F: Format> {
    /// Where it is drawn.
    fn vertex(vertex: Vertex<F>) -> Vertex<F>;
}

/// The format's own grid.
#[derive(Clone, Copy, Debug)]
pub struct Own;

impl<F: Format> Grid<F> for Own {
    #[inline(always)]
    fn vertex(vertex: Vertex<F>) -> Vertex<F> {
        vertex
    }
}

/// The grid of whole pixels; halves go to the right and down.
#[derive(Clone, Copy, Debug)]
pub struct WholePixels;

impl<F: Format> Grid<F> for WholePixels {
    fn vertex(vertex: Vertex<F>) -> Vertex<F> {
        let bits = F::SUBPIXEL_BITS;
        let nearest = |steps: i32| (steps + (1 << (bits - 1))) >> bits << bits;
        // Off the guard band only for a vertex at its very end, which then stays as it is.
        Vertex::new(nearest(vertex.x()), nearest(vertex.y()), vertex.z()).unwrap_or(vertex)
    }
}

/// Positions on another grid.
#[derive(Clone, Copy, Debug)]
pub struct On<P, G>(pub P, pub PhantomData<G>);

impl<F: Format, P: Positions<F>, G: Grid<F>> Positions<F> for On<P, G> {
    #[inline]
    fn count(&self) -> usize {
        self.0.count()
    }

    #[inline]
    fn window(&self) -> Option<Region<F>> {
        self.0.window()
    }

    #[inline]
    fn assemble<E: FnMut([Vertex<F>; 3])>(&self, corners: [usize; 3], mut emit: E) -> Assembly {
        self.0.assemble(corners, |vertices| emit(vertices.map(G::vertex)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_move_to_whole_pixels() {
        let of = |x, y| {
            let moved = WholePixels::vertex(Vertex::<Bits3>::new(x, y, 77).unwrap());
            (moved.x(), moved.y(), moved.z())
        };
        assert_eq!(of(3, 4), (0, 8, 77));
        assert_eq!(of(-4, -5), (0, -8, 77));
        assert_eq!(of(16, 17), (16, 16, 77));
    }
}
