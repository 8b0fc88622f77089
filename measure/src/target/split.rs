//! A picture's rows divided among threads by what they took the last time.

use std::{ops::Range, time::Duration};

/// Bands of rows, one for each thread, each a multiple of 4 rows but for the last.
///
/// Whoever divides evenly waits for the band with the most in it. Frames are much like the one before, so the time that
/// each band took says where they should have been divided. Any division gives the same picture.
#[derive(Debug)]
pub(super) struct Split {
    height: u32,
    /// Where bands end, in rows of blocks; strictly increasing.
    ends: Vec<u32>,
}

impl Split {
    /// Into so many bands of the same height, or as many as there are rows of blocks.
    pub(super) fn even(height: u32, bands: usize) -> Self {
        let rows = height.div_ceil(4).max(1);
        let bands = (bands as u64).clamp(1, u64::from(rows));
        let ends = (1..=bands).map(|band| (u64::from(rows) * band / bands) as u32).collect();
        Self { height, ends }
    }

    /// How many there are.
    pub(super) const fn count(&self) -> usize {
        self.ends.len()
    }

    /// The rows of pixels of each band, from the top.
    pub(super) fn bands(&self) -> impl Iterator<Item = Range<u32>> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| 4 * start..(4 * end).min(self.height))
    }

    /// Divides anew, halfway to where all bands would have taken as long as each other, had the time in each been
    /// spent evenly over its rows.
    pub(super) fn learn(&mut self, times: &[Duration]) {
        let count = self.ends.len();
        let total: f64 = times.iter().map(Duration::as_secs_f64).sum();
        if times.len() != count || total <= 0.0 {
            return;
        }
        let (old, last) = (self.ends.clone(), count - 1);
        let (mut band, mut before) = (0, 0.0);
        for (at, end) in self.ends.iter_mut().take(last).enumerate() {
            let wanted = total * (at + 1) as f64 / count as f64;
            while band < last && before + times[band].as_secs_f64() < wanted {
                before += times[band].as_secs_f64();
                band += 1;
            }
            let start = if band == 0 { 0 } else { old[band - 1] };
            let part = (wanted - before) / times[band].as_secs_f64().max(f64::MIN_POSITIVE);
            let ideal = f64::from(start) + f64::from(old[band] - start) * part.clamp(0.0, 1.0);
            *end = f64::midpoint(f64::from(*end), ideal).round() as u32;
        }
        // None is empty.
        let rows = old[last];
        let mut least = 1;
        for (at, end) in self.ends.iter_mut().enumerate() {
            *end = (*end).clamp(least, rows - (last - at) as u32);
            least = *end + 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(split: &Split) -> Vec<Range<u32>> {
        split.bands().collect()
    }

    #[test]
    fn bands_are_all_rows_once() {
        assert_eq!(rows(&Split::even(30, 2)), [0..16, 16..30]);
        // One row of blocks.
        assert_eq!(Split::even(3, 16).count(), 1);
        for (height, bands) in [(1080, 16), (720, 3), (64, 16), (61, 16), (1, 1)] {
            let mut split = Split::even(height, bands);
            // What no frame takes, too.
            for times in [[0, 0, 0], [1, 1000, 1], [1000, 0, 0], [0, 0, 1000], [0, 1, 0]] {
                let times: Vec<_> =
                    (0..split.count()).map(|at| Duration::from_micros(times[at % 3])).collect();
                split.learn(&times);
                let bands = rows(&split);
                assert_eq!((bands[0].start, bands[bands.len() - 1].end), (0, height));
                assert!(bands.windows(2).all(|two| two[0].end == two[1].start && two[0].end % 4 == 0));
                assert!(bands.iter().all(|band| !band.is_empty()), "{bands:?}");
            }
        }
    }

    /// Work that is not spread evenly: after some frames no band takes much longer than another.
    #[test]
    fn bands_take_the_same_time_after_some_frames() {
        // All of it in the upper half, and twice as much in the fourth eighth.
        let work = |rows: Range<u32>| -> u64 {
            rows.map(|row| if (270..360).contains(&row) { 2 } else { u64::from(row < 360) }).sum()
        };
        for bands in [2, 3, 8] {
            let mut split = Split::even(720, bands);
            for _ in 0..40 {
                let times: Vec<_> = split.bands().map(|band| Duration::from_micros(work(band))).collect();
                split.learn(&times);
            }
            let times: Vec<_> = split.bands().map(work).collect();
            let most = times.iter().max().copied().unwrap_or(0);
            assert!(most <= 450 / bands as u64 + 16, "{times:?}");
        }
    }
}
