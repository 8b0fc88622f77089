//! A camera that moves a little every frame: a frame that is repeated exactly is learnt by heart by the
//! branch predictor, which no user's frames are.

use halfplane_cli::camera::Matrix;

use super::View;

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
    /// Of the camera of a view.
    pub(super) fn new(view: &View) -> Self {
        let mut distances: Vec<f32> =
            view.mesh.positions.iter().map(|&p| view.clip(p)[3]).filter(|w| *w > 0.0).collect();
        distances.sort_by(f32::total_cmp);
        let median = distances.get(distances.len() / 2).copied().unwrap_or(1.0);
        let (width, height) = view.size;
        // A pixel is 2 / width of clip space at w = 1.
        let amplitude = [width, height].map(|side| PIXELS * median * 2.0 / side as f32);
        Self { matrix: view.matrix, amplitude }
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
    use crate::scenes::micro;

    #[test]
    fn no_frame_repeats_and_none_moves_far() {
        let view = micro::random("test", 100, 8.0, (640, 480));
        let motion = view.motion();
        let mut seen = Vec::new();
        for frame in 0..660 {
            let matrix = motion.at(frame);
            let moved = crate::scenes::View { matrix, ..view.clone() };
            for &p in &view.mesh.positions[..3] {
                let (before, after) = (view.clip(p), moved.clip(p));
                assert_eq!(before[2..], after[2..]);
                let (before, after) = (view.window(before), moved.window(after));
                assert!(before.iter().zip(after).all(|(a, b)| (a - b).abs() < 4.01));
            }
            assert!(!seen.contains(&matrix));
            seen.push(matrix);
        }
    }
}
