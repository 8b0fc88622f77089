//! A mesh and the buffers it is drawn into, as often as wanted.

use halfplane::simd::{self, RowAttachment, Snapped, Triangles};
use halfplane::{
    ClipPositions, Coverage, Depth, DepthFormat, DepthTest, Ids, ModelPositions, NO_ID, Standard, Statistics,
    Viewport, blocks, draw, texels,
};

use crate::args::Attachments;
use crate::camera::Matrix;
use crate::level;
use crate::measure::buffer::Buffer;
use crate::mesh::Mesh;
use crate::render::{RenderError, Settings, clip};

/// What a frame needs beside the matrix, prepared once: indices checked, memory of the right size.
#[derive(Debug)]
pub struct Target<'m, D: DepthFormat<Standard>> {
    mesh: &'m Mesh,
    triangles: Triangles<'m, u32>,
    settings: Settings,
    /// Of the vector levels.
    records: Buffer<Snapped>,
    /// Of the level without vectors.
    clip: Buffer<[f32; 4]>,
    buffers: Buffers<D::Texel>,
}

#[derive(Debug)]
enum Buffers<T> {
    Depth(Buffer<T>),
    Ids(Buffer<u32>),
    DepthIds(Buffer<T>, Buffer<u32>),
    Coverage(Buffer<u16>),
}

/// How much of a frame is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extent {
    Frame,
    Vertices,
}

impl<'m, D: DepthFormat<Standard>> Target<'m, D>
where
    for<'a> Depth<'a, Standard, D>: RowAttachment,
{
    /// Memory for drawing `mesh`.
    ///
    /// # Errors
    ///
    /// [`RenderError::Draw`] for indices that are no good; not for any mesh that was loaded.
    pub fn new(mesh: &'m Mesh, settings: &Settings, attachments: Attachments) -> Result<Self, RenderError> {
        let (width, height) = (settings.region.width(), settings.region.height());
        let depth = || Buffer::new(texels(width, height), D::FAR);
        let ids = || Buffer::new(texels(width, height), NO_ID);
        let vertices = mesh.positions.len();
        let (records, clip) = if level::is_fallback(settings.level) { (0, vertices) } else { (vertices, 0) };
        Ok(Self {
            mesh,
            triangles: Triangles::new(&mesh.indices, vertices)?,
            settings: *settings,
            records: Buffer::new(records, Snapped::default()),
            clip: Buffer::new(clip, [0.0; 4]),
            buffers: match attachments {
                Attachments::Depth => Buffers::Depth(depth()),
                Attachments::Ids => Buffers::Ids(ids()),
                Attachments::DepthIds => Buffers::DepthIds(depth(), ids()),
                Attachments::Coverage => Buffers::Coverage(Buffer::new(blocks(width, height), 0)),
            },
        })
    }

    /// Everything from positions and a matrix to finished buffers: clear, transform, draw.
    ///
    /// # Errors
    ///
    /// [`RenderError`] where the rasterizer refuses; if not the first time, then never.
    pub fn frame(&mut self, matrix: &Matrix) -> Result<Statistics, RenderError> {
        self.run(matrix, Extent::Frame)
    }

    /// The vertex stage alone: at the vector levels a draw of no triangles, otherwise the product of
    /// every position and the matrix.
    ///
    /// # Errors
    ///
    /// As [`frame`](Self::frame).
    pub fn vertices(&mut self, matrix: &Matrix) -> Result<(), RenderError> {
        self.run(matrix, Extent::Vertices).map(|_| ())
    }

    fn run(&mut self, matrix: &Matrix, extent: Extent) -> Result<Statistics, RenderError> {
        let region = self.settings.region;
        let positions = &self.mesh.positions;
        if level::is_fallback(self.settings.level) {
            for (clipped, &position) in self.clip.as_mut_slice().iter_mut().zip(positions) {
                *clipped = clip(position, matrix);
            }
            if extent == Extent::Vertices {
                return Ok(Statistics::default());
            }
        }
        let whole = extent == Extent::Frame;
        let shot = Shot {
            matrix,
            mesh: self.mesh,
            triangles: if whole { self.triangles } else { Triangles::new(&[], positions.len())? },
            settings: &self.settings,
            records: self.records.as_mut_slice(),
            clip: self.clip.as_slice(),
        };
        let depth = |texels| Depth::<Standard, D>::new(region, texels, DepthTest::LESS);
        match &mut self.buffers {
            Buffers::Depth(texels) => {
                let mut depth = depth(texels.as_mut_slice())?;
                if whole {
                    depth.clear(D::FAR);
                }
                shot.draw(&mut depth)
            }
            Buffers::Ids(texels) => {
                let mut ids = Ids::new(region, texels.as_mut_slice())?;
                if whole {
                    ids.clear();
                }
                shot.draw(&mut ids)
            }
            Buffers::DepthIds(depths, texels) => {
                let mut depth = depth(depths.as_mut_slice())?;
                let mut ids = Ids::new(region, texels.as_mut_slice())?;
                if whole {
                    depth.clear(D::FAR);
                    ids.clear();
                }
                shot.draw(&mut (&mut depth, &mut ids))
            }
            Buffers::Coverage(masks) => {
                let mut coverage = Coverage::new(region, masks.as_mut_slice())?;
                if whole {
                    coverage.clear();
                }
                shot.draw(&mut coverage)
            }
        }
    }

    /// How many pixels the last frame covers.
    #[must_use]
    pub fn covered(&self) -> usize {
        // What pads the blocks at the borders is never covered.
        match &self.buffers {
            Buffers::Depth(texels) => texels.as_slice().iter().filter(|&&texel| texel != D::FAR).count(),
            Buffers::Ids(ids) | Buffers::DepthIds(_, ids) => {
                ids.as_slice().iter().filter(|&&id| id != NO_ID).count()
            }
            Buffers::Coverage(masks) => masks.as_slice().iter().map(|mask| mask.count_ones() as usize).sum(),
        }
    }

    /// The depths in rows from the top; none if depth is not attached.
    ///
    /// # Errors
    ///
    /// None that a target of this type can have.
    pub fn depth_rows(&mut self) -> Result<Vec<u32>, RenderError> {
        let region = self.settings.region;
        let (Buffers::Depth(texels) | Buffers::DepthIds(texels, _)) = &mut self.buffers else {
            return Ok(Vec::new());
        };
        let mut rows = vec![D::FAR; region.width() as usize * region.height() as usize];
        Depth::<Standard, D>::new(region, texels.as_mut_slice(), DepthTest::LESS)?.to_linear(&mut rows)?;
        Ok(rows.into_iter().map(Into::into).collect())
    }

    /// The ids in rows from the top; none if ids are not attached.
    ///
    /// # Errors
    ///
    /// None that a target of this type can have.
    pub fn id_rows(&mut self) -> Result<Vec<u32>, RenderError> {
        let region = self.settings.region;
        let (Buffers::Ids(texels) | Buffers::DepthIds(_, texels)) = &mut self.buffers else {
            return Ok(Vec::new());
        };
        let mut rows = vec![NO_ID; region.width() as usize * region.height() as usize];
        Ids::<Standard>::new(region, texels.as_mut_slice())?.to_linear(&mut rows)?;
        Ok(rows)
    }
}

/// One draw, whatever it writes.
struct Shot<'a> {
    matrix: &'a Matrix,
    mesh: &'a Mesh,
    triangles: Triangles<'a, u32>,
    settings: &'a Settings,
    records: &'a mut [Snapped],
    clip: &'a [[f32; 4]],
}

impl Shot<'_> {
    fn draw<A: RowAttachment>(self, attachments: &mut A) -> Result<Statistics, RenderError> {
        let state = self.settings.state();
        let viewport = Viewport::new(self.settings.region);
        if level::is_fallback(self.settings.level) {
            // Vertices are transformed once each, not once for every corner.
            let positions = ClipPositions::new(self.clip, viewport);
            return Ok(draw(&positions, &self.mesh.indices, 0, &state, attachments)?);
        }
        let m = self.matrix;
        let rows = [0, 4, 8, 12].map(|row| [m[row], m[row + 1], m[row + 2], m[row + 3]]);
        let positions = ModelPositions::new(&self.mesh.positions, rows, viewport);
        Ok(simd::draw(self.settings.level, &positions, self.records, self.triangles, 0, &state, attachments)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::{self, Hand};
    use crate::level::Level;
    use crate::scene;
    use halfplane::{Cull, D16, D32, Region, Winding};

    fn frames<D: DepthFormat<Standard>>()
    where
        for<'a> Depth<'a, Standard, D>: RowAttachment,
    {
        let size = (97, 55);
        let mesh = scene::evening();
        let request = camera::Request { name: Some(scene::CAMERA.to_owned()), ..Default::default() };
        let cameras = scene::cameras();
        let matrix = camera::choose(&request, &cameras, scene::NAME, &mesh, Hand::Left, size).unwrap();
        let mirrored = std::array::from_fn(|k| if k % 4 == 0 { -matrix[k] } else { matrix[k] });
        let settings = Settings {
            region: Region::of_size(size.0, size.1).unwrap(),
            cull: Cull::Back,
            front: Winding::Clockwise,
            // The target's type counts.
            depth: crate::args::DepthFormat::D32,
            level: Level::FALLBACK,
        };
        for attachments in
            [Attachments::Depth, Attachments::Ids, Attachments::DepthIds, Attachments::Coverage]
        {
            let mut pictures = level::available().into_iter().rev().map(|level| {
                let mut target =
                    Target::<D>::new(&mesh, &Settings { level, ..settings }, attachments).unwrap();
                // The second frame must not see the first.
                target.frame(&mirrored).unwrap();
                target.vertices(&matrix).unwrap();
                let statistics = target.frame(&matrix).unwrap();
                (statistics, target.covered(), target.depth_rows().unwrap(), target.id_rows().unwrap())
            });
            let scalar = pictures.next().unwrap();
            assert!(scalar.1 > 97 * 55 / 2 && scalar.0.drawn > 1000, "{attachments:?}");
            let rows = [scalar.2.len(), scalar.3.len()].map(|len| len > 0);
            let (depth, ids) = (
                matches!(attachments, Attachments::Depth | Attachments::DepthIds),
                matches!(attachments, Attachments::Ids | Attachments::DepthIds),
            );
            assert_eq!(rows, [depth, ids]);
            for picture in pictures {
                assert!(picture == scalar, "{attachments:?}");
            }
        }
    }

    #[test]
    fn every_level_draws_the_same() {
        frames::<D32>();
        frames::<D16>();
    }
}
