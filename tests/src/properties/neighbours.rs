//! Clip-space triangles of any bits against their neighbours: what two of them share is in the same place
//! for both, so surfaces that close cancel at every sample.
//!
//! A triangle counts by its winding, and the windings of a closed outline's pieces add up to how often it
//! goes round a sample, whatever snapping has turned over. So the sums are exactly 0, without a tolerance.

use super::clipping::counted;
use crate::{Frame, double::Overdraw, ensure, failure::Verdict};
use halfplane::Format;

/// A triangle and its other side cancel, whichever corner the other side begins at: each edge, and
/// wherever a plane cuts it, is the same from both ends.
pub fn other_sides_cancel<F: Format>(frame: &Frame, triangle: &[[f32; 4]; 3]) -> Verdict {
    for other in [[2, 1, 0], [1, 0, 2], [0, 2, 1]] {
        let counts = counted::<F>(frame, triangle, &[[0, 1, 2], other])?;
        cancels(frame, &counts, &format!("{triangle:?} and {other:?}"))?;
    }
    Ok(())
}

/// The four sides of a tetrahedron between the near and the far plane cancel, wherever the guard band cuts
/// them: it cuts outside the viewport.
///
/// Depths are moved there; a tetrahedron with a NaN or an infinity is not closed, and passes.
pub fn closed_surfaces_cancel<F: Format>(frame: &Frame, corners: &[[f32; 4]; 4]) -> Verdict {
    if !corners.as_flattened().iter().all(|v| v.is_finite()) {
        return Ok(());
    }
    let between = corners.map(|[x, y, z, w]| {
        let w = w.abs().max(f32::MIN_POSITIVE);
        [x, y, w * ((z.to_bits() >> 8) as f32 / (1 << 24) as f32), w]
    });
    let counts = counted::<F>(frame, &between, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])?;
    cancels(frame, &counts, &format!("the sides of {between:?}"))
}

fn cancels(frame: &Frame, counts: &Overdraw, what: &str) -> Verdict {
    for pixel in frame.pixels() {
        let signed = counts.signed(pixel);
        ensure!(signed == 0, "{what}: pixel {pixel:?} is covered {signed} times\n{}", counts.picture());
    }
    Ok(())
}
