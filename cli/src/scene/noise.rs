//! Randomness that is the same everywhere: an integer hash, and smooth noise made from it.

/// 32 well-mixed bits from two coordinates and a stream number.
pub(super) fn hash(x: i32, y: i32, stream: u32) -> u32 {
    let mut h = (x as u32).wrapping_mul(0x9e37_79b1)
        ^ (y as u32).wrapping_mul(0x85eb_ca77)
        ^ stream.wrapping_mul(0xc2b2_ae3d);
    for multiplier in [0x7feb_352d, 0x846c_a68b_u32] {
        h ^= h >> 16;
        h = h.wrapping_mul(multiplier);
    }
    h ^ h >> 16
}

/// A number from 0 to 1.
pub(super) fn unit(x: i32, y: i32, stream: u32) -> f64 {
    f64::from(hash(x, y, stream)) / 4_294_967_296.0
}

/// 0 below `low`, 1 above `high`, smooth between.
pub(super) fn smooth(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smooth noise from -1 to 1 with features of size 1.
fn value(x: f64, y: f64, stream: u32) -> f64 {
    let (i, j) = (x.floor(), y.floor());
    let (u, v) = (smooth(0.0, 1.0, x - i), smooth(0.0, 1.0, y - j));
    let (i, j) = (i as i32, j as i32);
    let corner = |di, dj| unit(i.wrapping_add(di), j.wrapping_add(dj), stream) * 2.0 - 1.0;
    let low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * u;
    let high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * u;
    low + (high - low) * v
}

/// Noise of several octaves, about -1 to 1.
pub(super) fn hills(x: f64, y: f64, octaves: u32, stream: u32) -> f64 {
    sum(x, y, octaves, 0.48, stream, |noise| noise)
}

/// Noise with sharp crests, 0 to about 1.
pub(super) fn ridges(x: f64, y: f64, octaves: u32, stream: u32) -> f64 {
    sum(x, y, octaves, 0.38, stream, |noise| {
        let crest = 1.0 - noise.abs();
        crest * crest
    })
}

fn sum(x: f64, y: f64, octaves: u32, fade: f64, stream: u32, shape: impl Fn(f64) -> f64) -> f64 {
    let (mut total, mut weight, mut weights) = (0.0, 1.0, 0.0);
    let (mut x, mut y) = (x, y);
    for octave in 0..octaves {
        total += weight * shape(value(x, y, stream.wrapping_add(octave * 101)));
        weights += weight;
        weight *= fade;
        // Turned and scaled, so that the octaves' grids do not line up.
        (x, y) = (1.7 * x - 1.1 * y + 5.3, 1.1 * x + 1.7 * y - 2.9);
    }
    total / weights
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The scene hangs on these bits.
    #[test]
    fn known_values() {
        assert_eq!(hash(0, 0, 0), 0);
        assert_eq!(hash(1, 0, 0), hash(1, 0, 0));
        assert_ne!(hash(1, 0, 0), hash(0, 1, 0));
        for k in 0..1000 {
            let (x, y) = (f64::from(k) * 0.37, f64::from(k) * -0.91);
            assert!(hills(x, y, 5, 1).abs() <= 1.0);
            assert!((0.0..=1.0).contains(&ridges(x, y, 5, 1)));
        }
    }
}
