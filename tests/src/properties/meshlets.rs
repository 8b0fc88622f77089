//! Meshlets draw what their mesh draws, whatever of it is left out unseen.

use super::simd::{Storage, levels};
use crate::{Failure, case::Case, ensure, ensure_eq, failure::Verdict, shapes::Random};
use halfplane::{
    Coverage, Cull, D16, Depth, DepthTest, DrawError, Ids, ModelPositions, NO_ID, Region, Standard, State,
    Statistics, Viewport, draw,
    simd::{self, Meshlet, MeshletError, MeshletScratch, make_meshlets, max_meshlets},
    texels,
};

/// The meshlets of a mesh, in memory that held others before.
fn meshlets_of(positions: &[[f32; 3]], indices: &[u32]) -> Result<Vec<Meshlet>, Failure> {
    let mut memory = vec![Meshlet::EMPTY; max_meshlets(indices.len() / 3)];
    if !memory.is_empty() {
        make_meshlets(&[[3.0, 4.0, 5.0]; 3], &[0u32, 1, 2], &mut memory)?;
    }
    let count = make_meshlets(positions, indices, &mut memory)?.len();
    memory.truncate(count);
    Ok(memory)
}

/// Draws a mesh with the scalar code, and its meshlets at every level; compares outcome and storage.
macro_rules! meshlets_at_every_level {
    ($name:literal, $case:expr, |$storage:ident| { $($make:tt)* } => $attachments:expr) => {{
        let case: &Case = $case;
        let (positions, state, region) = (case.positions()?, case.state()?, case.frame.core_region()?);
        let before = Storage::new(region, case.contents);
        let mut expected = before.clone();
        let wanted = {
            let $storage = &mut expected;
            $($make)*
            draw(&positions, &case.indices, case.first_id, &state, $attachments)
        };
        let meshlets = meshlets_of(&case.model.vertices, &case.indices)?;
        let [x0, y0, x1, y1] = case.viewport;
        let viewport = Viewport::new(Region::new(x0, y0, x1, y1)?);
        let mut scratch = MeshletScratch::NEW;
        for level in levels() {
            let what = format!("{} {} from meshlets", level.name(), $name);
            let mut given = before.clone();
            let outcome = {
                let $storage = &mut given;
                $($make)*
                simd::draw_meshlets(
                    level, &meshlets, case.model.matrix, viewport, &mut scratch, case.first_id, &state,
                    $attachments,
                )
            };
            ensure_eq!(outcome, wanted, "{what}");
            given.equals(&expected, &what)?;
        }
        wanted?
    }};
}

/// The same pixels and the same statistics, with one of some attachments; the statistics.
pub fn meshlets_are_the_mesh(case: &Case) -> Result<Statistics, Failure> {
    let (region, test) = (case.frame.core_region()?, case.test);
    Ok(match case.attachments % 4 {
        0 => meshlets_at_every_level!("coverage", case, |s| {
            let mut coverage = Coverage::new(region, &mut s.masks)?;
        } => &mut coverage),
        1 => meshlets_at_every_level!("depth", case, |s| {
            let mut depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
        } => &mut depth),
        2 => meshlets_at_every_level!("16-bit depth", case, |s| {
            let mut depth = Depth::<Standard, D16>::new(region, &mut s.depths16, test)?;
        } => &mut depth),
        _ => meshlets_at_every_level!("depth and ids", case, |s| {
            let depth = Depth::<Standard>::new(region, &mut s.depths, test)?;
            let mut all = (depth, Ids::new(region, &mut s.ids)?);
        } => &mut all),
    })
}

/// A mesh whose vertices all lie within some last bits of a plane of the frustum, seen through a matrix
/// that scales and moves that axis: what each vertex is, its rounding decides.
#[derive(Clone, Copy, Debug)]
pub struct Grazing {
    /// The axis: x, y or z.
    pub axis: usize,
    /// Which of its two planes.
    pub upper: bool,
    /// The axis is scaled by 2 to this, and somewhat more.
    pub scale: i32,
    /// And moved by 2 to this, and somewhat more.
    pub shift: i32,
    /// Chooses the rest.
    pub seed: u64,
}

/// Boxes are left out only where every triangle is outside; how many were all outside.
pub fn grazing_meshlets_are_the_mesh(grazing: &Grazing) -> Result<bool, Failure> {
    let Grazing { axis, upper, scale, shift, seed } = *grazing;
    let mut random = Random(seed);
    let unit = |random: &mut Random| random.below(1 << 24) as f32 / (1 << 24) as f32;
    let factor = (scale as f32).exp2() * (1.0 + unit(&mut random));
    let offset = (shift as f32).exp2() * (1.0 + unit(&mut random)) * if upper { -1.0 } else { 1.0 };
    let mut matrix = [[0.0f32; 4]; 4];
    for (k, row) in matrix.iter_mut().enumerate().take(3) {
        row[k] = 1.0;
    }
    matrix[3][3] = 1.0;
    matrix[axis][axis] = factor;
    matrix[3][axis] = offset;
    let plane = match (axis, upper) {
        (_, true) => 1.0,
        (2, false) => 0.0,
        (_, false) => -1.0,
    };
    let at_plane = (plane - f64::from(offset)) / f64::from(factor);
    let spread = [1, 3, 17, 300][random.below(4)];
    // All on one side of the plane's place, or on both.
    let centre = [-1i64, 0, 1][random.below(3)] * spread;
    let vertices: Vec<[f32; 3]> = (0..18)
        .map(|_| {
            let ulps = centre + random.below(2 * spread as usize + 1) as i64 - spread;
            let bits = (at_plane as f32).to_bits().wrapping_add_signed(ulps as i32);
            let mut vertex = [unit(&mut random) - 0.5, unit(&mut random) - 0.5, unit(&mut random)];
            vertex[axis] = f32::from_bits(bits);
            vertex
        })
        .collect();
    let indices: Vec<u32> = (0..18).collect();
    let region = Region::<Standard>::of_size(64, 64)?;
    let state = State { cull: Cull::None, ..State::new(region) };
    let viewport = Viewport::new(region);
    let (mut expected, mut given) = (vec![u32::MAX; texels(64, 64)], vec![u32::MAX; texels(64, 64)]);
    let mut depth: Depth<'_, Standard> = Depth::new(region, &mut expected, DepthTest::LESS)?;
    let wanted = draw(&ModelPositions::new(&vertices, matrix, viewport), &indices, 0, &state, &mut depth)?;
    let meshlets = meshlets_of(&vertices, &indices)?;
    let mut scratch = MeshletScratch::NEW;
    for level in levels() {
        given.fill(u32::MAX);
        let mut depth: Depth<'_, Standard> = Depth::new(region, &mut given, DepthTest::LESS)?;
        let (meshlets, scratch) = (&meshlets, &mut scratch);
        let statistics =
            simd::draw_meshlets(level, meshlets, matrix, viewport, scratch, 0, &state, &mut depth)?;
        ensure_eq!(statistics, wanted, "{}", level.name());
        ensure!(given == expected, "{}: other depths", level.name());
    }
    Ok(wanted.culled.outside == wanted.submitted)
}

/// Meshlets hold the triangles of the mesh, each once and in order: drawn one by one in any order, they
/// draw its ids.
pub fn meshlets_can_be_drawn_alone(triangles: usize, seed: u64) -> Verdict {
    let (positions, indices) = scattered(triangles, seed);
    let meshlets = meshlets_of(&positions, &indices)?;
    ensure!(meshlets.len() <= max_meshlets(triangles), "{} meshlets", meshlets.len());
    let region = Region::<Standard>::of_size(200, 120)?;
    let state = State::new(region);
    let viewport = Viewport::new(region);
    let identity = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let (mut texels_of, mut ids_of) = (vec![u32::MAX; texels(200, 120)], vec![NO_ID; texels(200, 120)]);
    let mut all =
        (Depth::<Standard>::new(region, &mut texels_of, DepthTest::LESS)?, Ids::new(region, &mut ids_of)?);
    let model = ModelPositions::new(&positions, identity, viewport);
    let wanted = draw(&model, &indices, 7, &state, &mut all)?;
    let mut scratch = MeshletScratch::NEW;
    for level in levels() {
        let (mut depths, mut ids) = (vec![u32::MAX; texels(200, 120)], vec![NO_ID; texels(200, 120)]);
        let mut all =
            (Depth::<Standard>::new(region, &mut depths, DepthTest::LESS)?, Ids::new(region, &mut ids)?);
        let mut sum = Statistics::default();
        // Depths differ from triangle to triangle, so the order does not show.
        for one in meshlets.chunks(1).rev() {
            let scratch = &mut scratch;
            sum += simd::draw_meshlets(level, one, identity, viewport, scratch, 7, &state, &mut all)?;
        }
        ensure_eq!(sum, wanted, "{}", level.name());
        ensure!(depths == texels_of && ids == ids_of, "{}: another picture", level.name());
    }
    Ok(())
}

/// Small triangles anywhere in the window, no two with the same depth.
fn scattered(triangles: usize, seed: u64) -> (Vec<[f32; 3]>, Vec<u32>) {
    let mut random = Random(seed);
    let mut unit = || random.below(1 << 20) as f32 / (1 << 20) as f32;
    let mut positions = Vec::new();
    for number in 0..triangles {
        let (x, y) = (2.0 * unit() - 1.0, 2.0 * unit() - 1.0);
        let z = (number as f32 + 0.5) / triangles as f32;
        for _ in 0..3 {
            positions.push([x + 0.2 * unit(), y + 0.2 * unit(), z]);
        }
    }
    let indices = (0..positions.len() as u32).collect();
    (positions, indices)
}

/// Refused meshes, and how many meshlets are needed.
pub fn meshlet_errors(triangles: usize, seed: u64) -> Verdict {
    let (positions, mut indices) = scattered(triangles, seed);
    let needed = meshlets_of(&positions, &indices)?.len();
    let mut few = vec![Meshlet::EMPTY; needed - 1];
    let given = few.len();
    ensure_eq!(
        make_meshlets(&positions, &indices, &mut few).map(|made| made.len()),
        Err(MeshletError::TooFew { needed, given }),
        "{triangles} triangles"
    );
    let mut memory = vec![Meshlet::EMPTY; needed];
    let count = indices.len() - 1;
    ensure_eq!(
        make_meshlets(&positions, &indices[..count], &mut memory).map(|made| made.len()),
        Err(MeshletError::Indices(DrawError::IndexCount { count })),
        "{count} indices"
    );
    let at = seed as usize % indices.len();
    indices[at] = positions.len() as u32;
    ensure_eq!(
        make_meshlets(&positions, &indices, &mut memory).map(|made| made.len()),
        Err(MeshletError::Indices(DrawError::IndexOutOfRange {
            at,
            index: positions.len() as u32,
            vertices: positions.len()
        })),
        "place {at}"
    );
    Ok(())
}

/// A meshlet's box is the one round its own triangles' corners; and it has no cone where two of its triangles face opposite
/// ways.
pub fn meshlets_say_what_they_hold(triangles: usize, seed: u64) -> Verdict {
    let (positions, indices) = scattered(triangles, seed);
    let meshlets = meshlets_of(&positions, &indices)?;
    let mut next = 0;
    for meshlet in &meshlets {
        let range = meshlet.triangles();
        ensure_eq!(range.start, next, "the first triangle");
        next = range.end;
        let own = &indices[3 * range.start as usize..3 * range.end as usize];
        let corners = own.iter().map(|&index| positions[index as usize]);
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for corner in corners {
            for axis in 0..3 {
                low[axis] = low[axis].min(corner[axis]);
                high[axis] = high[axis].max(corner[axis]);
            }
        }
        ensure_eq!(meshlet.corners_of_box(), [low, high], "the box of {range:?}");
    }
    ensure_eq!(next as usize, triangles, "triangles");
    let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    for (indices, has_cone) in [(&[0u32, 1, 2][..], true), (&[0, 1, 2, 0, 2, 1], false), (&[0, 1, 1], false)]
    {
        let given: Vec<bool> = meshlets_of(&face, indices)?.iter().map(Meshlet::has_cone).collect();
        ensure_eq!(given, [has_cone], "a cone of {indices:?}");
    }
    Ok(())
}

/// Triangles that are a meshlet each: as many as there are, however few fill the scratch memory.
pub fn single_triangles_are_the_mesh(triangles: usize, seed: u64) -> Verdict {
    let (positions, indices) = scattered(triangles, seed);
    let mut singles = Vec::new();
    for corners in indices.chunks(3) {
        singles.extend(meshlets_of(&positions, corners)?);
    }
    let region = Region::<Standard>::of_size(64, 64)?;
    let (viewport, state) = (Viewport::new(region), State::new(region));
    let matrix = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];
    let mut expected = Storage::new(region, 0);
    let mut depth = Depth::<Standard>::new(region, &mut expected.depths, DepthTest::LESS)?;
    let positions = ModelPositions::new(&positions, matrix, viewport);
    let wanted = draw(&positions, &indices, 0, &state, &mut depth)?;
    let mut scratch = MeshletScratch::NEW;
    for level in levels() {
        let mut given = Storage::new(region, 0);
        let mut depth = Depth::<Standard>::new(region, &mut given.depths, DepthTest::LESS)?;
        let statistics =
            simd::draw_meshlets(level, &singles, matrix, viewport, &mut scratch, 0, &state, &mut depth)?;
        ensure_eq!(statistics, wanted, "{}", level.name());
        given.equals(&expected, level.name())?;
    }
    Ok(())
}
