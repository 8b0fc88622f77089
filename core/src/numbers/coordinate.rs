//! Window coordinates in fixed point, and snapping to them.

use super::{bounds::Bounds, format::Format};
use core::marker::PhantomData;

/// A window coordinate: a whole number of steps of 2^-S px within the guard band, from the target's
/// top-left corner, x to the right, y down. Pixel i covers `[i, i + 1)`, its centre is at i + 1/2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Coordinate<F> {
    steps: i32,
    format: PhantomData<F>,
}

impl<F: Format> Coordinate<F> {
    /// The target's origin.
    pub const ZERO: Self = Self { steps: 0, format: PhantomData };

    /// The coordinate of that many steps; `None` outside the guard band.
    #[must_use]
    pub const fn from_steps(steps: i32) -> Option<Self> {
        let () = Bounds::<F>::CHECKED;
        if steps < -Bounds::<F>::GUARD_BAND || steps > Bounds::<F>::GUARD_BAND {
            None
        } else {
            Some(Self { steps, format: PhantomData })
        }
    }

    /// The coordinate nearest to `pixels`, ties to the even step (Direct3D 11.3, 3.2.4.1; the
    /// specification calls this the reference). Beyond the guard band, infinities included, it is
    /// the guard band's end; `None` for NaN.
    ///
    /// Multiplying by 2^S is exact, and below 2^23 a float's integer part and its fraction are exact
    /// floats: no rounding but the last. Below 2^22 the addition of 1.5 2^23 is the rounding: floats
    /// of that size are whole numbers, and ties go to the even one.
    #[inline]
    #[must_use]
    pub fn snap(pixels: f32) -> Option<Self> {
        let () = Bounds::<F>::CHECKED;
        let scaled = pixels * Bounds::<F>::STEPS_PER_PIXEL as f32;
        let end = Bounds::<F>::GUARD_BAND as f32;
        if scaled.is_nan() {
            return None;
        }
        let steps = if scaled.abs() < end.min((1 << 22) as f32) {
            let magic = (3 << 22) as f32;
            ((scaled + magic).to_bits() as i32).wrapping_sub(magic.to_bits() as i32)
        } else if scaled >= end {
            Bounds::<F>::GUARD_BAND
        } else if scaled <= -end {
            -Bounds::<F>::GUARD_BAND
        } else {
            let toward_zero = scaled as i32;
            let fraction = scaled - toward_zero as f32;
            let odd = toward_zero & 1 != 0;
            let up = fraction > 0.5 || (fraction == 0.5 && odd);
            let down = fraction < -0.5 || (fraction == -0.5 && odd);
            toward_zero + i32::from(up) - i32::from(down)
        };
        Some(Self { steps, format: PhantomData })
    }

    /// Steps of 2^-S px.
    #[must_use]
    pub const fn steps(self) -> i32 {
        self.steps
    }
}
