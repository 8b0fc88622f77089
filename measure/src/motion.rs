//! A camera that moves a little every frame: a frame that is repeated exactly is learnt by heart by the
//! branch predictor, which no user's frames are.

use crate::Matrix;

/// The largest shift of the picture at the median distance, in pixels.
const PIXELS: f32 = 4.0;

/// Matrices of an eye that moves sideways and up and down, never twice to the same place.
///
/// Adding a constant to x and y in clip space is what moving the eye in its own plane does, parallax
/// included. Depth and w of every vertex stay the same, so what the near plane cuts does too.
#[derive(Debug, Clone)]
pub struct Motion {
    matrix: Matrix,
    amplitude: [f32; 2],
}

impl Motion {
    /// Round the place of a camera that sees these positions in a picture of this size.
    #[must_use]
    pub fn new(positions: &[[f32; 3]], matrix: &Matrix, size: (u32, u32)) -> Self {
        let m = matrix;
        let w = |&[x, y, z]: &[f32; 3]| x * m[3] + y * m[7] + z * m[11] + m[15];
        let mut distances: Vec<f32> = positions.iter().map(w).filter(|w| *w > 0.0).collect();
        distances.sort_by(f32::total_cmp);
        let median = distances.get(distances.len() / 2).copied().unwrap_or(1.0);
        // A pixel is 2 / width of clip space at w = 1.
        let amplitude = [size.0, size.1].map(|side| PIXELS * median * 2.0 / side as f32);
        Self { matrix: *matrix, amplitude }
    }

    /// The matrix of a frame: points of a sequence that fills the square evenly (Roberts's R2).
    #[must_use]
    pub fn at(&self, frame: u64) -> Matrix {
        let point = |step: f64| (frame as f64 * step).fract() as f32 * 2.0 - 1.0;
        let mut matrix = self.matrix;
        matrix[12] += self.amplitude[0] * point(0.754_877_666_246_692_7);
        matrix[13] += self.amplitude[1] * point(0.569_840_290_998_053_2);
        matrix
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_frame_repeats_and_none_moves_far() {
        // Perspective: w is z. The point in the middle is at the median distance.
        let positions = [[0.3, 0.2, 1.0], [-1.0, 0.5, 3.0], [4.0, -4.0, 10.0]];
        let matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -0.5, 0.0];
        let (width, height) = (640, 480);
        let window = |m: &Matrix| {
            let [x, y, z] = positions[1];
            let clip: [f32; 4] = std::array::from_fn(|k| x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k]);
            [clip[0] / clip[3] * 0.5 * width as f32, clip[1] / clip[3] * 0.5 * height as f32]
        };
        let motion = Motion::new(&positions, &matrix, (width, height));
        let mut seen = Vec::new();
        for frame in 0..660 {
            let moved = motion.at(frame);
            let shift = window(&moved).into_iter().zip(window(&matrix));
            assert!(shift.clone().all(|(a, b)| (a - b).abs() < 4.01), "{frame}");
            assert!(!seen.contains(&moved));
            seen.push(moved);
        }
    }
}
