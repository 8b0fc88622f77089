//! Samples, regions, extents: which pixels there are.

use super::{LAST_SMALL, LAST_STANDARD, SMALL, STANDARD, sample, vertex};
use crate::{
    Format, Region, RegionError, Sample, Small, Standard,
    geometry::{Extent, is_outside},
    numbers::Bounds,
    proof::{assume, cover, prove},
};

#[inline(always)]
fn samples<F: Format>(x: i32, y: i32, column: u32, row: u32) {
    let pixel = Bounds::<F>::STEPS_PER_PIXEL;
    let inside = 0 <= x && x < pixel && 0 <= y && y < pixel;
    let Some(sample) = Sample::<F>::new(x, y) else {
        assert!(!inside);
        return;
    };
    assert!(inside);
    let at = sample.of_pixel(column, row);
    assert!(at == (column as i32 * pixel + x, row as i32 * pixel + y));
    assert!(at.0 < Bounds::<F>::GUARD_BAND && at.1 < Bounds::<F>::GUARD_BAND);
    assert!(Sample::<F>::CENTER.of_pixel(column, row).0 == column as i32 * pixel + pixel / 2);
    cover!(x == 0 && y == pixel - 1);
}

/// Pixel i is one of `first..end` exactly where its sample is at `low..high`.
#[inline(always)]
fn pixels<F: Format>(low: i32, high: i32, at: [i32; 2], pixel: u32) {
    let Some(sample) = sample::<F>(at) else { return };
    let (x, y) = sample.of_pixel(pixel, pixel);
    let (pixel, within) = (pixel as i32, |(first, end), pixel| first <= pixel && pixel < end);
    assert!(within(sample.columns(low, high), pixel) == (low <= x && x < high));
    assert!(within(sample.rows(low, high), pixel) == (low <= y && y < high));
    cover!(x == low && x < high);
    cover!(x == high);
}

#[inline(always)]
fn is_region<F: Format>([x0, y0, x1, y1]: [u32; 4]) -> bool {
    x0 < x1 && y0 < y1 && x1 <= F::MAX_TARGET && y1 <= F::MAX_TARGET
}

#[inline(always)]
fn region<F: Format>(ends: [u32; 4]) -> Option<Region<F>> {
    let [x0, y0, x1, y1] = ends;
    Region::new(x0, y0, x1, y1).ok()
}

#[inline(always)]
fn ends<F: Format>(region: Region<F>) -> [u32; 4] {
    [region.x0(), region.y0(), region.x1(), region.y1()]
}

#[inline(always)]
fn has<F: Format>(region: Region<F>, x: u32, y: u32) -> bool {
    region.x0() <= x && x < region.x1() && region.y0() <= y && y < region.y1()
}

#[inline(always)]
fn constructs_regions<F: Format>(given: [u32; 4]) {
    let [x0, y0, x1, y1] = given;
    match Region::<F>::new(x0, y0, x1, y1) {
        Ok(region) => {
            assert!(is_region::<F>(given) && ends(region) == given);
            assert!(region.width() == x1 - x0 && region.height() == y1 - y0);
            assert!(x0 != 0 || y0 != 0 || Region::of_size(x1, y1) == Ok(region));
            cover!(x1 == F::MAX_TARGET);
        }
        Err(RegionError::TargetTooLarge { x1: x, y1: y, limit }) => {
            assert!((x, y) == (x1, y1) && limit == F::MAX_TARGET && (x1 > limit || y1 > limit));
        }
        Err(RegionError::Empty { width, height }) => {
            assert!(x1 <= F::MAX_TARGET && y1 <= F::MAX_TARGET && (width == 0 || height == 0));
            assert!(u64::from(x0) + u64::from(width) == u64::from(x0.max(x1)));
            cover!(width > 0);
        }
    }
}

/// A pixel is in the cut where it is in both; nothing is said of no pixels.
#[inline(always)]
fn cuts<F: Format>(given: [u32; 4], [x0, y0, x1, y1]: [u32; 4], [x, y]: [u32; 2]) {
    let Some(region) = region::<F>(given) else { return };
    let both = has(region, x, y) && x0 <= x && x < x1 && y0 <= y && y < y1;
    match region.cut(x0, y0, x1, y1) {
        Some(cut) => {
            assert!(is_region::<F>(ends(cut)) && region.contains(cut) && has(cut, x, y) == both);
            cover!(!region.contains(cut) || cut != region);
        }
        None => {
            assert!(!both);
            cover!(x0 < x1 && y0 < y1);
        }
    }
}

#[inline(always)]
fn two_regions<F: Format>(given: [u32; 4], other: [u32; 4], [x, y]: [u32; 2]) {
    let (Some(region), Some(other)) = (region::<F>(given), region::<F>(other)) else { return };
    let common = region.intersect(other);
    assert!(common.is_some_and(|common| has(common, x, y)) == (has(region, x, y) && has(other, x, y)));
    assert!(common == other.intersect(region));
    // One contains the other exactly where their intersection is the other.
    assert!(region.contains(other) == (common == Some(other)));
    cover!(common.is_none());
    cover!(region.contains(other) && region != other);
}

/// The blocks of a region are whole, hold it, and each holds a pixel of it.
#[inline(always)]
fn block_ends<F: Format>(given: [u32; 4]) {
    let Some(region) = region::<F>(given) else { return };
    let blocks = region.blocks();
    assert!(blocks.contains(region) && is_region::<F>(ends(blocks)));
    assert!(ends(blocks).into_iter().all(|end| end.is_multiple_of(4)));
    assert!(region.x0() - blocks.x0() < 4 && blocks.x1() - region.x1() < 4);
    assert!(region.y0() - blocks.y0() < 4 && blocks.y1() - region.y1() < 4);
    cover!(blocks == region);
}

/// The bounds of three vertices hold a pixel of the region exactly where its sample lies in the half-open
/// extent; none where the extent is outside.
#[inline(always)]
fn bounds<F: Format>(corners: [[i32; 2]; 3], at: [i32; 2], given: [u32; 4], [column, row]: [u32; 2]) {
    let Some(region) = region::<F>(given) else { return };
    let Some(sample) = sample::<F>(at) else { return };
    let [a, b, c] = corners;
    let (Some(a), Some(b), Some(c)) = (vertex(a, 0), vertex(b, 0), vertex(c, 0)) else { return };
    assume!(has(region, column, row));
    let (x, y) = sample.of_pixel(column, row);
    let [xs, ys] = [[a.x(), b.x(), c.x()], [a.y(), b.y(), c.y()]];
    let within = |at: i32, all: [i32; 3]| all.iter().any(|v| *v <= at) && all.iter().any(|v| at < *v);
    let expected = within(x, xs) && within(y, ys);
    let extent = Extent::of([a, b, c]);
    let found = extent.bounds(sample, region);
    assert!(found.is_ok_and(|found| has(found, column, row)) == expected);
    assert!(found.is_ok_and(|found| region.contains(found)) || found.is_err());
    let outside = is_outside([a, b, c], region);
    assert!(!(outside && expected));
    cover!(outside);
    cover!(expected);
    cover!(!outside && found.is_err());
}

prove! {
    /// A sample position is less than a pixel from the pixel's corner; window positions of samples fit.
    [Sample::new, Sample::of_pixel]
    fn samples_of_standard(x: i32, y: i32, column: u32 = 0..=LAST_STANDARD, row: u32 = 0..=LAST_STANDARD) {
        samples::<Standard>(x, y, column, row);
    }

    /// The same for the small format.
    [Sample::new, Sample::of_pixel]
    fn samples_of_small(x: i32, y: i32, column: u32 = 0..=LAST_SMALL, row: u32 = 0..=LAST_SMALL) {
        samples::<Small>(x, y, column, row);
    }

    /// The pixels between two coordinates are those whose samples are.
    [Sample::columns, Sample::rows, Sample::pixels]
    fn pixels_of_standard(
        low: i32 = -STANDARD..=STANDARD,
        high: i32 = -STANDARD..=STANDARD,
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: u32 = 0..=LAST_STANDARD,
    ) {
        pixels::<Standard>(low, high, at, pixel);
    }

    /// The same for the small format.
    [Sample::columns, Sample::rows, Sample::pixels]
    fn pixels_of_small(
        low: i32 = -SMALL..=SMALL,
        high: i32 = -SMALL..=SMALL,
        at: [i32; 2] = [0; 2]..=[255; 2],
        pixel: u32 = 0..=LAST_SMALL,
    ) {
        pixels::<Small>(low, high, at, pixel);
    }

    /// A region is made of exactly the rectangles with a pixel inside the largest target.
    [Region::new, Region::of_size, Region::width, Region::height]
    fn regions_are_inside_the_target(given: [u32; 4]) {
        constructs_regions::<Standard>(given);
        constructs_regions::<Small>(given);
    }

    /// Cutting a region.
    [Region::cut, Region::contains]
    fn cuts_hold_what_both_hold(given: [u32; 4], cut: [u32; 4], pixel: [u32; 2]) {
        cuts::<Standard>(given, cut, pixel);
    }

    /// Intersecting two.
    [Region::intersect, Region::contains]
    fn intersections_hold_what_both_hold(given: [u32; 4], other: [u32; 4], pixel: [u32; 2]) {
        two_regions::<Small>(given, other, pixel);
    }

    /// Rounding out to whole blocks: targets are whole blocks, so nothing overflows.
    #[kani::unwind(5)]
    [Region::blocks]
    fn regions_round_out_to_blocks(given: [u32; 4]) {
        block_ends::<Standard>(given);
        block_ends::<Small>(given);
    }

    /// Bounds and rejection of a triangle, for every region, sample position and pixel.
    #[kani::unwind(4)]
    [Extent::of, Extent::bounds, Extent::is_outside, is_outside]
    fn bounds_of_standard(
        corners: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3],
        at: [i32; 2] = [0; 2]..=[255; 2],
        given: [u32; 4],
        pixel: [u32; 2],
    ) {
        bounds::<Standard>(corners, at, given, pixel);
    }

    /// The same for the small format.
    #[kani::unwind(4)]
    [Extent::of, Extent::bounds, Extent::is_outside, is_outside]
    fn bounds_of_small(
        corners: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3],
        at: [i32; 2] = [0; 2]..=[255; 2],
        given: [u32; 4],
        pixel: [u32; 2],
    ) {
        bounds::<Small>(corners, at, given, pixel);
    }
}
