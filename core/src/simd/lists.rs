//! Questions about triangle lists.

use super::{hierarchical::Occluder, level::Level, questions::Visibility};
use crate::{
    draw::{self, DrawError, Index, State},
    geometry::{Positions, Region},
    lanes::{ArrayLanes, Lanes, VectorLanes},
    numbers::Standard,
};
use fearless_simd::dispatch;

/// What can be seen of triangles, three indices each, behind what was drawn. Nothing is drawn. "Outside" and "hidden"
/// are certain: drawing them would change no pixel.
///
/// Triangles are clipped, snapped and culled as [`draw`](crate::draw()) does it. Each is hidden where everything at its
/// nearest vertex's depth is, in all pixels with samples between its ends: so less is seen in vain than where
/// [`ask`](super::ask) is asked about a box round them, and it takes longer, the longer the more triangles are hidden;
/// the first that is not ends it. A list of which no triangle covers a sample is outside.
///
/// How many samples would pass, exactly: draw into `(Depth, Count)` with a test that does not
/// [write](crate::DepthTest::write).
///
/// # Errors
///
/// [`DrawError::IndexCount`] and [`DrawError::IndexOutOfRange`]; [`DrawError::OutsideAttachment`] where the scissor is
/// not in the attachment.
pub fn ask_triangles<P, I, A>(
    level: Level,
    positions: &P,
    indices: &[I],
    state: &State<Standard>,
    attachments: &mut A,
) -> Result<Visibility, DrawError>
where
    P: Positions<Standard> + ?Sized,
    I: Index,
    A: Occluder,
{
    let triangles = draw::check_indices(indices, positions.count())?;
    let area = match positions.window() {
        None => Some(state.scissor),
        Some(window) => state.scissor.intersect(window),
    };
    let Some(area) = area else { return Ok(Visibility::Outside) };
    attachments.check_area(area)?;
    Ok(match level.0 {
        Some(vectors) => dispatch!(vectors, simd => {
            ask_all::<VectorLanes<_>, P, I, A>(simd, positions, triangles, area, state, attachments)
        }),
        None => ask_all::<ArrayLanes, P, I, A>((), positions, triangles, area, state, attachments),
    })
}

#[inline(always)]
fn ask_all<L, P, I, A>(
    token: L::Token,
    positions: &P,
    triangles: &[[I; 3]],
    area: Region<Standard>,
    state: &State<Standard>,
    attachments: &mut A,
) -> Visibility
where
    L: Lanes,
    P: Positions<Standard> + ?Sized,
    I: Index,
    A: Occluder,
{
    let mut answer = Visibility::Outside;
    for corners in triangles {
        positions.assemble(corners.map(Index::to_usize), |vertices| {
            if answer == Visibility::Visible {
                return;
            }
            // Nothing is covered by what is culled.
            let Ok(bounds) = draw::bounds(vertices, area, state) else { return };
            let [a, b, c] = vertices.map(|vertex| vertex.z());
            let depths = [a.min(b).min(c), a.max(b).max(c)];
            let hidden = L::vectorize(
                token,
                #[inline(always)]
                || attachments.hides::<L>(token, bounds, depths),
            );
            answer = if hidden { Visibility::Hidden } else { Visibility::Visible };
        });
        if answer == Visibility::Visible {
            break;
        }
    }
    answer
}
