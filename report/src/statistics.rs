//! Errors of many samples in three numbers.

/// The largest and the mean of absolute errors.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Errors {
    /// How many there are.
    pub count: u64,
    /// The largest.
    pub largest: f64,
    sum: f64,
}

impl Errors {
    /// Adds one, whatever its sign; what is no number counts as infinite.
    pub fn add(&mut self, error: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error.abs() };
        self.count += 1;
        self.sum += error;
        self.largest = self.largest.max(error);
    }

    /// The sum over the number; 0 of none.
    #[must_use]
    pub fn mean(&self) -> f64 {
        if self.count == 0 { 0.0 } else { self.sum / self.count as f64 }
    }
}

/// In how many places two pictures differ, and in how many of those one of them has nothing.
#[must_use]
pub fn differences(given: &[u32], expected: &[u32], nothing: u32) -> (u64, u64) {
    let mut differing = (0, 0);
    for (&given, &expected) in given.iter().zip(expected) {
        if given != expected {
            differing.0 += 1;
            differing.1 += u64::from(given == nothing || expected == nothing);
        }
    }
    differing
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_known_errors() {
        let mut errors = Errors::default();
        assert_eq!((errors.mean(), errors.largest), (0.0, 0.0));
        for error in [1.0, -4.0, 0.0, 3.0] {
            errors.add(error);
        }
        assert_eq!((errors.count, errors.mean(), errors.largest), (4, 2.0, 4.0));
        errors.add(f64::NAN);
        assert_eq!(errors.largest, f64::INFINITY);
    }

    #[test]
    fn differences_are_counted_by_kind() {
        assert_eq!(differences(&[1, 2, 9, 4, 9], &[1, 3, 3, 9, 9], 9), (3, 2));
        assert_eq!(differences(&[], &[], 9), (0, 0));
    }
}
