//! What is measured: one row for each choice.

use halfplane_measure::protocol::{Frame, Summary};

use crate::pareto::{self, Point};

/// A question that a table answers: what one gives and gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Question {
    /// In file names and links.
    pub id: &'static str,
    /// The heading.
    pub title: &'static str,
    /// What is compared with what, in a few sentences.
    pub about: &'static str,
    /// The error that the plot shows.
    pub error: Column,
    /// What else is told of each row.
    pub details: &'static [Column],
}

/// A column of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Its heading.
    pub name: &'static str,
    /// Its unit; empty for a count that the heading names.
    pub unit: &'static str,
}

impl Column {
    /// A column of that name and unit.
    #[must_use]
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, unit }
    }

    /// Both, as axes and headings show them.
    #[must_use]
    pub fn label(&self) -> String {
        if self.unit.is_empty() { self.name.to_owned() } else { format!("{} ({})", self.name, self.unit) }
    }
}

/// Whose a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Whose {
    /// This crate's.
    Ours,
    /// Written here for the comparison.
    Textbook,
    /// Another crate's.
    Peer,
}

impl Whose {
    /// In tables and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ours => "halfplane",
            Self::Textbook => "textbook",
            Self::Peer => "peer",
        }
    }
}

/// One choice and what it gives.
#[derive(Debug, Clone)]
pub struct Row {
    /// What it is.
    pub name: String,
    /// Whose it is.
    pub whose: Whose,
    /// In the question's unit; none where it could not be measured.
    pub error: Option<f64>,
    /// In the order of the question's columns.
    pub details: Vec<Option<f64>>,
    /// Memory of a frame: attachments, and what is kept of the vertices and of the mesh.
    pub bytes: Option<usize>,
    /// Frames; none where there are none.
    pub time: Option<Summary>,
    /// Why something is not there, or what else is to be known.
    pub note: String,
}

impl Row {
    /// Of ours, with nothing known of it yet.
    #[must_use]
    pub fn new(name: impl Into<String>, whose: Whose) -> Self {
        let name = name.into();
        Self { name, whose, error: None, details: Vec::new(), bytes: None, time: None, note: String::new() }
    }

    /// A choice that cannot be measured, and why.
    #[must_use]
    pub fn pending(name: impl Into<String>, whose: Whose, reason: &str) -> Self {
        Self { note: format!("pending: {reason}"), ..Self::new(name, whose) }
    }

    /// Error and time, where both are known.
    #[must_use]
    pub fn point(&self) -> Option<Point> {
        Some(Point { error: self.error?, time: self.time.as_ref()?.min })
    }
}

/// A row, and the frames that are still to be timed.
pub struct Entry<'a> {
    /// The row without its time.
    pub row: Row,
    /// Its frames.
    pub frame: Option<Frame<'a>>,
}

impl<'a> Entry<'a> {
    /// A row with frames.
    pub fn new(row: Row, frame: impl FnMut(u64) + 'a) -> Self {
        Self { row, frame: Some(Box::new(frame)) }
    }
}

impl From<Row> for Entry<'_> {
    fn from(row: Row) -> Self {
        Self { row, frame: None }
    }
}

/// A question and its answers.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The question.
    pub question: Question,
    /// The picture's size, as `1280x720`.
    pub size: String,
    /// In the order of the tables.
    pub rows: Vec<Row>,
}

impl Answer {
    /// Places of the rows that no other beats in both error and time, by time.
    #[must_use]
    pub fn front(&self) -> Vec<usize> {
        let known: Vec<(usize, Point)> =
            self.rows.iter().enumerate().filter_map(|(place, row)| Some((place, row.point()?))).collect();
        let points: Vec<Point> = known.iter().map(|(_, point)| *point).collect();
        pareto::front(&points).into_iter().map(|place| known[place].0).collect()
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) const QUESTION: Question = Question {
        id: "bits",
        title: "Bits & pieces",
        about: "A < B.",
        error: Column::new("wrong pixels", "px"),
        details: &[Column::new("largest", "2^-32")],
    };

    pub(crate) fn row(name: &str, error: Option<f64>, ms: Option<f64>) -> Row {
        let time = ms.map(|min| Summary { frames: 3, min, median: min, max: min, ..Summary::default() });
        Row { error, time, details: vec![error], ..Row::new(name, Whose::Ours) }
    }

    pub(crate) fn answer() -> Answer {
        let rows = vec![
            row("slow, exact", Some(0.0), Some(5.0)),
            Row::pending("later", Whose::Ours, "not there"),
            row("fast <b>", Some(7.0), Some(1.0)),
            row("beaten", Some(9.0), Some(2.0)),
        ];
        Answer { question: QUESTION, size: "64x48".to_owned(), rows }
    }

    #[test]
    fn rows_without_a_time_are_not_on_the_front() {
        assert_eq!(answer().front(), [2, 0]);
    }
}
