//! The ways from a mesh to a picture, as the options ask for them; no depth depends on which.

use std::collections::HashMap;
use std::num::NonZeroUsize;

use halfplane::bins::TileOrder;
use halfplane::simd::RowAttachment;
use halfplane::{D16, D32, Depth, HierarchicalDepth, NO_ID, Standard, Statistics};

use crate::args::{self, DepthFormat, Options};
use crate::camera::Matrix;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::render::{RenderError, Settings};
use crate::target::{Attachments, Banded, Binned, Clustered, Occluded, Preparation, Prepared, Target};

/// Triangles that bins hold at a time.
pub const BINNED: usize = 1 << 16;

/// How a mesh is drawn, and what was made of it for that.
#[derive(Debug)]
pub enum Way {
    /// Its triangles, in their order.
    Triangles,
    /// Its meshlets, in their order.
    Meshlets(Prepared),
    /// Its batches from front to back, but those that are hidden.
    Queries(Clustered),
    /// Its triangles through bins, drawn by so many threads.
    Bins(NonZeroUsize),
    /// Its meshlets, by so many threads.
    Bands(Prepared, NonZeroUsize),
}

/// Depths and ids in rows, and what became of the triangles.
pub(crate) struct Rows {
    pub(crate) depth: Vec<u32>,
    pub(crate) ids: Vec<u32>,
    pub(crate) statistics: Statistics,
}

impl Way {
    /// The way that the options ask for, and what has to be made of the mesh.
    ///
    /// # Errors
    ///
    /// None for any mesh that was loaded.
    pub fn of(mesh: &Mesh, options: &Options) -> Result<Self, Error> {
        let (positions, indices) = (&mesh.positions, &mesh.indices);
        let several = options.threads > NonZeroUsize::MIN;
        Ok(if options.queries {
            Self::Queries(Clustered::new(positions, indices)?)
        } else if options.binned {
            Self::Bins(options.threads)
        } else if several {
            Self::Bands(Prepared::new(positions, indices)?, options.threads)
        } else if options.meshlets {
            Self::Meshlets(Prepared::new(positions, indices)?)
        } else {
            Self::Triangles
        })
    }

    /// What was made, if anything was.
    #[must_use]
    pub fn preparation(&self) -> Option<Preparation> {
        match self {
            Self::Triangles | Self::Bins(_) => None,
            Self::Meshlets(prepared) | Self::Bands(prepared, _) => Some(prepared.preparation()),
            Self::Queries(clustered) => Some(clustered.preparation()),
        }
    }

    /// The meshlets of a way that draws no more than those.
    #[must_use]
    pub fn meshlets(&self) -> Option<&Prepared> {
        match self {
            Self::Meshlets(prepared) => Some(prepared),
            _ => None,
        }
    }

    /// Whether the id is the first one's where several triangles are at the same depth.
    #[must_use]
    pub const fn is_ordered(&self) -> bool {
        !matches!(self, Self::Queries(_))
    }

    /// Draws depth and ids.
    pub(crate) fn draw(
        &self,
        mesh: &Mesh,
        matrix: &Matrix,
        settings: &Settings,
    ) -> Result<Rows, RenderError> {
        match settings.depth {
            DepthFormat::D32 => self.draw_in::<D32>(mesh, matrix, settings),
            DepthFormat::D16 => self.draw_in::<D16>(mesh, matrix, settings),
        }
    }

    /// The same in the settings' depth format.
    fn draw_in<D: halfplane::DepthFormat<Standard, Texel: Send>>(
        &self,
        mesh: &Mesh,
        matrix: &Matrix,
        settings: &Settings,
    ) -> Result<Rows, RenderError>
    where
        for<'a> Depth<'a, Standard, D>: RowAttachment,
        for<'a> HierarchicalDepth<'a, Standard, D>: RowAttachment,
    {
        let (state, level) = (settings.state(), settings.level);
        let (positions, indices) = (&mesh.positions, &mesh.indices);
        match self {
            Self::Triangles | Self::Meshlets(_) => {
                let attachments = args::Attachments::DepthIds.in_format(settings.depth);
                let mut target = Target::new(positions, indices, &state)?;
                target.set_meshlets(self.meshlets().map(Prepared::meshlets));
                let statistics = target.frame(level, attachments, matrix)?;
                let depth = target.depth_rows(attachments)?;
                Ok(Rows { depth, ids: target.id_rows(attachments)?, statistics })
            }
            Self::Queries(clustered) => {
                let mut target = Occluded::<D>::new(clustered, &state, true);
                let (statistics, _) = target.frame(level, matrix)?;
                let mut ids = target.id_rows()?;
                let numbers = numbers(clustered.indices(), indices);
                for id in ids.iter_mut().filter(|id| **id != NO_ID) {
                    *id = numbers[*id as usize];
                }
                Ok(Rows { depth: target.depth_rows()?, ids, statistics })
            }
            Self::Bins(threads) => {
                let order = TileOrder::Rows;
                let mut target = Binned::<D>::new(positions, indices, &state, order, *threads, BINNED)?;
                let (statistics, _) = target.frame(level, matrix)?;
                let [depth, ids] = target.rows()?;
                Ok(Rows { depth, ids, statistics })
            }
            Self::Bands(prepared, threads) => {
                let mut target = Banded::<D>::new(prepared, &state, *threads, true)?;
                target.frame(level, matrix)?;
                // A triangle is in several bands: it is counted apart.
                let mut counted = Target::new(positions, indices, &state)?;
                counted.set_meshlets(Some(prepared.meshlets()));
                let statistics = counted.frame(level, Attachments::Coverage, matrix)?;
                Ok(Rows { depth: target.depth_rows()?, ids: target.id_rows()?, statistics })
            }
        }
    }
}

/// For each triangle of a list its number in another one that has the same triangles; of the same three corners, the
/// lowest number comes first.
fn numbers(list: &[u32], original: &[u32]) -> Vec<u32> {
    let mut places: HashMap<&[u32; 3], Vec<u32>> = HashMap::new();
    for (number, corners) in original.as_chunks::<3>().0.iter().enumerate().rev() {
        places.entry(corners).or_default().push(number as u32);
    }
    let number = |corners| places.get_mut(corners).and_then(Vec::pop).unwrap_or(NO_ID);
    list.as_chunks::<3>().0.iter().map(number).collect()
}
