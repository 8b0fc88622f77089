//! The draw that asks before it draws.

#[cfg(any(kani, test))]
mod proofs;

use super::{
    attachment::RowAttachment,
    batch::Batch,
    cone::Facing,
    cull::Culling,
    fetch::Records,
    hierarchical::Occluder,
    level::Level,
    meshlet::{Meshlet, MeshletPositions},
    pipeline::{Drawing, Scratch},
    questions::{Questions, Visibility},
    sort,
    source::InView,
    vertex::VertexLanes,
    window::MeshletScratch,
};
use crate::{
    draw::{self, DrawError, State, Statistics},
    lanes::{ArrayLanes, Lanes, VectorLanes},
    numbers::Standard,
    transform::{Frustum, ModelPositions, Viewport},
};
use fearless_simd::{Simd, dispatch};

/// Memory to put a batch in its place from front to back.
#[derive(Clone, Copy, Debug, Default)]
pub struct BatchOrder(u64);

impl BatchOrder {
    /// To fill arrays with.
    pub const NEW: Self = Self(0);

    /// By distance, then by place. Positive floats have the order of their bits; all others become 0.
    pub(super) fn of(distance: f32, place: u32) -> Self {
        let distance = if distance > 0.0 { distance } else { 0.0 };
        Self(u64::from(distance.to_bits()) << 32 | u64::from(place))
    }

    /// The place.
    pub(super) const fn place(self) -> usize {
        self.0 as u32 as usize
    }
}

/// What was asked in a draw of batches, and how often the answer was "hidden".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Occlusion {
    /// Batches that are not all outside the view frustum.
    pub batches: u32,
    /// Of these, the hidden ones.
    pub hidden_batches: u32,
    /// Meshlets of batches that are not hidden, all of whose triangles face the culled way: nothing was asked.
    pub facing_meshlets: u32,
    /// Other meshlets that were asked about: those of batches that are not hidden, themselves not all outside the
    /// frustum, as long as answers are "hidden" often enough to be worth it.
    pub meshlets: u32,
    /// Of these, the hidden ones.
    pub hidden_meshlets: u32,
}

/// Draws batches of meshlets from front to back, and leaves out those whose boxes are hidden behind what was
/// drawn before, in this draw or earlier: the same picture as [`draw_meshlets`](super::draw_meshlets), in
/// less time where much is hidden. With ids, of two triangles at the same depth another one may win, as the order
/// is another.
///
/// Where a face is culled, meshlets [whose triangles face much the same way](Meshlet::has_cone) are left out unseen if
/// that is the culled one for all of them, however they are snapped; these are counted as facing it.
///
/// Depths are looked at as far as they are written, and vector registers draw several meshlets at a time: which of
/// them are hidden is not the same at [`Level::FALLBACK`].
///
/// The triangles left out as hidden are counted as [that](crate::CulledCounts::hidden), whatever else might be said of
/// them. `order` is scratch memory, at least as long as there are batches. For the rest, see `draw_meshlets`.
///
/// # Errors
///
/// [`DrawError`], before anything is written: [`DrawError::TooManyIds`], [`DrawError::OutsideAttachment`] and
/// [`DrawError::ScratchTooSmall`].
#[expect(clippy::too_many_arguments, reason = "as many as there are things to say")]
pub fn draw_batches<A: RowAttachment + Occluder>(
    level: Level,
    batches: &[Batch],
    meshlets: &[Meshlet],
    matrix: [[f32; 4]; 4],
    viewport: Viewport<Standard>,
    order: &mut [BatchOrder],
    scratch: &mut MeshletScratch,
    first_id: u32,
    state: &State<Standard>,
    attachments: &mut A,
) -> Result<(Statistics, Occlusion), DrawError> {
    let camera = ModelPositions::new(&[], matrix, viewport);
    let members = || batches.iter().flat_map(|batch| batch.meshlets(meshlets));
    let ids = members().map(Meshlet::end).max().unwrap_or(0);
    draw::check_draw(&camera, ids, first_id, state, attachments)?;
    let triangles = members().map(|m| m.corners().len()).sum();
    let (submitted, area) = draw::check_draw(&camera, triangles, 0, state, attachments)?;
    let (needed, given) = (batches.len(), order.len());
    let order = order.get_mut(..needed).ok_or(DrawError::ScratchTooSmall { needed, given })?;
    let mut statistics = Statistics { submitted, ..Statistics::default() };
    let by_definition = |meshlet: &Meshlet, attachments: &mut A| {
        let positions = MeshletPositions { meshlet, camera: &camera };
        let first = first_id.saturating_add(meshlet.first());
        // Nothing is wrong with it that was not found above.
        let drawn = draw::draw(&positions, meshlet.corners().as_flattened(), first, state, attachments);
        Statistics { submitted: 0, ..drawn.unwrap_or_default() }
    };
    let Some(area) = area else {
        // Nothing can be seen; triangles are counted by what they are.
        members().for_each(|meshlet| statistics.include(by_definition(meshlet, attachments)));
        return Ok((statistics, Occlusion::default()));
    };
    let frustum = Frustum::of_area(&matrix, &viewport, area);
    let mut outside = 0;
    let order = front_to_back(batches, &matrix, order, |batch| {
        let excluded = frustum.excludes_box(batch.corners());
        if excluded {
            draw::add(&mut outside, triangles_of(batch.meshlets(meshlets)));
        }
        !excluded
    });
    statistics.culled.outside = outside;
    let order = order.iter().filter_map(|key| batches.get(key.place()));
    let questions = Questions { frustum, matrix: &matrix, viewport: &viewport, state, area };
    let pass = Pass { meshlets, first_id, questions, facing: Facing::new(&matrix, &viewport, state) };
    let mut occlusion = Occlusion::default();
    match level.0.filter(|_| attachments.fast()) {
        Some(vectors) => dispatch!(vectors, simd => {
            simd.vectorize(
                #[inline(always)]
                || {
                    let mut drawing = Vectors {
                        simd,
                        pass,
                        camera: &camera,
                        lanes: VertexLanes::new(simd, &camera),
                        culling: Culling::new(simd, area, state),
                        queues: Scratch::EMPTY.clone(),
                        scratch,
                    };
                    drawing.scratch.clear();
                    pass.run::<VectorLanes<_>, A>(
                        simd, order, &mut occlusion, &mut statistics, attachments,
                        #[inline(always)]
                        |number, meshlet, attachments, statistics| {
                            drawing.add(number, meshlet, attachments, statistics);
                        },
                    );
                    drawing.flush(attachments, &mut statistics);
                },
            );
        }),
        None => pass.run::<ArrayLanes, A>(
            (),
            order,
            &mut occlusion,
            &mut statistics,
            attachments,
            |_, meshlet, attachments, statistics| statistics.include(by_definition(meshlet, attachments)),
        ),
    }
    Ok((statistics, occlusion))
}

/// Batches by their nearest corner, then by their place.
fn front_to_back<'o>(
    batches: &[Batch],
    matrix: &[[f32; 4]; 4],
    order: &'o mut [BatchOrder],
    mut keep: impl FnMut(&Batch) -> bool,
) -> &'o [BatchOrder] {
    let mut kept = 0;
    for (place, batch) in (0..).zip(batches) {
        if keep(batch)
            && let Some(key) = order.get_mut(kept)
        {
            *key = BatchOrder::of(batch.distance(matrix), place);
            kept += 1;
        }
    }
    let order = order.get_mut(..kept).unwrap_or_default();
    sort::sort(order, |key| key.0);
    order
}

/// Whether questions about meshlets are worth their time: each costs, and each answer "hidden" pays for several.
pub(super) struct Worth(pub(super) u32);

impl Worth {
    /// Questions that go on without an answer "hidden".
    pub(super) const NEW: Self = Self(96);

    /// Whether to ask.
    #[inline(always)]
    pub(super) const fn asking(&mut self) -> bool {
        let asking = self.0 > 0;
        self.0 = self.0.saturating_sub(1);
        asking
    }

    /// A batch or a meshlet was hidden.
    #[inline(always)]
    pub(super) const fn hidden(&mut self) {
        self.0 = if self.0 + 32 < Self::NEW.0 { self.0 + 32 } else { Self::NEW.0 };
    }
}

/// What stays the same in a draw.
#[derive(Clone, Copy)]
struct Pass<'a> {
    meshlets: &'a [Meshlet],
    first_id: u32,
    questions: Questions<'a>,
    /// Where a face is culled.
    facing: Option<Facing>,
}

impl<'a> Pass<'a> {
    /// Hands the meshlets that are neither outside nor hidden to `draw`.
    #[inline(always)]
    fn run<L: Lanes, A: RowAttachment + Occluder>(
        &self,
        token: L::Token,
        order: impl Iterator<Item = &'a Batch>,
        occlusion: &mut Occlusion,
        statistics: &mut Statistics,
        attachments: &mut A,
        mut draw: impl FnMut(u32, &'a Meshlet, &mut A, &mut Statistics),
    ) {
        let mut worth = Worth::NEW;
        for batch in order {
            let members = batch.meshlets(self.meshlets);
            draw::add(&mut occlusion.batches, 1);
            if self.questions.ask::<L, _, A>(token, batch.corners(), attachments) != Visibility::Visible {
                draw::add(&mut occlusion.hidden_batches, 1);
                worth.hidden();
                draw::add(&mut statistics.culled.hidden, triangles_of(members));
                continue;
            }
            for (number, meshlet) in (batch.first()..).zip(members) {
                let corners = [meshlet.low, meshlet.high];
                let count = meshlet.count();
                if self.questions.frustum.excludes_box(corners) {
                    draw::add(&mut statistics.culled.outside, count);
                    continue;
                }
                if self.facing.as_ref().is_some_and(|facing| facing.culls(meshlet)) {
                    draw::add(&mut occlusion.facing_meshlets, 1);
                    draw::add(&mut statistics.culled.facing, count);
                    continue;
                }
                if !worth.asking() {
                    draw(number, meshlet, attachments, statistics);
                    continue;
                }
                draw::add(&mut occlusion.meshlets, 1);
                if self.questions.ask::<L, _, A>(token, corners, attachments) != Visibility::Visible {
                    draw::add(&mut occlusion.hidden_meshlets, 1);
                    worth.hidden();
                    draw::add(&mut statistics.culled.hidden, count);
                    continue;
                }
                draw(number, meshlet, attachments, statistics);
            }
        }
    }
}

fn triangles_of(meshlets: &[Meshlet]) -> u32 {
    meshlets.iter().map(Meshlet::count).sum()
}

/// A draw in vector registers, of some meshlets at a time.
struct Vectors<'a, S: Simd> {
    simd: S,
    pass: Pass<'a>,
    camera: &'a ModelPositions<'a, Standard>,
    lanes: VertexLanes<S>,
    culling: Culling<S>,
    queues: Scratch,
    scratch: &'a mut MeshletScratch,
}

impl<S: Simd> Vectors<'_, S> {
    #[inline(always)]
    fn add<A: RowAttachment>(
        &mut self,
        number: u32,
        meshlet: &Meshlet,
        attachments: &mut A,
        statistics: &mut Statistics,
    ) {
        self.scratch.add(self.simd, &self.lanes, meshlet, number);
        if !self.scratch.has_room() {
            self.flush(attachments, statistics);
        }
    }

    /// Draws what is there.
    #[inline(always)]
    fn flush<A: RowAttachment>(&mut self, attachments: &mut A, statistics: &mut Statistics) {
        let Pass { meshlets, first_id, questions: Questions { area, state, .. }, .. } = self.pass;
        let scratch = &*self.scratch;
        let drawing = Drawing {
            simd: self.simd,
            records: Records { places: scratch.places(), depths: scratch.depths() },
            triangles: scratch.triangles(),
            source: InView { scratch, meshlets, camera: self.camera, first_id },
            area,
            state,
        };
        drawing.run(&self.culling, &mut self.queues, attachments, statistics);
        self.scratch.clear();
    }
}
