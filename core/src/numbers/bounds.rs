//! Every bound of the rasterizer, derived from a format's parameters and asserted at compile time.

use super::{
    format::{Format, Small, Standard},
    wide::Wide,
    word::Word,
};
use core::marker::PhantomData;

/// The bounds that follow from a [`Format`].
///
/// | quantity | bound | `Standard` | `Small` |
/// |---|---|---|---|
/// | vertex x, y | `GUARD_BAND` | 2^23 | 2^14 |
/// | edge deltas A, B | `MAX_DELTA` | 2^24 | 2^15 |
/// | edge value E, doubled area D | `MAX_AREA` | 2^48 | 2^30 |
/// | what is taken off an edge value | `MAX_BIAS` | 2^24 | 2^15 |
/// | edge value at a pixel of a tile that the edge crosses | `MAX_TILE_VALUE` | < 2^31 | < 2^31 |
/// | steps of an edge value within a block | `MAX_BLOCK_STEPS` | < 2^27 | < 2^18 |
/// | numerator of a depth gradient | `MAX_NUMERATOR` | 2^57 | 2^32 |
///
/// An edge value E(p) = A (px - xa) + B (py - ya) is twice the signed area of the triangle (a, b, p).
/// All three points lie in the guard band, a square of side `MAX_DELTA`, and a triangle in a square
/// covers at most half of it; hence the bound on E, and on D. Each of the two products is at most
/// `MAX_DELTA`², and their sum is exact, so no intermediate value is larger. A pixel's corners, where
/// conservative coverage evaluates E, are no farther out than `MAX_TARGET` pixels and so in the guard band too.
#[derive(Clone, Copy, Debug)]
pub struct Bounds<F>(PhantomData<F>);

impl<F: Format> Bounds<F> {
    /// Steps in a pixel, 2^S.
    pub const STEPS_PER_PIXEL: i32 = 1 << F::SUBPIXEL_BITS;
    /// Largest magnitude of a vertex's x and y, in steps.
    pub const GUARD_BAND: i32 = 1 << F::GUARD_BAND_BITS;
    /// Largest magnitude of a difference of two coordinates, in steps.
    pub const MAX_DELTA: i32 = 2 * Self::GUARD_BAND;
    /// Largest magnitude of an edge value and of a doubled area, in steps².
    pub const MAX_AREA: i128 = (Self::MAX_DELTA as i128) * (Self::MAX_DELTA as i128);
    /// Largest magnitude of what a rule takes off an edge value, in steps²: half of |A| + |B|, rounded up.
    pub const MAX_BIAS: i128 = Self::MAX_DELTA as i128;
    /// Largest magnitude of a reduced edge value at a pixel of a 64x64 tile that the edge crosses:
    /// the value changes its sign within the tile, and 63 steps each way are all there is.
    pub const MAX_TILE_VALUE: i128 = 63 * 2 * (Self::MAX_DELTA as i128);
    /// Largest magnitude of what an edge value's steps from a 4x4 block's first pixel to another add up to.
    pub const MAX_BLOCK_STEPS: i128 = 3 * 2 * (Self::MAX_DELTA as i128);
    /// Largest magnitude of a depth gradient's numerator, in steps times depth units.
    pub const MAX_NUMERATOR: i128 = 2 * (Self::MAX_DELTA as i128) * ((1 << F::Word::HALF_BITS) - 1);
    /// The farthest from 0 that clipping leaves a vertex, in pixels: 31/32 of the guard band. The
    /// rest is room for the rounding of the clip arithmetic.
    pub const CLIP_PIXELS: i32 = (Self::GUARD_BAND >> F::SUBPIXEL_BITS) / 32 * 31;
    /// Largest error of an interpolated depth, in units of the format's widest depth
    /// (2^-32 for [`Standard`], 2^-16 for [`Small`]), times 2^16: half a unit for the rounding of a
    /// block's base, half for the rounding of a lane's offset, and half a unit of the gradient's
    /// last place for each of up to `MAX_DELTA` steps in x and in y.
    pub const MAX_DEPTH_ERROR_2_16: i64 =
        (1 << 16) + (((Self::MAX_DELTA as i64) << 16) >> F::Word::HALF_BITS);

    /// Fails to compile where a bound does not hold; every constructor of the crate evaluates it.
    pub const CHECKED: () = {
        assert!(F::SUBPIXEL_BITS >= 1 && F::SUBPIXEL_BITS <= 8, "1 to 8 sub-pixel bits");
        assert!(F::GUARD_BAND_BITS <= 23, "a coordinate is exact in an f32 with its half step");
        assert!(F::GUARD_BAND_BITS > F::SUBPIXEL_BITS + 5, "the clip margin is a whole pixel");
        assert!(F::MAX_TARGET.is_multiple_of(64) && F::MAX_TARGET > 0, "targets of whole tiles");
        assert!(F::MAX_TARGET as i64 <= Self::CLIP_PIXELS as i64, "the target lies inside the clip square");
        assert!(
            Self::MAX_AREA + Self::MAX_BIAS <= <F::Wide as Wide>::MAX,
            "edge values, areas and biases fit Wide"
        );
        assert!(Self::MAX_TILE_VALUE <= i32::MAX as i128, "values inside a tile fit 32-bit lanes");
        assert!(Self::MAX_BLOCK_STEPS < 1 << 30, "a dropped edge of value 2^30 is positive in a block");
        assert!(Self::MAX_AREA <= F::Word::MAX_DIVISOR, "the gradient's division fits Word");
        assert!(Self::MAX_NUMERATOR <= F::Word::MAX_NUMERATOR, "the gradient's numerator fits Word");
        assert!(Self::MAX_DEPTH_ERROR_2_16 < 2 << 16, "depths stay inside their range");
    };
}

const _: () = Bounds::<Standard>::CHECKED;
const _: () = Bounds::<Small>::CHECKED;
// 1 + 2^-8 units of 2^-32, within the promised 1.01; 1.5 units of 2^-16.
const _: () = assert!(Bounds::<Standard>::MAX_DEPTH_ERROR_2_16 * 100 <= 101 << 16);
const _: () = assert!(Bounds::<Small>::MAX_DEPTH_ERROR_2_16 * 10 <= 15 << 16);
