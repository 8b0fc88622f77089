//! A scene by brute force: every triangle on every sample of its rows, in the order of submission.

use rayon::prelude::*;

use crate::scene::NO_ID;
use crate::{
    Compare, DepthSpec, ExactPlane, Fraction, Grid, Rect, Scene, SceneError, SpecifiedPlane, cover_rows,
};

/// Rows of a band: the unit of parallel work. No picture depends on it.
pub(crate) const BAND_ROWS: u32 = 16;

/// No triangle of the scene.
const NOBODY: u32 = u32::MAX;

/// Rows of the target and the triangles that reach them, in the order of submission.
pub(crate) struct Band {
    pub(crate) rect: Rect,
    pub(crate) triangles: Vec<u32>,
}

/// The bands of a scene, top down.
pub(crate) fn bands_of(scene: &Scene, grid: Grid) -> Vec<Band> {
    let band = |index: u32| Rect {
        y0: index * BAND_ROWS,
        y1: ((index + 1) * BAND_ROWS).min(scene.height),
        ..scene.rect()
    };
    let mut bands: Vec<Band> = (0..scene.height.div_ceil(BAND_ROWS))
        .map(|index| Band { rect: band(index), triangles: Vec::new() })
        .collect();
    for (index, triangle) in (0..).zip(&scene.triangles) {
        let [a, b, c] = triangle.xy.map(|[_, y]| i64::from(y));
        let rows = grid.rows(a.min(b).min(c), a.max(b).max(c), 0, scene.height);
        if !rows.is_empty() {
            for band in rows.start / BAND_ROWS..=(rows.end - 1) / BAND_ROWS {
                bands[band as usize].triangles.push(index);
            }
        }
    }
    bands
}

/// What is known of one pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Texel {
    /// The specified depth.
    pub(crate) depth: u32,
    /// Which triangle of the scene left it there.
    winner: u32,
    /// The triangle whose exact depth the comparison favours, the earliest of several.
    best: u32,
    /// The integer part of that depth.
    best_floor: u32,
}

impl Texel {
    /// Position in the scene of the triangle that won, by the specified depths.
    pub(crate) fn winner(&self) -> Option<u32> {
        (self.winner != NOBODY).then_some(self.winner)
    }

    /// Position in the scene of the triangle that is best, by the exact depths.
    pub(crate) fn best(&self) -> Option<u32> {
        (self.best != NOBODY).then_some(self.best)
    }
}

/// A scene that has been checked, and how depths are compared and stored.
pub(crate) struct Renderer<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) compare: Compare,
    pub(crate) spec: DepthSpec,
    grid: Grid,
}

impl<'a> Renderer<'a> {
    pub(crate) fn new(scene: &'a Scene, compare: Compare, spec: DepthSpec) -> Result<Self, SceneError> {
        Ok(Renderer { scene, compare, spec, grid: scene.check(spec)? })
    }

    pub(crate) fn bands(&self) -> Vec<Band> {
        bands_of(self.scene, self.grid)
    }

    /// The exact depth of a triangle of the scene at a pixel; `None` without area or triangle.
    pub(crate) fn exact(&self, triangle: u32, x: u32, y: u32) -> Option<Fraction> {
        Some(self.exact_plane(triangle)?.at(x, y))
    }

    fn exact_plane(&self, triangle: u32) -> Option<ExactPlane> {
        let triangle = self.scene.triangles.get(triangle as usize)?;
        ExactPlane::new(&triangle.xy, &triangle.z.map(|z| self.spec.keep(z)), self.grid)
    }

    /// Whether a triangle of the scene covers a pixel's sample.
    pub(crate) fn covers(&self, triangle: u32, x: u32, y: u32) -> bool {
        let mut covered = false;
        if let Some(triangle) = self.scene.triangles.get(triangle as usize) {
            let pixel = Rect { x0: x, y0: y, x1: x + 1, y1: y + 1 };
            cover_rows(&triangle.xy, self.grid, pixel, |_, _| covered = true);
        }
        covered
    }

    /// The pixels of a band, row-major.
    pub(crate) fn band(&self, band: &Band) -> Vec<Texel> {
        let clear =
            Texel { depth: self.compare.clear_value(self.spec), winner: NOBODY, best: NOBODY, best_floor: 0 };
        let Rect { x0, y0, x1, y1 } = band.rect;
        let width = (x1 - x0) as usize;
        let mut texels = vec![clear; width * (y1 - y0) as usize];
        for &index in &band.triangles {
            let triangle = &self.scene.triangles[index as usize];
            let z = triangle.z.map(|z| self.spec.keep(z));
            let planes = (
                ExactPlane::new(&triangle.xy, &z, self.grid),
                SpecifiedPlane::new(&triangle.xy, &z, self.grid, self.spec),
            );
            let (Some(exact), Some(specified)) = planes else {
                continue;
            };
            cover_rows(&triangle.xy, self.grid, band.rect, |y, columns| {
                let row = &mut texels[(y - y0) as usize * width..][..width];
                let mut walk = exact.walk(columns.start, y);
                let mut base = specified.block(columns.start, y);
                for x in columns {
                    if x % 4 == 0 {
                        base = specified.block(x, y);
                    }
                    let texel = &mut row[(x - x0) as usize];
                    let depth = specified.in_block(base, x, y);
                    if self.compare.passes(&depth, &texel.depth) {
                        texel.depth = depth;
                        texel.winner = index;
                    }
                    // Between the corners' depths, so within 32 bits.
                    let floor = u32::try_from(walk.whole()).unwrap_or(u32::MAX);
                    if self.favours(floor, walk.rest(), texel, x, y) {
                        texel.best = index;
                        texel.best_floor = floor;
                    }
                    walk.advance();
                }
            });
        }
        texels
    }

    /// Whether an exact depth is strictly better than the best so far.
    fn favours(&self, floor: u32, rest: Fraction, texel: &Texel, x: u32, y: u32) -> bool {
        let Some(best) = texel.best() else {
            return true;
        };
        let better = match self.compare {
            Compare::Less | Compare::LessEqual => Compare::Less,
            Compare::Greater | Compare::GreaterEqual => Compare::Greater,
            Compare::Always => return true,
        };
        if floor != texel.best_floor {
            return better.passes(&floor, &texel.best_floor);
        }
        self.exact_plane(best).is_some_and(|plane| better.passes(&rest, &plane.walk(x, y).rest()))
    }
}

/// What a scene looks like, by the specification; rows from the top, pixels from the left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The specified depth of every pixel; the clear value where nothing was drawn.
    pub depth: Vec<u32>,
    /// The id of the triangle that won every pixel, [`NO_ID`] where nothing was drawn.
    pub ids: Vec<u32>,
    /// Position in the scene of the triangle that won every pixel, by the specified depths.
    pub winners: Vec<Option<u32>>,
    /// Position in the scene of the triangle that is best by the **exact** depths (the nearest for
    /// `Less`, the farthest for `Greater`, the last for `Always`; the earliest of equals).
    pub best: Vec<Option<u32>>,
}

/// Renders a scene by brute force, in the order of submission, with the specified depths.
///
/// `progress` is called from several threads, each time with the number of pixels newly finished;
/// they sum to the size of the target.
///
/// # Errors
/// [`SceneError`] for a scene that is not valid for this format.
pub fn render(
    scene: &Scene,
    compare: Compare,
    spec: DepthSpec,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Picture, SceneError> {
    let renderer = Renderer::new(scene, compare, spec)?;
    let render_band = |band: &Band| {
        let texels = renderer.band(band);
        progress(texels.len() as u64);
        texels
    };
    let bands: Vec<Vec<Texel>> = renderer.bands().par_iter().map(render_band).collect();
    let texels = || bands.iter().flatten();
    let id = |texel: &Texel| texel.winner().map_or(NO_ID, |winner| scene.triangles[winner as usize].id);
    Ok(Picture {
        width: scene.width,
        height: scene.height,
        depth: texels().map(|texel| texel.depth).collect(),
        ids: texels().map(id).collect(),
        winners: texels().map(Texel::winner).collect(),
        best: texels().map(Texel::best).collect(),
    })
}

impl Picture {
    /// The exact depth, in stored units, of the triangle that is best at a pixel by the exact depths.
    ///
    /// `scene` and `spec` are those the picture was rendered from. `None` where nothing covers the
    /// pixel, or outside the picture.
    pub fn exact_best(&self, scene: &Scene, spec: DepthSpec, x: u32, y: u32) -> Option<Fraction> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let best = *self.best.get(y as usize * self.width as usize + x as usize)?;
        Renderer::new(scene, Compare::Less, spec).ok()?.exact(best?, x, y)
    }
}
