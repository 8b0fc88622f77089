//! The page: one file without anything from the network, the same numbers as CSV, and a summary for the
//! terminal.

mod answer;
mod csv;
mod html;
mod numbers;
mod summary;

use crate::error::ReportError;
use crate::run::SceneReport;

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
    use crate::row::tests::answer;
    use halfplane::Statistics;
    use halfplane_measure::protocol::Summary;

    pub(crate) fn report() -> Report {
        let scene = SceneReport {
            name: "a <small> scene".to_owned(),
            size: (64, 48),
            triangles: 3,
            vertices: 9,
            statistics: Statistics::default(),
            decided_in_integers: 5,
            clear: Summary { frames: 3, min: 0.5, ..Summary::default() },
            answers: vec![answer()],
            seconds: 1.0,
        };
        Report {
            command: "halfplane report".to_owned(),
            machine: "a machine".to_owned(),
            scenes: vec![scene],
            absent: vec!["castle: there is no \"castle.bin\"".to_owned()],
        }
    }

    #[test]
    fn the_files_are_the_page_and_a_table_for_each_question() {
        let files = report().files().unwrap();
        let names: Vec<_> = files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!(names, ["index.html", "bits.csv"]);
        assert!(files.iter().all(|file| !file.text.is_empty()));
    }
}
