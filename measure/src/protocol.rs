//! How frames are timed: warm-up, then measured frames, in rounds that go from one contender to the
//! next, and the usual numbers over them.
//!
//! This file uses the standard library only and nothing of this crate.

use std::time::{Duration, Instant};

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plan {
    /// Frames that are drawn but not measured, over all rounds.
    pub warm_up: u32,
    /// Frames that are measured, over all rounds.
    pub frames: u32,
    /// The frames are divided among so many rounds. In each round every contender has its share in one
    /// go, so a slow spell of the machine meets all of them.
    pub rounds: u32,
    /// A contender that has used more than this is cut short; at least [`LEAST`] frames are measured.
    pub limit: Duration,
}

/// Fewest measured frames of a contender, whatever the limit; one per round if there are more rounds.
pub const LEAST: u32 = 3;

impl Plan {
    /// The protocol of the classic write-up on this subject: 60 frames to warm up, 600 measured.
    pub const CLASSIC: Self = Self { warm_up: 60, frames: 600, rounds: 6, limit: Duration::MAX };

    /// The plan for a contender whose frame takes about so long: in fewer rounds where each would be
    /// a single frame.
    #[must_use]
    pub fn for_frames_of(self, time: Duration) -> Self {
        let each = time.saturating_mul(self.rounds);
        Self { rounds: if each > self.limit { LEAST.min(self.rounds) } else { self.rounds }, ..self }
    }
}

/// Times of frames in milliseconds.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Summary {
    /// How many were measured.
    pub frames: u32,
    /// The shortest.
    pub min: f64,
    /// A quarter of the frames took no longer.
    pub p25: f64,
    /// Half of them.
    pub median: f64,
    /// Three quarters.
    pub p75: f64,
    /// The longest.
    pub max: f64,
    /// The sum over the number.
    pub mean: f64,
    /// The root of the mean squared distance from the mean (of all, not of a sample).
    pub sdev: f64,
}

impl Summary {
    /// Of these times; all 0 if there are none.
    #[must_use]
    pub fn of(times: &[f64]) -> Self {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (Some(&min), Some(&max)) = (sorted.first(), sorted.last()) else { return Self::default() };
        let count = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / count;
        let variance = sorted.iter().map(|t| (t - mean) * (t - mean)).sum::<f64>() / count;
        Self {
            frames: u32::try_from(sorted.len()).unwrap_or(u32::MAX),
            min,
            p25: quantile(&sorted, 0.25),
            median: quantile(&sorted, 0.5),
            p75: quantile(&sorted, 0.75),
            max,
            mean,
            sdev: variance.sqrt(),
        }
    }
}

/// Between the two nearest of the sorted times, linearly.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let at = part * (sorted.len() - 1) as f64;
    let (low, high) = (at.floor() as usize, at.ceil() as usize);
    sorted[low] + (sorted[high] - sorted[low]) * at.fract()
}

/// Draws one frame; the number counts every frame of this contender, so that cameras can move.
pub type Frame<'a> = Box<dyn FnMut(u64) + 'a>;

/// Something to be timed, and for how long.
pub struct Contender<'a> {
    /// Its frames.
    pub plan: Plan,
    /// What draws them.
    pub frame: Frame<'a>,
}

/// Times every contender by its plan; the summaries are in the contenders' order.
#[must_use]
pub fn measure(contenders: &mut [Contender<'_>]) -> Vec<Summary> {
    measure_and_tell(contenders, &mut |_| ())
}

/// [`measure`], and tells the part that is done, from 0 to 1, between the contenders' shares.
#[must_use]
pub fn measure_and_tell(contenders: &mut [Contender<'_>], tell: &mut dyn FnMut(f64)) -> Vec<Summary> {
    let shares = contenders.iter().map(|contender| contender.plan.rounds.max(1)).sum::<u32>();
    let mut done = 0u32;
    let mut runs: Vec<Run> = contenders.iter().map(|_| Run::default()).collect();
    let most = contenders.iter().map(|contender| contender.plan.rounds.max(1)).max().unwrap_or(0);
    for round in 0..most {
        for (run, Contender { plan, frame }) in runs.iter_mut().zip(contenders.iter_mut()) {
            let rounds = plan.rounds.max(1);
            if round >= rounds {
                continue;
            }
            let share = |frames: u32| frames * (round + 1) / rounds - frames * round / rounds;
            let until = plan.limit.checked_mul(round + 1).map_or(Duration::MAX, |limit| limit / rounds);
            let least = LEAST.div_ceil(rounds) * (round + 1);
            run.round(share(plan.warm_up), share(plan.frames), least, until, frame);
            done += 1;
            tell(f64::from(done) / f64::from(shares));
        }
    }
    runs.iter().map(|run| Summary::of(&run.times)).collect()
}

/// What a contender has behind it.
#[derive(Default)]
struct Run {
    times: Vec<f64>,
    drawn: u64,
    spent: Duration,
}

impl Run {
    fn round(&mut self, warm_up: u32, frames: u32, least: u32, until: Duration, frame: &mut Frame<'_>) {
        for _ in 0..warm_up {
            // A long frame needs no long warm-up: a quarter of the time at most.
            if self.spent > until / 4 {
                break;
            }
            let _ = self.one(frame);
        }
        for _ in 0..frames {
            if self.spent > until && self.times.len() >= least as usize {
                break;
            }
            let time = self.one(frame);
            self.times.push(time.as_secs_f64() * 1e3);
        }
    }

    fn one(&mut self, frame: &mut Frame<'_>) -> Duration {
        let number = self.drawn;
        self.drawn += 1;
        let started = Instant::now();
        frame(number);
        let time = started.elapsed();
        self.spent += time;
        time
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::thread::sleep;

    #[test]
    fn the_numbers_of_a_known_series() {
        let summary = Summary::of(&[4.0, 1.0, 3.0, 2.0, 5.0]);
        let Summary { frames, min, p25, median, p75, max, mean, sdev } = summary;
        assert_eq!((frames, min, p25, median, p75, max, mean), (5, 1.0, 2.0, 3.0, 4.0, 5.0, 3.0));
        assert!((sdev - 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(Summary::of(&[1.0, 2.0]).median, 1.5);
        assert_eq!(Summary::of(&[]), Summary::default());
    }

    #[test]
    fn every_contender_draws_all_its_frames_in_turns() {
        let log = Cell::new(0u64);
        let (mut first, mut second) = (Vec::new(), Vec::new());
        let tick = || log.replace(log.get() + 1);
        let plan = Plan { warm_up: 7, frames: 20, rounds: 3, limit: Duration::MAX };
        let mut contenders = [
            Contender { plan, frame: Box::new(|n| first.push((n, tick()))) },
            Contender { plan, frame: Box::new(|n| second.push((n, tick()))) },
        ];
        let mut told = Vec::new();
        let summaries = measure_and_tell(&mut contenders, &mut |done| told.push(done));
        drop(contenders);
        assert!(told.len() == 6 && told.is_sorted() && told[5] == 1.0, "{told:?}");
        assert!(summaries.iter().all(|s| s.frames == 20));
        assert!(first.iter().map(|f| f.0).eq(0..27) && second.iter().map(|f| f.0).eq(0..27));
        // The second's first round comes before the first's second.
        assert!(second[0].1 < first[26].1);
    }

    #[test]
    fn a_slow_contender_is_cut_short() {
        let plan = Plan { warm_up: 6, frames: 100, rounds: 3, limit: Duration::from_millis(6) };
        let frame: Frame<'_> = Box::new(|_| sleep(Duration::from_millis(4)));
        let frames = measure(&mut [Contender { plan, frame }])[0].frames;
        assert!((3..10).contains(&frames), "{frames}");
    }
}
