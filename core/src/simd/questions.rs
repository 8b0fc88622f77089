//! Questions about many boxes or spheres at once.

use super::{hierarchical::Occluder, level::Level, volume::Volume};
use crate::{
    draw::{DrawError, State},
    geometry::Region,
    lanes::{ArrayLanes, Lanes, VectorLanes},
    numbers::Standard,
    transform::{Bound, Frustum, Viewport},
};
use fearless_simd::{Simd as _, dispatch};

/// What can be seen of a box, a sphere or triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Visibility {
    /// Nothing: it is outside the view, the viewport's or the scissor's.
    Outside,
    /// Nothing: what was drawn is before it.
    Hidden,
    /// Something, or it is not known that nothing can be.
    #[default]
    Visible,
}

/// What can be seen of boxes, each between two corners of object space (the smallest x, y and z, and the largest), or
/// of spheres, each a centre and a radius that is not negative, behind what was drawn. Nothing is drawn. "Outside" and
/// "hidden" are certain: no triangle inside would change a pixel.
///
/// Matrix and viewport are those of [`ModelPositions`](crate::ModelPositions). About triangles there is
/// [`ask_triangles`](super::ask_triangles); about a rectangle of pixels and a depth,
/// [`HierarchicalDepth::hides`](crate::HierarchicalDepth::hides).
///
/// # Errors
///
/// [`DrawError::ScratchTooSmall`] where there are fewer `answers` than volumes; [`DrawError::OutsideAttachment`] where
/// the scissor is not in the attachment. No answer is written then.
pub fn ask<V: Volume, A: Occluder>(
    level: Level,
    volumes: &[V],
    matrix: &[[f32; 4]; 4],
    viewport: &Viewport<Standard>,
    state: &State<Standard>,
    attachments: &mut A,
    answers: &mut [Visibility],
) -> Result<(), DrawError> {
    let (needed, given) = (volumes.len(), answers.len());
    let answers = answers.get_mut(..needed).ok_or(DrawError::ScratchTooSmall { needed, given })?;
    let Some(area) = viewport.region().intersect(state.scissor) else {
        answers.fill(Visibility::Outside);
        return Ok(());
    };
    attachments.check_area(area)?;
    let questions =
        Questions { frustum: Frustum::of_area(matrix, viewport, area), matrix, viewport, state, area };
    match level.0 {
        Some(vectors) => dispatch!(vectors, simd => {
            simd.vectorize(
                #[inline(always)]
                || questions.ask_all::<VectorLanes<_>, V, A>(simd, volumes, attachments, answers),
            );
        }),
        None => questions.ask_all::<ArrayLanes, V, A>((), volumes, attachments, answers),
    }
    Ok(())
}

/// What stays the same for all questions of a frame.
#[derive(Clone, Copy)]
pub(super) struct Questions<'a> {
    pub(super) frustum: Frustum,
    pub(super) matrix: &'a [[f32; 4]; 4],
    pub(super) viewport: &'a Viewport<Standard>,
    pub(super) state: &'a State<Standard>,
    /// The pixels that can be written.
    pub(super) area: Region<Standard>,
}

impl Questions<'_> {
    #[inline(always)]
    fn ask_all<L: Lanes, V: Volume, A: Occluder>(
        &self,
        token: L::Token,
        volumes: &[V],
        attachments: &mut A,
        answers: &mut [Visibility],
    ) {
        for (&volume, answer) in volumes.iter().zip(answers) {
            *answer = if volume.is_outside(&self.frustum) {
                Visibility::Outside
            } else {
                self.ask::<L, V, A>(token, volume, attachments)
            };
        }
    }

    /// About a volume that the frustum does not exclude.
    #[inline(always)]
    pub(super) fn ask<L: Lanes, V: Volume, A: Occluder>(
        &self,
        token: L::Token,
        volume: V,
        attachments: &mut A,
    ) -> Visibility {
        match volume.bound(self.viewport, self.matrix, self.state.sample) {
            Bound::Nothing => Visibility::Outside,
            Bound::Within { area, depths } => match area.intersect(self.area) {
                Some(area) if attachments.hides::<L>(token, area, depths) => Visibility::Hidden,
                Some(_) => Visibility::Visible,
                None => Visibility::Outside,
            },
            Bound::Anything => Visibility::Visible,
        }
    }
}
