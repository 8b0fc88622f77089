//! What a scene did not need: counted while it is drawn, by an attachment.

use halfplane::{
    Assembly, Attachment, Block, ClipPositions, Depth, DepthTest, Mask, Positions as _, Region, Standard,
    State, Triangle, Viewport, draw, texels,
};
use halfplane_measure::clip;

use crate::error::ReportError;
use crate::scene::Scene;

/// One kind of work that was saved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saving {
    /// What did not happen.
    pub name: &'static str,
    /// How often.
    pub saved: u64,
    /// Of how many.
    pub of: u64,
    /// Of what.
    pub unit: &'static str,
}

/// Counts what a scene does not need.
///
/// # Errors
///
/// Where it cannot be drawn.
pub fn savings(scene: &Scene) -> Result<Vec<Saving>, ReportError> {
    let state = scene.state::<Standard>()?;
    let region = state.scissor;
    let clip: Vec<_> = scene.positions.iter().map(|&position| clip(position, &scene.matrix)).collect();
    let positions = ClipPositions::new(&clip, Viewport::new(region));
    let (mut outside, mut whole, mut clipped) = (0, 0, 0);
    for corners in scene.indices.as_chunks::<3>().0 {
        match positions.assemble(corners.map(|index| index as usize), |_| ()) {
            Assembly::Outside => outside += 1,
            Assembly::Whole => whole += 1,
            Assembly::Clipped => clipped += 1,
            Assembly::NonFinite | Assembly::NoVertex => {}
        }
    }
    let mut covered = Tally::new(&state);
    let mut passed = Passed(0);
    let mut storage = vec![u32::MAX; texels(region.width(), region.height())];
    let mut depth = Depth::<Standard>::new(region, &mut storage, DepthTest::LESS)?;
    let statistics =
        draw(&positions, &scene.indices, 0, &state, &mut (&mut covered, (&mut depth, &mut passed)))?;
    let Tally { pieces, small, narrow, full, blocks, samples, .. } = covered;
    let submitted = u64::from(statistics.submitted);
    let culled = u64::from(statistics.culled.total()) - outside;
    let saving = |name, saved, of, unit| Saving { name, saved, of, unit };
    Ok(vec![
        saving("outside the view: neither clipped nor divided", outside, submitted, "triangles"),
        saving("inside the planes: no clipping", whole, whole + clipped, "triangles that are not outside"),
        saving(
            "culled before any edge is set up: facing away, no area, no sample",
            culled,
            submitted,
            "triangles",
        ),
        saving(
            "doubled area below 2^31: 32 bits hold every edge value",
            narrow,
            pieces,
            "window triangles drawn",
        ),
        saving("at most 32 px wide and high: no tiles", small, pieces, "window triangles drawn"),
        saving("blocks of 4x4 covered whole: no mask is needed", full, blocks, "blocks"),
        saving("hidden: depth is read and not written", samples - passed.0, samples, "covered samples"),
    ])
}

/// What is covered, before the depth test.
struct Tally {
    region: Region<Standard>,
    pieces: u64,
    small: u64,
    narrow: u64,
    full: u64,
    blocks: u64,
    samples: u64,
}

impl Tally {
    fn new(state: &State<Standard>) -> Self {
        let region = state.scissor;
        Self { region, pieces: 0, small: 0, narrow: 0, full: 0, blocks: 0, samples: 0 }
    }
}

impl Attachment<Standard> for Tally {
    fn begin(&mut self, triangle: &Triangle<Standard>) {
        self.pieces += 1;
        self.narrow += u64::from(triangle.doubled_area() < 1 << 31);
        let is_small = |bounds: Region<Standard>| bounds.width() <= 32 && bounds.height() <= 32;
        self.small += u64::from(triangle.bounds(self.region).is_ok_and(is_small));
    }

    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        self.blocks += 1;
        self.full += u64::from(block.mask == Mask::FULL);
        self.samples += u64::from(block.mask.0.count_ones());
        block.mask
    }
}

/// Samples that the depth test lets through.
struct Passed(u64);

impl Attachment<Standard> for Passed {
    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        self.0 += u64::from(block.mask.0.count_ones());
        block.mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn savings_of_a_known_scene() {
        let square = |z: f32| [[-1.0, 1.0, z], [1.0, 1.0, z], [-1.0, -1.0, z], [1.0, -1.0, z]];
        let mut positions: Vec<[f32; 3]> = [square(0.25), square(0.5)].concat();
        positions.extend([[5.0, 0.0, 0.5], [6.0, 0.0, 0.5], [5.0, -1.0, 0.5]]);
        let mut matrix = [0.0; 16];
        (0..4).for_each(|k| matrix[5 * k] = 1.0);
        let square = |first: u32| [first, first + 1, first + 2, first + 1, first + 3, first + 2];
        // Near, far behind it, one outside, one that faces away.
        let indices = [&square(0)[..], &square(4), &[8, 9, 10], &[0, 2, 1]].concat();
        let scene =
            Scene { name: String::new(), positions, indices, matrix, size: (16, 16), two_sided: false };
        let found: Vec<_> = savings(&scene).unwrap().into_iter().map(|s| (s.saved, s.of)).collect();
        // 16 blocks of each triangle's 10 are the diagonal's 4 and 6 whole ones.
        assert_eq!(found, [(1, 6), (5, 5), (1, 6), (4, 4), (4, 4), (24, 40), (256, 512)]);
    }
}
