//! Properties that no prover finished: for tests alone.

use super::{
    super::hierarchical::{DepthRange, limit::Limit},
    hierarchical::COMPARISONS,
};
use crate::{
    attachments::{D32, DepthTest, HierarchicalDepth},
    geometry::Region,
    numbers::Standard,
    proof::prove,
};

/// The answer for a region of one block, of these depths, is that of its pixels one by one, asked twice.
fn is_every_pixel(
    compare: usize,
    texels: [u32; 16],
    area: [u32; 4],
    nearest: u32,
    [width, height]: [u32; 2],
) {
    let compare = COMPARISONS[compare];
    let (Ok(region), [x0, y0, x1, y1]) = (Region::<Standard>::of_size(width, height), area) else { return };
    let Ok(area) = Region::new(x0, y0, x1, y1) else { return };
    let (mut storage, mut ranges) = (texels, [DepthRange::UNKNOWN; 2]);
    let test = DepthTest { compare, write: true };
    let depth = HierarchicalDepth::<Standard>::new(region, &mut storage, &mut ranges, test);
    let Ok(mut depth) = depth else { unreachable!("there is memory") };
    let hidden = depth.hides(area, nearest);
    let limit = Limit::new::<Standard, D32>(compare, nearest);
    let mut expected = limit.is_some();
    for (at, &stored) in (0..).zip(&texels) {
        let (x, y) = (at % 4, at / 4);
        let asked = x0 <= x && x < x1.min(width) && y0 <= y && y < y1.min(height);
        let shown = limit.is_some_and(|l| !l.hides(DepthRange { low: stored, high: stored, version: 0 }));
        expected &= !(asked && shown);
    }
    assert!(hidden == expected);
    // Now that the ranges are known.
    assert!(depth.hides(area, nearest) == expected);
}

prove! {
    /// A whole answer: nothing is said to be hidden but where every pixel hides it, and everything is that is.
    []
    fn answers_are_every_pixels(
        compare: usize = 0..=4,
        texels: [u32; 16],
        area: [u32; 4] = [0; 4]..=[3, 3, 5, 5],
        nearest: u32,
        size: [u32; 2] = [1; 2]..=[4; 2],
    ) {
        is_every_pixel(compare, texels, area, nearest, size);
    }
}
