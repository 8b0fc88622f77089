//! Logarithmic scales in pixels, with a place for 0.

/// Maps numbers to pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Exponents of ten at the ends.
    low: f64,
    high: f64,
    /// Pixels of the ends.
    from: f64,
    to: f64,
    /// Pixel of 0, where the scale has it.
    zero: Option<f64>,
}

/// A mark on an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// Its pixel.
    pub at: i32,
    /// What stands there; empty for a line of the grid alone.
    pub label: String,
}

/// Pixels between 0 and the smallest decade.
const GAP: f64 = 34.0;

impl Scale {
    /// For these numbers between two pixels. Zeros, if there are any, or if `zero`, have a place of their own at
    /// `from`; what is neither positive nor 0 has none.
    #[must_use]
    pub fn new(values: &[f64], zero: bool, [from, to]: [i32; 2]) -> Self {
        let positive = || values.iter().copied().filter(|v| v.is_finite() && *v > 0.0).map(f64::log10);
        let (mut low, mut high) =
            (positive().fold(f64::INFINITY, f64::min), positive().fold(f64::MIN, f64::max));
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        let room = f64::max(0.06 * (high - low), 0.12);
        (low, high) = (low - room, high + room);
        let (mut from, to) = (f64::from(from), f64::from(to));
        let zero = (zero || values.contains(&0.0)).then_some(from);
        if zero.is_some() {
            from += GAP * (to - from).signum();
        }
        Self { low, high, from, to, zero }
    }

    /// The pixel of a number.
    #[must_use]
    pub fn at(&self, value: f64) -> Option<i32> {
        if value == 0.0 {
            return self.zero.map(|at| at as i32);
        }
        if !value.is_finite() || value < 0.0 {
            return None;
        }
        let part = (value.log10() - self.low) / (self.high - self.low);
        Some((self.from + part.clamp(0.0, 1.0) * (self.to - self.from)).round() as i32)
    }

    /// 0, if it has a place, and the powers of ten, or so many of them as have room; where there are few, 2 and
    /// 5 times them too.
    #[must_use]
    pub fn ticks(&self) -> Vec<Tick> {
        let zero = self.zero.map(|at| Tick { at: at as i32, label: "0".to_owned() });
        let mut ticks: Vec<Tick> = zero.into_iter().collect();
        let decades = self.high - self.low;
        let every = (decades * 34.0 / (self.to - self.from).abs()).ceil().max(1.0) as i32;
        let first = self.low.floor() as i32;
        for exponent in first..=self.high.ceil() as i32 {
            for times in [1.0, 2.0, 5.0] {
                let value = times * 10f64.powi(exponent);
                let inside = (self.low..=self.high).contains(&value.log10());
                if !inside || times > 1.0 && decades > 2.5 || exponent.rem_euclid(every) != 0 {
                    continue;
                }
                if let Some(at) = self.at(value) {
                    ticks.push(Tick { at, label: super::power(value) });
                }
            }
        }
        ticks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nought_has_a_place_below_all_others() {
        let scale = Scale::new(&[0.0, 1.0, 1000.0], false, [400, 0]);
        assert_eq!(scale.at(0.0), Some(400));
        let [one, thousand] = [1.0, 1000.0].map(|v| scale.at(v).unwrap());
        assert!(one < 400 - 30 && thousand < one && thousand > 0, "{one} {thousand}");
        let labels: Vec<_> = scale.ticks().into_iter().map(|tick| tick.label).collect();
        assert_eq!(labels, ["0", "1", "10", "100", "1000"]);
        assert_eq!(scale.at(f64::NAN), None);
        assert_eq!(scale.at(-1.0), None);
    }

    #[test]
    fn a_scale_of_one_number_or_none_is_one() {
        let scale = Scale::new(&[3.0], false, [0, 100]);
        assert!((45..=55).contains(&scale.at(3.0).unwrap()));
        assert_eq!(scale.at(0.0), None);
        assert!(!Scale::new(&[], true, [0, 100]).ticks().is_empty());
    }
}
