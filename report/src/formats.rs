//! A sub-pixel format for each number of bits that the rasterizer has, alike in everything else; the grid of whole
//! pixels, which it has not; and formats that it refuses, with the bounds that they break.

use std::marker::PhantomData;

use halfplane::{Assembly, Bounds, Format, Positions, Region, Standard, Vertex};

macro_rules! formats {
    ($($name:ident $bits:literal, $guard:expr, $target:expr, $about:literal;)+) => {
        $(
            #[doc = concat!($about, ", with ", $bits, " sub-pixel bits.")]
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
            pub struct $name;

            impl Format for $name {
                const SUBPIXEL_BITS: u32 = $bits;
                const GUARD_BAND_BITS: u32 = $guard;
                const MAX_TARGET: u32 = $target;
                type Wide = <Standard as Format>::Wide;
                type Word = <Standard as Format>::Word;
            }
        )+
    };
}

// The guard band of all but the last is Standard's in pixels.
formats! {
    Bits1 1, 15 + 1, Standard::MAX_TARGET, "As [`Standard`]";
    Bits2 2, 15 + 2, Standard::MAX_TARGET, "As [`Standard`]";
    Bits3 3, 15 + 3, Standard::MAX_TARGET, "As [`Standard`]";
    Bits4 4, 15 + 4, Standard::MAX_TARGET, "As [`Standard`]";
    Bits5 5, 15 + 5, Standard::MAX_TARGET, "As [`Standard`]";
    Bits6 6, 15 + 6, Standard::MAX_TARGET, "As [`Standard`]";
    Bits7 7, 15 + 7, Standard::MAX_TARGET, "As [`Standard`]";
    Bits0 0, 15, Standard::MAX_TARGET, "Refused by the rasterizer: as [`Standard`]";
    Bits12 12, 15 + 12, Standard::MAX_TARGET, "Refused by the rasterizer: as [`Standard`]";
    Bits12Near 12, 23, 1984, "Refused by the rasterizer: as many steps of guard band as [`Standard`]";
}

/// The assertions of [`Bounds::CHECKED`] that a format does not hold, each with its numbers. A format with 64-bit
/// integers, whose divisions [`Standard`] uses up: what it divides by is the widest that can be.
#[must_use]
pub fn broken<F>() -> Vec<String>
where
    F: Format<Wide = <Standard as Format>::Wide, Word = <Standard as Format>::Word>,
{
    let (bits, guard, target) = (F::SUBPIXEL_BITS, F::GUARD_BAND_BITS, F::MAX_TARGET);
    let (tile, block) = (Bounds::<F>::MAX_TILE_VALUE, Bounds::<F>::MAX_BLOCK_STEPS);
    let (area, numerator) = (Bounds::<F>::MAX_AREA, Bounds::<F>::MAX_NUMERATOR);
    let (clip, error) = (Bounds::<F>::CLIP_PIXELS, Bounds::<F>::MAX_DEPTH_ERROR_2_16);
    let power = |value: i128| format!("2^{:.2}", (value as f64).log2());
    let checks = [
        ((1..=8).contains(&bits), format!("1 to 8 sub-pixel bits: {bits}")),
        (
            guard <= 23,
            format!("a coordinate is exact in an f32 with its half step: 2^{guard} steps, at most 2^23"),
        ),
        (guard > bits + 5, format!("the clip margin is a whole pixel: 2^{guard} steps of 2^-{bits} px")),
        (target.is_multiple_of(64) && target > 0, format!("targets of whole tiles: {target} px")),
        (
            i64::from(target) <= i64::from(clip),
            format!("the target lies inside the clip square: {target} of {clip} px"),
        ),
        (area < i128::from(i64::MAX), format!("edge values fit 64 bits: {}", power(area))),
        (
            tile <= i128::from(i32::MAX),
            format!("values inside a tile fit 32-bit lanes: {}, below 2^31", power(tile)),
        ),
        (block < 1 << 30, format!("steps inside a block: {}, below 2^30", power(block))),
        (
            area <= Bounds::<Standard>::MAX_AREA,
            format!("the gradient's division by the area: {}, at most 2^48", power(area)),
        ),
        (
            numerator <= i128::from(i64::MAX),
            format!("the gradient's numerator: {}, below 2^63", power(numerator)),
        ),
        (error < 2 << 16, format!("depths stay inside their range: {error} of 2^-16 units, below 2^17")),
    ];
    checks.into_iter().filter(|(holds, _)| !holds).map(|(_, what)| what).collect()
}

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
    fn formats_that_are_drawn_break_nothing_and_the_others_what_is_told() {
        // These compile, so every assertion holds.
        let () = (Bounds::<Bits1>::CHECKED, Bounds::<Bits7>::CHECKED).1;
        assert_eq!([broken::<Bits1>(), broken::<Bits7>(), broken::<Standard>()].concat(), [""; 0]);
        assert_eq!(broken::<Bits0>(), ["1 to 8 sub-pixel bits: 0"]);
        assert_eq!(broken::<Bits12Near>(), ["1 to 8 sub-pixel bits: 12"]);
        let told = broken::<Bits12>();
        let starts = [
            "1 to 8",
            "a coordinate",
            "values inside a tile",
            "steps inside a block",
            "the gradient's division",
        ];
        assert_eq!(told.len(), starts.len(), "{told:?}");
        assert!(told.iter().zip(starts).all(|(told, start)| told.starts_with(start)), "{told:?}");
        assert!(told[2].ends_with(": 2^34.98, below 2^31"), "{told:?}");
    }

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
