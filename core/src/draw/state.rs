//! The fixed state of a draw.

use crate::{
    geometry::{Cull, Region, Sample, Winding},
    numbers::Format,
};

/// What does not change during a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct State<F> {
    /// The only pixels that may be written; any rectangle inside the attachments.
    pub scissor: Region<F>,
    /// The faces not drawn.
    pub cull: Cull,
    /// The winding of front faces.
    pub front: Winding,
    /// Where in a pixel coverage and depth are evaluated.
    pub sample: Sample<F>,
}

impl<F: Format> State<F> {
    /// Everything in `scissor`, both faces, clockwise in front, sampled at pixel centres.
    #[must_use]
    pub const fn new(scissor: Region<F>) -> Self {
        Self { scissor, cull: Cull::None, front: Winding::Clockwise, sample: Sample::CENTER }
    }
}
