//! Depth within its interval, and the tests it decides.

use super::{
    check,
    input::{Place, Shape},
};
use crate::{
    failure::Verdict,
    properties::{depth, depth_test},
    shapes::depths as depths_of,
};
use arbitrary::Arbitrary;
use halfplane::{D16, D32, DepthFormat, DepthTest, Format, Small, Standard};
use halfplane_reference::DepthSpec;

/// Largest side of a frame: every covered sample costs a division of 128 bits.
const SIDE: u16 = 40;
/// Most triangles of a scene.
const MOST_TRIANGLES: usize = 12;

#[derive(Debug, Arbitrary)]
struct Case {
    format: u8,
    place: Place,
    what: What,
}

#[derive(Debug, Arbitrary)]
enum What {
    One(Shape, [u32; 4]),
    Scene { compare: u8, write: bool, stored: u64, triangles: Vec<(Shape, [u32; 4])> },
}

/// The depth of one triangle: the specified integer, within its distance of the exact rational, the same
/// from every vertex on. Of several: as the comparison says.
pub fn depths(data: &[u8]) -> Verdict {
    check(data, |case: &Case| match case.format % 3 {
        0 => holds::<Standard, D32>(case, DepthSpec::D32),
        1 => holds::<Standard, D16>(case, DepthSpec::D16),
        _ => holds::<Small, D16>(case, DepthSpec::SMALL),
    })
}

fn holds<F: Format, D: DepthFormat<F>>(case: &Case, spec: DepthSpec) -> Verdict
where
    D::Texel: TryFrom<u32>,
{
    let frame = case.place.small::<F>(SIDE);
    match &case.what {
        What::One(shape, z) => {
            let (corners, z) = (shape.corners::<F>(&frame), depths_of(*z));
            depth::is_specified_and_bounded::<F, D>(&frame, &corners, z, spec)?;
            depth::does_not_depend_on_the_order::<F, D>(&frame, &corners, z)?;
            depth::equals_definition::<F, D>(&frame, &corners, z, spec)
        }
        What::Scene { compare, write, stored, triangles } => {
            let shots: Vec<_> =
                triangles.iter().take(MOST_TRIANGLES).map(|(shape, z)| shape.shot::<F>(&frame, *z)).collect();
            let compare = depth_test::COMPARISONS[usize::from(*compare) % depth_test::COMPARISONS.len()];
            depth_test::equals_model::<F, D>(
                &frame,
                &shots,
                DepthTest { compare, write: *write },
                spec,
                *stored,
            )
        }
    }
}
