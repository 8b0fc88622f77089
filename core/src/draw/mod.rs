//! Whole meshes: indices checked once, then every triangle drawn, culled or rejected, and counted.

mod error;
mod index;
mod instances;
#[cfg(any(kani, test))]
mod proofs;
mod state;
mod statistics;

pub use error::DrawError;
pub use index::Index;
pub use instances::instance_of;
pub use state::State;
#[cfg(feature = "simd")]
pub(crate) use statistics::add;
pub use statistics::{CulledCounts, RejectedCounts, Statistics};

use crate::{
    attachments::{Attachment, Block},
    geometry::{Culled, Extent, Positions, Region, Triangle, Vertex, winding},
    lanes::{ArrayLanes, Lanes},
    numbers::Format,
    traversal::walk,
};

/// Draws triangles: three indices each, in order, triangle n of the list with id `first_id + n`.
///
/// Every triangle is accounted for in the statistics by what became of it.
///
/// # Errors
///
/// [`DrawError`], before anything is written.
pub fn draw<F, P, I, A>(
    positions: &P,
    indices: &[I],
    first_id: u32,
    state: &State<F>,
    attachments: &mut A,
) -> Result<Statistics, DrawError>
where
    F: Format,
    P: Positions<F> + ?Sized,
    I: Index,
    A: Attachment<F>,
{
    draw_with::<ArrayLanes, F, P, I, A>((), positions, indices, first_id, state, attachments)
}

/// [`draw`] with other lanes; the same pixels and statistics.
pub(crate) fn draw_with<L, F, P, I, A>(
    token: L::Token,
    positions: &P,
    indices: &[I],
    first_id: u32,
    state: &State<F>,
    attachments: &mut A,
) -> Result<Statistics, DrawError>
where
    L: Lanes,
    F: Format,
    P: Positions<F> + ?Sized,
    I: Index,
    A: Attachment<F>,
{
    let triangles = check_indices(indices, positions.count())?;
    let (submitted, area) = check_draw(positions, triangles.len(), first_id, state, attachments)?;
    let mut statistics = Statistics { submitted, ..Statistics::default() };
    for (id, corners) in (first_id..first_id.saturating_add(submitted)).zip(triangles) {
        let mut outcome = None;
        let assembly = positions.assemble(corners.map(Index::to_usize), |vertices| {
            let piece = match area {
                Some(area) => draw_one::<L, F, A>(token, &vertices, area, state, id, attachments),
                None => Err(Culled::Outside),
            };
            // A triangle in several pieces is drawn if one of them is.
            if outcome.is_none_or(|known: Result<(), Culled>| known.is_err()) {
                outcome = Some(piece);
            }
        });
        statistics.count(assembly, outcome);
    }
    Ok(statistics)
}

/// A triangle list, if every index names one of `vertices` vertices.
pub(crate) fn check_indices<I: Index>(indices: &[I], vertices: usize) -> Result<&[[I; 3]], DrawError> {
    let (triangles, rest) = indices.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(DrawError::IndexCount { count: indices.len() });
    }
    for (at, index) in indices.iter().enumerate() {
        if index.to_usize() >= vertices {
            return Err(DrawError::IndexOutOfRange { at, index: index.to_u32(), vertices });
        }
    }
    Ok(triangles)
}

/// What else can be wrong with a draw; the number of triangles, and the pixels that it may write.
pub(crate) fn check_draw<F, P, A>(
    positions: &P,
    triangles: usize,
    first_id: u32,
    state: &State<F>,
    attachments: &A,
) -> Result<(u32, Option<Region<F>>), DrawError>
where
    F: Format,
    P: Positions<F> + ?Sized,
    A: Attachment<F>,
{
    let submitted = match u32::try_from(triangles) {
        Ok(count) if first_id.checked_add(count).is_some() => count,
        _ => return Err(DrawError::TooManyIds { first_id, triangles }),
    };
    let area = match positions.window() {
        None => Some(state.scissor),
        Some(window) => state.scissor.intersect(window),
    };
    if let Some(area) = area {
        attachments.check(area)?;
    }
    Ok((submitted, area))
}

/// The pixels that a window triangle may cover; first what costs least to find out.
#[inline(always)]
pub(crate) fn bounds<F: Format>(
    vertices: [Vertex<F>; 3],
    area: Region<F>,
    state: &State<F>,
) -> Result<Region<F>, Culled> {
    let extent = Extent::of(vertices);
    if extent.is_outside(area) {
        return Err(Culled::Outside);
    }
    match winding(vertices) {
        None => Err(Culled::ZeroArea),
        Some(winding) if state.cull.culls(winding, state.front) => Err(Culled::Facing),
        Some(_) => extent.bounds(state.sample, area),
    }
}

/// Sets up one window triangle; the pixels it may cover.
#[cfg(feature = "simd")]
#[inline]
pub(crate) fn prepare<F: Format>(
    vertices: [Vertex<F>; 3],
    area: Region<F>,
    state: &State<F>,
) -> Result<(Triangle<F>, Region<F>), Culled> {
    let bounds = bounds(vertices, area, state)?;
    let triangle = Triangle::new(vertices, state.sample).ok_or(Culled::ZeroArea)?;
    Ok((triangle, bounds))
}

/// Sets up one window triangle and hands its blocks to the attachments.
///
/// Never inlined: all pieces of all triangles come through one copy of it.
#[inline(never)]
fn draw_one<L: Lanes, F: Format, A: Attachment<F>>(
    token: L::Token,
    vertices: &[Vertex<F>; 3],
    area: Region<F>,
    state: &State<F>,
    id: u32,
    attachments: &mut A,
) -> Result<(), Culled> {
    L::vectorize(
        token,
        #[inline(always)]
        || {
            let bounds = bounds(*vertices, area, state)?;
            let triangle = Triangle::new(*vertices, state.sample).ok_or(Culled::ZeroArea)?;
            let mut begun = false;
            let drawn = walk::<L, F>(
                token,
                &triangle,
                area,
                bounds,
                #[inline(always)]
                |x, y, mask| {
                    if !begun {
                        begun = true;
                        attachments.begin(&triangle);
                    }
                    attachments.block_with::<L>(token, &Block { x, y, mask, triangle: &triangle, id });
                },
            );
            if drawn { Ok(()) } else { Err(Culled::NoSample) }
        },
    )
}
