//! A rasterizer's picture against the specification and the exact numbers, pixel by pixel.

use std::cell::OnceCell;
use std::collections::HashMap;
use std::error::Error;
use std::fmt;

use num_traits::Signed;
use rayon::prelude::*;

use crate::render::{Band, Renderer, Texel};
use crate::scene::NO_ID;
use crate::{
    Compare, DepthSpec, Difference, Fraction, Mismatches, Outcome, Rational, Report, Scene, SceneError,
};

/// Why a picture cannot be verified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VerifyError {
    /// The scene is not valid for this format.
    Scene(SceneError),
    /// The depth picture has not as many values as the target has pixels.
    DepthLength {
        /// Pixels of the target.
        needed: usize,
        /// Values in the buffer.
        given: usize,
    },
    /// The id picture has not as many values as the target has pixels.
    IdsLength {
        /// Pixels of the target.
        needed: usize,
        /// Values in the buffer.
        given: usize,
    },
}

impl fmt::Display for VerifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VerifyError::Scene(error) => error.fmt(f),
            VerifyError::DepthLength { needed, given } => {
                write!(f, "the depth picture has {given} values, the target {needed} pixels")
            }
            VerifyError::IdsLength { needed, given } => {
                write!(f, "the id picture has {given} values, the target {needed} pixels")
            }
        }
    }
}

impl Error for VerifyError {}

impl From<SceneError> for VerifyError {
    fn from(error: SceneError) -> Self {
        VerifyError::Scene(error)
    }
}

/// Compares a rasterizer's picture (rows from the top, pixels from the left) with the specification and
/// with the exact depths, at every pixel of the target.
///
/// A pixel differs if it is drawn and not covered or the reverse; if its id is not the specified
/// winner's; if its depth is not the specified one; if its depth is further than
/// [`DepthSpec::bound`] from the exact depth of the triangle named by its id; or if that triangle is worse
/// than the exactly best by more than twice the bound. Drawn is what has an id, or without ids (`None`)
/// what has not the clear value, and then the winner is taken to be the specified one.
///
/// 16-bit depths come widened to 32. `progress` is called from several threads, each time with the
/// number of pixels newly finished; they sum to the size of the target.
///
/// # Errors
/// [`VerifyError`] for a scene that is not valid for this format, or pictures of another size.
pub fn verify(
    scene: &Scene,
    compare: Compare,
    spec: DepthSpec,
    depth: &[u32],
    ids: Option<&[u32]>,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Report, VerifyError> {
    let renderer = Renderer::new(scene, compare, spec)?;
    let needed = scene.width as usize * scene.height as usize;
    if depth.len() != needed {
        return Err(VerifyError::DepthLength { needed, given: depth.len() });
    }
    if let Some(given) = ids.map(<[u32]>::len).filter(|&given| given != needed) {
        return Err(VerifyError::IdsLength { needed, given });
    }
    let judge_band = |band: &Band| {
        let texels = renderer.band(band);
        let start = band.rect.y0 as usize * scene.width as usize;
        let pixels = start..start + texels.len();
        let mut judge = Judge::new(&renderer, band);
        for (position, texel) in pixels.zip(&texels) {
            let (x, y) = (position % scene.width as usize, position / scene.width as usize);
            judge.pixel(x as u32, y as u32, texel, depth[position], ids.map(|ids| ids[position]));
        }
        progress(texels.len() as u64);
        judge.tally
    };
    let tallies: Vec<Tally> = renderer.bands().par_iter().map(judge_band).collect();
    Ok(total(tallies, spec))
}

/// What was counted in a band.
#[derive(Default)]
struct Tally {
    pixels: u64,
    covered: u64,
    mismatches: Mismatches,
    first: Option<Difference>,
    measured: u64,
    max_error: Option<Fraction>,
    sum_error: f64,
}

fn total(tallies: Vec<Tally>, spec: DepthSpec) -> Report {
    let mut all = Tally::default();
    for tally in tallies {
        all.pixels += tally.pixels;
        all.covered += tally.covered;
        all.mismatches += tally.mismatches;
        all.first = all.first.or(tally.first);
        all.measured += tally.measured;
        all.max_error = all.max_error.max(tally.max_error);
        all.sum_error += tally.sum_error;
    }
    Report {
        pixels: all.pixels,
        covered: all.covered,
        mismatches: all.mismatches,
        first: all.first,
        measured: all.measured,
        max_error: all.max_error.map_or(0.0, Fraction::approximate),
        mean_error: if all.measured == 0 { 0.0 } else { all.sum_error / all.measured as f64 },
        spec,
    }
}

/// Judges the pixels of one band.
struct Judge<'a> {
    renderer: &'a Renderer<'a>,
    band: &'a Band,
    by_id: OnceCell<HashMap<u32, Vec<u32>>>,
    tally: Tally,
}

impl<'a> Judge<'a> {
    fn new(renderer: &'a Renderer<'a>, band: &'a Band) -> Self {
        Judge { renderer, band, by_id: OnceCell::new(), tally: Tally::default() }
    }

    fn pixel(&mut self, x: u32, y: u32, texel: &Texel, depth: u32, id: Option<u32>) {
        let Renderer { scene, compare, spec, .. } = *self.renderer;
        let id_of = |triangle: u32| scene.triangles[triangle as usize].id;
        let winner = texel.winner();
        let specified_id = winner.map_or(NO_ID, id_of);
        let drawn = id.map_or(depth != compare.clear_value(spec), |id| id != NO_ID);
        let given_winner = match id {
            _ if !drawn => None,
            Some(id) if id != specified_id => self.piece(id, x, y, depth),
            _ => winner,
        };
        let given_exact = given_winner.and_then(|triangle| self.renderer.exact(triangle, x, y));

        let mut kinds = Mismatches::default();
        match (winner.is_some(), drawn) {
            (true, false) => kinds.missing = 1,
            (false, true) => kinds.extra = 1,
            _ => kinds.depth = u64::from(depth != texel.depth),
        }
        if winner.is_some() && drawn {
            kinds.id = u64::from(id.is_some_and(|id| id != specified_id));
        }
        if let Some(error) = given_exact.and_then(|exact| exact.distance_to(i128::from(depth))) {
            let (numerator, denominator) = spec.bound();
            kinds.bound = u64::from(Some(error) > Fraction::new(numerator, denominator));
            self.tally.measured += 1;
            self.tally.sum_error += error.approximate();
            self.tally.max_error = self.tally.max_error.max(Some(error));
        }
        let best = texel.best().and_then(|best| Some((best, self.renderer.exact(best, x, y)?)));
        if let (Some(given), Some((best, best_exact))) = (given_exact, best)
            && given_winner != Some(best)
            && compare != Compare::Always
        {
            kinds.winner = u64::from(further_than_twice_the_bound(given, best_exact, spec));
        }

        kinds.pixels = u64::from(kinds != Mismatches::default());
        self.tally.pixels += 1;
        self.tally.covered += u64::from(winner.is_some());
        self.tally.mismatches += kinds;
        if kinds.pixels > 0 && self.tally.first.is_none() {
            let exact = |triangle| self.renderer.exact(triangle, x, y);
            let named = |id: u32| (id != NO_ID).then_some(id);
            self.tally.first = Some(Difference {
                x,
                y,
                kinds,
                specified: Outcome {
                    id: named(specified_id),
                    depth: texel.depth,
                    exact: winner.and_then(exact),
                },
                given: Outcome { id: id.and_then(named), depth, exact: given_exact },
                best: best.map(|(triangle, exact)| (id_of(triangle), exact)),
            });
        }
    }

    /// The triangle of this id that covers the pixel; of several, the one nearest to the depth given.
    fn piece(&self, id: u32, x: u32, y: u32, depth: u32) -> Option<u32> {
        let by_id = self.by_id.get_or_init(|| {
            let mut by_id: HashMap<u32, Vec<u32>> = HashMap::new();
            for &index in &self.band.triangles {
                by_id.entry(self.renderer.scene.triangles[index as usize].id).or_default().push(index);
            }
            by_id
        });
        let pieces = by_id.get(&id)?.iter().copied();
        let covering = pieces.filter(|&piece| self.renderer.covers(piece, x, y));
        covering.min_by_key(|&piece| self.renderer.exact(piece, x, y)?.distance_to(i128::from(depth)))
    }
}

/// Whether two exact depths are more than twice the bound apart; in unbounded integers only where
/// the integer parts leave it open.
fn further_than_twice_the_bound(a: Fraction, b: Fraction, spec: DepthSpec) -> bool {
    let (numerator, denominator) = spec.bound();
    let whole = (a.floor() - b.floor()).abs();
    if (whole + 1) * denominator <= 2 * numerator {
        false
    } else if (whole - 1) * denominator >= 2 * numerator {
        true
    } else {
        let bound = Rational::new((2 * numerator).into(), denominator.into());
        (a.to_rational() - b.to_rational()).abs() > bound
    }
}
