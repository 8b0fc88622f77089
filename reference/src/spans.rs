//! Coverage by scanlines in integers: the fast form of [`covers`](crate::covers).
//!
//! On the horizontal line through a row's samples a triangle covers one half-open interval: from the
//! left outline, included, to the right outline, excluded; and the lines it reaches are those from its
//! top, included, to its bottom, excluded. That is the top-left rule without any case for it.

use std::ops::Range;

use rayon::prelude::*;

use crate::grid::{ceil_div, clamp_to};
use crate::render::{BAND_ROWS, bands_of};
use crate::{Grid, Rect, Scene, SceneError};

/// Calls `row(y, x0..x1)` for every row of the rectangle in which the triangle covers samples, top
/// down, with the (never empty) interval of covered columns.
///
/// `xy` in sub-pixel steps: any `i32`. Intermediate values stay below 2^67 in magnitude, so `i128` is
/// exact. Held to the definition by `tests/coverage.rs`.
pub fn cover_rows(xy: &[[i32; 2]; 3], grid: Grid, rect: Rect, mut row: impl FnMut(u32, Range<u32>)) {
    let mut corners = xy.map(|[x, y]| (i64::from(y), i64::from(x)));
    corners.sort_unstable();
    let [top, middle, bottom] = corners;
    let middle_offset = line_at(top, bottom, middle.0).map(|(n, d)| i128::from(middle.1) * d - n);
    let Some(offset @ (..=-1 | 1..)) = middle_offset else {
        return; // no height, or all corners on one line
    };
    let long_is_left = offset > 0;
    for y in grid.rows(top.0, bottom.0, rect.y0, rect.y1) {
        let (_, line) = grid.sample_at(0, y);
        let (from, to) = if line < middle.0 { (top, middle) } else { (middle, bottom) };
        let long = first_column(top, bottom, line, grid, rect);
        let short = first_column(from, to, line, grid, rect);
        let columns = if long_is_left { long..short } else { short..long };
        if !columns.is_empty() {
            row(y, columns);
        }
    }
}

/// Where the line through two corners (y, x) crosses height `y`, in steps: numerator and positive
/// denominator. `None` if it is horizontal.
fn line_at(from: (i64, i64), to: (i64, i64), y: i64) -> Option<(i128, i128)> {
    let rise = i128::from(to.0 - from.0);
    let run = i128::from(to.1 - from.1);
    (rise > 0).then(|| (i128::from(from.1) * rise + run * i128::from(y - from.0), rise))
}

/// The first column of the rectangle whose sample is not left of the edge on this line.
fn first_column(from: (i64, i64), to: (i64, i64), line: i64, grid: Grid, rect: Rect) -> u32 {
    match line_at(from, to, line) {
        Some((n, d)) => {
            let from_sample = n - i128::from(grid.sample().0) * d;
            clamp_to(ceil_div(from_sample, d << grid.subpixel_bits()), rect.x0, rect.x1)
        }
        None => rect.x1, // not reached: an edge is asked only for lines of from.y <= line < to.y
    }
}

/// How many triangles cover each sample, row-major: 1 everywhere inside a watertight mesh.
///
/// # Errors
/// [`SceneError`] for a scene that is not valid (depths are not looked at).
pub fn cover_count_picture(scene: &Scene) -> Result<Vec<u32>, SceneError> {
    let grid = scene.grid()?;
    let bands = bands_of(scene, grid);
    let width = scene.width as usize;
    let mut counts = vec![0; width * scene.height as usize];
    counts.par_chunks_mut(width * BAND_ROWS as usize).zip(&bands).for_each(|(counts, band)| {
        for &index in &band.triangles {
            cover_rows(&scene.triangles[index as usize].xy, grid, band.rect, |y, columns| {
                let start = (y - band.rect.y0) as usize * width;
                for count in &mut counts[start + columns.start as usize..start + columns.end as usize] {
                    *count += 1;
                }
            });
        }
    });
    Ok(counts)
}

/// How many samples of the target each triangle covers, in the order of the scene.
///
/// # Errors
/// [`SceneError`] for a scene that is not valid (depths are not looked at).
pub fn cover_counts(scene: &Scene) -> Result<Vec<u64>, SceneError> {
    let grid = scene.grid()?;
    let rect = scene.rect();
    let count = |triangle: &crate::SceneTriangle| {
        let mut samples = 0;
        cover_rows(&triangle.xy, grid, rect, |_, columns| {
            samples += u64::from(columns.end - columns.start);
        });
        samples
    };
    Ok(scene.triangles.par_iter().map(count).collect())
}
