//! What hierarchical depth says is hidden, against every pixel.

use crate::{Failure, Frame, ensure, ensure_eq, failure::Verdict, shapes::Random, strategies::Shot};
use halfplane::{
    Compare, Depth, DepthFormat, DepthRange, DepthTest, Format, HierarchicalDepth, Region, State,
    StorageError, Vertex, depth_ranges, draw, texels,
};
use halfplane_reference::DepthSpec;

/// Answers of both kinds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Answers {
    /// How often something was hidden.
    pub hidden: u64,
    /// How often not.
    pub seen: u64,
}

/// Whether a depth passes against a stored one.
const fn passes(compare: Compare, depth: i64, stored: i64) -> bool {
    match compare {
        Compare::Less => depth < stored,
        Compare::LessEqual => depth <= stored,
        Compare::Greater => depth > stored,
        Compare::GreaterEqual => depth >= stored,
        Compare::Always => true,
    }
}

/// Asks between draws, of depths close to the stored ones, and compares each answer with what the stored depths say
/// one by one; whatever was there before, and whatever was asked before. The depths are those of an attachment
/// that nobody asks.
pub fn answers_are_those_of_the_pixels<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    shots: &[Shot],
    test: DepthTest,
    spec: DepthSpec,
    seed: u64,
) -> Result<Answers, Failure> {
    let mut random = Random(seed);
    let region = frame.core_region()?;
    let (width, height) = (frame.width(), frame.height());
    let mut storage = vec![[D::FAR, D::NEAR][random.below(2)]; texels(width, height)];
    // What ranges hold before is of no account, nor are those beyond the last.
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(width, height) + random.below(3)];
    let mut answers = Answers::default();
    let mut plain_storage = storage.clone();
    let mut plain = Depth::<F, D>::new(region, &mut plain_storage, test)?;
    for _ in 0..2 {
        let mut depth = HierarchicalDepth::<F, D>::new(region, &mut storage, &mut ranges, test)?;
        ensure_eq!(depth.region(), region, "the region");
        if random.below(3) == 0 {
            let value = [D::FAR, D::NEAR][random.below(2)];
            depth.clear(value);
            plain.clear(value);
        }
        let vertices = super::scene::vertices::<F>(shots)?;
        for (at, shot) in shots.iter().enumerate() {
            let first = 3 * at as u32;
            let corners = [first, first + 1, first + 2];
            let drawn = draw(&vertices[..], &corners, 0, &frame.state()?, &mut depth)?;
            ensure_eq!(drawn, draw(&vertices[..], &corners, 0, &frame.state()?, &mut plain)?, "statistics");
            for _ in 0..random.below(6) {
                let question = Question::new(frame, shot, &mut random);
                let Some(area) = question.region::<F>() else { continue };
                ensure_eq!(depth.range(area), range_of(&plain, question.area), "range of {question:?}");
                let expected = question.is_hidden(&depth, test.compare, spec);
                ensure_eq!(depth.hides(area, question.nearest), expected, "{question:?} under {test:?}");
                if expected {
                    answers.hidden += 1;
                } else {
                    answers.seen += 1;
                }
            }
            if random.below(8) == 0 {
                let value = [D::FAR, D::NEAR][random.below(2)];
                depth.clear(value);
                plain.clear(value);
            }
        }
        let mut pictures = [0, 1].map(|_| vec![D::FAR; (width * height) as usize]);
        depth.depth().to_linear(&mut pictures[0])?;
        plain.to_linear(&mut pictures[1])?;
        ensure!(pictures[0] == pictures[1], "depths are not those of an attachment that nobody asks");
        let [x0, y0, x1, y1] = frame.region;
        if let Ok(larger) = Region::new(x0, y0, x1 + 1, y1) {
            let state = State { scissor: larger, ..frame.state()? };
            let refused = draw(&vertices[..], &[0u8, 1, 2], 0, &state, &mut depth).err();
            ensure_eq!(refused, draw(&vertices[..], &[0u8, 1, 2], 0, &state, &mut plain).err(), "outside");
            ensure!(refused.is_some(), "drawn outside the region");
        }
    }
    Ok(answers)
}

/// The smallest and the largest depth of an area's pixels, one by one.
fn range_of<F: Format, D: DepthFormat<F>>(
    depth: &Depth<'_, F, D>,
    [x0, y0, x1, y1]: [u32; 4],
) -> Option<[D::Texel; 2]> {
    let stored = (y0..y1).flat_map(|y| (x0..x1).filter_map(move |x| depth.get(x, y)));
    stored.fold(None, |range, depth| {
        let [low, high] = range.unwrap_or([depth; 2]);
        Some([low.min(depth), high.max(depth)])
    })
}

/// A surface in front of everything, with a few holes of a pixel: an area is hidden where no hole is in it, whatever
/// was asked before. Some regions have several tiles to a side.
pub fn holes_are_found<F: Format, D: DepthFormat<F>>(
    compare: Compare,
    seed: u64,
) -> Result<Answers, Failure> {
    let mut random = Random(seed);
    let most = [40, 100, 100, 400][random.below(4)];
    let [width, height] = [0; 2].map(|_| 1 + random.below(most) as u32);
    let [x0, y0] = [width, height].map(|size| {
        // At the origin, half of the time.
        let corner = random.below((F::MAX_TARGET - size + 1) as usize) as u32;
        if random.below(2) == 0 { 0 } else { corner & !3 }
    });
    let region = Region::<F>::new(x0, y0, x0 + width, y0 + height)?;
    let farther_wins = matches!(compare, Compare::Greater | Compare::GreaterEqual);
    let (surface, hole) = if farther_wins { (D::FAR, D::NEAR) } else { (D::NEAR, D::FAR) };
    let mut storage = vec![surface; texels(width, height)];
    for _ in 0..random.below(4) {
        let at = random.below(storage.len());
        storage[at] = hole;
    }
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(width, height)];
    let test = DepthTest { compare, write: true };
    let mut depth = HierarchicalDepth::<F, D>::new(region, &mut storage, &mut ranges, test)?;
    let pixels = (y0..y0 + height).flat_map(|y| (x0..x0 + width).map(move |x| (x, y)));
    let holes: Vec<_> = pixels.filter(|&(x, y)| depth.depth().get(x, y) == Some(hole)).collect();
    let part = |from: u32, size: u32, random: &mut Random| {
        let first = random.below(size as usize) as u32;
        (from + first, from + first + 1 + random.below((size - first) as usize) as u32)
    };
    let mut answers = Answers::default();
    for _ in 0..20 {
        let (left, right) = part(x0, width, &mut random);
        let (top, bottom) = part(y0, height, &mut random);
        let seen = holes.iter().any(|(x, y)| (left..right).contains(x) && (top..bottom).contains(y));
        let hidden = depth.hides(Region::new(left, top, right, bottom)?, 1 << 31);
        ensure_eq!(hidden, !seen, "({left}, {top}) to ({right}, {bottom}) of {region:?}, holes {holes:?}");
        if hidden {
            answers.hidden += 1;
        } else {
            answers.seen += 1;
        }
    }
    Ok(answers)
}

#[derive(Clone, Copy, Debug)]
struct Question {
    area: [u32; 4],
    /// In units of 2^-32.
    nearest: u32,
}

impl Question {
    /// About an area in the frame's region or over its ends, of any size, and a depth close to those of a triangle.
    fn new(frame: &Frame, shot: &Shot, random: &mut Random) -> Self {
        let [x0, y0, x1, y1] = frame.region;
        let mut side = |from: u32, to: u32| {
            let size = to - from;
            if random.below(20) == 0 {
                return [to, to + 1 + random.below(40) as u32];
            }
            let first = (from + random.below(size as usize) as u32).saturating_sub(random.below(4) as u32);
            let end = match random.below(4) {
                0 => first + 1 + random.below(4) as u32,
                1 => to + random.below(20) as u32,
                _ => first + 1 + random.below(size as usize) as u32,
            };
            // Often whole squares, counted from the region's corner.
            let grid = |v: u32| from + (v.saturating_sub(from)) / 16 * 16;
            if random.below(2) == 0 { [grid(first), grid(end).max(grid(first) + 1)] } else { [first, end] }
        };
        let ([left, right], [top, bottom]) = (side(x0, x1), side(y0, y1));
        let depth = shot.z[random.below(3)];
        let unit = [1, 1 << 16][random.below(2)];
        let near = random.below(9) as i64 - 4;
        let nearest = match random.below(6) {
            0 => random.bits() as u32,
            1 => [0, u32::MAX][random.below(2)],
            _ => (i64::from(depth) + near * unit).clamp(0, u32::MAX.into()) as u32,
        };
        Self { area: [left, top, right, bottom], nearest }
    }

    fn region<F: Format>(&self) -> Option<Region<F>> {
        let [x0, y0, x1, y1] = self.area;
        Region::new(x0, y0, x1, y1).ok()
    }

    /// A fragment's depth may be one unit before its vertices'; it must pass nowhere.
    fn is_hidden<F: Format, D: DepthFormat<F>>(
        &self,
        depth: &HierarchicalDepth<'_, F, D>,
        compare: Compare,
        spec: DepthSpec,
    ) -> bool {
        if compare == Compare::Always {
            return false;
        }
        let [vertex, ..] = crate::oracle::vertex_depths([self.nearest; 3], spec);
        let nearer = match compare {
            Compare::Less | Compare::LessEqual => i64::from(vertex) - 1,
            _ => i64::from(vertex) + 1,
        };
        let [x0, y0, x1, y1] = self.area;
        let stored = (y0..y1).flat_map(|y| (x0..x1).filter_map(move |x| depth.depth().get(x, y)));
        stored.into_iter().all(|stored| !passes(compare, nearer, i64::from(stored.into())))
    }
}

/// What is hidden by its bound would not have changed a pixel: drawn after all, it does not.
pub fn hidden_triangles_change_nothing<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    shots: &[Shot],
    test: DepthTest,
) -> Result<Answers, Failure> {
    let region = frame.core_region()?;
    let (width, height) = (frame.width(), frame.height());
    let clear = match test.compare {
        Compare::Greater | Compare::GreaterEqual => D::NEAR,
        _ => D::FAR,
    };
    let mut storage = vec![clear; texels(width, height)];
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(width, height)];
    let mut depth = HierarchicalDepth::<F, D>::new(region, &mut storage, &mut ranges, test)?;
    depth.clear(clear);
    let state = frame.state()?;
    let vertices = super::scene::vertices::<F>(shots)?;
    let mut answers = Answers::default();
    let mut before = vec![clear; (width * height) as usize];
    let mut after = before.clone();
    for (at, shot) in shots.iter().enumerate() {
        let Some(area) = bounds(&shot.corners) else { continue };
        let nearest = match test.compare {
            Compare::Greater | Compare::GreaterEqual => shot.z.iter().max(),
            _ => shot.z.iter().min(),
        };
        let hidden = depth.hides(area, nearest.copied().unwrap_or(0));
        let first = 3 * at as u32;
        depth.depth().to_linear(&mut before)?;
        draw(&vertices[..], &[first, first + 1, first + 2], 0, &state, &mut depth)?;
        depth.depth().to_linear(&mut after)?;
        ensure!(!hidden || before == after, "a hidden triangle is seen: {shot:?}");
        if hidden {
            answers.hidden += 1;
        } else {
            answers.seen += 1;
        }
    }
    Ok(answers)
}

/// The pixels that a triangle may cover.
fn bounds<F: Format>(corners: &[[i32; 2]; 3]) -> Option<Region<F>> {
    let [xs, ys] = [0, 1].map(|axis| corners.map(|corner| corner[axis]));
    let pixel = |v: i32| (v >> F::SUBPIXEL_BITS).clamp(0, F::MAX_TARGET as i32) as u32;
    let end = |v: i32| (pixel(v) + 1).min(F::MAX_TARGET);
    let least = |v: [i32; 3]| v[0].min(v[1]).min(v[2]);
    let most = |v: [i32; 3]| v[0].max(v[1]).max(v[2]);
    Region::new(pixel(least(xs)), pixel(least(ys)), end(most(xs)), end(most(ys))).ok()
}

/// After so many draws and questions, answers are still those of the pixels: a hole stays one until it is filled.
pub fn versions_come_round(draws: u32) -> Verdict {
    let region = Region::<halfplane::Standard>::of_size(16, 16)?;
    let (mut storage, mut ranges) = ([7; 256], [DepthRange::UNKNOWN; 2]);
    storage[255] = u32::MAX;
    let mut depth =
        HierarchicalDepth::<halfplane::Standard>::new(region, &mut storage, &mut ranges, DepthTest::LESS)?;
    let triangle = |z| -> Result<[Vertex<halfplane::Standard>; 3], Failure> {
        Ok([Vertex::new(0, 0, z)?, Vertex::new(32 << 8, 0, z)?, Vertex::new(0, 32 << 8, z)?])
    };
    let (far, near, state) = (triangle(u32::MAX)?, triangle(99)?, State::new(region));
    for _ in 0..draws {
        draw(&far[..], &[0u8, 1, 2], 0, &state, &mut depth)?;
        ensure!(!depth.hides(region, 1 << 31), "there is a hole");
    }
    draw(&near[..], &[0u8, 1, 2], 0, &state, &mut depth)?;
    ensure!(depth.hides(region, 1 << 31), "the hole was filled");
    Ok(())
}

/// Memory that is too short is refused, and told how long it must be.
pub fn short_memory_is_refused(width: u32, height: u32, less: usize) -> Verdict {
    let region = Region::<halfplane::Standard>::of_size(width, height)?;
    let needed =
        (width.div_ceil(16) * height.div_ceil(16) + width.div_ceil(64) * height.div_ceil(64)) as usize;
    ensure_eq!(depth_ranges(width, height), needed, "ranges of {width} x {height}");
    let given = needed - 1 - less % needed;
    let mut storage = vec![0; texels(width, height)];
    let mut ranges = vec![DepthRange::UNKNOWN; given];
    let error =
        HierarchicalDepth::<halfplane::Standard>::new(region, &mut storage, &mut ranges, DepthTest::LESS);
    ensure_eq!(error.err(), Some(StorageError::BufferTooSmall { needed, given }), "{given} ranges");
    let mut ranges = vec![DepthRange::UNKNOWN; needed];
    let short = &mut storage[1..];
    let error = HierarchicalDepth::<halfplane::Standard>::new(region, short, &mut ranges, DepthTest::LESS);
    ensure!(
        matches!(error, Err(StorageError::BufferTooSmall { .. })),
        "a texel is missing, and nothing said"
    );
    Ok(())
}
