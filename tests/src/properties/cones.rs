//! Meshlets that are left out as they face the culled way: the picture does not tell.

use super::simd::{Storage, levels};
use crate::{
    Failure,
    case::Case,
    ensure, ensure_eq,
    shapes::{Model, Patch},
};
use halfplane::{
    Cull, Depth, DepthRange, DepthTest, HierarchicalDepth, Region, Standard, State, Viewport, Winding,
    depth_ranges, draw,
    simd::{
        Batch, BatchOrder, Meshlet, MeshletScratch, draw_batches, make_batches, make_meshlets, max_batches,
        max_meshlets,
    },
};

/// What became of a patch's triangles and meshlets under one way to cull.
#[derive(Clone, Copy, Debug, Default)]
pub struct Faced {
    /// Meshlets all of whose triangles are culled for facing the culled way.
    pub facing: u32,
    /// Those that were left out for that.
    pub left_out: u32,
    /// Meshlets with a cone, and all.
    pub cones: [u32; 2],
}

impl Faced {
    /// Both together.
    pub fn and(self, more: Self) -> Self {
        Self {
            facing: self.facing + more.facing,
            left_out: self.left_out + more.left_out,
            cones: [self.cones[0] + more.cones[0], self.cones[1] + more.cones[1]],
        }
    }
}

const WAYS: [(Cull, Winding); 5] = [
    (Cull::Back, Winding::Clockwise),
    (Cull::Back, Winding::CounterClockwise),
    (Cull::Front, Winding::Clockwise),
    (Cull::Front, Winding::CounterClockwise),
    (Cull::None, Winding::Clockwise),
];

/// Under each way to cull, a patch in batches is the picture of its triangles one by one; of a meshlet that was left out,
/// every triangle would have been culled for the way that it faces, or is outside, or has two corners at one place.
pub fn patches_are_their_triangles(patch: &Patch, size: [u32; 2]) -> Result<Faced, Failure> {
    faces_are_those_of_triangles(&patch.model(size), size)
}

/// The same for a case's first triangles, seen through its frame: each is drawn many times.
pub fn meshes_are_their_triangles(case: &Case) -> Result<Faced, Failure> {
    let [x0, y0, x1, y1] = case.frame.region;
    let mut model = case.model.clone();
    let indices = case.indices.iter().take(3 * 64);
    model.vertices = indices.map(|&index| case.model.vertices[index as usize]).collect();
    faces_are_those_of_triangles(&model, [x1 - x0, y1 - y0])
}

fn faces_are_those_of_triangles(model: &Model, [width, height]: [u32; 2]) -> Result<Faced, Failure> {
    let Model { vertices, matrix } = model;
    let region = Region::<Standard>::of_size(width, height)?;
    let viewport = Viewport::new(region);
    let positions = halfplane::ModelPositions::new(vertices, *matrix, viewport);
    let indices: Vec<u32> = (0..vertices.len() as u32).collect();
    let mut meshlets = vec![Meshlet::EMPTY; max_meshlets(indices.len() / 3)];
    let meshlets = make_meshlets(vertices, &indices, &mut meshlets)?;
    let mut ranges = vec![DepthRange::UNKNOWN; depth_ranges(width, height)];
    let mut scratch = MeshletScratch::NEW;
    let mut faced = Faced::default();
    for (cull, front) in WAYS {
        let state = State { cull, front, ..State::new(region) };
        // One at a time, so that it is known which was left out.
        for meshlet in meshlets.iter() {
            let triangles = meshlet.triangles();
            let own = &indices[3 * triangles.start as usize..3 * triangles.end as usize];
            let mut expected = Storage::new(region, 0);
            let mut depth = Depth::<Standard>::new(region, &mut expected.depths, DepthTest::LESS)?;
            let one_by_one = draw(&positions, own, 0, &state, &mut depth)?;
            let count = triangles.len() as u32;
            faced.facing += u32::from(one_by_one.culled.facing == count);
            faced.cones = [faced.cones[0] + u32::from(meshlet.has_cone()), faced.cones[1] + 1];
            let mut batches = [Batch::EMPTY; max_batches(1)];
            make_batches(std::slice::from_ref(meshlet), &mut batches)?;
            for (at, level) in levels().enumerate() {
                let mut given = Storage::new(region, 0);
                let mut depth = HierarchicalDepth::<Standard>::new(
                    region,
                    &mut given.depths,
                    &mut ranges,
                    DepthTest::LESS,
                )?;
                let (statistics, occlusion) = draw_batches(
                    level,
                    &batches,
                    std::slice::from_ref(meshlet),
                    *matrix,
                    viewport,
                    &mut [BatchOrder::NEW],
                    &mut scratch,
                    0,
                    &state,
                    &mut depth,
                )?;
                given.equals(&expected, &format!("{} {cull:?} {front:?}", level.name()))?;
                if occlusion.facing_meshlets == 0 {
                    continue;
                }
                faced.left_out += u32::from(at == 0);
                ensure!(cull != Cull::None && meshlet.has_cone(), "left out without a reason");
                ensure_eq!(statistics.culled.facing, count, "triangles counted as facing");
                // No area is not enough, but where two corners are one.
                let place = |index: u32| vertices[index as usize];
                let points = own.as_chunks::<3>().0.iter().map(|corners| corners.map(place));
                let flat = points.filter(|[a, b, c]| a == b || b == c || c == a).count() as u32;
                let culled = one_by_one.culled;
                ensure!(
                    culled.facing + culled.outside + culled.zero_area == count && culled.zero_area <= flat,
                    "left out under {cull:?} {front:?}: {one_by_one:?}"
                );
            }
        }
    }
    Ok(faced)
}
