//! What a box can cover at most.

use crate::{
    geometry::{Region, Sample},
    numbers::{Bounds, Coordinate, Format, Small, Standard, unorm32},
    proof::{assume, cover, prove, which},
    transform::{
        Bound, Viewport,
        bound::{Corners, pixels},
    },
};

/// A pixel whose sample lies between two window coordinates as they are snapped is among those found.
#[inline(always)]
fn holds_the_samples_between<F: Format>(ends: [u32; 2], column: u32, offset: i32) {
    let [first, last] = ends.map(f32::from_bits);
    let (Some(low), Some(high)) = (Coordinate::<F>::snap(first), Coordinate::<F>::snap(last)) else { return };
    let steps = (column << F::SUBPIXEL_BITS) as i32 + offset;
    let [x0, x1] = pixels::<F>([first, last], offset as f32 / Bounds::<F>::STEPS_PER_PIXEL as f32);
    assert!(!(low.steps() <= steps && steps <= high.steps()) || (x0 <= column && column < x1));
    cover!(low.steps() == steps && high.steps() == steps);
    cover!(x0 == column + 1 && low.steps() == steps + 2);
}

/// The matrix that moves object space.
fn moved(x: f32, y: f32, z: f32) -> [[f32; 4]; 4] {
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [x, y, z, 1.0]]
}

/// A box of half the viewport's size.
const BOX: [[f32; 3]; 2] = [[-0.5, -0.5, 0.25], [0.5, 0.5, 0.75]];

prove! {
    /// In pixels: steps times their size, less than a pixel.
    [Sample::offset]
    fn offsets_are_exact(x: i32 = 0..=255, y: i32 = 0..=255) {
        let Some(sample) = Sample::<Standard>::new(x, y) else { return };
        let (offset_x, offset_y) = sample.offset();
        assert!(offset_x * 256.0 == x as f32 && offset_y * 256.0 == y as f32);
        assert!((0.0..1.0).contains(&offset_x) && (0.0..1.0).contains(&offset_y));
    }

    /// Where two corners of a triangle are snapped to, pixels with samples between them are found: for all floats, at
    /// the sample in the centre.
    [pixels, Coordinate::snap]
    fn pixels_hold_the_samples_between(ends: [u32; 2], column: u32 = 0..=16383) {
        holds_the_samples_between::<Standard>(ends, column, 128);
    }

    /// The same at the pixel's left.
    [pixels, Coordinate::snap]
    fn pixels_hold_the_left_samples_between(ends: [u32; 2], column: u32 = 0..=16383) {
        holds_the_samples_between::<Standard>(ends, column, 0);
    }

    /// The same of the small format.
    [pixels, Coordinate::snap]
    fn small_pixels_hold_the_samples_between(ends: [u32; 2], column: u32 = 0..=Small::MAX_TARGET - 1) {
        holds_the_samples_between::<Small>(ends, column, 7);
    }

    /// A clip coordinate is taken at all eight corners: through coefficients whose products are exact.
    [Corners::new]
    fn corners_are_all_there(low: [u32; 3], high: [u32; 3]) {
        let (low, high) = (low.map(f32::from_bits), high.map(f32::from_bits));
        let found = Corners::new([1.0, -1.0, 1.0, 0.5], low, high);
        for corner in 0..8 {
            let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
            let expected = (at(0) - at(1)) + (at(2) + 0.5);
            assert!(found.values[corner] == expected || expected.is_nan());
        }
        cover!(found.values[7] == -3.0);
    }

    /// The size is at least the sum of the magnitudes at any corner, and no more than the largest such sum and twice
    /// what is added.
    [Corners::new]
    fn sizes_hold_all_magnitudes(number: u32 = 0..=31) {
        let found = which(32, |number| {
            let low = [number % 4 - 2, 1 - number / 4 % 4, number / 16 * 5 - 4];
            let high = [low[0] + 3, low[1] + 1, low[2] + 2];
            [-8, -1, 0, 3].into_iter().all(|added: i32| {
                let column = [2, -3, 1, added].map(|v| v as f32);
                let size = Corners::new(column, low.map(|v| v as f32), high.map(|v| v as f32)).size as i32;
                let most = (0..8).map(|corner| {
                    let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
                    2 * at(0).abs() + 3 * at(1).abs() + at(2).abs() + added.abs()
                });
                most.max().is_some_and(|most| most <= size && size <= most + 2 * added.abs())
            })
        });
        assert!(found >> number & 1 == 1);
        cover!(number == 31);
    }

    /// No quotient is left out of the ends, at any corner: seven corners at 1, and w at 2.
    [Corners::quotients, least]
    fn slow_quotients_lie_between_the_ends(value: u32, at: usize = 0..=7) {
        let value = f32::from_bits(value);
        assume!(value.abs() <= 1e30);
        let mut corners = Corners { values: [1.0; 8], size: 4.0 };
        corners.values[at] = value;
        let [low, high] = corners.quotients(Corners { values: [2.0; 8], size: 2.0 }, 2.0);
        assert!(low <= 0.5 && low <= 0.5 * value && 0.5 <= high && 0.5 * value <= high);
        cover!(low < -3.0);
    }

    /// Samples of a triangle in the box are in the bound, wherever the box is moved to: the pixels between where its
    /// corners are projected to.
    [Viewport::bound_box, Viewport::bound, ends_of_box, Corners::new, Corners::quotients, pixels]
    fn slow_moved_boxes_cover_no_more_columns(x: u32, column: u32 = 0..=63) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let (viewport, x) = (Viewport::new(region), f32::from_bits(x));
        let [low, high] = BOX.map(|[left, y, z]| viewport.project([left + x, y, z, 1.0]).map_or(0, |v| v.x()));
        let sample = (column << 8) as i32 + 128;
        let has = match viewport.bound_box(&moved(x, 0.0, 0.0), BOX, Sample::CENTER) {
            Bound::Nothing => false,
            Bound::Within { area, .. } => area.x0() <= column && column < area.x1(),
            Bound::Anything => true,
        };
        assert!(has || sample < low || high < sample);
        cover!(!has && column == 5);
        cover!(has && column == 5 && sample > low + 512);
    }

    /// The same for rows.
    [Viewport::bound_box, Viewport::bound, ends_of_box, Corners::new, Corners::quotients, pixels]
    fn slow_moved_boxes_cover_no_more_rows(y: u32) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let (viewport, y) = (Viewport::new(region), f32::from_bits(y));
        let [low, high] = BOX.map(|[x, bottom, z]| viewport.project([x, bottom + y, z, 1.0]).map_or(0, |v| v.y()));
        for row in [0, 5, 63] {
            let sample = (row << 8) as i32 + 128;
            let has = match viewport.bound_box(&moved(0.0, y, 0.0), BOX, Sample::CENTER) {
                Bound::Nothing => false,
                Bound::Within { area, .. } => area.y0() <= row && row < area.y1(),
                Bound::Anything => true,
            };
            assert!(has || sample < high || low < sample);
            cover!(has == (row == 5));
        }
    }

    /// A box of which a coordinate is no number can cover anything.
    [Viewport::bound_box, Corners::new]
    fn slow_boxes_without_numbers_cover_anything(low: [u32; 3], high: [u32; 3]) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let corners = [low, high].map(|corner| corner.map(f32::from_bits));
        assume!(corners.as_flattened().iter().any(|v| v.is_nan()));
        let bound = Viewport::new(region).bound_box(&moved(0.0, 0.0, 0.0), corners, Sample::CENTER);
        assert!(bound == Bound::Anything);
    }

    /// Depths in the box are between those of the bound, wherever it is moved to, by steps of 1/64.
    [Viewport::bound_box, Viewport::bound, ends_of_box, Corners::new, Corners::quotients]
    fn a_moved_box_has_no_other_depths(steps: i32 = -128..=127) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let (viewport, z) = (Viewport::new(region), steps as f32 / 64.0);
        let bound = viewport.bound_box(&moved(0.0, 0.0, z), BOX, Sample::CENTER);
        let Bound::Within { depths: [least, most], .. } = bound else { unreachable!("it is in the viewport") };
        let [[.., near], [.., far]] = BOX;
        assert!(least <= unorm32(near + z) && unorm32(far + z) <= most);
        cover!(least > 0 && most < u32::MAX);
    }
}
