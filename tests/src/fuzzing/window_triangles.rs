//! One window triangle against the reference.

use super::{
    check,
    input::{Faces, Place, Shape},
};
use crate::{
    failure::Verdict,
    properties::{coverage, entry, statistics},
};
use arbitrary::Arbitrary;
use halfplane::{Format, Small, Standard};

/// Pixels of a frame that the definition in rationals is evaluated for.
const DEFINITION_PIXELS: u32 = 64;

#[derive(Debug, Arbitrary)]
struct Case {
    small: bool,
    place: Place,
    shape: Shape,
    faces: Faces,
}

/// Coverage, bounds, statistics and what later attachments see, of one triangle in a frame.
pub fn window_triangles(data: &[u8]) -> Verdict {
    check(data, |case: &Case| if case.small { holds::<Small>(case) } else { holds::<Standard>(case) })
}

fn holds<F: Format>(case: &Case) -> Verdict {
    let frame = case.place.frame::<F>();
    let shot = case.shape.shot::<F>(&frame, [1 << 30; 4]);
    coverage::equals_reference::<F>(&frame, &shot.corners)?;
    coverage::bounds_are_half_open::<F>(&frame, &shot.corners)?;
    statistics::equal_model::<F>(&frame, &[shot], case.faces.cull(), case.faces.front())?;
    entry::careless_attachments_cover_nothing_more::<F>(&frame, &shot.corners)?;
    if frame.width() * frame.height() <= DEFINITION_PIXELS {
        coverage::equals_definition::<F>(&frame, &shot.corners)?;
    }
    Ok(())
}
