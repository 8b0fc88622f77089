//! Orders, mirrors, splits, shared edges and accumulation: what must not change a picture, and by how much it does.

use halfplane::{
    Attachment, Block, Depth, DepthTest, Ids, Mask, NO_ID, Region, Standard, State, Vertex, draw, texels,
};

use super::{Corners, Shapes, families, vertices};
use crate::error::ReportError;

/// One check: how much was compared, and what differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Check {
    /// What it is, as a sentence.
    pub name: &'static str,
    /// What was compared.
    pub compared: u64,
    /// In words, what that is.
    pub unit: &'static str,
    /// How many differ; 0 is right.
    pub differences: u64,
}

const SIZE: (u32, u32) = (64, 64);

/// All checks.
///
/// # Errors
///
/// Where something cannot be drawn.
pub fn all() -> Result<Vec<Check>, ReportError> {
    Ok(vec![orders()?, mirrored()?, split()?, meshes()?, ties()?, layers()?])
}

/// Depths and covers of each sample, of triangles that are drawn one over the other.
#[derive(Debug, PartialEq, Eq)]
struct Picture {
    depth: Vec<u32>,
    covers: Vec<u32>,
}

fn picture(triangles: &[Corners]) -> Result<Picture, ReportError> {
    let region = Region::<Standard>::of_size(SIZE.0, SIZE.1)?;
    let corners: Vec<Vertex<Standard>> =
        triangles.iter().map(vertices).collect::<Result<Vec<_>, _>>()?.into_flattened();
    let indices: Vec<u32> = (0..corners.len() as u32).collect();
    let mut storage = vec![u32::MAX; texels(SIZE.0, SIZE.1)];
    let mut depth = Depth::<Standard>::new(region, &mut storage, DepthTest::LESS)?;
    let mut covers = Covers(vec![0; (SIZE.0 * SIZE.1) as usize]);
    draw(&corners[..], &indices, 0, &State::new(region), &mut (&mut covers, &mut depth))?;
    let mut rows = vec![0; covers.0.len()];
    depth.to_linear(&mut rows)?;
    Ok(Picture { depth: rows, covers: covers.0 })
}

/// How often each sample is covered.
struct Covers(Vec<u32>);

impl Attachment<Standard> for Covers {
    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        for (column, row) in block.mask.cells() {
            self.0[((block.y + row) * SIZE.0 + block.x + column) as usize] += 1;
        }
        block.mask
    }
}

/// Samples in which two pictures differ.
fn differing(a: &Picture, b: &Picture) -> u64 {
    let same = |place: usize| a.depth[place] == b.depth[place] && a.covers[place] == b.covers[place];
    (0..a.depth.len()).filter(|&place| !same(place)).count() as u64
}

/// Every rung of every family of window triangles.
fn rungs() -> Vec<Vec<Corners>> {
    let rungs = families().into_iter().flat_map(|family| family.rungs);
    rungs
        .filter_map(|rung| match rung.shapes {
            Shapes::Window(triangles) => Some(triangles),
            Shapes::Model { .. } => None,
        })
        .collect()
}

/// All six orders of the corners, both windings.
fn orders() -> Result<Check, ReportError> {
    let name = "Another order of the corners, another winding: all six, at every rung";
    let mut check = Check { name, compared: 0, unit: "samples", differences: 0 };
    for triangles in rungs() {
        let first = picture(&triangles)?;
        for [i, j, k] in [[1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let turned: Vec<Corners> =
                triangles.iter().map(|(xy, z)| ([xy[i], xy[j], xy[k]], [z[i], z[j], z[k]])).collect();
            check.differences += differing(&first, &picture(&turned)?);
            check.compared += first.depth.len() as u64;
        }
    }
    Ok(check)
}

/// Coverage of mirrored triangles, of which no edge goes through a sample.
fn mirrored() -> Result<Check, ReportError> {
    let name = "Mirrored in x, in y and in both: coverage, of triangles whose edges meet no sample";
    let mut check = Check { name, compared: 0, unit: "samples", differences: 0 };
    let (width, height) = (SIZE.0 as usize, SIZE.1 as usize);
    for triangles in rungs() {
        // Only those that no sample lies on, or the rule for edges decides, which has a left and a right.
        let clear: Vec<Corners> = triangles.into_iter().filter(|(xy, _)| !meets_a_sample(xy)).collect();
        for (by_x, by_y) in [(true, false), (false, true), (true, true)] {
            let flip = |[x, y]: [i32; 2]| {
                let of = |mirrored: bool, side: u32, v: i32| if mirrored { side as i32 * 256 - v } else { v };
                [of(by_x, SIZE.0, x), of(by_y, SIZE.1, y)]
            };
            // What leaves the guard band cannot be drawn.
            let limit = 1 << 23;
            let fits = |(xy, _): &&Corners| xy.iter().all(|&at| flip(at).iter().all(|v| v.abs() <= limit));
            let kept: Vec<Corners> = clear.iter().filter(fits).copied().collect();
            let first = picture(&kept)?;
            let turned: Vec<Corners> = kept.iter().map(|&(xy, z)| (xy.map(flip), z)).collect();
            let other = picture(&turned)?;
            for place in 0..width * height {
                let (x, y) = (place % width, place / width);
                let there =
                    (if by_y { height - 1 - y } else { y }) * width + if by_x { width - 1 - x } else { x };
                check.differences += u64::from(first.covers[place] != other.covers[there]);
                check.compared += 1;
            }
        }
    }
    Ok(check)
}

/// Whether a sample of the target lies on the outline.
fn meets_a_sample(xy: &[[i32; 2]; 3]) -> bool {
    let corner = |k: usize| xy[k % 3].map(i64::from);
    (0..3).any(|k| {
        let ([ax, ay], [bx, by]) = (corner(k), corner(k + 1));
        // Row by row: the sample's row decides where on the edge it would have to lie.
        (0..i64::from(SIZE.1)).any(|row| {
            let y = row * 256 + 128;
            if y < ay.min(by) || y > ay.max(by) {
                return false;
            }
            if ay == by {
                return true;
            }
            let across = (bx - ax) * (y - ay);
            across % (by - ay) == 0 && (ax + across / (by - ay)).rem_euclid(256) == 128
        })
    })
}

/// A triangle and its four quarters, each sample of which belongs to exactly one.
fn split() -> Result<Check, ReportError> {
    let name = "A triangle against its quarters, split again five times: each sample exactly once";
    let mut check = Check { name, compared: 0, unit: "samples", differences: 0 };
    for shape in [
        [[64, 32], [16_000, 3_200], [4_096, 16_064]],
        [[128, 128], [16_256, 128], [128, 16_256]],
        [[0, 8_192], [16_384, 8_224], [8_192, 8_256]],
    ] {
        let mut pieces = vec![shape];
        let whole = picture(&[(shape, [9; 3])])?;
        for _ in 0..5 {
            pieces = pieces.into_iter().flat_map(quarters).collect();
            let triangles: Vec<Corners> = pieces.iter().map(|&xy| (xy, [9; 3])).collect();
            check.differences += differing(&whole, &picture(&triangles)?);
            check.compared += whole.covers.len() as u64;
        }
    }
    Ok(check)
}

fn quarters([a, b, c]: [[i32; 2]; 3]) -> [[[i32; 2]; 3]; 4] {
    let middle = |p: [i32; 2], q: [i32; 2]| [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}

/// Meshes without T-junctions, whose inner vertices are anywhere: each sample exactly once.
fn meshes() -> Result<Check, ReportError> {
    let name = "Meshes without T-junctions, with vertices moved at random: each sample exactly once";
    let mut check = Check { name, compared: 0, unit: "samples", differences: 0 };
    for cells in [1, 2, 3, 5, 8, 16, 33, 64, 100] {
        let mut state = 0x2545_f491_4f6c_dd1du64;
        let mut random = |below: i32| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state % below as u64) as i32
        };
        let side = 64 * 256;
        let step = side / cells;
        let mut grid = Vec::new();
        for row in 0..=cells {
            for column in 0..=cells {
                let inner = |at: i32| at > 0 && at < cells;
                let end = |at: i32| if at == cells { side } else { at * step };
                // Less than a third of a cell: nothing is turned over.
                let jitter = (step / 3).max(1);
                let (x, y) = (random(jitter), random(jitter));
                let is_inner = inner(row) && inner(column);
                grid.push([
                    end(column) + if is_inner { x } else { 0 },
                    end(row) + if is_inner { y } else { 0 },
                ]);
            }
        }
        let mut triangles: Vec<Corners> = Vec::new();
        for row in 0..cells {
            for column in 0..cells {
                let at = |r: i32, c: i32| grid[((row + r) * (cells + 1) + column + c) as usize];
                triangles.push(([at(0, 0), at(0, 1), at(1, 0)], [5; 3]));
                triangles.push(([at(0, 1), at(1, 1), at(1, 0)], [5; 3]));
            }
        }
        let covers = picture(&triangles)?.covers;
        check.compared += covers.len() as u64;
        check.differences += covers.iter().filter(|&&count| count != 1).count() as u64;
    }
    Ok(check)
}

/// Triangles over one another.
const LAYERS: u32 = 1_000_000;

/// A million triangles of equal depth: the first keeps every sample.
fn ties() -> Result<Check, ReportError> {
    let name = "A million triangles over one another at equal depth: the first wins everywhere";
    over(name, |_| 1 << 31, |_| 0)
}

/// A million triangles, each a little nearer: the last keeps every sample, at its own depth.
fn layers() -> Result<Check, ReportError> {
    let name =
        "A million triangles over one another, each one unit of 2^-32 nearer: the last wins everywhere";
    over(name, |id| (1 << 31) - id, |last| last)
}

fn over(
    name: &'static str,
    z: impl Fn(u32) -> u32,
    winner: impl Fn(u32) -> u32,
) -> Result<Check, ReportError> {
    let (width, height) = (8, 8);
    let region = Region::<Standard>::of_size(width, height)?;
    let mut depth_storage = vec![u32::MAX; texels(width, height)];
    let mut id_storage = vec![NO_ID; texels(width, height)];
    let mut depth = Depth::<Standard>::new(region, &mut depth_storage, DepthTest::LESS)?;
    let mut ids = Ids::<Standard>::new(region, &mut id_storage)?;
    let state = State::new(region);
    for id in 0..LAYERS {
        let z = [z(id); 3];
        let corners = vertices(&([[-64, -64], [4_400, -64], [-64, 4_400]], z))?;
        draw(&corners[..], &[0u16, 1, 2], id, &state, &mut (&mut depth, &mut ids))?;
    }
    let expected = winner(LAYERS - 1);
    let mut check = Check { name, compared: 0, unit: "samples", differences: 0 };
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        check.compared += 1;
        let right = ids.get(x, y) == Some(expected) && depth.get(x, y) == Some(z(expected));
        check.differences += u64::from(!right);
    }
    Ok(check)
}
