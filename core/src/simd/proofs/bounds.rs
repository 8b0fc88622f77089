//! The bounds of sixteen triangles.

use super::{
    super::extent::{Extent, MEDIUM, SMALL},
    ints, simd,
};
use crate::{
    draw::State,
    geometry::{self, Region, Sample, Vertex},
    numbers::{Bounds, Standard},
    proof::{cover, prove},
    simd::ops::{bits, splat},
};

/// Steps in the guard band.
const BAND: i32 = Bounds::<Standard>::GUARD_BAND;
/// The largest target.
const TARGET: u32 = 16384;

/// A state with samples there.
#[inline(always)]
fn state(region: Region<Standard>, [x, y]: [i32; 2]) -> Option<State<Standard>> {
    Some(State { sample: Sample::new(x, y)?, ..State::new(region) })
}

prove! {
    /// The pixels are those of the scalar set-up, none where it finds none.
    [Extent::new, Extent::bounds, PixelBounds::empty, Extent::of, Extent::bounds]
    fn bounds_are_those_of_one_triangle(
        low: [i32; 2] = [-BAND; 2]..=[BAND; 2],
        high: [i32; 2] = [-BAND; 2]..=[BAND; 2],
        region: [u32; 4] = [0; 4]..=[TARGET; 4],
        sample: [i32; 2] = [0; 2]..=[255; 2],
    ) {
        let ([left, top], [right, bottom], [x0, y0, x1, y1]) = (low, high, region);
        if left > right || top > bottom {
            return;
        }
        let Ok(region) = Region::new(x0, y0, x1, y1) else { return };
        let Some(state) = state(region, sample) else { return };
        let (Ok(a), Ok(b)) = (Vertex::<Standard>::new(left, top, 0), Vertex::new(right, bottom, 0)) else { return };
        let found = Extent::new(simd(), region, &state).bounds([left, right, top, bottom].map(|v| splat(simd(), v)));
        let inside = found.inside.map(|lanes| ints(lanes)[9]);
        let empty = bits(found.empty());
        match geometry::Extent::of([a, b, a]).bounds(state.sample, region) {
            Ok(expected) => {
                let expected = [expected.x0(), expected.x1(), expected.y0(), expected.y1()];
                assert!(empty == 0 && inside == expected.map(|v| v as i32));
            }
            Err(_) => assert!(empty == 0xFFFF),
        }
        cover!(empty == 0 && inside[1] < x1 as i32 && inside[0] == x0 as i32);
        cover!(empty != 0);
    }

    /// Triangles with pixels that are small or medium: below 72 pixels each way, no row outside the
    /// region, and whole blocks in the window.
    [Extent::bounds, PixelBounds::small, PixelBounds::medium, PixelBounds::within]
    fn windows_hold_small_and_medium(
        low: [i32; 2] = [-BAND; 2]..=[BAND; 2],
        size: [i32; 2] = [0; 2]..=[32768; 2],
        region: [u32; 4] = [0; 4]..=[TARGET; 4],
    ) {
        let ([left, top], [width, height], [x0, y0, x1, y1]) = (low, size, region);
        let (right, bottom) = (left + width, top + height);
        let Ok(region) = Region::new(x0, y0, x1, y1) else { return };
        let found = Extent::new(simd(), region, &State::new(region))
            .bounds([left, right, top, bottom].map(|v| splat(simd(), v)));
        let [x0, x1, y0, y1] = found.inside.map(|lanes| ints(lanes)[3]);
        if x0 >= x1 || y0 >= y1 {
            return;
        }
        let (small, medium) = (bits(found.small()) & 1 != 0, bits(found.medium()) & 1 != 0);
        // From the first pixel's block on.
        let window = [x1 - (x0 & !3), y1 - (y0 & !3)];
        if medium {
            assert!(window[0] <= 4 * MEDIUM[0] && window[1] <= 4 * MEDIUM[1]);
            assert!(width < 72 << 8 && height < 72 << 8);
            assert!((y0 << 8) - top <= 128 && bottom - (y1 << 8) <= 128);
        }
        assert!(!small || medium);
        assert!(small == (medium && window[0] <= 4 * SMALL && window[1] <= 4 * SMALL));
        cover!(medium && window == [28, 64]);
        cover!(small && window == [8, 8]);
    }
}
