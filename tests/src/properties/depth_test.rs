//! Each comparison, with writes on and off, against a model of one pixel.

use crate::{Failure, Frame, ensure_eq, failure::Verdict, oracle, shapes::Random, strategies::Shot};
use halfplane::{Compare, Count, Depth, DepthFormat, DepthTest, Format, Ids, NO_ID, draw, texels};
use halfplane_reference::{DepthSpec, SpecifiedPlane};

/// All comparisons.
pub const COMPARISONS: [Compare; 5] =
    [Compare::Less, Compare::LessEqual, Compare::Greater, Compare::GreaterEqual, Compare::Always];

/// One pixel: what the comparison says of numbers, and nothing else.
#[derive(Clone, Copy)]
struct Pixel {
    depth: u32,
    id: u32,
}

impl Pixel {
    fn take(&mut self, test: DepthTest, depth: u32, id: u32) -> bool {
        let passes = match test.compare {
            Compare::Less => depth < self.depth,
            Compare::LessEqual => depth <= self.depth,
            Compare::Greater => depth > self.depth,
            Compare::GreaterEqual => depth >= self.depth,
            Compare::Always => true,
        };
        if passes {
            self.id = id;
            if test.write {
                self.depth = depth;
            }
        }
        passes
    }
}

/// Draws over stored depths that lie close to the triangles' own, so that every outcome occurs, ties
/// included, and compares depth, id and the number of passing samples with the model.
pub fn equals_model<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    shots: &[Shot],
    test: DepthTest,
    spec: DepthSpec,
    seed: u64,
) -> Verdict
where
    D::Texel: TryFrom<u32>,
{
    let grid = frame.grid::<F>()?;
    let mut random = Random(seed);
    // The specified depths of each triangle at each covered pixel.
    let mut drawn = Vec::new();
    for shot in shots {
        let z = oracle::vertex_depths(shot.z, spec);
        let covered = oracle::coverage::<F>(frame, &shot.corners)?;
        let Some(plane) = SpecifiedPlane::new(&shot.corners, &z, grid, spec) else {
            drawn.push(vec![None; covered.len()]);
            continue;
        };
        let depth = |((x, y), covered): ((u32, u32), bool)| covered.then(|| plane.at(x, y));
        drawn.push(frame.pixels().zip(covered).map(depth).collect());
    }
    let mut model: Vec<Pixel> = (0..(frame.width() * frame.height()) as usize)
        .map(|place| {
            let chosen = drawn.get(random.below(drawn.len())).and_then(|depths| depths[place]);
            let depth = match (chosen, random.below(4)) {
                (Some(depth), 0 | 1) => depth,
                (Some(depth), 2) => depth + 1,
                (Some(depth), _) => depth - 1,
                (None, _) => random.bits() as u32 & spec.farthest(),
            };
            Pixel { depth, id: NO_ID }
        })
        .collect();

    let size = texels(frame.width(), frame.height());
    let (mut depth_storage, mut id_storage) = (vec![D::FAR; size], vec![0; size]);
    let pitch = frame.width().div_ceil(4);
    for (pixel, known) in frame.pixels().zip(&model) {
        let (column, row) = (pixel.0 - frame.region[0], pixel.1 - frame.region[1]);
        let place = (row / 4 * pitch + column / 4) * 16 + row % 4 * 4 + column % 4;
        depth_storage[place as usize] =
            D::Texel::try_from(known.depth).map_err(|_| Failure::new("a model depth has too many bits"))?;
    }
    let region = frame.core_region()?;
    let mut depth = Depth::<F, D>::new(region, &mut depth_storage, test)?;
    let mut ids = Ids::<F>::new(region, &mut id_storage)?;
    ids.clear();
    let mut count = Count::default();
    let indices: Vec<u32> = (0..3 * shots.len() as u32).collect();
    let attachments = &mut (&mut depth, &mut ids, &mut count);
    draw(&super::scene::vertices::<F>(shots)?[..], &indices, 40, &frame.state()?, attachments)?;

    let mut passed = 0;
    for (id, depths) in (40..).zip(&drawn) {
        for (pixel, depth) in model.iter_mut().zip(depths) {
            passed += u64::from(depth.is_some_and(|depth| pixel.take(test, depth, id)));
        }
    }
    for (pixel, expected) in frame.pixels().zip(&model) {
        ensure_eq!(depth.get(pixel.0, pixel.1).map(Into::into), Some(expected.depth), "depth at {pixel:?}");
        ensure_eq!(ids.get(pixel.0, pixel.1), Some(expected.id), "id at {pixel:?}");
    }
    ensure_eq!(count.samples, passed, "samples that passed");
    Ok(())
}
