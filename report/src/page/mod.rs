//! The page: one file without anything from the network, the same numbers as CSV, and a summary for the
//! terminal.

mod absent;
mod answer;
mod csv;
mod html;
mod ladder;
mod numbers;
mod summary;

use crate::error::ReportError;
use crate::leaving_out::Programs;
use crate::run::SceneReport;
use crate::stiffness::Ladder;
use crate::stiffness::checks::Check;

pub use answer::plot;
pub use summary::terminal;

/// Everything that a page tells.
#[derive(Debug, Clone)]
pub struct Report {
    /// The command that made it.
    pub command: String,
    /// What was measured on.
    pub machine: String,
    /// The scenes, in the page's order.
    pub scenes: Vec<SceneReport>,
    /// The stiffness ladder; nothing where it was not climbed.
    pub ladders: Vec<Ladder>,
    /// Orders, symmetries and accumulation.
    pub checks: Vec<Check>,
    /// Linked programs, or why there are none.
    pub programs: Result<Programs, String>,
    /// Wrong pixels that a recommendation may have; without it, as few as there can be.
    pub max_error: Option<f64>,
    /// Scenes that were looked for and are not there, and why.
    pub absent: Vec<String>,
}

/// A file of a report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct File {
    /// Its name, in the report's folder.
    pub name: String,
    /// Its contents.
    pub text: String,
}

impl Report {
    /// All files: `index.html`, the CSVs and the main plot by itself.
    ///
    /// # Errors
    ///
    /// [`ReportError::Plot`] where a plot cannot be drawn.
    pub fn files(&self) -> Result<Vec<File>, ReportError> {
        let mut files = vec![File { name: "index.html".to_owned(), text: html::page(self)? }];
        files.extend(csv::files(self));
        if let Some(svg) = answer::main_plot(self)? {
            files.push(File { name: "depth.svg".to_owned(), text: svg });
        }
        Ok(files)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::leaving_out::{Executed, Program};
    use crate::row::tests::answer;
    use crate::savings::Saving;
    use crate::statistics::Errors;
    use crate::stiffness::{Judged, Promise, Step};
    use halfplane::Statistics;
    use halfplane_measure::protocol::Summary;

    fn ladder() -> Ladder {
        let mut depth = [Errors::default(); 6];
        for (place, errors) in depth.iter_mut().enumerate() {
            errors.add(place as f64 / 4.0);
        }
        let judged = Judged { samples: 9, wrong: [0, 3, 1], depth };
        let steps = vec![Step { k: 4, judged, ms: 0.5, ratio: 1.25 }];
        Ladder { id: "needles", title: "Needles", about: "2^k & more.", promise: Promise::Exact, steps }
    }

    pub(crate) fn report() -> Report {
        let scene = SceneReport {
            name: "a <small> scene".to_owned(),
            size: (64, 48),
            triangles: 3,
            vertices: 9,
            statistics: Statistics::default(),
            decided_in_integers: 5,
            clear: Summary { frames: 3, min: 0.5, ..Summary::default() },
            savings: vec![Saving { name: "no & such", saved: 1, of: 4, unit: "triangles" }],
            answers: vec![answer()],
            seconds: 1.0,
        };
        let check = Check { name: "one < another", compared: 64, unit: "samples", differences: 0 };
        let program = Program {
            name: "depth",
            what: "depth D32",
            target: "here".to_owned(),
            code: 12_345,
            constants: 6,
            statics: 7,
            instructions: None,
            executed: Err("not measured: x < y".to_owned()),
            helpers: vec!["__udivdi3".to_owned()],
        };
        let run = Program { name: "run", executed: Ok(Executed::KNOWN), ..program.clone() };
        Report {
            command: "halfplane report".to_owned(),
            machine: "a machine".to_owned(),
            scenes: vec![scene],
            ladders: vec![ladder()],
            checks: vec![check],
            programs: Ok(Programs {
                compiler: "rustc".to_owned(),
                linked: vec![program, run],
                skipped: Some("elsewhere: skipped, because a & b".to_owned()),
            }),
            max_error: None,
            absent: vec!["castle: there is no \"castle.bin\"".to_owned()],
        }
    }

    #[test]
    fn the_files_are_the_page_and_a_table_for_each_question() {
        let files = report().files().unwrap();
        let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!(
            names,
            ["index.html", "bits.csv", "savings.csv", "stiffness.csv", "checks.csv", "programs.csv"]
        );
        assert!(files.iter().all(|file| !file.text.is_empty()));
    }

    #[test]
    fn programs_have_their_numbers_or_the_reason_for_none() {
        let files = report().files().unwrap();
        let [page, .., programs] = &files[..] else { panic!("{files:?}") };
        let rows: Vec<_> = programs.text.lines().collect();
        assert_eq!(rows[1], "depth,depth D32,here,12345,6,7,,,,,,,,__udivdi3,not measured: x < y");
        assert_eq!(rows[2], "run,depth D32,here,12345,6,7,96,1288,15.5,,,,,__udivdi3,");
        assert!(page.text.contains("<td>96</td><td>1288</td><td>15.50</td>"), "{}", page.text);
        assert!(page.text.contains("colspan=\"3\">not measured: x &lt; y</td>"), "{}", page.text);
        assert!(page.text.contains("elsewhere: skipped, because a &amp; b."), "{}", page.text);
    }
}
