//! Proofs of hierarchical depth as a whole: its answers are those of its pixels.

use super::super::hierarchical::{DepthRange, depth_ranges, limit::Limit};
use crate::{
    attachments::{Compare, D32, DepthTest, HierarchicalDepth, texels},
    geometry::Region,
    numbers::Standard,
    proof::{cover, prove},
};

/// Pixels of two squares, the second of one block.
const WIDTH: u32 = 20;
const HEIGHT: u32 = 4;
const TEXELS: usize = texels(WIDTH, HEIGHT);

/// Depths that are all `others` but at (2, 1), in the first square, and (17, 3), in the second.
#[inline(always)]
fn depths(others: u32, [first, second]: [u32; 2]) -> [u32; TEXELS] {
    let mut depths = [others; TEXELS];
    depths[4 + 2] = first;
    depths[4 * 16 + 3 * 4 + 1] = second;
    depths
}

/// Whether what is in the columns of an area, at `nearest` or farther, is hidden at each pixel.
#[inline(always)]
fn is_hidden_everywhere(
    compare: Compare,
    nearest: u32,
    others: u32,
    [first, second]: [u32; 2],
    [x0, x1]: [u32; 2],
) -> bool {
    let Some(limit) = Limit::new::<Standard, D32>(compare, nearest) else { return false };
    let hides = |depth| limit.hides(DepthRange { low: depth, high: depth, version: 0 });
    let [has_first, has_second] = [2, 17].map(|x| x0 <= x && x < x1);
    // A whole column at least is of the others.
    (!has_first || hides(first)) && (!has_second || hides(second)) && hides(others)
}

/// Questions one after the other, about columns of all rows: each answer is that of every pixel.
#[inline(always)]
fn answers_are_exact(test: DepthTest, nearest: u32, others: u32, pixels: [u32; 2], questions: &[[u32; 2]]) {
    let Ok(region) = Region::<Standard>::of_size(WIDTH, HEIGHT) else { return };
    let mut storage = depths(others, pixels);
    let mut ranges = [DepthRange::UNKNOWN; depth_ranges(WIDTH, HEIGHT)];
    let depth = HierarchicalDepth::<Standard>::new(region, &mut storage, &mut ranges, test);
    let Ok(mut depth) = depth else { unreachable!("there is enough memory") };
    for &[x0, x1] in questions {
        let Ok(area) = Region::new(x0, 0, x1, HEIGHT) else { return };
        let expected = is_hidden_everywhere(test.compare, nearest, others, pixels, [x0, x1]);
        assert!(depth.hides(area, nearest) == expected);
    }
}

prove! {
    /// The answer is that of every pixel, for the columns of one square, of parts of both, and of all: two of the
    /// depths and the one asked about are any.
    #[kani::unwind(18)]
    [HierarchicalDepth::hides_with, HierarchicalDepth::look, HierarchicalDepth::shows, Tiled::rows]
    fn hidden_is_hidden_at_every_pixel(nearest: u32, pixels: [u32; 2]) {
        for columns in [[0, 16], [3, 5], [2, 18], [17, 20]] {
            answers_are_exact(DepthTest::LESS, nearest, 1000, pixels, &[columns]);
        }
        cover!(nearest == 1001 && pixels == [1001, 7]);
    }

    /// What was found for one question is not taken for more than it is in the next.
    #[kani::unwind(18)]
    [HierarchicalDepth::hides_with, HierarchicalDepth::look, HierarchicalDepth::shows]
    fn slow_answers_do_not_depend_on_earlier_ones(nearest: u32, pixels: [u32; 2]) {
        answers_are_exact(DepthTest::LESS, nearest, 1000, pixels, &[[0, 4], [0, 20]]);
        cover!(nearest == 1001 && pixels == [1001, 7]);
    }
}
