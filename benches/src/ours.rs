//! The rasterizer: the only file of this crate that calls its drawing. Another path is plugged in here:
//! a new [`Level`], and its arms in [`Target::frame`], [`Target::stage`] and [`Target::has`].

use std::hint::black_box;

use halfplane::simd::{self, Snapped, Triangles};
use halfplane::{
    ClipPositions, Cull, D16, Depth, DepthTest, Ids, ModelPositions, NO_ID, Positions as _, Region, Standard,
    State, Statistics, Triangle, Viewport, blocks, draw, texels,
};
use halfplane_cli::camera::Matrix;

use crate::buffer::Buffer;
use crate::scenes::View;

/// How the inner loops are run.
#[derive(Debug, Clone, Copy)]
pub enum Level {
    /// Plain arrays, the edge-function hierarchy: what runs everywhere. Vertices are transformed to clip
    /// space once, before the draw.
    Scalar,
    /// Vector registers. Vertices are transformed in the draw.
    Simd(simd::Level),
}

impl Level {
    /// Those that this machine can run, the fastest first; the last is [`Level::Scalar`].
    #[must_use]
    pub fn available() -> Vec<Self> {
        let fallback = simd::Level::FALLBACK.name();
        let vector = simd::Level::detect().and_below().filter(|level| level.name() != fallback);
        vector.map(Self::Simd).chain([Self::Scalar]).collect()
    }

    /// The first of [`available`](Self::available).
    #[must_use]
    pub fn fastest() -> Self {
        Self::available().first().copied().unwrap_or(Self::Scalar)
    }

    /// Its name in tables and on command lines.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Simd(level) => level.name(),
        }
    }

    /// The available level of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::available().into_iter().find(|level| level.name() == name)
    }
}

/// What a frame writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attachments {
    /// 32-bit depth.
    Depth32,
    /// 16-bit depth.
    Depth16,
    /// Triangle ids, the last one drawn wins.
    Ids,
    /// 32-bit depth and the id of the nearest triangle.
    DepthIds,
    /// One bit per pixel.
    Coverage,
}

impl Attachments {
    /// All combinations that are measured.
    pub const ALL: [Self; 5] = [Self::Depth32, Self::Depth16, Self::Ids, Self::DepthIds, Self::Coverage];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Depth32 => "depth",
            Self::Depth16 => "depth D16",
            Self::Ids => "ids",
            Self::DepthIds => "depth+ids",
            Self::Coverage => "coverage",
        }
    }

    const fn depth32(self) -> bool {
        matches!(self, Self::Depth32 | Self::DepthIds)
    }

    const fn ids(self) -> bool {
        matches!(self, Self::Ids | Self::DepthIds)
    }
}

/// A part of a frame, for measuring it apart. Setup, traversal and draws each hold the work of those before
/// it but the clear, so the difference of two is what the later one adds. They do not hold the transform,
/// which comes before them, at [`Level::Scalar`]; they do at the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The clear of the attachments.
    Clear(Attachments),
    /// Object space to clip space, every vertex once.
    Transform,
    /// Assembly, rejection, clipping, division, snapping, culling, edges and bounds of every triangle.
    Setup,
    /// The above and the traversal; no attachment.
    Traverse,
    /// The above and the attachments.
    Draw(Attachments),
    /// Everything: clear, transform, draw.
    Frame(Attachments),
}

/// A mesh and the buffers it is drawn into, prepared once. Faces that wind counter-clockwise are culled.
#[derive(Debug)]
pub struct Target<'v> {
    positions: &'v [[f32; 3]],
    indices: &'v [u32],
    triangles: Triangles<'v, u32>,
    state: State<Standard>,
    viewport: Viewport<Standard>,
    records: Buffer<Snapped>,
    clip: Buffer<[f32; 4]>,
    depth32: Buffer<u32>,
    depth16: Buffer<u16>,
    ids: Buffer<u32>,
    coverage: Buffer<u16>,
}

impl<'v> Target<'v> {
    /// Buffers for drawing a view's whole mesh.
    ///
    /// # Panics
    ///
    /// If the view's size is none that a target can have.
    #[must_use]
    pub fn new(view: &'v View) -> Self {
        Self::with_indices(view, &view.mesh.indices)
    }

    /// The same for some of the mesh's triangles.
    ///
    /// # Panics
    ///
    /// If the view's size is none that a target can have.
    #[must_use]
    pub fn with_indices(view: &'v View, indices: &'v [u32]) -> Self {
        let (width, height) = view.size;
        let region = Region::of_size(width, height).expect("views have sizes that targets can have");
        let texels = texels(width, height);
        Self {
            positions: &view.mesh.positions,
            indices,
            triangles: Triangles::new(indices, view.mesh.positions.len())
                .expect("views have indices that exist"),
            records: Buffer::new(view.mesh.positions.len(), Snapped::default()),
            state: State { cull: Cull::Back, ..State::new(region) },
            viewport: Viewport::new(region),
            clip: Buffer::new(view.mesh.positions.len(), [0.0; 4]),
            depth32: Buffer::new(texels, 0),
            depth16: Buffer::new(texels, 0),
            ids: Buffer::new(texels, 0),
            coverage: Buffer::new(blocks(width, height), 0),
        }
    }

    /// From object-space positions and a matrix to the finished attachments: clear, transform, draw.
    pub fn frame(&mut self, level: Level, attachments: Attachments, matrix: &Matrix) -> Statistics {
        self.clear(attachments);
        match level {
            Level::Scalar => {
                self.transform(matrix);
                self.draw_scalar(attachments)
            }
            Level::Simd(level) => self.draw_simd(level, attachments, matrix),
        }
    }

    /// Whether a level has a stage that can be measured apart.
    #[must_use]
    pub const fn has(level: Level, stage: Stage) -> bool {
        match level {
            Level::Scalar => true,
            Level::Simd(_) => !matches!(stage, Stage::Setup | Stage::Traverse),
        }
    }

    /// One stage; nothing if the level does not [have](Self::has) it. At [`Level::Scalar`], stages after
    /// [`Stage::Transform`] draw what it left.
    pub fn stage(&mut self, level: Level, stage: Stage, matrix: &Matrix) {
        match (stage, level) {
            (Stage::Clear(attachments), _) => self.clear(attachments),
            (Stage::Transform, Level::Scalar) => self.transform(matrix),
            (Stage::Transform, Level::Simd(level)) => self.transform_simd(level, matrix),
            (Stage::Setup, Level::Scalar) => self.set_up_scalar(),
            (Stage::Traverse, Level::Scalar) => {
                let clip = ClipPositions::new(self.clip.as_slice(), self.viewport);
                black_box(accepted(draw(&clip, self.indices, 0, &self.state, &mut ())));
            }
            (Stage::Setup | Stage::Traverse, Level::Simd(_)) => {}
            (Stage::Draw(attachments), Level::Scalar) => {
                black_box(self.draw_scalar(attachments));
            }
            (Stage::Draw(attachments), Level::Simd(level)) => {
                black_box(self.draw_simd(level, attachments, matrix));
            }
            (Stage::Frame(attachments), level) => {
                black_box(self.frame(level, attachments, matrix));
            }
        }
    }

    /// Clears what a frame would.
    pub fn clear(&mut self, attachments: Attachments) {
        if attachments.depth32() {
            self.depth32.as_mut_slice().fill(u32::MAX);
        }
        if attachments.ids() {
            self.ids.as_mut_slice().fill(NO_ID);
        }
        match attachments {
            Attachments::Depth16 => self.depth16.as_mut_slice().fill(u16::MAX),
            Attachments::Coverage => self.coverage.as_mut_slice().fill(0),
            _ => {}
        }
    }

    /// Row vectors, from left to right in `f32`: the bits that the command's renderings have.
    fn transform(&mut self, m: &Matrix) {
        for (clip, &[x, y, z]) in self.clip.as_mut_slice().iter_mut().zip(self.positions) {
            *clip = [0, 1, 2, 3].map(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k]);
        }
    }

    fn set_up_scalar(&self) {
        let positions = ClipPositions::new(self.clip.as_slice(), self.viewport);
        let State { scissor, cull, front, sample } = self.state;
        for &[a, b, c] in self.indices.as_chunks::<3>().0 {
            positions.assemble([a, b, c].map(|index| index as usize), |vertices| {
                if let Some(triangle) = Triangle::<Standard>::new(vertices, sample)
                    && !cull.culls(triangle.winding(), front)
                {
                    let _ = black_box((triangle.bounds(scissor), &triangle));
                }
            });
        }
    }

    fn draw_scalar(&mut self, attachments: Attachments) -> Statistics {
        let region = self.state.scissor;
        let clip = ClipPositions::new(self.clip.as_slice(), self.viewport);
        let (indices, state) = (self.indices, &self.state);
        let mut ids = Ids::new(region, self.ids.as_mut_slice()).expect("ids for the region");
        let mut depth = Depth::<Standard>::new(region, self.depth32.as_mut_slice(), DepthTest::LESS)
            .expect("depths for the region");
        accepted(match attachments {
            Attachments::Depth32 => draw(&clip, indices, 0, state, &mut depth),
            Attachments::Depth16 => {
                let texels = self.depth16.as_mut_slice();
                let mut depth = Depth::<Standard, D16>::new(region, texels, DepthTest::LESS)
                    .expect("depths for the region");
                draw(&clip, indices, 0, state, &mut depth)
            }
            Attachments::Ids => draw(&clip, indices, 0, state, &mut ids),
            Attachments::DepthIds => draw(&clip, indices, 0, state, &mut (&mut depth, &mut ids)),
            Attachments::Coverage => {
                let masks = self.coverage.as_mut_slice();
                let mut coverage = halfplane::Coverage::new(region, masks).expect("masks for the region");
                draw(&clip, indices, 0, state, &mut coverage)
            }
        })
    }

    /// A draw of no triangles is its vertex stage.
    fn transform_simd(&mut self, level: simd::Level, matrix: &Matrix) {
        let region = self.state.scissor;
        let none = Triangles::new(&[0u32; 0], self.positions.len()).expect("no index is wrong");
        let model = ModelPositions::new(self.positions, rows(matrix), self.viewport);
        let masks = self.coverage.as_mut_slice();
        let mut coverage = halfplane::Coverage::new(region, masks).expect("masks for the region");
        let records = self.records.as_mut_slice();
        black_box(accepted(simd::draw(level, &model, records, none, 0, &self.state, &mut coverage)));
        black_box(self.records.as_slice());
    }

    fn draw_simd(&mut self, level: simd::Level, attachments: Attachments, matrix: &Matrix) -> Statistics {
        let region = self.state.scissor;
        let model = ModelPositions::new(self.positions, rows(matrix), self.viewport);
        let (triangles, state) = (self.triangles, &self.state);
        let records = self.records.as_mut_slice();
        let mut ids = Ids::new(region, self.ids.as_mut_slice()).expect("ids for the region");
        let mut depth = Depth::<Standard>::new(region, self.depth32.as_mut_slice(), DepthTest::LESS)
            .expect("depths for the region");
        accepted(match attachments {
            Attachments::Depth32 => simd::draw(level, &model, records, triangles, 0, state, &mut depth),
            Attachments::Depth16 => {
                let texels = self.depth16.as_mut_slice();
                let mut depth = Depth::<Standard, D16>::new(region, texels, DepthTest::LESS)
                    .expect("depths for the region");
                simd::draw(level, &model, records, triangles, 0, state, &mut depth)
            }
            Attachments::Ids => simd::draw(level, &model, records, triangles, 0, state, &mut ids),
            Attachments::DepthIds => {
                simd::draw(level, &model, records, triangles, 0, state, &mut (&mut depth, &mut ids))
            }
            Attachments::Coverage => {
                let masks = self.coverage.as_mut_slice();
                let mut coverage = halfplane::Coverage::new(region, masks).expect("masks for the region");
                simd::draw(level, &model, records, triangles, 0, state, &mut coverage)
            }
        })
    }

    /// How many pixels something covers, by an attachment that was drawn; padding of the last blocks
    /// included, which nothing ever covers.
    #[must_use]
    pub fn covered(&self, attachments: Attachments) -> usize {
        let other = |texels: &[u32]| texels.iter().filter(|&&texel| texel != u32::MAX).count();
        match attachments {
            Attachments::Depth32 | Attachments::DepthIds => other(self.depth32.as_slice()),
            Attachments::Depth16 => self.depth16.as_slice().iter().filter(|&&d| d != u16::MAX).count(),
            Attachments::Ids => other(self.ids.as_slice()),
            Attachments::Coverage => {
                self.coverage.as_slice().iter().map(|mask| mask.count_ones() as usize).sum()
            }
        }
    }

    /// A number that two pictures share only if they are the same (FNV-1a, 64 bits).
    #[must_use]
    pub fn fingerprint(&self, attachments: Attachments) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325u64;
        let mut add = |word: u32| hash = (hash ^ u64::from(word)).wrapping_mul(0x100_0000_01b3);
        if attachments.depth32() {
            self.depth32.as_slice().iter().copied().for_each(&mut add);
        }
        if attachments.ids() {
            self.ids.as_slice().iter().copied().for_each(&mut add);
        }
        match attachments {
            Attachments::Depth16 => self.depth16.as_slice().iter().map(|&d| u32::from(d)).for_each(&mut add),
            Attachments::Coverage => {
                self.coverage.as_slice().iter().map(|&m| u32::from(m)).for_each(&mut add);
            }
            _ => {}
        }
        hash
    }
}

/// A matrix as rows.
fn rows(matrix: &Matrix) -> [[f32; 4]; 4] {
    [0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| matrix[row + column]))
}

fn accepted<E: std::error::Error>(drawn: Result<Statistics, E>) -> Statistics {
    drawn.expect("views have indices that exist")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::micro;

    #[test]
    fn every_level_draws_the_same_picture() {
        let view = micro::random("test", 2000, 24.0, (200, 120));
        let mut target = Target::new(&view);
        for attachments in Attachments::ALL {
            target.frame(Level::Scalar, attachments, &view.matrix);
            let (expected, covered) = (target.fingerprint(attachments), target.covered(attachments));
            assert!(covered > 200 * 120 / 2, "{attachments:?} {covered}");
            for level in Level::available() {
                target.frame(level, attachments, &view.matrix);
                assert_eq!(target.fingerprint(attachments), expected, "{level:?} {attachments:?}");
            }
        }
    }

    #[test]
    fn a_frame_is_its_stages() {
        let view = micro::random("test", 500, 24.0, (100, 80));
        let mut target = Target::new(&view);
        for level in Level::available() {
            target.frame(level, Attachments::DepthIds, &view.matrix);
            let whole = target.fingerprint(Attachments::DepthIds);
            for stage in [
                Stage::Clear(Attachments::DepthIds),
                Stage::Transform,
                Stage::Setup,
                Stage::Traverse,
                Stage::Draw(Attachments::DepthIds),
            ] {
                target.stage(level, stage, &view.matrix);
            }
            assert_eq!(target.fingerprint(Attachments::DepthIds), whole, "{level:?}");
        }
    }
}
