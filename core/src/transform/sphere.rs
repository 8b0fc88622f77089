//! What a sphere can cover at most, as seen through a viewport.

#[cfg(any(kani, test))]
mod proofs;

use super::{
    bound::{Bound, Ends, MARGIN, TINY, ends_of_box},
    root::root_above,
    viewport::Viewport,
};
use crate::{geometry::Sample, numbers::Format};

impl<F: Format> Viewport<F> {
    /// What the sphere of a radius, not negative, round a centre, and any triangles inside it, can cover at most: see
    /// [`bound_box`](Self::bound_box). Never more than what the box round the sphere can.
    ///
    /// Over a sphere, the quotient of two clip coordinates is smallest and largest where a plane through the eye
    /// touches it (Mara and McGuire, "2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere", for a
    /// camera's matrix; here for any).
    #[inline(always)]
    #[must_use]
    pub fn bound_sphere(
        &self,
        matrix: &[[f32; 4]; 4],
        center: [f32; 3],
        radius: f32,
        sample: Sample<F>,
    ) -> Bound<F> {
        // Rounded once, which is little beside what a corner's rounding is taken for.
        let corners = [center.map(|v| v - radius), center.map(|v| v + radius)];
        if radius.is_nan() || radius < 0.0 {
            return Bound::Anything;
        }
        match (ends_of_box(matrix, corners), ends_of_sphere(matrix, center, radius)) {
            (None, None) => Bound::Anything,
            (Some(ends), None) | (None, Some(ends)) => self.bound(ends, sample),
            (Some(outer), Some(ends)) => self.bound(intersect(outer, ends), sample),
        }
    }
}

/// What is between both.
#[inline(always)]
fn intersect(a: Ends, b: Ends) -> Ends {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    let both = |[a, b]: [f32; 2], [c, d]: [f32; 2]| [a.max(c), b.min(d)];
    [both(ax, bx), both(ay, by), both(az, bz)]
}

/// The ends of quotients over a sphere and what is in it, rounding allowed for; `None` where w may not be positive, or
/// something is not finite.
///
/// In `f64`, whose rounding is nothing beside the margin for that of vertices: a coordinate is off by less than 2^-50
/// of the sum of its terms' magnitudes.
#[inline(always)]
fn ends_of_sphere(matrix: &[[f32; 4]; 4], center: [f32; 3], radius: f32) -> Option<Ends> {
    let [[ax, ay, az, aw], [bx, by, bz, bw], [cx, cy, cz, cw], [dx, dy, dz, dw]] = *matrix;
    let over = |column| Linear::new(column, center, radius);
    let (x, y) = (over([ax, bx, cx, dx]), over([ay, by, cy, dy]));
    let (z, w) = (over([az, bz, cz, dz]), over([aw, bw, cw, dw]));
    let nearest = w.value - root_above(dot(w.slope, w.slope)) - w.size * f64::from(MARGIN);
    // NaN and infinities compare to false.
    if !(nearest >= f64::from(f32::MIN_POSITIVE) && x.size + y.size + z.size + w.size < f64::from(f32::MAX)) {
        return None;
    }
    Some([x.quotients(w, nearest), y.quotients(w, nearest), z.quotients(w, nearest)])
}

/// One clip coordinate over a sphere: `value + slope . u`, u in the unit ball.
#[derive(Clone, Copy)]
struct Linear {
    value: f64,
    slope: [f64; 3],
    /// The largest sum of the magnitudes of its terms.
    size: f64,
}

impl Linear {
    #[inline(always)]
    fn new(column: [f32; 4], center: [f32; 3], radius: f32) -> Self {
        let ([a, b, c, d], [x, y, z]) = (column.map(f64::from), center.map(f64::from));
        let radius = f64::from(radius);
        let reach = |v: f64| v.abs() + radius;
        Self {
            value: a * x + b * y + c * z + d,
            slope: [a * radius, b * radius, c * radius],
            size: a.abs() * reach(x) + b.abs() * reach(y) + c.abs() * reach(z) + d.abs(),
        }
    }

    /// The smallest and the largest quotient by w, whose least is `nearest`, and a margin.
    ///
    /// With q the quotient at the centre, b = `w.slope / w.value` and v = `slope / w.value` - q b it is
    /// q + v . u / (1 + b . u), |b| < 1. That is at most q + t wherever v . u - t b . u <= t, so if |v - t b| <= t.
    /// Both sides are equal for t = (-v . b + s) / (1 - b²), s² = v² (1 - b²) + (v . b)²; and the smallest is q - t
    /// for the t of -v.
    #[inline(always)]
    fn quotients(self, w: Self, nearest: f64) -> [f32; 2] {
        let center = self.value / w.value;
        let b = w.slope.map(|v| v / w.value);
        let ([x, y, z], [bx, by, bz]) = (self.slope.map(|v| v / w.value), b);
        let v = [x - center * bx, y - center * by, z - center * bz];
        let (square, along, rest) = (dot(v, v), dot(v, b), 1.0 - dot(b, b));
        // The larger t without cancellation, and the other by their product v² / (1 - b²).
        let sum = root_above(square * rest + along * along) + along.abs();
        let (larger, smaller) = (sum / rest, square / sum.max(f64::MIN_POSITIVE));
        let (up, down) = if along < 0.0 { (larger, smaller) } else { (smaller, larger) };
        let low = center - confirmed(down, v.map(|v| -v), b);
        let high = center + confirmed(up, v, b);
        let most = high.max(-low);
        let magnitude = (self.size + most * w.size + f64::from(TINY)) / nearest + most;
        let margin = magnitude * f64::from(MARGIN);
        [(low - margin) as f32, (high + margin) as f32]
    }
}

/// A millionth more than `t` where |v - t b| <= t for that; infinity where that is not certain.
#[inline(always)]
fn confirmed(t: f64, [x, y, z]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    let t = t * (1.0 + 1.0 / 1_048_576.0);
    let left = [x - t * bx, y - t * by, z - t * bz];
    // Both sides are good to 2^-48 of t².
    if dot(left, left) <= t * t * (1.0 - 1.0 / (1u64 << 40) as f64) { t } else { f64::INFINITY }
}

#[inline(always)]
fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}
