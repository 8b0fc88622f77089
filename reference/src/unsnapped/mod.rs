//! The picture of a model before any rounding: vertices of floats, a matrix of floats, and from there on real
//! numbers. It is what snapping to a sub-pixel grid, a transform in floats and a depth of so many bits are
//! measured against.
//!
//! Coverage is decided in clip space, at each sample by itself: with the corners' (x, y, w) as columns of a
//! matrix, a sample is a sum of the corners with weights, and the triangle covers it where none is negative
//! (Olano and Greer, 1997). So nothing is cut at the near plane, and no triangle needs another for its sake.
//! The near and far planes are asked of the sample's own depth.
//!
//! Every comparison is made in `f64` with a bound of its error, and where that does not decide, again in
//! integers of unbounded size; so the picture is exact, and quick.

mod exact;
mod model;
mod plane;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering as Memory};

use rayon::prelude::*;

use crate::render::BAND_ROWS;
use crate::scene::NO_ID;
use exact::{Exact, Integers};
pub use model::{Model, ModelError};
use plane::{Filter, Sides};

/// What a model looks like without any rounding; rows from the top, pixels from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Unsnapped {
    /// The id of the nearest triangle of every pixel, the earlier of equals; [`NO_ID`] where there is none.
    pub ids: Vec<u32>,
    /// Its depth z/w there, 0 to 1, within 10^-9; 1 where there is none.
    pub depth: Vec<f64>,
    /// Its 1/w there, as near; 0 where there is none.
    pub inverse_w: Vec<f64>,
    /// How many comparisons floats did not decide.
    pub decided_in_integers: u64,
}

/// Depths that may be further off in floats are taken from the integers.
const DEPTH_ERROR: f64 = 1e-9;

/// Renders a model exactly. `progress` is called from several threads, each time with the number of pixels
/// newly finished; they sum to the size of the target.
///
/// # Errors
/// [`ModelError`], naming the first thing that is wrong.
pub fn unsnapped(model: &Model<'_>, progress: &(dyn Fn(u64) + Sync)) -> Result<Unsnapped, ModelError> {
    model.check()?;
    let count = (model.indices.len() / 3) as u32;
    let integers = Integers::of(model);
    let exact: Vec<OnceLock<Box<Exact>>> = (0..count).map(|_| OnceLock::new()).collect();
    let asked = AtomicU64::new(0);
    let renderer = Renderer { model, integers: &integers, exact: &exact, asked: &asked };
    let filters: Vec<Option<Filter>> =
        (0..count).into_par_iter().map(|triangle| renderer.filter(triangle)).collect();

    let bands = model.height.div_ceil(BAND_ROWS);
    let mut of_band: Vec<Vec<u32>> = vec![Vec::new(); bands as usize];
    for (triangle, filter) in (0..).zip(&filters) {
        let Some([_, y0, _, y1]) = filter.as_ref().map(|filter| filter.bounds) else { continue };
        for band in &mut of_band[(y0 / BAND_ROWS) as usize..y1.div_ceil(BAND_ROWS) as usize] {
            band.push(triangle);
        }
    }
    let parts: Vec<Vec<Texel>> = (0..bands)
        .into_par_iter()
        .zip(&of_band)
        .map(|(band, triangles)| {
            let rows = [band * BAND_ROWS, ((band + 1) * BAND_ROWS).min(model.height)];
            let texels = renderer.band(rows, triangles, &filters);
            progress(texels.len() as u64);
            texels
        })
        .collect();
    let texels = || parts.iter().flatten();
    Ok(Unsnapped {
        ids: texels().map(|texel| texel.id).collect(),
        depth: texels().map(|texel| texel.depth).collect(),
        inverse_w: texels().map(|texel| texel.inverse_w).collect(),
        decided_in_integers: asked.load(Memory::Relaxed),
    })
}

#[derive(Clone, Copy)]
struct Texel {
    id: u32,
    depth: f64,
    /// How far `depth` may be off.
    error: f64,
    inverse_w: f64,
}

struct Renderer<'a> {
    model: &'a Model<'a>,
    integers: &'a Integers,
    exact: &'a [OnceLock<Box<Exact>>],
    asked: &'a AtomicU64,
}

impl Renderer<'_> {
    fn exact(&self, triangle: u32) -> &Exact {
        let make = || Box::new(self.integers.triangle(self.model.corners(triangle)));
        self.exact[triangle as usize].get_or_init(make)
    }

    /// [`exact`](Self::exact) because floats do not decide.
    fn ask(&self, triangle: u32) -> &Exact {
        self.asked.fetch_add(1, Memory::Relaxed);
        self.exact(triangle)
    }

    /// `None` where it is certain that the triangle is not seen.
    fn filter(&self, triangle: u32) -> Option<Filter> {
        let Model { matrix, width, height, .. } = *self.model;
        let mut filter = Filter::new(self.model.corners(triangle), &matrix, (width, height))?;
        let orientation = match filter.orientation() {
            Some(sign) => sign,
            None => self.ask(triangle).orientation(),
        };
        // Seen with y up, the determinant of corners that go round clockwise is negative.
        if orientation == 0 || self.model.clockwise_only && orientation > 0 {
            return None;
        }
        filter.turn(orientation);
        Some(filter)
    }

    /// The pixels of some rows, row-major.
    fn band(&self, [top, bottom]: [u32; 2], triangles: &[u32], filters: &[Option<Filter>]) -> Vec<Texel> {
        let width = self.model.width as usize;
        let clear = Texel { id: NO_ID, depth: 1.0, error: 0.0, inverse_w: 0.0 };
        let mut texels = vec![clear; width * (bottom - top) as usize];
        for &triangle in triangles {
            let Some(filter) = &filters[triangle as usize] else { continue };
            let [x0, y0, x1, y1] = filter.bounds;
            for y in y0.max(top)..y1.min(bottom) {
                let row = &mut texels[(y - top) as usize * width..][..width];
                for (x, texel) in (x0..x1).zip(&mut row[x0 as usize..x1 as usize]) {
                    self.pixel(triangle, filter, (x, y), texel);
                }
            }
        }
        texels
    }

    #[inline]
    fn pixel(&self, triangle: u32, filter: &Filter, (x, y): (u32, u32), texel: &mut Texel) {
        let sample = self.model.sample(x, y);
        let at = sample.map(|v| v as f64);
        match filter.covers(at) {
            Sides::Outside => return,
            Sides::Unknown if !self.ask(triangle).covers(sample) => return,
            Sides::Inside | Sides::Unknown => {}
        }
        let (mut depth, mut error) = filter.depth(at);
        let mut inverse_w = filter.inverse_w(at);
        if error.is_nan() || error > DEPTH_ERROR {
            let exact = self.exact(triangle);
            (depth, inverse_w) = (exact.depth(sample), exact.inverse_w(sample));
            error = 4.0 * f64::EPSILON;
        }
        if texel.id != NO_ID {
            if depth - error > texel.depth + texel.error {
                return;
            }
            let surely = depth + error < texel.depth - texel.error;
            if !surely && !self.ask(triangle).is_nearer(self.exact(texel.id), sample) {
                return;
            }
        }
        *texel = Texel { id: triangle, depth, error, inverse_w };
    }
}
