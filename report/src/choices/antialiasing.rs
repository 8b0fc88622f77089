//! How many samples stand for a pixel's area.

use halfplane::{Sample, Standard, State};
use halfplane_measure::level::Level;
use halfplane_reference::{Grid, Point, Rect, Scene as Window, cover_rows, covered_area, from_steps};
use num_traits::ToPrimitive;
use rayon::prelude::*;

use super::repeated;
use crate::error::ReportError;
use crate::row::{Column, Entry, Question, Row, Whose};
use crate::scene::Scene;
use crate::statistics::Errors;
use crate::truth::Truth;
use crate::vector::CoverageFrames;

/// Antialiasing.
pub const QUESTION: Question = Question {
    id: "antialiasing",
    title: "Samples against exact area",
    about: "The part of a pixel that a triangle covers, told by N samples at Direct3D's standard places, against \
            the exact area, over pixels on triangles' outlines. Several samples are several draws of coverage, one \
            for each sample position, clears included; a draw of several samples in one pass is pending.",
    error: Column::new("mean error of coverage", "% of a pixel"),
    details: &[Column::new("largest error", "% of a pixel"), Column::new("outline pixels looked at", "")],
};

/// Outline pixels whose exact areas are computed, evenly spread over the scene's triangles.
const PIXELS: usize = 3_000;

/// Direct3D's standard sample positions in 1/16 px from the pixel's centre.
const PATTERNS: [&[[i32; 2]]; 5] = [
    &[[0, 0]],
    &[[4, 4], [-4, -4]],
    &[[-2, -6], [6, -2], [-6, 2], [2, 6]],
    &[[1, -3], [-1, 3], [5, 1], [-3, -5], [-5, 5], [-7, -1], [3, 7], [7, -7]],
    &[
        [1, 1],
        [-1, -3],
        [-3, 2],
        [4, -1],
        [-5, -2],
        [2, 5],
        [5, 3],
        [3, -5],
        [-2, 6],
        [0, -7],
        [-4, -6],
        [-6, 4],
        [-8, 0],
        [7, -4],
        [6, 7],
        [-7, -8],
    ],
];

/// A row for each number of samples.
///
/// # Errors
///
/// Where the scene cannot be drawn.
pub fn antialiasing<'a>(scene: &'a Scene, truth: &Truth) -> Result<Vec<Entry<'a>>, ReportError> {
    let areas = areas(&truth.window);
    let level = Level::detect();
    let mut entries = Vec::new();
    for pattern in PATTERNS {
        let places: Vec<[i32; 2]> = pattern.iter().map(|place| place.map(|v| 128 + 16 * v)).collect();
        let mut errors = Errors::default();
        for outline in &areas {
            let inside = places.iter().filter(|&&place| outline.covers(&truth.window, place)).count();
            errors.add(100.0 * (inside as f64 / places.len() as f64 - outline.area));
        }
        let state = scene.state()?;
        let sample = |&[x, y]: &[i32; 2]| Sample::new(x, y).map(|sample| State { sample, ..state });
        let states: Vec<State<Standard>> = places.iter().filter_map(sample).collect();
        let mut coverage = CoverageFrames::new(scene, scene.indices.clone())?;
        let bytes = places.len() * coverage.bytes();
        let mut frame = move || states.iter().try_for_each(|state| coverage.frame(level, state));
        frame()?;
        let count = places.len();
        let name = if count == 1 { "1 sample".to_owned() } else { format!("{count} samples") };
        let row = Row {
            error: Some(errors.mean()),
            details: vec![Some(errors.largest), Some(errors.count as f64)],
            bytes: Some(bytes),
            ..Row::new(name, Whose::Ours)
        };
        entries.push(Entry::new(row, move |_| repeated(frame())));
    }
    let reason =
        "there is one sample position for each draw; the rows above draw as often as they have samples";
    entries.push(Row::pending("several samples in one pass", Whose::Ours, reason).into());
    Ok(entries)
}

/// A pixel on a triangle's outline.
struct Outline {
    triangle: usize,
    pixel: (u32, u32),
    area: f64,
}

impl Outline {
    fn covers(&self, window: &Window, [x, y]: [i32; 2]) -> bool {
        let (column, row) = self.pixel;
        let rect = Rect { x0: column, y0: row, x1: column + 1, y1: row + 1 };
        let mut covered = false;
        if let Ok(grid) = Grid::new(8, (x as u32, y as u32)) {
            cover_rows(&window.triangles[self.triangle].xy, grid, rect, |_, _| covered = true);
        }
        covered
    }
}

/// Pixels that triangles cover in part, and the exact parts.
fn areas(window: &Window) -> Vec<Outline> {
    // Few pixels of many triangles, so that no large one has all of them.
    let stride = window.triangles.len().div_ceil(PIXELS).max(1);
    let each = PIXELS.div_ceil(window.triangles.len().max(1)).max(2);
    let chosen: Vec<usize> = (0..window.triangles.len()).step_by(stride).collect();
    let of = |&triangle: &usize| {
        let xy = window.triangles[triangle].xy;
        let corners = xy.map(|[x, y]| Point::new(from_steps(x.into(), 8), from_steps(y.into(), 8)));
        outline(&xy, (window.width, window.height), each)
            .into_iter()
            .filter_map(|pixel| {
                let area = covered_area(&corners, (pixel.0.into(), pixel.1.into())).to_f64()?;
                (area > 0.0 && area < 1.0).then_some(Outline { triangle, pixel, area })
            })
            .collect::<Vec<_>>()
    };
    chosen.par_iter().flat_map_iter(of).collect()
}

/// At most so many pixels along a triangle's edges, on the target.
fn outline(xy: &[[i32; 2]; 3], (width, height): (u32, u32), most: usize) -> Vec<(u32, u32)> {
    let mut pixels = Vec::new();
    for step in 0..most {
        let ([ax, ay], [bx, by]) = (xy[step % 3], xy[(step + 1) % 3]);
        // Along the edge by the golden ratio: evenly, however many there are.
        let along = ((step + 1) as f64 * 0.618_033_988_75).fract();
        let at = |a: i32, b: i32| (f64::from(a) + (f64::from(b) - f64::from(a)) * along) / 256.0;
        let (x, y) = (at(ax, bx).floor(), at(ay, by).floor());
        if x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height) {
            let pixel = (x as u32, y as u32);
            if !pixels.contains(&pixel) {
                pixels.push(pixel);
            }
        }
    }
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfplane_reference::SceneTriangle;

    #[test]
    fn patterns_are_as_many_as_they_say_and_inside_their_pixel() {
        for (pattern, count) in PATTERNS.iter().zip([1, 2, 4, 8, 16]) {
            assert_eq!(pattern.len(), count);
            let mut all = pattern.to_vec();
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), count);
            assert!(all.as_flattened().iter().all(|v| (-8..8).contains(v)));
        }
    }

    #[test]
    fn half_a_pixel_is_half_an_area() {
        // The right half of every pixel of a column.
        let xy = [[128, 0], [100_000, 0], [128, 100_000]];
        let triangles = vec![SceneTriangle { xy, z: [9; 3], id: 0 }];
        let window = Window { width: 4, height: 4, subpixel_bits: 8, sample: (128, 128), triangles };
        let areas = areas(&window);
        let first = areas.iter().find(|outline| outline.pixel.0 == 0).unwrap();
        assert_eq!(first.area, 0.5);
        assert!(first.covers(&window, [128, 128]) && !first.covers(&window, [127, 128]));
    }
}
