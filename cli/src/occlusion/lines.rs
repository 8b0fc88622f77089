//! The edges of boxes as lines in a picture.

use crate::camera::Matrix;
use crate::measure::clip;

/// Draws the twelve edges of the box between two corners, as far as they are before the eye and in the picture.
pub(super) fn draw_box(
    pixels: &mut [[u8; 3]],
    size: (u32, u32),
    matrix: &Matrix,
    [low, high]: &[[f32; 3]; 2],
    colour: [u8; 3],
) {
    let corner = |at: usize| [0, 1, 2].map(|axis| if at >> axis & 1 == 0 { low[axis] } else { high[axis] });
    for from in 0..8usize {
        for axis in 0..3 {
            let to = from | 1 << axis;
            if to != from {
                line(pixels, size, [from, to].map(|at| clip(corner(at), matrix).map(f64::from)), colour);
            }
        }
    }
}

/// Cuts a line at the planes x = ±w, y = ±w and z = 0, and draws what is left, a pixel for each step along its longer
/// side.
fn line(pixels: &mut [[u8; 3]], (width, height): (u32, u32), [a, b]: [[f64; 4]; 2], colour: [u8; 3]) {
    let distances = |[x, y, z, w]: [f64; 4]| [w + x, w - x, w + y, w - y, z];
    let (mut first, mut last) = (0.0f64, 1.0f64);
    for (from, to) in distances(a).into_iter().zip(distances(b)) {
        let at = from / (from - to);
        match (from < 0.0, to < 0.0) {
            (true, true) => return,
            (true, false) => first = first.max(at),
            (false, true) => last = last.min(at),
            (false, false) => (),
        }
    }
    if first >= last {
        return;
    }
    let place = |part: f64| {
        let [x, y, _, w] = [0, 1, 2, 3].map(|k| a[k] + part * (b[k] - a[k]));
        [(0.5 + 0.5 * x / w) * f64::from(width), (0.5 - 0.5 * y / w) * f64::from(height)]
    };
    let ([x0, y0], [x1, y1]) = (place(first), place(last));
    let steps = (x1 - x0).abs().max((y1 - y0).abs()).ceil().clamp(1.0, 1e5) as u32;
    for step in 0..=steps {
        let part = f64::from(step) / f64::from(steps);
        let (x, y) = (x0 + part * (x1 - x0), y0 + part * (y1 - y0));
        // Towards 0, and NaN to it; what is beyond is no pixel.
        let (column, row) = (x as usize, y as usize);
        if column < width as usize
            && let Some(pixel) = pixels.get_mut(row * width as usize + column)
        {
            *pixel = colour;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

    #[test]
    fn a_box_is_its_edges() {
        let mut pixels = vec![[0; 3]; 64];
        draw_box(&mut pixels, (8, 8), &IDENTITY, &[[-0.5, -0.49, 0.1], [0.49, 0.5, 0.2]], [9; 3]);
        let drawn = |x: usize, y: usize| pixels[8 * y + x] == [9; 3];
        // A square of 4 pixels from (2, 2) to (5, 5); nothing inside, nothing outside.
        for (x, y) in (0..8).flat_map(|y| (0..8).map(move |x| (x, y))) {
            let on = |v: usize| v == 2 || v == 5;
            let in_range = (2..=5).contains(&x) && (2..=5).contains(&y);
            assert_eq!(drawn(x, y), in_range && (on(x) || on(y)), "({x}, {y})");
        }
    }

    #[test]
    fn what_is_behind_the_eye_is_not_drawn() {
        let mut pixels = vec![[0; 3]; 64];
        let mut matrix = IDENTITY;
        // w is z: the box from z = -2 to -1 is behind.
        (matrix[11], matrix[15]) = (1.0, 0.0);
        draw_box(&mut pixels, (8, 8), &matrix, &[[-0.5, -0.5, -2.0], [0.5, 0.5, -1.0]], [9; 3]);
        assert!(pixels.iter().all(|pixel| *pixel == [0; 3]));
        draw_box(&mut pixels, (8, 8), &matrix, &[[-0.5, -0.5, -2.0], [0.5, 0.5, 1.0]], [9; 3]);
        assert!(pixels.contains(&[9; 3]));
    }
}
