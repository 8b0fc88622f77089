//! As many triangles in every view, larger and larger: the time should grow with the samples they cover and
//! no faster. Each is nearer than those before it, so that every sample passes the depth test.

use super::View;
use super::micro;

/// Samples that a view's triangles cover, about; one that fills the picture would cover 10^9.
pub const COUNTS: [u32; 5] = [10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// Triangles in a view.
const TRIANGLES: u32 = 1000;

/// The view's name.
#[must_use]
pub fn name(samples: u32) -> String {
    format!("pixels 10^{}", samples.ilog10())
}

/// The view whose triangles cover about so many samples.
#[must_use]
pub fn view(samples: u32, size: (u32, u32)) -> View {
    let side = (2.0 * samples as f32 / TRIANGLES as f32).sqrt();
    View { peers: false, ..micro::nearer(&name(samples), TRIANGLES, side, size) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contest;

    #[test]
    fn as_many_samples_as_the_name_says() {
        for samples in COUNTS {
            let counted = contest::samples(&view(samples, micro::SIZE)) as f64;
            assert!((counted / f64::from(samples) - 1.0).abs() < 0.1, "{counted} for {samples}");
        }
    }
}
