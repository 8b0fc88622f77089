//! The Pareto front: of what was measured, those that nothing else beats in both error and time.

/// A measured choice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// At least 0; less is better.
    pub error: f64,
    /// Less is better.
    pub time: f64,
}

impl Point {
    /// Whether it is at least as good in both and better in one.
    #[must_use]
    pub fn beats(self, other: Self) -> bool {
        self.error <= other.error
            && self.time <= other.time
            && (self.error < other.error || self.time < other.time)
    }
}

/// Places of the points that no other beats, by time. Points that are no numbers are never among them;
/// equal ones all are.
#[must_use]
pub fn front(points: &[Point]) -> Vec<usize> {
    let is_number = |point: &Point| !point.error.is_nan() && !point.time.is_nan();
    let mut front: Vec<usize> = (0..points.len())
        .filter(|&place| {
            let point = points[place];
            is_number(&point) && !points.iter().any(|other| is_number(other) && other.beats(point))
        })
        .collect();
    front.sort_by(|&a, &b| points[a].time.total_cmp(&points[b].time));
    front
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(pairs: &[(f64, f64)]) -> Vec<Point> {
        pairs.iter().map(|&(error, time)| Point { error, time }).collect()
    }

    #[test]
    fn the_front_of_a_known_set() {
        // Exact and slow, coarse and fast, one between that is beaten, one between that is not.
        let all = points(&[(0.0, 9.0), (5.0, 1.0), (5.0, 4.0), (2.0, 3.0), (2.0, 3.5), (9.0, 9.0)]);
        assert_eq!(front(&all), [1, 3, 0]);
    }

    #[test]
    fn equal_points_share_the_front_and_no_numbers_never_do() {
        let all = points(&[(1.0, 1.0), (1.0, 1.0), (f64::NAN, 0.0), (0.0, f64::NAN)]);
        assert_eq!(front(&all), [0, 1]);
        assert_eq!(front(&[]), [] as [usize; 0]);
    }

    #[test]
    fn an_error_of_nought_in_no_time_is_the_whole_front() {
        assert_eq!(front(&points(&[(0.0, 1.0), (0.0, 2.0), (3.0, 1.0), (3.0, 1.5)])), [0]);
    }
}
