//! The walk by edge functions draws the same with lanes of every vector level as with arrays: pictures,
//! statistics, and what an attachment of the caller's is told, in order.

use crate::{
    Failure, Frame,
    case::{Case, Numbers},
    ensure_eq,
    properties::simd::levels,
    shapes::{Kind, depths, triangle},
};
use halfplane::{
    Attachment, Block, Compare, Coverage, D16, D32, Depth, DepthFormat, DepthTest, Format, Ids, Index, Mask,
    Positions, Region, Small, State, Statistics, Vertex, blocks, draw, simd, texels,
};

/// All comparisons.
const COMPARES: [Compare; 5] =
    [Compare::Less, Compare::LessEqual, Compare::Greater, Compare::GreaterEqual, Compare::Always];

/// An attachment of a caller's: it has only the required method. Keeps every block it is given, and lets
/// some of the samples through.
#[derive(Debug, Default)]
struct Recorder(Vec<[u32; 4]>);

impl<F: Format> Attachment<F> for Recorder {
    fn block(&mut self, block: &Block<'_, F>) -> Mask {
        self.0.push([block.x, block.y, u32::from(block.mask.0), block.id]);
        block.mask.and(Mask(0xB7ED_u16.rotate_left((block.x / 4).wrapping_add(block.id))))
    }
}

/// All that a draw leaves.
#[derive(Debug, PartialEq)]
struct Picture<T> {
    statistics: Statistics,
    masks: Vec<u16>,
    depths: Vec<T>,
    ids: Vec<u32>,
    blocks: [Vec<[u32; 4]>; 2],
}

/// What is drawn.
struct Scene<'a, F: Format, P: ?Sized, I> {
    region: Region<F>,
    state: State<F>,
    positions: &'a P,
    indices: &'a [I],
    first_id: u32,
    /// The value of every bit of the attachments before, by turns.
    contents: u32,
}

impl<F: Format, P: Positions<F> + ?Sized, I: Index> Scene<'_, F, P, I> {
    /// Draws in the scalar code, or at a level.
    fn picture<D: DepthFormat<F>>(
        &self,
        level: Option<simd::Level>,
        test: DepthTest,
        before: D::Texel,
    ) -> Result<Picture<D::Texel>, Failure> {
        let (width, height) = (self.region.width(), self.region.height());
        let mut masks = vec![0; blocks(width, height)];
        let mut depths = vec![before; texels(width, height)];
        let mut ids = vec![self.contents; texels(width, height)];
        let depth = Depth::<F, D>::new(self.region, &mut depths, test)?;
        let (coverage, ids_of_region) =
            (Coverage::new(self.region, &mut masks)?, Ids::new(self.region, &mut ids)?);
        let mut all =
            (Recorder::default(), (depth, coverage), (&mut Recorder::default(), (ids_of_region, ())));
        let (positions, indices, first_id) = (self.positions, self.indices, self.first_id);
        let statistics = match level {
            None => draw(positions, indices, first_id, &self.state, &mut all),
            Some(level) => simd::draw_any(level, positions, indices, first_id, &self.state, &mut all),
        }?;
        let blocks = [all.0.0, std::mem::take(&mut all.2.0.0)];
        Ok(Picture { statistics, masks, depths, ids, blocks })
    }

    /// Draws at every level as with arrays, by every comparison, with and without writing depths.
    fn is_the_one_of_arrays<D: DepthFormat<F>>(&self, befores: [D::Texel; 3]) -> Result<Statistics, Failure> {
        let mut statistics = Statistics::default();
        for (number, compare) in COMPARES.into_iter().enumerate() {
            let write = !(self.contents as usize + number).is_multiple_of(3);
            let before = befores[(self.contents as usize / 3 + number) % 3];
            let test = DepthTest { compare, write };
            let expected = self.picture::<D>(None, test, before)?;
            for level in levels() {
                let given = self.picture::<D>(Some(level), test, before)?;
                ensure_eq!(given.statistics, expected.statistics, "{}, {test:?}", level.name());
                ensure_eq!(given.blocks, expected.blocks, "blocks, {}, {test:?}", level.name());
                let what = format!("the picture, {}, {test:?}", level.name());
                crate::ensure!(given == expected, "{what} is another one");
            }
            statistics = expected.statistics;
        }
        Ok(statistics)
    }
}

/// A mesh from object space, drawn at every level as with arrays; the statistics.
pub fn frame_is_the_one_of_arrays(case: &Case) -> Result<Statistics, Failure> {
    let scene = Scene {
        region: case.frame.core_region()?,
        state: case.state()?,
        positions: &case.positions()?,
        indices: &case.indices[..],
        first_id: case.first_id,
        contents: case.contents,
    };
    if case.attachments.is_multiple_of(2) {
        scene.is_the_one_of_arrays::<D32>([u32::MAX, 0, 1 << 31])
    } else {
        scene.is_the_one_of_arrays::<D16>([u16::MAX, 0, 1 << 15])
    }
}

/// Window vertices of the small format, drawn at every level as with arrays; the statistics.
pub fn small_format_is_the_one_of_arrays(
    place: [u32; 12],
    contents: u32,
    triangles: &[Numbers],
) -> Result<Statistics, Failure> {
    let frame = Frame::from_numbers::<Small>(place);
    let mut vertices = Vec::new();
    for &(kind, numbers, z) in triangles {
        let corners = triangle::<Small>(Kind::ALL[kind as usize % Kind::ALL.len()], &frame, numbers);
        for ([x, y], z) in corners.into_iter().zip(depths(z)) {
            vertices.push(Vertex::<Small>::new(x, y, z)?);
        }
    }
    let indices: Vec<u16> = (0..vertices.len() as u16).collect();
    let scene = Scene {
        region: frame.core_region()?,
        state: frame.state()?,
        positions: &vertices[..],
        indices: &indices[..],
        first_id: contents % 1000,
        contents,
    };
    scene.is_the_one_of_arrays::<D16>([u16::MAX, 0, 1 << 15])
}
