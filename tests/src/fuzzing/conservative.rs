//! What one window triangle touches and contains, against the reference.

use super::{
    check,
    input::{Place, Shape, near},
};
use crate::{failure::Verdict, properties::conservative};
use arbitrary::Arbitrary;
use halfplane::{Format, Small, Standard};

/// Pixels of a frame that the definitions in rationals are evaluated for.
const DEFINITION_PIXELS: u32 = 32;

#[derive(Debug, Arbitrary)]
struct Case {
    small: bool,
    place: Place,
    shape: Shape,
    other: [i16; 2],
    moved: [[i8; 2]; 3],
}

/// Masks, overlap with regions, bounds, rectangles and the relations between them, of one triangle in a frame.
pub fn conservative(data: &[u8]) -> Verdict {
    check(data, |case: &Case| if case.small { holds::<Small>(case) } else { holds::<Standard>(case) })
}

fn holds<F: Format>(case: &Case) -> Verdict {
    let frame = case.place.frame::<F>();
    let corners = case.shape.corners::<F>(&frame);
    conservative::equals_reference::<F>(&frame, &corners)?;
    conservative::overlaps::<F>(&frame, &corners)?;
    conservative::is_nested::<F>(&frame, &corners)?;
    let other = near::<F>(&frame, case.other);
    conservative::an_edge_is_touched_from_both_sides::<F>(&frame, &corners, other)?;
    conservative::rectangles::<F>(&frame, [corners[0], other])?;
    if frame.width() * frame.height() <= DEFINITION_PIXELS {
        conservative::equals_definition::<F>(&frame, &corners)?;
        conservative::holds_before_snapping::<F>(&frame, &corners, case.moved)?;
    }
    Ok(())
}
