//! A mesh and the buffers it is drawn into, as often as wanted: where the rasterizer's draw is called, whole or by
//! its stages. The command and the measurements of whole scenes go through it.

mod attachments;
mod banded;
mod binned;
mod buffers;
mod clustered;
mod error;
mod occluded;
mod prepared;
mod split;

use std::hint::black_box;

use halfplane::simd::{self, Meshlet, MeshletScratch, RowAttachment, Snapped, Triangles};
use halfplane::{
    ClipPositions, ModelPositions, Positions as _, Standard, State, Statistics, Triangle, Viewport, draw,
};

pub use attachments::Attachments;
pub use banded::Banded;
pub use binned::Binned;
pub use clustered::Clustered;
pub use error::TargetError;
pub use occluded::Occluded;
pub use prepared::{Preparation, Prepared};

use buffers::{Buffers, Visitor};

use crate::buffer::Buffer;
use crate::level::{self, Level};
use crate::{Matrix, clip};

/// A part of a frame, for measuring it apart. [`Setup`](Self::Setup), [`Traverse`](Self::Traverse) and
/// [`Draw`](Self::Draw) each hold the work of those before but the clear, so the difference of two is what
/// the later one adds. They do not hold the transform, which comes before them, at the fallback level; they
/// do at the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The clear of the attachments.
    Clear(Attachments),
    /// The vertices alone, all of them: at the vector levels a draw of no triangles, at the fallback level the product
    /// of every position and the matrix.
    Transform,
    /// Assembly, rejection, clipping, division, snapping, culling, edges and bounds of every triangle;
    /// fallback level only.
    Setup,
    /// The above and the traversal, no attachment; fallback level only.
    Traverse,
    /// The above and the attachments.
    Draw(Attachments),
    /// Everything: clear, transform, draw.
    Frame(Attachments),
}

/// What a frame needs beside the matrix, prepared once: indices checked, memory of the right size.
#[derive(Debug)]
pub struct Target<'m> {
    positions: &'m [[f32; 3]],
    indices: &'m [u32],
    triangles: Triangles<'m, u32>,
    /// Drawn instead of the triangles, if there are any.
    meshlets: Option<&'m [Meshlet]>,
    state: State<Standard>,
    viewport: Viewport<Standard>,
    /// Of meshlets.
    scratch: Box<MeshletScratch>,
    /// Of the vector levels.
    records: Buffer<Snapped>,
    /// Of the fallback level.
    clip: Buffer<[f32; 4]>,
    buffers: Buffers,
}

impl<'m> Target<'m> {
    /// For drawing triangles of three indices each into positions; the picture is the state's scissor.
    ///
    /// # Errors
    ///
    /// [`TargetError::Draw`] for indices that are no good.
    pub fn new(
        positions: &'m [[f32; 3]],
        indices: &'m [u32],
        state: &State<Standard>,
    ) -> Result<Self, TargetError> {
        Ok(Self {
            positions,
            indices,
            triangles: Triangles::new(indices, positions.len())?,
            meshlets: None,
            state: *state,
            viewport: Viewport::new(state.scissor),
            scratch: Box::default(),
            records: Buffer::new(0, Snapped::default()),
            clip: Buffer::new(0, [0.0; 4]),
            buffers: Buffers::new(state.scissor),
        })
    }

    /// From now on draws meshlets of the same mesh, which change no picture; without any, its triangles.
    pub fn set_meshlets(&mut self, meshlets: Option<&'m [Meshlet]>) {
        self.meshlets = meshlets;
    }

    /// Everything from positions and a matrix to finished buffers: clear, transform, draw.
    ///
    /// # Errors
    ///
    /// [`TargetError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(
        &mut self,
        level: Level,
        attachments: Attachments,
        matrix: &Matrix,
    ) -> Result<Statistics, TargetError> {
        self.buffers.clear(attachments)?;
        if level::is_fallback(level) && self.meshlets.is_none() {
            self.transform_fallback(matrix);
        }
        self.draw(level, attachments, matrix, self.drawn())
    }

    fn drawn(&self) -> Drawn<'m> {
        self.meshlets.map_or(Drawn::Triangles(self.triangles), Drawn::Meshlets)
    }

    /// Whether a level has a stage that can be measured apart.
    #[must_use]
    pub fn has(level: Level, stage: Stage) -> bool {
        level::is_fallback(level) || !matches!(stage, Stage::Setup | Stage::Traverse)
    }

    /// One stage; nothing if the level does not [have](Self::has) it. At the fallback level, stages after
    /// [`Stage::Transform`] draw what it left.
    ///
    /// # Errors
    ///
    /// As [`frame`](Self::frame).
    pub fn stage(&mut self, level: Level, stage: Stage, matrix: &Matrix) -> Result<(), TargetError> {
        if !Self::has(level, stage) {
            return Ok(());
        }
        match stage {
            Stage::Clear(attachments) => self.buffers.clear(attachments)?,
            Stage::Transform if level::is_fallback(level) => {
                self.transform_fallback(matrix);
                black_box(self.clip.as_slice());
            }
            Stage::Transform => {
                let none = Triangles::new(&[], self.positions.len())?;
                black_box(self.draw(level, Attachments::Coverage, matrix, Drawn::Triangles(none))?);
                black_box(self.records.as_slice());
            }
            Stage::Setup => self.set_up_fallback(),
            Stage::Traverse => {
                let clip = ClipPositions::new(self.clip.as_slice(), self.viewport);
                black_box(draw(&clip, self.indices, 0, &self.state, &mut ())?);
            }
            Stage::Draw(attachments) => {
                black_box(self.draw(level, attachments, matrix, self.drawn())?);
            }
            Stage::Frame(attachments) => {
                black_box(self.frame(level, attachments, matrix)?);
            }
        }
        Ok(())
    }

    fn transform_fallback(&mut self, matrix: &Matrix) {
        if self.clip.as_slice().len() < self.positions.len() {
            self.clip = Buffer::new(self.positions.len(), [0.0; 4]);
        }
        for (clipped, &position) in self.clip.as_mut_slice().iter_mut().zip(self.positions) {
            *clipped = clip(position, matrix);
        }
    }

    fn set_up_fallback(&self) {
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

    fn draw(
        &mut self,
        level: Level,
        attachments: Attachments,
        matrix: &Matrix,
        drawn: Drawn<'m>,
    ) -> Result<Statistics, TargetError> {
        let listed = matches!(drawn, Drawn::Triangles(_));
        if listed && !level::is_fallback(level) && self.records.as_slice().len() < self.positions.len() {
            self.records = Buffer::new(self.positions.len(), Snapped::default());
        }
        let shot = Shot {
            level,
            matrix,
            positions: self.positions,
            indices: self.indices,
            drawn,
            state: &self.state,
            viewport: self.viewport,
            scratch: &mut self.scratch,
            records: self.records.as_mut_slice(),
            clip: self.clip.as_slice(),
        };
        self.buffers.visit(attachments, shot)?
    }

    /// How many pixels something covers, by an attachment that was drawn.
    #[must_use]
    pub fn covered(&self, attachments: Attachments) -> usize {
        self.buffers.covered(attachments)
    }

    /// A number that two pictures share only if they are the same.
    #[must_use]
    pub fn fingerprint(&self, attachments: Attachments) -> u64 {
        self.buffers.fingerprint(attachments)
    }

    /// The depths in rows from the top; none if depth is not attached.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn depth_rows(&mut self, attachments: Attachments) -> Result<Vec<u32>, TargetError> {
        self.buffers.depth_rows(attachments)
    }

    /// The ids in rows from the top; none if ids are not attached.
    ///
    /// # Errors
    ///
    /// None that a target can have.
    pub fn id_rows(&mut self, attachments: Attachments) -> Result<Vec<u32>, TargetError> {
        self.buffers.id_rows(attachments)
    }
}

/// A matrix in rows.
fn rows_of(m: &Matrix) -> [[f32; 4]; 4] {
    [0, 4, 8, 12].map(|row| [m[row], m[row + 1], m[row + 2], m[row + 3]])
}

/// What a draw is told to draw.
#[derive(Clone, Copy)]
enum Drawn<'m> {
    Triangles(Triangles<'m, u32>),
    Meshlets(&'m [Meshlet]),
}

/// One draw, whatever it writes.
struct Shot<'a> {
    level: Level,
    matrix: &'a Matrix,
    positions: &'a [[f32; 3]],
    indices: &'a [u32],
    drawn: Drawn<'a>,
    state: &'a State<Standard>,
    viewport: Viewport<Standard>,
    scratch: &'a mut MeshletScratch,
    records: &'a mut [Snapped],
    clip: &'a [[f32; 4]],
}

impl Visitor for Shot<'_> {
    type Result = Result<Statistics, TargetError>;

    fn visit<A: RowAttachment>(self, attachments: &mut A) -> Self::Result {
        let Self { level, state, viewport, scratch, .. } = self;
        let m = self.matrix;
        let rows = rows_of(m);
        let triangles = match self.drawn {
            Drawn::Triangles(triangles) => triangles,
            Drawn::Meshlets(meshlets) => {
                let drawn =
                    simd::draw_meshlets(level, meshlets, rows, viewport, scratch, 0, state, attachments);
                return Ok(drawn?);
            }
        };
        if level::is_fallback(level) {
            // Vertices are transformed once each, not once for every corner.
            let positions = ClipPositions::new(self.clip, viewport);
            return Ok(draw(&positions, self.indices, 0, state, attachments)?);
        }
        let positions = ModelPositions::new(self.positions, rows, viewport);
        Ok(simd::draw(level, &positions, self.records, triangles, 0, state, attachments)?)
    }
}
