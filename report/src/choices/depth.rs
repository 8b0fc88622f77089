//! How depth is interpolated and stored.

use halfplane::{
    Attachment, Block, Compare, D16, D32, Depth, DepthFormat, DepthTest, Ids, Mask, NO_ID, Region, Standard,
    State, Triangle, texels,
};
use halfplane_measure::level::{self, Level};
use halfplane_measure::target::{Attachments, Target};
use halfplane_reference::ExactPlane;

use super::repeated;
use crate::error::ReportError;
use crate::plain::{Plain, rows};
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::{Errors, differences};
use crate::textbook::{Barycentric32, ExactRational, Gradient32, Gradient64, Plane, PlaneDepth, exact_plane};
use crate::truth::Truth;

/// Depth.
pub const QUESTION: Question = Question {
    id: "depth",
    title: "Depth",
    about: "The stored depth against the exact one of the snapped triangle, at every sample that a triangle \
            covers, hidden ones included. A wrong winner is a pixel whose depth test lets another triangle win \
            than exact depths do. Textbook planes are drawn by the same traversal, with the same coverage, into \
            buffers of the same layout. Depth only is timed, with plain arrays for lanes, but for the last two \
            rows: what this crate does where vector registers may be used.",
    error: Column::new("largest error", "2^-32"),
    details: &[Column::new("mean error", "2^-32"), Column::new("wrong winners", "px")],
};

/// A row for each plane.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn depth<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let mut judge = Judge::new(scene.state()?);
    Plain::<Standard>::new(scene)?.draw(&mut judge)?;
    let [ours32, ours16, bary, grad32, grad64, rational] = judge.errors;
    let names = ["D32, plain arrays", "D16, plain arrays"];
    let (e32, w32) = ours::<D32>(scene, truth, names[0], ours32)?;
    let (e16, w16) = ours::<D16>(scene, truth, names[1], ours16)?;
    let mut entries = vec![
        e32,
        e16,
        textbook::<Barycentric32>(scene, truth, bary)?,
        textbook::<Gradient32>(scene, truth, grad32)?,
        textbook::<Gradient64>(scene, truth, grad64)?,
        textbook::<ExactRational>(scene, truth, rational)?,
    ];
    let best = Level::detect();
    if !level::is_fallback(best) {
        let (name, attachments) = ("D32", Attachments::Depth32);
        entries.push(fast(scene, best, (name, attachments), ours32, w32)?);
        entries.push(fast(scene, best, ("D16", Attachments::Depth16), ours16, w16)?);
    }
    Ok(entries)
}

fn row(name: impl Into<String>, whose: Whose, errors: &Errors, winners: u64) -> Row {
    let details = vec![Some(errors.mean()), Some(winners as f64)];
    Row { error: Some(errors.largest), details, ..Row::new(name, whose) }
}

fn ours<'a, D: DepthFormat<Standard>>(
    scene: &'a Scene,
    truth: &Truth,
    name: &str,
    errors: Errors,
) -> Result<(Entry<'a>, u64), ReportError> {
    let mut plain = Plain::<Standard>::new(scene)?;
    let region = plain.state().scissor;
    let mut storage = vec![D::FAR; texels(region.width(), region.height())];
    let winners = {
        let mut storage = storage.clone();
        let mut depth = Depth::<Standard, D>::new(region, &mut storage, DepthTest::LESS)?;
        wrong_winners(&mut plain, truth, &mut depth)?
    };
    let row =
        Row { bytes: Some(size_of_val(storage.as_slice())), ..row(name, Whose::Ours, &errors, winners) };
    let mut frame = move || -> Result<(), ReportError> {
        let mut depth = Depth::<Standard, D>::new(region, &mut storage, DepthTest::LESS)?;
        depth.clear(D::FAR);
        plain.draw(&mut depth)?;
        Ok(())
    };
    frame()?;
    Ok((Entry::new(row, move |_| repeated(frame())), winners))
}

fn textbook<'a, P: Plane + 'a>(
    scene: &'a Scene,
    truth: &Truth,
    errors: Errors,
) -> Result<Entry<'a>, ReportError> {
    let mut plain = Plain::<Standard>::new(scene)?;
    let region = plain.state().scissor;
    let winners = wrong_winners(&mut plain, truth, &mut PlaneDepth::<P>::new(region))?;
    let bytes = texels(region.width(), region.height()) * size_of::<P::Depth>();
    let row = Row { bytes: Some(bytes), ..row(P::NAME, Whose::Textbook, &errors, winners) };
    let mut depth = PlaneDepth::<P>::new(region);
    let mut frame = move || {
        depth.clear();
        plain.draw(&mut depth)
    };
    frame()?;
    Ok(Entry::new(row, move |_| repeated(frame())))
}

/// Pixels where the depth test lets another triangle win than the exact depths do.
fn wrong_winners<A: Attachment<Standard>>(
    plain: &mut Plain<'_, Standard>,
    truth: &Truth,
    depth: &mut A,
) -> Result<u64, ReportError> {
    let state = *plain.state();
    let mut storage = vec![NO_ID; texels(state.scissor.width(), state.scissor.height())];
    let mut ids = Ids::new(state.scissor, &mut storage)?;
    plain.draw(&mut (depth, &mut ids))?;
    Ok(differences(&rows(&state, &mut storage)?, &truth.nearest, NO_ID).0)
}

fn fast<'a>(
    scene: &'a Scene,
    level: Level,
    (name, attachments): (&str, Attachments),
    errors: Errors,
    winners: u64,
) -> Result<Entry<'a>, ReportError> {
    let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
    target.frame(level, attachments, &scene.matrix)?;
    let row = row(format!("{name}, {}", level.name()), Whose::Ours, &errors, winners);
    Ok(Entry::new(row, move |_| repeated(target.frame(level, attachments, &scene.matrix))))
}

/// Every plane at every covered sample, against the exact depth.
struct Judge {
    depth32: Vec<u32>,
    depth16: Vec<u16>,
    region: Region<Standard>,
    exact: Option<ExactPlane>,
    planes: Option<(Barycentric32, Gradient32, Gradient64, ExactRational)>,
    errors: [Errors; 6],
}

impl Judge {
    fn new(state: State<Standard>) -> Self {
        let region = state.scissor;
        let texels = texels(region.width(), region.height());
        Self {
            depth32: vec![0; texels],
            depth16: vec![0; texels],
            region,
            exact: None,
            planes: None,
            errors: [Errors::default(); 6],
        }
    }

    /// What the rasterizer stores for a block: by drawing it.
    fn ours<D: DepthFormat<Standard>>(
        region: Region<Standard>,
        storage: &mut [D::Texel],
        block: &Block<'_, Standard>,
    ) -> [u32; 16] {
        let mut depths = [0; 16];
        let test = DepthTest { compare: Compare::Always, write: true };
        if let Ok(mut depth) = Depth::<Standard, D>::new(region, storage, test) {
            depth.begin(block.triangle);
            depth.block(block);
            for (column, row) in block.mask.cells() {
                let stored = depth.get(block.x + column, block.y + row).map_or(0, Into::into);
                depths[(row * 4 + column) as usize] = stored;
            }
        }
        depths
    }
}

impl Attachment<Standard> for Judge {
    fn begin(&mut self, triangle: &Triangle<Standard>) {
        self.exact = exact_plane(triangle);
        self.planes = Some((
            Barycentric32::new(triangle),
            Gradient32::new(triangle),
            Gradient64::new(triangle),
            ExactRational::new(triangle),
        ));
    }

    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        let (Some(exact), Some((bary, grad32, grad64, rational))) = (&self.exact, &self.planes) else {
            return Mask::EMPTY;
        };
        let (x, y) = (block.x, block.y);
        let ours32 = Self::ours::<D32>(self.region, &mut self.depth32, block);
        let ours16 = Self::ours::<D16>(self.region, &mut self.depth16, block);
        let all = [
            ours32.map(f64::from),
            // 65535 units of 16 bits are 2^32 - 1 units of 32.
            ours16.map(|depth| f64::from(depth) * 65_537.0),
            bary.block(x, y).map(Barycentric32::units),
            grad32.block(x, y).map(Gradient32::units),
            grad64.block(x, y).map(Gradient64::units),
            rational.block(x, y).map(ExactRational::units),
        ];
        for (column, row) in block.mask.cells() {
            let depth = exact.at(x + column, y + row);
            let whole = depth.floor();
            let rest = (depth.numerator() - whole * depth.denominator()) as f64 / depth.denominator() as f64;
            for (errors, depths) in self.errors.iter_mut().zip(&all) {
                // Whole parts first: they are exact in f64, and what is left is small.
                let given = depths[(row * 4 + column) as usize];
                // What is no depth at all counts as the whole range.
                let error = if given.is_nan() { 4_294_967_296.0 } else { given - whole as f64 - rest };
                errors.add(error);
            }
        }
        block.mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfplane::Vertex;

    /// A needle over the whole guard band: what `f32` cannot hold.
    #[test]
    fn the_judge_sees_what_textbooks_lose() {
        let region = Region::<Standard>::of_size(64, 64).unwrap();
        let vertex = |x, y, z| Vertex::<Standard>::new(x, y, z).unwrap();
        let corners =
            [vertex(-8_000_000, 128, 2), vertex(8_000_000, 120, 4_000_000_000), vertex(8_000_000, 136, 9)];
        let mut judge = Judge::new(State::new(region));
        halfplane::draw(&corners[..], &[0u16, 1, 2], 0, &State::new(region), &mut judge).unwrap();
        let [ours, _, bary, grad32, _, rational] = judge.errors;
        assert!(ours.count > 10 && ours.count == rational.count);
        assert!(ours.largest <= 1.01 && rational.largest <= 0.5, "{ours:?} {rational:?}");
        assert!(bary.largest > 100.0 && grad32.largest > 100.0, "{bary:?} {grad32:?}");
    }
}
