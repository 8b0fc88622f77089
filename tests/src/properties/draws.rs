//! Whole draw calls, right and wrong ones, against brute force: every pixel by the reference's scanlines
//! and depths, one triangle after another, and every texel of the caller's slices compared.

use super::statistics::add_up;
use crate::{
    Failure, Frame, ensure, ensure_eq, failure::Verdict, oracle, shapes::Random, shapes::doubled_area,
};
use halfplane::{
    Coverage, Cull, Depth, DepthFormat, DepthTest, DrawError, Format, Ids, Index, OutsideAttachment,
    Positions, Region, State, Winding, blocks, draw, texels,
};
use halfplane_reference::{DepthSpec, SpecifiedPlane};

/// What a draw call is given besides positions and indices.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// The attachments, and the sample.
    pub frame: Frame,
    /// `[x0, y0, x1, y1]` of the scissor: any region, also one beyond the attachments.
    pub scissor: [u32; 4],
    /// The faces not drawn.
    pub cull: Cull,
    /// The winding of front faces.
    pub front: Winding,
    /// The depth test.
    pub test: DepthTest,
    /// The first triangle's id.
    pub first_id: u32,
    /// How many elements more than needed the slices have.
    pub surplus: usize,
    /// Chooses what the slices hold before.
    pub contents: u64,
}

/// The caller's slices.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Slices<T> {
    masks: Vec<u16>,
    depths: Vec<T>,
    ids: Vec<u32>,
}

impl<T: Copy + Eq + TryFrom<u32>> Slices<T> {
    fn new(call: &Call, spec: DepthSpec) -> Result<Self, Failure> {
        let (width, height) = (call.frame.width(), call.frame.height());
        let mut random = Random(call.contents);
        let depth = |random: &mut Random| {
            // Often the ends, so that something passes.
            let bits = match random.below(4) {
                0 => 0,
                1 | 2 => spec.farthest(),
                _ => random.bits() as u32 & spec.farthest(),
            };
            T::try_from(bits).map_err(|_| Failure::new("a depth has too many bits"))
        };
        let size = texels(width, height) + call.surplus;
        Ok(Self {
            masks: (0..blocks(width, height) + call.surplus).map(|_| random.bits() as u16).collect(),
            depths: (0..size).map(|_| depth(&mut random)).collect::<Result<_, _>>()?,
            ids: (0..size).map(|_| random.bits() as u32).collect(),
        })
    }
}

/// The outcome and every element of the slices are those of brute force; nothing is written by a call that
/// is refused.
pub fn is_brute_force<F, D, P, I>(call: &Call, positions: &P, indices: &[I], spec: DepthSpec) -> Verdict
where
    F: Format,
    D: DepthFormat<F>,
    D::Texel: TryFrom<u32>,
    P: Positions<F> + ?Sized,
    I: Index,
{
    let region = call.frame.core_region::<F>()?;
    let [x0, y0, x1, y1] = call.scissor;
    let scissor = Region::new(x0, y0, x1, y1)?;
    let state = State { scissor, cull: call.cull, front: call.front, sample: call.frame.core_sample::<F>()? };
    let mut given = Slices::new(call, spec)?;
    let mut expected = given.clone();
    let outcome = {
        let coverage = Coverage::new(region, &mut given.masks)?;
        let depth = Depth::<F, D>::new(region, &mut given.depths, call.test)?;
        let mut all = (coverage, depth, Ids::new(region, &mut given.ids)?);
        draw(positions, indices, call.first_id, &state, &mut all)
    };
    let area = positions.window().map_or(Some(scissor), |window| scissor.intersect(window));
    match (fault(call, positions.count(), indices, region, area), outcome) {
        (None, Ok(statistics)) => {
            add_up(&statistics, indices.len() / 3)?;
            let drawn = match area {
                Some(area) => brute_force::<F, D, P, I>(call, positions, indices, spec, area, &mut expected)?,
                None => 0,
            };
            ensure_eq!(statistics.drawn, drawn, "drawn of {statistics}");
        }
        (fault, outcome) => ensure_eq!(outcome.err(), fault, "what is wrong with the call"),
    }
    same("mask", &given.masks, &expected.masks)?;
    same("depth", &given.depths, &expected.depths)?;
    same("id", &given.ids, &expected.ids)
}

/// What is wrong with a call, in the order in which it is found.
fn fault<F: Format, I: Index>(
    call: &Call,
    vertices: usize,
    indices: &[I],
    region: Region<F>,
    area: Option<Region<F>>,
) -> Option<DrawError> {
    let (count, triangles) = (indices.len(), indices.len() / 3);
    if !count.is_multiple_of(3) {
        return Some(DrawError::IndexCount { count });
    }
    if let Some(at) = indices.iter().position(|index| index.to_usize() >= vertices) {
        return Some(DrawError::IndexOutOfRange { at, index: indices[at].to_u32(), vertices });
    }
    if u64::from(call.first_id) + triangles as u64 > u64::from(u32::MAX) {
        return Some(DrawError::TooManyIds { first_id: call.first_id, triangles });
    }
    let area = area.filter(|area| !region.contains(*area))?;
    let corners = |r: Region<F>| [r.x0(), r.y0(), r.x1(), r.y1()];
    Some(OutsideAttachment { area: corners(area), attachment: corners(region) }.into())
}

/// Draws into slices, pixel by pixel; how many triangles covered a sample.
fn brute_force<F, D, P, I>(
    call: &Call,
    positions: &P,
    indices: &[I],
    spec: DepthSpec,
    area: Region<F>,
    slices: &mut Slices<D::Texel>,
) -> Result<u32, Failure>
where
    F: Format,
    D: DepthFormat<F>,
    D::Texel: TryFrom<u32>,
    P: Positions<F> + ?Sized,
    I: Index,
{
    let frame = Frame { scissor: [area.x0(), area.y0(), area.x1(), area.y1()], ..call.frame };
    let pitch = frame.width().div_ceil(4);
    let mut drawn = 0;
    for (id, corners) in (call.first_id..=u32::MAX).zip(indices.chunks(3)) {
        let mut pieces = Vec::new();
        let corners = [corners[0], corners[1], corners[2]].map(I::to_usize);
        positions.assemble(corners, |piece| {
            pieces.push((piece.map(|v| [v.x(), v.y()]), piece.map(|v| v.z())));
        });
        let mut any = false;
        for (xy, z) in pieces {
            let winding = match doubled_area(&xy) {
                0 => continue,
                1.. => Winding::Clockwise,
                _ => Winding::CounterClockwise,
            };
            let culled = match call.cull {
                Cull::None => false,
                Cull::Back => winding != call.front,
                Cull::Front => winding == call.front,
            };
            let z = oracle::vertex_depths(z, spec);
            let plane = SpecifiedPlane::new(&xy, &z, frame.grid::<F>()?, spec);
            let (false, Some(plane)) = (culled, plane) else { continue };
            let covered = oracle::coverage::<F>(&frame, &xy)?;
            for ((x, y), _) in frame.pixels().zip(covered).filter(|(_, covered)| *covered) {
                any = true;
                let (column, row) = (x - frame.region[0], y - frame.region[1]);
                let block = (row / 4 * pitch + column / 4) as usize;
                let cell = (row % 4 * 4 + column % 4) as usize;
                slices.masks[block] |= 1 << cell;
                let (depth, place) = (plane.at(x, y), 16 * block + cell);
                let stored: u32 = slices.depths[place].into();
                if oracle::compare(call.test.compare).passes(&depth, &stored) {
                    slices.ids[place] = id;
                    if call.test.write {
                        slices.depths[place] = D::Texel::try_from(depth)
                            .map_err(|_| Failure::new("a specified depth has too many bits"))?;
                    }
                }
            }
        }
        drawn += u32::from(any);
    }
    Ok(drawn)
}

fn same<T: PartialEq + std::fmt::Debug>(name: &str, given: &[T], expected: &[T]) -> Verdict {
    for (at, (given, expected)) in given.iter().zip(expected).enumerate() {
        ensure!(given == expected, "{name} {at} is {given:?}, not {expected:?}");
    }
    Ok(())
}
