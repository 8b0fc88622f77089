//! The tables as CSV: one file for each question, a row for each choice of each scene.

use super::{File, Report, ladder};
use crate::leaving_out::Program;
use crate::row::{Answer, Column, Question};
use crate::run::SceneReport;
use crate::savings::Saving;
use crate::stiffness::Ladder;
use crate::stiffness::checks::Check;

/// The files of all questions that are answered.
pub(super) fn files(report: &Report) -> Vec<File> {
    let mut questions: Vec<Question> = Vec::new();
    for answer in report.scenes.iter().flat_map(|scene| &scene.answers) {
        if !questions.contains(&answer.question) {
            questions.push(answer.question);
        }
    }
    let mut files: Vec<File> = questions.iter().map(|question| of_question(report, question)).collect();
    files.push(of_savings(report));
    if !report.ladders.is_empty() {
        files.push(of_ladders(&report.ladders));
    }
    if !report.checks.is_empty() {
        files.push(of_checks(&report.checks));
    }
    if let Ok(programs) = &report.programs {
        files.push(of_programs(&programs.linked));
    }
    files
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

fn of_ladders(ladders: &[Ladder]) -> File {
    let columns = ladder::COLUMNS.map(|column| name(&Column::new(column, "")));
    let mut rows = vec![std::iter::once("family".to_owned()).chain(columns).collect::<Vec<_>>()];
    for of in ladders {
        for step in &of.steps {
            let numbers = ladder::numbers(step).map(|number| number.to_string());
            rows.push(std::iter::once(of.id.to_owned()).chain(numbers).collect());
        }
    }
    File { name: "stiffness.csv".to_owned(), text: text(&rows) }
}

fn of_checks(checks: &[Check]) -> File {
    let mut rows = vec![["check", "compared", "unit", "differences"].map(str::to_owned).to_vec()];
    for check in checks {
        let (compared, differences) = (check.compared.to_string(), check.differences.to_string());
        rows.push(vec![check.name.to_owned(), compared, check.unit.to_owned(), differences]);
    }
    File { name: "checks.csv".to_owned(), text: text(&rows) }
}

fn of_savings(report: &Report) -> File {
    let mut rows = vec![["scene", "size", "saved", "number", "of", "unit"].map(str::to_owned).to_vec()];
    for scene in &report.scenes {
        for Saving { name, saved, of, unit } in &scene.savings {
            let (size, numbers) =
                (format!("{}x{}", scene.size.0, scene.size.1), [saved, of].map(u64::to_string));
            let [saved, of] = numbers;
            rows.push(vec![scene.name.clone(), size, (*name).to_owned(), saved, of, (*unit).to_owned()]);
        }
    }
    File { name: "savings.csv".to_owned(), text: text(&rows) }
}

fn of_programs(programs: &[Program]) -> File {
    let heading = [
        "program",
        "has",
        "target",
        "code_bytes",
        "constant_bytes",
        "static_bytes",
        "deepest_stack_bytes",
        "instructions_per_triangle",
        "instructions_per_pixel",
        "instructions_in_the_file",
        "divisions",
        "of_floats",
        "in_vector_registers",
        "helpers",
        "note",
    ];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    for program in programs {
        let sizes = [program.code, program.constants, program.statics].map(|size| size.to_string());
        let executed = program.executed.as_ref().ok();
        let executed = executed.map(|of| [of.stack as f64, of.per_triangle(), of.per_pixel()]);
        let counts = program.instructions.map(|of| [of.total, of.divisions, of.floats, of.vectors]);
        let mut row = vec![program.name.to_owned(), program.what.to_owned(), program.target.clone()];
        row.extend(sizes);
        row.extend((0..3).map(|k| executed.map_or(String::new(), |numbers| numbers[k].to_string())));
        row.extend((0..4).map(|k| counts.map_or(String::new(), |counts| counts[k].to_string())));
        row.push(program.helpers.join(" "));
        row.push(program.executed.as_ref().err().cloned().unwrap_or_default());
        rows.push(row);
    }
    File { name: "programs.csv".to_owned(), text: text(&rows) }
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
        assert_eq!(files.len(), 5);
        assert!(files[2].text.starts_with("family,k,samples,wrong_samples,"), "{}", files[2].text);
        assert!(files[2].text.contains("\nneedles,4,9,0,3,1,0,1.01,0.25,"), "{}", files[2].text);
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
