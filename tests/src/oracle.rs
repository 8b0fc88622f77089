//! What the reference says, as pictures of a frame.

use crate::{Failure, Frame, shapes::Corners};
use halfplane::Format;
use halfplane_reference::{DepthSpec, Point, cover_rows, covers, z16_from_z32};

/// Which pixels of the frame's scissor a triangle covers: a row-major picture of the region.
pub fn coverage<F: Format>(frame: &Frame, corners: &Corners) -> Result<Vec<bool>, Failure> {
    let mut picture = vec![false; (frame.width() * frame.height()) as usize];
    cover_rows(corners, frame.grid::<F>()?, frame.scissor_rect(), |y, columns| {
        for x in columns {
            picture[frame.place((x, y))] = true;
        }
    });
    Ok(picture)
}

/// The same from the definition, in rationals.
pub fn coverage_by_definition<F: Format>(frame: &Frame, corners: &Corners) -> Vec<bool> {
    let corners = corners.map(|[x, y]| Point::from_integers(i64::from(x), i64::from(y)));
    let covered = |pixel| {
        let [x, y] = frame.sample_at::<F>(pixel);
        frame.scissor_has(pixel) && covers(&corners, &Point::from_integers(x, y))
    };
    frame.pixels().map(covered).collect()
}

/// Depths of vertices in the unit of a depth format, from 32-bit ones.
pub fn vertex_depths(z: [u32; 3], spec: DepthSpec) -> [u32; 3] {
    if spec.bits() == 32 { z.map(|z| spec.keep(z)) } else { z.map(|z| u32::from(z16_from_z32(z))) }
}

/// The oracle's name of a comparison.
pub fn compare(compare: halfplane::Compare) -> halfplane_reference::Compare {
    match compare {
        halfplane::Compare::Less => halfplane_reference::Compare::Less,
        halfplane::Compare::LessEqual => halfplane_reference::Compare::LessEqual,
        halfplane::Compare::Greater => halfplane_reference::Compare::Greater,
        halfplane::Compare::GreaterEqual => halfplane_reference::Compare::GreaterEqual,
        halfplane::Compare::Always => halfplane_reference::Compare::Always,
    }
}
