//! Triangles through bins: nothing is lost, whatever fits.

use super::{
    check,
    input::{Faces, Place, Shape},
};
use crate::{
    Frame,
    failure::Verdict,
    properties::{bins, scene},
    shapes::clip_bits,
};
use arbitrary::Arbitrary;
use halfplane::{ClipPositions, Format, Small, Standard, State, Viewport};

/// Most triangles of a case.
const MOST_TRIANGLES: usize = 40;

#[derive(Debug, Arbitrary)]
struct Case {
    place: Place,
    /// Sides of frames that are larger than a tile.
    large: Option<[u8; 2]>,
    faces: Faces,
    memory: u64,
    triangles: Triangles,
}

#[derive(Debug, Arbitrary)]
enum Triangles {
    Standard(Vec<(Shape, [u32; 4])>),
    Small(Vec<(Shape, [u32; 4])>),
    Clip(Vec<[u32; 13]>),
}

/// Immediate drawing and bins of any size, in either order of tiles, at once and by steps: one picture, the same
/// statistics; refused draws change nothing.
pub fn bins(data: &[u8]) -> Verdict {
    check(data, |case: &Case| match &case.triangles {
        Triangles::Standard(triangles) => window::<Standard>(case, triangles),
        Triangles::Small(triangles) => window::<Small>(case, triangles),
        Triangles::Clip(triangles) => {
            let frame = case.frame::<Standard>();
            let vertices: Vec<_> =
                triangles.iter().take(MOST_TRIANGLES).flat_map(|&numbers| clip_bits(numbers)).collect();
            let positions = ClipPositions::new(&vertices, Viewport::new(frame.core_region()?));
            let indices: Vec<u32> = (0..vertices.len() as u32).collect();
            let state = case.state::<Standard>(&frame)?;
            bins::binned_is_immediate(&positions, &indices, frame.core_region()?, &state, case.memory)?;
            bins::errors_change_nothing::<Standard>(frame.core_region()?, case.memory)
        }
    })
}

fn window<F: Format>(case: &Case, triangles: &[(Shape, [u32; 4])]) -> Verdict {
    let frame = case.frame::<F>();
    let shots: Vec<_> =
        triangles.iter().take(MOST_TRIANGLES).map(|(shape, z)| shape.shot::<F>(&frame, *z)).collect();
    let vertices = scene::vertices::<F>(&shots)?;
    let indices: Vec<u32> = (0..vertices.len() as u32).collect();
    let (region, state) = (frame.core_region()?, case.state(&frame)?);
    bins::binned_is_immediate(&vertices[..], &indices, region, &state, case.memory).map(|_| ())
}

impl Case {
    fn frame<F: Format>(&self) -> Frame {
        match self.large {
            Some([width, height]) => {
                let side = |v: u8| (1 + 2 * u32::from(v)).min(F::MAX_TARGET);
                Frame::whole::<F>(side(width), side(height))
            }
            None => self.place.frame::<F>(),
        }
    }

    fn state<F: Format>(&self, frame: &Frame) -> Result<State<F>, crate::Failure> {
        Ok(State { cull: self.faces.cull(), front: self.faces.front(), ..frame.state()? })
    }
}
