//! A mesh sorted by place, in meshlets and batches: made once, for frames that ask what is hidden.

use std::time::{Duration, Instant};

use halfplane::simd::{self, Batch, Meshlet};

use super::{Preparation, TargetError};

/// A mesh's triangles in clusters.
#[derive(Debug, Clone)]
pub struct Clustered {
    indices: Vec<u32>,
    meshlets: Vec<Meshlet>,
    batches: Vec<Batch>,
    time: Duration,
}

impl Clustered {
    /// Of triangles of three indices each into positions.
    ///
    /// # Errors
    ///
    /// [`TargetError::Draw`] for indices that are no good.
    pub fn new(positions: &[[f32; 3]], indices: &[u32]) -> Result<Self, TargetError> {
        let started = Instant::now();
        let mut indices = indices.to_vec();
        simd::cluster(positions, &mut indices)?;
        let mut meshlets = vec![Meshlet::EMPTY; simd::max_meshlets(indices.len() / 3)];
        let made = simd::make_meshlets(positions, &indices, &mut meshlets)?.len();
        meshlets.truncate(made);
        meshlets.shrink_to_fit();
        let mut batches = vec![Batch::EMPTY; simd::max_batches(made)];
        simd::make_batches(&meshlets, &mut batches)?;
        Ok(Self { indices, meshlets, batches, time: started.elapsed() })
    }

    /// The triangle list in its new order: ids of meshlets are places in it.
    #[must_use]
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// The meshlets.
    #[must_use]
    pub fn meshlets(&self) -> &[Meshlet] {
        &self.meshlets
    }

    /// The batches.
    #[must_use]
    pub fn batches(&self) -> &[Batch] {
        &self.batches
    }

    /// What it cost.
    #[must_use]
    pub fn preparation(&self) -> Preparation {
        Preparation {
            meshlets: self.meshlets.len(),
            ms: self.time.as_secs_f64() * 1e3,
            bytes: size_of_val(self.meshlets()) + size_of_val(self.batches()),
        }
    }
}
