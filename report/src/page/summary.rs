//! What to choose, in a few lines: for the top of the page and for the terminal.

use std::fmt::Write as _;

use super::Report;
use super::numbers::{figure, ms};
use crate::recommendation::recommend;
use crate::row::{Answer, Row};
use crate::run::SceneReport;

/// A row in words: name, error and time.
pub(super) fn in_words(answer: &Answer, row: &Row) -> String {
    let time = row.time.as_ref().map_or("no time".to_owned(), |time| format!("{} ms", ms(time.min)));
    let error = row.error.map_or("error unknown".to_owned(), |error| {
        let unit = answer.question.error.unit;
        format!("{} {unit}", figure(error))
    });
    format!("{}: {error}, {time}", row.name)
}

/// One line for each question: its Pareto front.
pub(super) fn fronts(scene: &SceneReport) -> Vec<(&Answer, Vec<String>)> {
    let of = |answer: &'_ Answer| -> Vec<String> {
        answer.front().into_iter().map(|place| in_words(answer, &answer.rows[place])).collect()
    };
    scene.answers.iter().map(|answer| (answer, of(answer))).collect()
}

/// The summary for a terminal.
#[must_use]
pub fn terminal(report: &Report) -> String {
    let mut text = format!("measured on: {}\n", report.machine);
    for scene in &report.scenes {
        let _ = writeln!(
            text,
            "\n{}, {}x{}: {} triangles, {} drawn",
            scene.name, scene.size.0, scene.size.1, scene.triangles, scene.statistics.drawn
        );
        for (answer, front) in fronts(scene) {
            let _ = writeln!(text, "  {}; {}", answer.question.title, answer.question.error.label());
            for line in front {
                let _ = writeln!(text, "    front: {}", line.replace('\u{2009}', " "));
            }
        }
    }
    for scene in &report.scenes {
        if let Some(recommended) = recommend(scene, report.max_error) {
            let _ = writeln!(text, "\nrecommended for {}: {}", scene.name, recommended.text());
        }
    }
    for absent in &report.absent {
        let _ = writeln!(text, "\nleft out: {absent}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_named() {
        let text = terminal(&super::super::tests::report());
        let lines: Vec<_> = text.lines().filter(|line| line.contains("front: ")).collect();
        assert_eq!(lines, ["    front: fast <b>: 7 px, 1.00 ms", "    front: slow, exact: 0 px, 5.00 ms"]);
        assert!(text.contains("left out: castle"), "{text}");
    }
}
