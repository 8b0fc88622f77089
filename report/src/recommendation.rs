//! The cheapest configuration that keeps the error one asked for.

use std::fmt::Write as _;

use crate::choices::{CONFIGURATIONS, Configuration, configuration};
use crate::row::Row;
use crate::run::SceneReport;

/// What to write, and what it was measured to give.
#[derive(Debug, Clone)]
pub struct Recommendation {
    /// What to write.
    pub configuration: Configuration,
    /// The row it was measured in.
    pub row: Row,
    /// Wrong pixels that were allowed.
    pub allowed: f64,
    /// Whether nothing kept that, so that this is the one with the fewest.
    pub exceeded: bool,
}

/// Chooses for a scene: the fastest row whose wrong pixels are at most so many; if there is none, the one with
/// the fewest. Without a limit, as few as any configuration gets. `None` where nothing was measured.
#[must_use]
pub fn recommend(scene: &SceneReport, max_error: Option<f64>) -> Option<Recommendation> {
    let answer = scene.answer(CONFIGURATIONS.id)?;
    let measured: Vec<(&Row, f64, f64)> = answer
        .rows
        .iter()
        .filter_map(|row| row.point().map(|point| (row, point.error, point.time)))
        .collect();
    let fewest = measured.iter().map(|&(_, error, _)| error).fold(f64::INFINITY, f64::min);
    let allowed = max_error.unwrap_or(fewest);
    let exceeded = fewest > allowed;
    let limit = if exceeded { fewest } else { allowed };
    let kept = measured.into_iter().filter(|&(_, error, _)| error <= limit);
    let (row, ..) = kept.min_by(|a, b| a.2.total_cmp(&b.2))?;
    let configuration = configuration(&row.name)?;
    Some(Recommendation { configuration, row: row.clone(), allowed, exceeded })
}

impl Recommendation {
    /// The line of `Cargo.toml`.
    #[must_use]
    pub fn dependency(&self) -> String {
        match self.configuration.features {
            "" => "halfplane = \"0.1\"".to_owned(),
            features => format!("halfplane = {{ version = \"0.1\", {features} }}"),
        }
    }

    /// All of it, as text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        let Row { name, error, time, .. } = &self.row;
        let error = error.unwrap_or(f64::NAN);
        let time = time.map_or(f64::NAN, |time| time.min);
        if self.exceeded {
            let _ = writeln!(
                text,
                "nothing keeps {} wrong pixels; the fewest, {error}, has: {name}, {time:.3} ms",
                self.allowed
            );
        } else {
            let _ = writeln!(
                text,
                "the fastest with at most {} wrong pixels: {name} ({error} wrong, {time:.3} ms)",
                self.allowed
            );
        }
        let _ = writeln!(text, "Cargo.toml: {}", self.dependency());
        text.push_str(self.configuration.code);
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::choices::ALL_CONFIGURATIONS;
    use crate::page::tests::report;
    use crate::row::Answer;
    use crate::row::tests::row;

    fn scene(rows: &[(usize, f64, f64)]) -> SceneReport {
        let rows = rows
            .iter()
            .map(|&(place, error, ms)| row(ALL_CONFIGURATIONS[place].name, Some(error), Some(ms)))
            .collect();
        let answer = Answer { question: CONFIGURATIONS, size: "64x48".to_owned(), rows };
        SceneReport { answers: vec![answer], ..report().scenes.remove(0) }
    }

    #[test]
    fn the_fastest_within_the_error_is_chosen() {
        let scene = scene(&[(0, 5.0, 2.0), (1, 90.0, 1.5), (4, 5.0, 9.0)]);
        let of = |max_error| recommend(&scene, max_error).unwrap();
        assert_eq!(of(None).row.name, ALL_CONFIGURATIONS[0].name);
        assert_eq!(of(Some(5.0)).row.name, ALL_CONFIGURATIONS[0].name);
        assert_eq!(of(Some(100.0)).row.name, ALL_CONFIGURATIONS[1].name);
        let least = of(Some(1.0));
        assert!(least.exceeded && least.row.name == ALL_CONFIGURATIONS[0].name);
        assert!(least.text().contains("nothing keeps 1 wrong pixels"), "{}", least.text());
        assert!(
            of(None).text().contains("halfplane = { version = \"0.1\", features = [\"simd\", \"std\"] }")
        );
    }

    #[test]
    fn without_rows_there_is_no_recommendation() {
        assert!(recommend(&scene(&[]), None).is_none());
    }
}
