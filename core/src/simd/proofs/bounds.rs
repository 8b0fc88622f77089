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

/// Whether a triangle of that extent is small and whether it is medium, as it should be, and the pixels of its window;
/// `None` where it has none.
#[inline(always)]
fn small_and_medium(
    low: [i32; 2],
    size: [i32; 2],
    region: Region<Standard>,
) -> Option<(bool, bool, [i32; 2])> {
    let ([left, top], [width, height]) = (low, size);
    let (right, bottom) = (left + width, top + height);
    let found = Extent::new(simd(), region, &State::new(region))
        .bounds([left, right, top, bottom].map(|v| splat(simd(), v)));
    let [x0, x1, y0, y1] = found.inside.map(|lanes| ints(lanes)[3]);
    if x0 >= x1 || y0 >= y1 {
        return None;
    }
    let (small, medium) = (bits(found.small()) & 1 != 0, bits(found.medium()) & 1 != 0);
    // From the first pixel's block on.
    let window = [x1 - (x0 & !3), y1 - (y0 & !3)];
    // No sample of a row outside is at the triangle's height.
    let (first, end) = (((region.y0() as i32 - 1) << 8) + 128, ((region.y1() as i32) << 8) + 128);
    let compact = width < 72 << 8 && height < 72 << 8 && first < top && bottom <= end;
    assert!(medium == (compact && window[0] <= 4 * MEDIUM[0] && window[1] <= 4 * MEDIUM[1]));
    assert!(small == (medium && window[0] <= 4 * SMALL && window[1] <= 4 * SMALL));
    Some((small, medium, window))
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

    /// Triangles with pixels are small or medium where they are below 72 pixels each way, have no row outside the region,
    /// and whole blocks in the window.
    [Extent::bounds, PixelBounds::small, PixelBounds::medium, PixelBounds::within]
    fn windows_hold_small_and_medium(
        low: [i32; 2] = [-BAND; 2]..=[BAND; 2],
        size: [i32; 2] = [0; 2]..=[32768; 2],
        region: [u32; 4] = [0; 4]..=[TARGET; 4],
    ) {
        let [x0, y0, x1, y1] = region;
        let Ok(region) = Region::new(x0, y0, x1, y1) else { return };
        let Some((small, medium, window)) = small_and_medium(low, size, region) else { return };
        cover!(medium && window == [28, 64]);
        cover!(small && window == [8, 8]);
    }

    /// The same for triangles that begin before a region or in it, which is some hundred pixels wide.
    [Extent::bounds, PixelBounds::small, PixelBounds::medium, PixelBounds::within]
    fn windows_hold_small_and_medium_at_the_side(
        low: [i32; 2] = [-(100 << 8); 2]..=[100 << 8; 2],
        size: [i32; 2] = [0; 2]..=[100 << 8; 2],
        origin: [u32; 2] = [0; 2]..=[TARGET - 128; 2],
        sides: [u32; 2] = [1; 2]..=[128; 2],
    ) {
        let ([x, y], [width, height]) = (origin, sides);
        let Ok(region) = Region::new(x, y, x + width, y + height) else { return };
        let low = [low[0] + ((x as i32) << 8), low[1] + ((y as i32) << 8)];
        let Some((small, medium, window)) = small_and_medium(low, size, region) else { return };
        cover!(medium && window == [28, 64]);
        cover!(!medium && window == [8, 8]);
        cover!(small && window == [1, 5]);
    }
}
