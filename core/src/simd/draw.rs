//! The draws: of a mesh with its indices, and of meshlets.

use super::{
    any::draw_any,
    attachment::RowAttachment,
    cull::Culling,
    fetch::Records,
    level::Level,
    meshlet::{Meshlet, MeshletPositions},
    pipeline::{Drawing, Scratch},
    source::{InView, Listed},
    vertex::{Snapped, VertexLanes, split, stage},
    window::MeshletScratch,
};
use crate::{
    draw::{self, DrawError, Index, State, Statistics},
    geometry::Positions,
    numbers::Standard,
    transform::{Frustum, ModelPositions, Viewport},
};
use fearless_simd::{Simd as _, dispatch};

/// A triangle list whose indices have been checked, once for many draws.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a, I> {
    triangles: &'a [[I; 3]],
    vertices: usize,
}

impl<'a, I: Index> Triangles<'a, I> {
    /// Triangles of three indices each into `vertices` vertices.
    ///
    /// # Errors
    ///
    /// [`DrawError::IndexCount`] and [`DrawError::IndexOutOfRange`].
    pub fn new(indices: &'a [I], vertices: usize) -> Result<Self, DrawError> {
        let triangles = draw::check_indices(indices, vertices)?;
        Ok(Self { triangles, vertices })
    }
}

/// [`draw`](crate::draw()) of object-space vertices in vector registers of `level`: the same picture,
/// the same statistics.
///
/// `records` is scratch memory, at least as long as there are vertices. Beside it, a draw takes some 15 KiB of
/// stack.
///
/// # Errors
///
/// [`DrawError`], before anything is written: as [`draw`](crate::draw()), and
/// [`DrawError::ScratchTooSmall`]; [`DrawError::IndexOutOfRange`] where `triangles` was checked for more
/// vertices than there are.
pub fn draw<I: Index, A: RowAttachment>(
    level: Level,
    positions: &ModelPositions<'_, Standard>,
    records: &mut [Snapped],
    triangles: Triangles<'_, I>,
    first_id: u32,
    state: &State<Standard>,
    attachments: &mut A,
) -> Result<Statistics, DrawError> {
    let vertices = positions.count();
    let indices = triangles.triangles.as_flattened();
    if triangles.vertices > vertices {
        draw::check_indices(indices, vertices)?;
    }
    let given = records.len();
    let Some(records) = records.get_mut(..vertices) else {
        return Err(DrawError::ScratchTooSmall { needed: vertices, given });
    };
    let triangles = triangles.triangles;
    let (submitted, area) = draw::check_draw(positions, triangles.len(), first_id, state, attachments)?;
    let (Some(vectors), Some(area), true) = (level.0, area, attachments.fast()) else {
        return draw_any(level, positions, indices, first_id, state, attachments);
    };
    let mut statistics = Statistics { submitted, ..Statistics::default() };
    dispatch!(vectors, simd => {
        simd.vectorize(
            #[inline(always)]
            || {
                let (places, depths) = split(records);
                stage(simd, positions, places, depths);
                let (records, source) = (Records { places, depths }, Listed { positions, triangles, first_id });
                let drawing = Drawing { simd, records, triangles, source, area, state };
                let culling = Culling::new(simd, area, state);
                drawing.run(&culling, &mut Scratch::EMPTY.clone(), attachments, &mut statistics);
            },
        );
    });
    Ok(statistics)
}

/// [`draw`](crate::draw()) of meshlets made of a mesh by [`make_meshlets`](super::make_meshlets), in vector
/// registers of `level`: the same picture, the same statistics, but nothing of meshlets outside the view
/// frustum is looked at.
///
/// Vertices, matrix and viewport are those of [`ModelPositions`]. A meshlet may be left out or drawn
/// alone; ids are always counted from the mesh's first triangle.
///
/// # Errors
///
/// [`DrawError`], before anything is written: [`DrawError::TooManyIds`] and
/// [`DrawError::OutsideAttachment`].
#[expect(clippy::too_many_arguments, reason = "as many as there are things to say")]
pub fn draw_meshlets<A: RowAttachment>(
    level: Level,
    meshlets: &[Meshlet],
    matrix: [[f32; 4]; 4],
    viewport: Viewport<Standard>,
    scratch: &mut MeshletScratch,
    first_id: u32,
    state: &State<Standard>,
    attachments: &mut A,
) -> Result<Statistics, DrawError> {
    let camera = ModelPositions::new(&[], matrix, viewport);
    let triangles = meshlets.iter().map(|meshlet| meshlet.corners().len()).sum();
    // The last id, of meshlets in any order.
    let ids = meshlets.iter().map(Meshlet::end).max().unwrap_or(0);
    draw::check_draw(&camera, ids, first_id, state, attachments)?;
    let (submitted, area) = draw::check_draw(&camera, triangles, 0, state, attachments)?;
    let mut statistics = Statistics::default();
    let (Some(vectors), Some(area), true) = (level.0, area, attachments.fast()) else {
        for meshlet in meshlets {
            let positions = MeshletPositions { meshlet, camera: &camera };
            let first = first_id.saturating_add(meshlet.first());
            let corners = meshlet.corners().as_flattened();
            statistics.include(draw::draw(&positions, corners, first, state, attachments)?);
        }
        return Ok(statistics);
    };
    statistics.submitted = submitted;
    dispatch!(vectors, simd => {
        simd.vectorize(
            #[inline(always)]
            || {
                // A band's, or another scissor's. What is beside it and would not be clipped is outside in
                // every draw.
                let beside = (area != viewport.region())
                    .then(|| (Frustum::of_area(&matrix, &viewport, area), Frustum::unclipped(&matrix, &viewport)));
                let frustum = Frustum::new(&matrix);
                let lanes = VertexLanes::new(simd, &camera);
                let culling = Culling::new(simd, area, state);
                let mut queues = Scratch::EMPTY.clone();
                let mut numbered = (0..).zip(meshlets);
                loop {
                    scratch.clear();
                    while scratch.has_room() && let Some((number, meshlet)) = numbered.next() {
                        let corners = [meshlet.low, meshlet.high];
                        let is_beside = |(sides, unclipped): (Frustum, Frustum)| {
                            sides.excludes_box(corners) && unclipped.contains_box(corners)
                        };
                        if frustum.excludes_box(corners) || beside.is_some_and(is_beside) {
                            draw::add(&mut statistics.culled.outside, meshlet.count());
                        } else {
                            scratch.add(simd, &lanes, meshlet, number);
                        }
                    }
                    let triangles = scratch.triangles();
                    if triangles.is_empty() {
                        break;
                    }
                    let records = Records { places: scratch.places(), depths: scratch.depths() };
                    let source = InView { scratch, meshlets, camera: &camera, first_id };
                    let drawing = Drawing { simd, records, triangles, source, area, state };
                    drawing.run(&culling, &mut queues, attachments, &mut statistics);
                }
            },
        );
    });
    Ok(statistics)
}
