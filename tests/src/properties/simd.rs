//! The vector code draws what the scalar code draws, at every level that this machine has.

use crate::{
    Failure, Frame, ensure, ensure_eq,
    failure::Verdict,
    frame::into_guard_band,
    shapes::{Corners, Kind, Model, Projection, Random, at_the_limit, depths, model, triangle},
};
use halfplane::{
    Bounds, Compare, Coverage, Cull, D16, Depth, DepthTest, DrawError, Format, Ids, ModelPositions, NO_ID,
    OutsideAttachment, Region, Standard, State, Statistics, Viewport, Winding, blocks, draw,
    numbers::{DEPTH32_MAX, DEPTH32_MIN},
    simd::{self, Level, Snapped, Triangles},
    texels, unorm32,
};

/// The levels of this machine, best first; the last has no vectors.
pub fn levels() -> impl Iterator<Item = Level> {
    Level::detect().and_below()
}

/// One triangle's numbers: kind, corners, depths.
pub type Numbers = (u32, [u32; 8], [u32; 4]);

/// A mesh and how it is drawn.
#[derive(Clone, Debug)]
pub struct Case {
    /// Region of the attachments, scissor, sample.
    pub frame: Frame,
    /// `[x0, y0, x1, y1]` of the viewport: often larger than the frame, as for a band.
    pub viewport: [u32; 4],
    /// How the corners get to clip space.
    pub projection: Projection,
    /// The triangles wanted in the window.
    pub wanted: Vec<Corners>,
    /// Vertices and matrix.
    pub model: Model,
    /// Three for each triangle.
    pub indices: Vec<u32>,
    /// The first triangle's id.
    pub first_id: u32,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which faces are in front.
    pub front: Winding,
    /// The depth test.
    pub test: DepthTest,
    /// Chooses the attachments.
    pub attachments: u32,
    /// What the attachments hold before: cleared where 0.
    pub contents: u32,
}

impl Case {
    /// A case from any numbers.
    pub fn from_numbers(place: [u32; 12], how: [u32; 10], triangles: &[Numbers], kinds: &[Kind]) -> Self {
        let [view, project, culling, test, attachments, contents, id, share, a, b] = how;
        let frame = frame(place, a);
        let projection = Projection::ALL[(project % 16) as usize % 6 * usize::from(project % 16 < 10)];
        let shape = |&(kind, numbers, _): &Numbers| match kinds.get(kind as usize % (kinds.len() + 2)) {
            Some(&kind) => triangle::<Standard>(kind, &frame, numbers),
            None => at_the_limit(&frame, numbers),
        };
        let wanted: Vec<Corners> = triangles.iter().map(shape).collect();
        // Often only few depths, so that some are equal, or on the near or the far plane.
        let depth = |&(_, _, z): &Numbers| match share % 3 {
            0 => [[1 << 30, 1 << 31, 3 << 30, 0, u32::MAX][z[0] as usize % 5]; 3],
            _ => depths(z),
        };
        let given: Vec<_> = wanted.iter().copied().zip(triangles.iter().map(depth)).collect();
        let viewport = viewport(&frame, view, b);
        let model = model(projection, viewport, &given, [a, b, test / 16, culling / 16]);
        let mut random = Random(share.into());
        let count = model.vertices.len();
        let indices = (0..count).map(|at| {
            // Some corners are those of other triangles.
            if share % 4 == 0 && random.below(4) == 0 { random.below(count) as u32 } else { at as u32 }
        });
        let compares = [
            Compare::Less,
            Compare::LessEqual,
            Compare::Greater,
            Compare::GreaterEqual,
            Compare::Always,
            Compare::Less,
        ];
        let test = match test % 4 {
            0 => DepthTest { compare: compares[test as usize / 4 % 6], write: test % 7 != 0 },
            _ => DepthTest::LESS,
        };
        Self {
            frame,
            viewport,
            projection,
            indices: indices.collect(),
            wanted,
            model,
            first_id: if id % 2 == 0 { id / 2 % 1000 } else { u32::MAX - triangles.len() as u32 },
            cull: [Cull::None, Cull::None, Cull::Back, Cull::Front][culling as usize % 4],
            front: [Winding::Clockwise, Winding::CounterClockwise][culling as usize / 4 % 2],
            test,
            attachments,
            contents: if contents % 2 == 0 { 0 } else { contents },
        }
    }

    pub(super) fn positions(&self) -> Result<ModelPositions<'_, Standard>, Failure> {
        let [x0, y0, x1, y1] = self.viewport;
        let viewport = Viewport::new(Region::new(x0, y0, x1, y1)?);
        Ok(ModelPositions::new(&self.model.vertices, self.model.matrix, viewport))
    }

    pub(super) fn state(&self) -> Result<State<Standard>, Failure> {
        Ok(State { cull: self.cull, front: self.front, ..self.frame.state()? })
    }
}

/// A frame of up to 100 pixels, or of some hundred, anywhere.
fn frame(place: [u32; 12], large: u32) -> Frame {
    let mut frame = Frame::from_numbers::<Standard>(place);
    if large.is_multiple_of(4) {
        let [x0, y0, ..] = frame.region;
        let (x1, y1) = (x0 + 100 + place[1] % 300, y0 + 40 + place[2] % 300);
        if x1 <= Standard::MAX_TARGET && y1 <= Standard::MAX_TARGET {
            frame.region = [x0, y0, x1, y1];
            frame.scissor = match large / 4 % 3 {
                0 => [x0, y0, x1, y1],
                _ => [x0 + place[6] % 90, y0 + place[7] % 40, x1 - place[8] % 10, y1],
            };
        }
    }
    frame
}

/// The viewport: sides that are powers of two, so that positions are exact, or the frame's, or others.
fn viewport(frame: &Frame, kind: u32, free: u32) -> [u32; 4] {
    let limit = Standard::MAX_TARGET;
    let [x0, y0, x1, y1] = frame.region;
    let side = |from: u32, to: u32| match (to - from).next_power_of_two() {
        side if from + side <= limit => (from, from + side),
        _ => (0, limit),
    };
    let ((left, right), (top, bottom)) = (side(x0, x1), side(y0, y1));
    match kind % 8 {
        0..=3 => [left, top, right, bottom],
        4 => [0, 0, limit, limit],
        5 => frame.region,
        6 => {
            let [sx0, sy0, sx1, sy1] = frame.scissor;
            [sx0 / 2, sy0 + free % (sy1 - sy0), sx1 - free / 100 % (sx1 - sx0), limit.min(sy1 + free % 50)]
        }
        // Anywhere; it need not meet the scissor.
        _ => {
            let [x, y] = [free % limit, free / limit % limit];
            [x, y, x + 1 + kind / 8 % (limit - x), y + 1 + kind / 64 % (limit - y)]
        }
    }
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

/// A window triangle of any corners and depths, alone in a whole frame: as a case.
pub fn single(frame: Frame, corners: Corners, z: [u32; 3]) -> Case {
    let corners = corners.map(|corner| corner.map(|v| into_guard_band::<Standard>(v.into())));
    let viewport = viewport(&frame, 0, 0);
    Case {
        frame,
        viewport,
        projection: Projection::Flat,
        wanted: vec![corners],
        model: model(Projection::Flat, viewport, &[(corners, z)], [0; 4]),
        indices: vec![0, 1, 2],
        first_id: 0,
        cull: Cull::None,
        front: Winding::Clockwise,
        test: DepthTest::LESS,
        attachments: 4,
        contents: 0,
    }
}
