//! Batches that are drawn from front to back, what is hidden left out, are the mesh's picture.

use super::{
    simd::{Storage, levels},
    statistics::add_up,
};
use crate::{Failure, case::Case, ensure, ensure_eq, failure::Verdict, shapes::Random};
use halfplane::{
    Compare, Coverage, D16, D32, Depth, DepthFormat, DepthRange, DepthTest, DrawError, HierarchicalDepth,
    Ids, Index as _, Standard, Statistics, depth_ranges, draw,
    simd::{
        Batch, BatchOrder, Level, Meshlet, MeshletError, MeshletScratch, Occluder, Occlusion, RowAttachment,
        cluster, draw_batches, make_batches, make_meshlets, max_batches, max_meshlets,
    },
};

/// A mesh in meshlets and batches, its triangles in another order.
struct Batched {
    indices: Vec<u32>,
    meshlets: Vec<Meshlet>,
    batches: Vec<Batch>,
}

impl Batched {
    fn new(positions: &[[f32; 3]], indices: &[u32]) -> Result<Self, Failure> {
        let mut indices = indices.to_vec();
        cluster(positions, &mut indices)?;
        let mut meshlets = vec![Meshlet::EMPTY; max_meshlets(indices.len() / 3)];
        let count = make_meshlets(positions, &indices, &mut meshlets)?.len();
        meshlets.truncate(count);
        let mut batches = vec![Batch::EMPTY; max_batches(count)];
        make_batches(&meshlets, &mut batches)?;
        Ok(Self { indices, meshlets, batches })
    }

    /// Draws them as a case says.
    fn draw<A: RowAttachment + Occluder>(
        &self,
        level: Level,
        case: &Case,
        order: &mut [BatchOrder],
        scratch: &mut MeshletScratch,
        attachments: &mut A,
    ) -> Result<Result<Drawn, DrawError>, Failure> {
        let (matrix, viewport, state) = (case.model.matrix, case.core_viewport()?, case.state()?);
        let (batches, meshlets) = (&self.batches, &self.meshlets);
        let first_id = case.first_id;
        Ok(draw_batches(
            level,
            batches,
            meshlets,
            matrix,
            viewport,
            order,
            scratch,
            first_id,
            &state,
            attachments,
        ))
    }
}

/// A triangle list's triangles in some order that does not depend on its own.
fn sorted(indices: &[u32]) -> Vec<[u32; 3]> {
    let mut triangles = indices.as_chunks::<3>().0.to_vec();
    triangles.sort_unstable();
    triangles
}

/// The same triangles come out, at places that are close where they are neighbours: boxes of runs are smaller than
/// those of the list as it was, unless it was in order already.
pub fn clusters_are_the_same_triangles(case: &Case) -> Verdict {
    let mut indices = case.indices.clone();
    cluster(&case.model.vertices, &mut indices)?;
    ensure_eq!(sorted(&indices), sorted(&case.indices), "the triangles");
    let mut wrong = case.indices.clone();
    wrong.push(0);
    let before = wrong.clone();
    let error = cluster(&case.model.vertices, &mut wrong);
    ensure_eq!(error, Err(DrawError::IndexCount { count: before.len() }), "one index more");
    ensure_eq!(wrong, before, "a refused list");
    Ok(())
}

/// A cloud of small triangles in any order: after clustering, meshlets have small boxes.
pub fn clusters_are_small(triangles: usize, seed: u64) -> Verdict {
    let mut random = Random(seed);
    let mut place = || random.below(1 << 20) as f32 / 1024.0;
    let positions: Vec<[f32; 3]> = (0..triangles)
        .flat_map(|_| {
            let [x, y, z] = [place(), place(), place()];
            [[x, y, z], [x + 1.0, y, z], [x, y + 1.0, z]]
        })
        .collect();
    let indices: Vec<u32> = (0..positions.len() as u32).collect();
    let volume = |indices: &[u32]| -> f64 {
        indices
            .chunks(3 * 64)
            .map(|run| {
                let axes = [0, 1, 2].map(|axis| run.iter().map(move |&i| (axis, i)));
                axes.into_iter()
                    .map(|axis| {
                        let values: Vec<f32> = axis.map(|(axis, i)| positions[i.to_usize()][axis]).collect();
                        let least = values.iter().copied().fold(f32::INFINITY, f32::min);
                        let most = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
                        f64::from(most - least)
                    })
                    .product::<f64>()
            })
            .sum()
    };
    let before = volume(&indices);
    let mut clustered = indices.clone();
    cluster(&positions, &mut clustered)?;
    ensure_eq!(sorted(&clustered), sorted(&indices), "the triangles");
    // Each halving halves the boxes; they do not meet the runs exactly.
    let halvings = (triangles as f64 / 64.0).log2().floor();
    let after = volume(&clustered);
    let allowed = before * 0.5f64.powf(halvings) * 4.0 + 1.0;
    ensure!(
        after.total_cmp(&allowed).is_le(),
        "boxes of {after} after, {before} before, for {triangles} triangles"
    );
    Ok(())
}

/// What a draw of batches left, and what it said.
type Drawn = (Statistics, Occlusion);

/// Draws batches at every level, and compares the depths with those of the mesh drawn by the scalar code; what each
/// level says must be the same.
fn at_every_level<D: DepthFormat<Standard>>(
    case: &Case,
    test: DepthTest,
    memory: impl Fn(&mut Storage) -> &mut Vec<D::Texel>,
) -> Result<Drawn, Failure>
where
    for<'a> Depth<'a, Standard, D>: RowAttachment,
    for<'a> HierarchicalDepth<'a, Standard, D>: RowAttachment,
{
    let (positions, state, region) = (case.positions()?, case.state()?, case.frame.core_region()?);
    let before = Storage::new(region, case.contents);
    let mut expected = before.clone();
    let mut depth = Depth::<Standard, D>::new(region, memory(&mut expected), test)?;
    let wanted = draw(&positions, &case.indices, case.first_id, &state, &mut depth)?;
    let batched = Batched::new(&case.model.vertices, &case.indices)?;
    let mut scratch = MeshletScratch::NEW;
    let mut order = vec![BatchOrder::default(); batched.batches.len() + case.attachments as usize % 3];
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(region.width(), region.height())];
    let mut said: Option<Drawn> = None;
    let mut all = Drawn::default();
    for level in levels() {
        let what = format!("{} batches under {test:?}", level.name());
        let mut given = before.clone();
        let mut depth = HierarchicalDepth::<Standard, D>::new(region, memory(&mut given), &mut ranges, test)?;
        let drawn = batched.draw(level, case, &mut order, &mut scratch, &mut depth)??;
        given.equals(&expected, &what)?;
        add_up(&drawn.0, case.indices.len() / 3)?;
        let rejected = drawn.0.rejected.total() + drawn.0.culled.hidden;
        ensure!(rejected >= wanted.rejected.total(), "{what}: {} rejected", drawn.0.rejected.total());
        ensure!(drawn.0.drawn <= wanted.drawn, "{what}: {} drawn of {}", drawn.0.drawn, wanted.drawn);
        let Occlusion { batches, hidden_batches, meshlets, hidden_meshlets, .. } = drawn.1;
        ensure!(hidden_batches <= batches && hidden_meshlets <= meshlets, "{what}: {:?}", drawn.1);
        // Several meshlets at a time are drawn from vectors, so others are hidden than from arrays.
        if level.name() != Level::FALLBACK.name() {
            ensure_eq!(*said.get_or_insert(drawn), drawn, "{what}, what is said");
        }
        all = drawn;
    }
    Ok(all)
}

/// The same depths, whatever was hidden.
pub fn batches_are_the_mesh(case: &Case) -> Result<Drawn, Failure> {
    // The last one wins, and which one is last the order decides.
    let test = match case.test.compare {
        Compare::Always => DepthTest { compare: Compare::Less, ..case.test },
        _ => case.test,
    };
    if case.attachments.is_multiple_of(4) {
        at_every_level::<D16>(case, test, |storage| &mut storage.depths16)
    } else {
        at_every_level::<D32>(case, test, |storage| &mut storage.depths)
    }
}

/// With ids: the depths are the mesh's, and so is the id wherever no other triangle is at the same depth. Coverage
/// beside them is that of what was drawn, so no more than the mesh's.
pub fn ids_of_batches_are_the_nearest(case: &Case) -> Result<Drawn, Failure> {
    let (state, region) = (case.state()?, case.frame.core_region()?);
    let batched = Batched::new(&case.model.vertices, &case.indices)?;
    let positions = case.positions()?;
    let mut scalar = [Compare::Less, Compare::LessEqual].map(|compare| (compare, Storage::new(region, 0)));
    for (compare, storage) in &mut scalar {
        let test = DepthTest { compare: *compare, write: true };
        let coverage = Coverage::new(region, &mut storage.masks)?;
        let depth = Depth::<Standard>::new(region, &mut storage.depths, test)?;
        let mut all = (coverage, (depth, Ids::new(region, &mut storage.ids)?));
        draw(&positions, &batched.indices, case.first_id, &state, &mut all)?;
    }
    let [(_, earlier), (_, later)] = &scalar;
    let mut scratch = MeshletScratch::NEW;
    let mut order = vec![BatchOrder::default(); batched.batches.len()];
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(region.width(), region.height())];
    let mut all_drawn = None;
    for level in levels() {
        let mut given = Storage::new(region, 0);
        let depth =
            HierarchicalDepth::<Standard>::new(region, &mut given.depths, &mut ranges, DepthTest::LESS)?;
        let coverage = Coverage::new(region, &mut given.masks)?;
        let mut all = (depth, (Ids::new(region, &mut given.ids)?, coverage));
        let drawn = batched.draw(level, case, &mut order, &mut scratch, &mut all)??;
        ensure_eq!(given.depths, earlier.depths, "{} depths", level.name());
        for (at, id) in given.ids.iter().enumerate() {
            let (earlier, later) = (earlier.ids[at], later.ids[at]);
            ensure!(earlier != later || *id == earlier, "{}: id {id} and not {earlier}", level.name());
        }
        for (at, mask) in given.masks.iter().enumerate() {
            ensure_eq!(mask & !earlier.masks[at], 0, "{}: coverage of block {at}", level.name());
        }
        all_drawn = Some(drawn);
    }
    all_drawn.ok_or_else(|| Failure::new("no level"))
}

/// Memory that is too short is refused, and nothing is written.
pub fn short_memory_is_refused(case: &Case) -> Verdict {
    let (state, region) = (case.state()?, case.frame.core_region()?);
    let Batched { meshlets, batches, .. } = Batched::new(&case.model.vertices, &case.indices)?;
    let (needed, count) = (max_batches(meshlets.len()), batches.len());
    ensure_eq!(count, needed, "batches");
    if count == 0 {
        return Ok(());
    }
    let mut few = vec![Batch::EMPTY; needed - 1];
    let error = make_batches(&meshlets, &mut few).map(|_| ());
    ensure_eq!(error, Err(MeshletError::TooFew { needed, given: needed - 1 }), "too few batches");
    let before = Storage::new(region, case.contents);
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(region.width(), region.height())];
    let mut scratch = MeshletScratch::NEW;
    for level in levels() {
        let mut given = before.clone();
        let mut depth =
            HierarchicalDepth::<Standard>::new(region, &mut given.depths, &mut ranges, DepthTest::LESS)?;
        let mut order = vec![BatchOrder::default(); count - 1];
        let error = draw_batches(
            level,
            &batches,
            &meshlets,
            case.model.matrix,
            case.core_viewport()?,
            &mut order,
            &mut scratch,
            case.first_id,
            &state,
            &mut depth,
        );
        let expected = DrawError::ScratchTooSmall { needed: count, given: count - 1 };
        ensure_eq!(error.err(), Some(expected), "{} order", level.name());
        given.equals(&before, "after an error")?;
    }
    Ok(())
}
