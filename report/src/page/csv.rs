//! The tables as CSV: one file for each question, a row for each choice of each scene.

use super::{File, Report};
use crate::row::{Answer, Column, Question};
use crate::run::SceneReport;

/// The files of all questions that are answered.
pub(super) fn files(report: &Report) -> Vec<File> {
    let mut questions: Vec<Question> = Vec::new();
    for answer in report.scenes.iter().flat_map(|scene| &scene.answers) {
        if !questions.contains(&answer.question) {
            questions.push(answer.question);
        }
    }
    questions.iter().map(|question| of_question(report, question)).collect()
}

fn of_question(report: &Report, question: &Question) -> File {
    let mut rows = vec![heading(question)];
    for scene in &report.scenes {
        for answer in scene.answers.iter().filter(|answer| answer.question == *question) {
            rows.extend(of_answer(scene, answer));
        }
    }
    File { name: format!("{}.csv", question.id), text: text(&rows) }
}

fn heading(question: &Question) -> Vec<String> {
    let first = ["scene", "size", "choice", "whose", "on_front"].map(str::to_owned);
    let last = ["memory_bytes", "frames", "min_ms", "p25_ms", "median_ms", "p75_ms", "max_ms", "note"];
    let columns = std::iter::once(&question.error).chain(question.details).map(name);
    first.into_iter().chain(columns).chain(last.map(str::to_owned)).collect()
}

/// A heading as programs like it.
pub(super) fn name(column: &Column) -> String {
    let mut name = String::new();
    for letter in column.label().chars() {
        match letter {
            'a'..='z' | '0'..='9' => name.push(letter),
            'A'..='Z' => name.push(letter.to_ascii_lowercase()),
            '%' => name.push_str("percent"),
            '^' => name.push_str("_to_"),
            '-' => name.push_str("minus"),
            _ if !name.ends_with('_') => name.push('_'),
            _ => {}
        }
    }
    name.trim_matches('_').replace("_to_minus", "_to_minus_").to_owned()
}

fn of_answer(scene: &SceneReport, answer: &Answer) -> Vec<Vec<String>> {
    let front = answer.front();
    let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    let of_row = |(place, row): (usize, &crate::row::Row)| {
        let mut fields = vec![
            scene.name.clone(),
            answer.size.clone(),
            row.name.clone(),
            row.whose.name().to_owned(),
            front.contains(&place).to_string(),
            number(row.error),
        ];
        let details = (0..answer.question.details.len()).map(|k| row.details.get(k).copied().flatten());
        fields.extend(details.map(number));
        fields.push(row.bytes.map_or(String::new(), |bytes| bytes.to_string()));
        fields.push(row.time.map_or(String::new(), |time| time.frames.to_string()));
        let times = row.time.map(|time| [time.min, time.p25, time.median, time.p75, time.max]);
        fields.extend((0..5).map(|k| times.map_or(String::new(), |times| format!("{:.6}", times[k]))));
        fields.push(row.note.clone());
        fields
    };
    answer.rows.iter().enumerate().map(of_row).collect()
}

/// Rows as text.
pub(super) fn text(rows: &[Vec<String>]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // A vector takes everything, and rows are of one length.
        let _ = writer.write_record(row);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_there_with_its_numbers() {
        let report = super::super::tests::report();
        let files = files(&report);
        assert_eq!(files.len(), 1);
        let mut reader = csv::Reader::from_reader(files[0].text.as_bytes());
        let headings: Vec<_> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        assert_eq!(headings[5..7], ["wrong_pixels_px", "largest_2_to_minus_32"]);
        let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 4);
        assert_eq!(
            rows[0].iter().take(6).collect::<Vec<_>>(),
            ["a <small> scene", "64x48", "slow, exact", "halfplane", "true", "0"]
        );
        assert_eq!(&rows[1][5], "");
        assert_eq!(&rows[1][rows[1].len() - 1], "pending: not there");
        assert_eq!(&rows[3][4], "false");
    }
}
