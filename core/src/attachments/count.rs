//! Counting covered samples.

use super::{Attachment, Block};
use crate::{numbers::Format, traversal::Mask};

/// Counts the samples that reach it: alone, every covered sample of every triangle; after a depth
/// attachment, those that pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Samples so far; saturates.
    pub samples: u64,
}

impl<F: Format> Attachment<F> for Count {
    #[inline]
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.samples = self.samples.saturating_add(u64::from(block.mask.count()));
        block.mask
    }
}
