//! The vector code draws what the scalar code draws, at every level that this machine has.

use crate::{
    Failure,
    case::Case,
    ensure, ensure_eq,
    failure::Verdict,
    shapes::{Projection, Random},
};
use halfplane::{
    Bounds, Coverage, D16, Depth, DepthTest, DrawError, Ids, ModelPositions, NO_ID, OutsideAttachment,
    Region, Standard, State, Statistics, Viewport, blocks, draw,
    numbers::{DEPTH32_MAX, DEPTH32_MIN},
    simd::{self, Level, Snapped, Triangles},
    texels, unorm32,
};
use std::collections::BTreeSet;

/// The levels of this machine, best first; the last has no vectors.
pub fn levels() -> impl Iterator<Item = Level> {
    Level::detect().and_below()
}

/// The levels of this machine have names, each its own: the best first, then the one that everything is compiled for, if it
/// is another, and those without vectors last.
pub fn levels_have_names() -> Verdict {
    let names: Vec<_> = levels().map(Level::name).collect();
    println!("levels: {names:?}");
    ensure_eq!(names.first(), Some(&Level::detect().name()), "the best one");
    ensure_eq!(names.last(), Some(&"fallback"), "the last one");
    ensure_eq!(BTreeSet::from_iter(&names).len(), names.len(), "names in {names:?}");
    ensure!(names.contains(&Level::baseline().name()), "{names:?}");
    #[cfg(target_arch = "x86_64")]
    ensure!(names.contains(&"sse2"), "{names:?}");
    #[cfg(target_arch = "aarch64")]
    ensure!(names.contains(&"neon"), "{names:?}");
    Ok(())
}

/// The memory of all attachments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Storage {
    region: Region<Standard>,
    pub(super) masks: Vec<u16>,
    pub(super) depths: Vec<u32>,
    pub(super) depths16: Vec<u16>,
    pub(super) ids: Vec<u32>,
}

impl Storage {
    /// Cleared, or filled with anything and sometimes longer than is needed.
    pub(super) fn new(region: Region<Standard>, contents: u32) -> Self {
        let (width, height) = (region.width(), region.height());
        let (blocks, texels) = (blocks(width, height), texels(width, height));
        if contents == 0 {
            return Self {
                region,
                masks: vec![0; blocks],
                depths: vec![u32::MAX; texels],
                depths16: vec![u16::MAX; texels],
                ids: vec![NO_ID; texels],
            };
        }
        let mut random = Random(contents.into());
        let more = contents as usize / 2 % 3;
        let (blocks, texels) = (blocks + more, texels + 16 * more);
        Self {
            region,
            masks: (0..blocks).map(|_| random.bits() as u16).collect(),
            depths: (0..texels).map(|_| random.bits() as u32).collect(),
            depths16: (0..texels).map(|_| random.bits() as u16).collect(),
            ids: (0..texels).map(|_| random.bits() as u32).collect(),
        }
    }

    /// Every bit is the same, also those of pixels beside the region.
    pub(super) fn equals(&self, expected: &Self, what: &str) -> Verdict {
        self.same(&self.masks, &expected.masks, 1, "mask", what)?;
        self.same(&self.depths, &expected.depths, 16, "depth", what)?;
        self.same(&self.depths16, &expected.depths16, 16, "16-bit depth", what)?;
        self.same(&self.ids, &expected.ids, 16, "id", what)
    }

    fn same<T: PartialEq + std::fmt::Debug>(
        &self,
        given: &[T],
        expected: &[T],
        block: usize,
        name: &str,
        what: &str,
    ) -> Verdict {
        if let Some(at) = (0..given.len()).find(|&at| given[at] != expected[at]) {
            let pitch = self.region.width().div_ceil(4) as usize;
            let (x, y) =
                (4 * (at / block % pitch) + at % block % 4, 4 * (at / block / pitch) + at % block / 4);
            let [x, y] = [self.region.x0() as usize + x, self.region.y0() as usize + y];
            let [given, expected] = [&given[at], &expected[at]];
            return Err(Failure::new(format_args!(
                "{what}: {name} at pixel ({x}, {y}) is {given:?}, not {expected:?}"
            )));
        }
        Ok(())
    }
}

/// Draws with the scalar code and at every level, and compares outcome and storage.
macro_rules! at_every_level {
    ($name:literal, $case:expr, $indices:expr, |$storage:ident| { $($make:tt)* } => $attachments:expr) => {{
        let case: &Case = $case;
        let (positions, state, region) = (case.positions()?, case.state()?, case.frame.core_region()?);
        let indices = $indices;
        let before = Storage::new(region, case.contents);
        let mut expected = before.clone();
        let wanted = {
            let $storage = &mut expected;
            $($make)*
            draw(&positions, indices, case.first_id, &state, $attachments)
        };
        let count = case.model.vertices.len();
        for level in levels() {
            let what = format!("{} {}", level.name(), $name);
            let mut given = before.clone();
            // Scratch memory may be longer, and is not read before it is written.
            let mut records = vec![Snapped::default(); count + case.attachments as usize % 3];
            let outcome = {
                let $storage = &mut given;
                $($make)*
                let triangles = Triangles::new(indices, count)?;
                simd::draw(level, &positions, &mut records, triangles, case.first_id, &state, $attachments)
            };
            ensure_eq!(outcome, wanted, "{what}");
            given.equals(&expected, &what)?;
        }
        wanted?
    }};
}

/// The same pixels and the same statistics, with one of all attachments; the statistics.
pub fn frame_is_the_scalar_one(case: &Case) -> Result<Statistics, Failure> {
    wanted_positions_are_met(case)?;
    let (region, test) = (case.frame.core_region()?, case.test);
    let wide = &case.indices[..];
    let statistics = match case.attachments % 12 {
        0 => at_every_level!("coverage", case, wide, |s| {
            let mut coverage = Coverage::new(region, &mut s.masks)?;
        } => &mut coverage),
        1 => at_every_level!("depth", case, wide, |s| {
            let mut depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
        } => &mut depth),
        2 => at_every_level!("16-bit depth", case, wide, |s| {
            let mut depth = Depth::<Standard, D16>::new(region, &mut s.depths16, test)?;
        } => &mut depth),
        3 => at_every_level!("ids", case, wide, |s| {
            let mut ids = Ids::new(region, &mut s.ids)?;
        } => &mut ids),
        4..=6 => at_every_level!("depth and ids", case, wide, |s| {
            let depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
            let mut all = (depth, Ids::new(region, &mut s.ids)?);
        } => &mut all),
        7 => at_every_level!("16-bit depth and ids", case, wide, |s| {
            let depth = Depth::<Standard, D16>::new(region, &mut s.depths16, test)?;
            let mut all = (depth, Ids::new(region, &mut s.ids)?);
        } => &mut all),
        8 => at_every_level!("coverage, depth and ids", case, wide, |s| {
            let coverage = Coverage::new(region, &mut s.masks)?;
            let depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
            let mut all = (coverage, (depth, Ids::new(region, &mut s.ids)?));
        } => &mut all),
        9 => at_every_level!("depth by reference and coverage", case, wide, |s| {
            let mut depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
            let mut coverage = Coverage::new(region, &mut s.masks)?;
            let mut all = (&mut depth, &mut coverage);
        } => &mut all),
        _ => {
            let short: Vec<u16> = case.indices.iter().map(|&index| index as u16).collect();
            at_every_level!("ids before depth, u16 indices", case, &short[..], |s| {
                let ids = Ids::new(region, &mut s.ids)?;
                let mut all = (ids, Depth::<Standard>::new(region, &mut s.depths, test)?);
            } => &mut all)
        }
    };
    Ok(statistics)
}

/// The same depths, for triangles whose gradients are the point.
pub fn depths_are_the_scalar_ones(case: &Case) -> Result<Statistics, Failure> {
    let region = case.frame.core_region()?;
    Ok(at_every_level!("depth", case, &case.indices[..], |s| {
        let mut depth = Depth::<Standard>::new(region, &mut s.depths, DepthTest::LESS)?;
    } => &mut depth))
}

/// Where positions are exact, the snapped vertices are the wanted ones: the kinds are what they say.
fn wanted_positions_are_met(case: &Case) -> Verdict {
    let [x0, y0, x1, y1] = case.viewport;
    if case.projection != Projection::Flat
        || !(x1 - x0).is_power_of_two()
        || !(y1 - y0).is_power_of_two()
        || (x1 - x0).min(y1 - y0) < 4
    {
        return Ok(());
    }
    let (positions, viewport) = (case.positions()?, Viewport::new(Region::<Standard>::new(x0, y0, x1, y1)?));
    let limit = Bounds::<Standard>::CLIP_PIXELS * Bounds::<Standard>::STEPS_PER_PIXEL;
    for (at, &[x, y]) in case.wanted.as_flattened().iter().enumerate() {
        if x.abs() > limit || y.abs() > limit {
            continue;
        }
        let clip = positions.clip(at).ok_or_else(|| Failure::new("a vertex is missing"))?;
        let vertex = viewport.project(clip).ok_or_else(|| Failure::new("an ordinary vertex is refused"))?;
        ensure_eq!([vertex.x(), vertex.y()], [x, y], "vertex {at}");
    }
    Ok(())
}

/// Triangles of constant depth have the unorm32 of it.
pub fn constant_depths_are_unorm32(depths: &[f32]) -> Verdict {
    const SIDE: u32 = 1024;
    let width = 4 * depths.len() as u32;
    ensure!(width <= SIDE, "too many depths");
    let region = Region::<Standard>::of_size(SIDE, 4)?;
    let mut vertices = Vec::new();
    for (at, &z) in depths.iter().enumerate() {
        let x = |pixel: usize| ((4 * at + pixel) as f32 - SIDE as f32 / 2.0) / (SIDE as f32 / 2.0);
        vertices.extend([[x(0), 1.0, z], [x(4), 1.0, z], [x(0), -1.0, z]]);
    }
    let matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let positions = ModelPositions::new(&vertices, matrix, Viewport::new(region));
    let indices: Vec<u16> = (0..vertices.len() as u16).collect();
    let mut records = vec![Snapped::default(); vertices.len()];
    for level in levels() {
        let mut storage = vec![u32::MAX; texels(SIDE, 4)];
        let mut depth = Depth::<Standard>::new(region, &mut storage, DepthTest::LESS)?;
        let triangles = Triangles::new(&indices, vertices.len())?;
        let state = State::new(region);
        let statistics = simd::draw(level, &positions, &mut records, triangles, 0, &state, &mut depth)?;
        ensure_eq!(statistics.drawn as usize, depths.len(), "{}: drawn", level.name());
        for (at, &z) in depths.iter().enumerate() {
            let expected = unorm32(z).clamp(DEPTH32_MIN, DEPTH32_MAX);
            ensure_eq!(
                depth.get(4 * at as u32, 0),
                Some(expected),
                "{}: depth {z:?} ({:#X})",
                level.name(),
                z.to_bits()
            );
        }
    }
    Ok(())
}

/// Sizes of a refused draw.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// Vertices, at least 3.
    pub vertices: usize,
    /// Triangles, at least 1.
    pub triangles: usize,
    /// Where the fault is put, modulo what there is.
    pub at: usize,
    /// How far beyond the limit it is.
    pub beyond: u32,
}

/// Draws into filled storage; fails if any of it changed, or if nothing was wrong.
fn refused(
    storage: &mut Storage,
    what: &str,
    draw: impl FnOnce(&mut Both<'_>) -> Result<Statistics, DrawError>,
) -> Result<DrawError, Failure> {
    let before = storage.clone();
    let region = storage.region;
    let outcome = draw(&mut (
        Depth::new(region, &mut storage.depths, DepthTest::LESS)?,
        Ids::new(region, &mut storage.ids)?,
    ));
    storage.equals(&before, what)?;
    match outcome {
        Ok(statistics) => Err(Failure::new(format_args!("{what}: not refused: {statistics}"))),
        Err(error) => Ok(error),
    }
}

type Both<'s> = (Depth<'s, Standard>, Ids<'s, Standard>);

/// The same named errors as the scalar code, and nothing is written with them.
pub fn errors_are_the_scalar_ones(case: Refused) -> Verdict {
    let Refused { vertices: count, triangles, at, beyond } = case;
    let region = Region::<Standard>::of_size(20, 12)?;
    let state = State::new(region);
    let corners = [[-1.0, 1.0, 0.5], [1.0, 1.0, 0.5], [-1.0, -1.0, 0.5]];
    let vertices: Vec<[f32; 3]> = (0..count).map(|at| corners[at % 3]).collect();
    let matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let positions = ModelPositions::new(&vertices, matrix, Viewport::new(region));
    let indices: Vec<u32> = (0..3 * triangles).map(|k| (k % count) as u32).collect();
    let mut storage = Storage::new(region, 0xA5A5_5A5A);

    // Found when the list is checked.
    let mut odd = indices.clone();
    odd.extend((0..1 + beyond % 2).map(|_| 0));
    let error = Triangles::new(&odd, count).err();
    ensure_eq!(error, Some(DrawError::IndexCount { count: odd.len() }), "an index too many");
    let at = at % indices.len();
    let mut wrong = indices.clone();
    wrong[at] = count as u32 + beyond % 1000;
    let out = DrawError::IndexOutOfRange { at, index: wrong[at], vertices: count };
    ensure_eq!(Triangles::new(&wrong, count).err(), Some(out), "an index that names no vertex");

    for level in levels() {
        let name = level.name();
        let mut records = vec![Snapped::default(); count];
        let list = Triangles::new(&indices, count)?;

        // Checked for more vertices than there are: refused only where one is missing.
        let wide = Triangles::new(&wrong, count + 1000)?;
        let error = refused(&mut storage, name, |both| {
            simd::draw(level, &positions, &mut records, wide, 0, &state, both)
        })?;
        ensure_eq!(error, out, "{name}: a list checked for more vertices");
        let more = Triangles::new(&indices, count + 1)?;
        let mut ids = vec![NO_ID; texels(20, 12)];
        let mut ids = Ids::new(region, &mut ids)?;
        let statistics = simd::draw(level, &positions, &mut records, more, 0, &state, &mut ids)?;
        ensure_eq!(statistics.submitted as usize, triangles, "{name}: all vertices are there after all");

        // Ids that do not fit, and the last ones that do.
        let first_id = u32::MAX - beyond % triangles as u32;
        let error = refused(&mut storage, name, |both| {
            simd::draw(level, &positions, &mut records, list, first_id, &state, both)
        })?;
        ensure_eq!(error, DrawError::TooManyIds { first_id, triangles }, "{name}: ids that do not fit");
        let last = u32::MAX - triangles as u32;
        simd::draw(level, &positions, &mut records, list, last, &state, &mut ids)?;
        let covering = corners.map(|c| vertices.iter().position(|&v| v == c));
        ensure!(covering.iter().all(Option::is_some), "the vertices lack a corner");

        // A viewport and a scissor that reach beyond the attachments.
        let y1 = 13 + beyond % 1000;
        let large = Region::new(0, 0, 20, y1)?;
        let tall = ModelPositions::new(&vertices, matrix, Viewport::new(large));
        let tall_state = State { scissor: large, ..state };
        let error = refused(&mut storage, name, |both| {
            simd::draw(level, &tall, &mut records, list, 0, &tall_state, both)
        })?;
        let outside = OutsideAttachment { area: [0, 0, 20, y1], attachment: [0, 0, 20, 12] };
        ensure_eq!(error, DrawError::OutsideAttachment(outside), "{name}: a scissor beyond the attachments");

        let given = count - 1 - beyond as usize % count;
        let error = refused(&mut storage, name, |both| {
            simd::draw(level, &positions, &mut records[..given], list, 0, &state, both)
        })?;
        ensure_eq!(error, DrawError::ScratchTooSmall { needed: count, given }, "{name}: too few records");
    }
    Ok(())
}
