//! The breakdown as rows: for people a table, for programs CSV.

use std::fmt::Write as _;
use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Part;

/// One stage of one view at one level.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The view.
    pub view: String,
    /// The level's name.
    pub level: String,
    /// The stage.
    pub part: Part,
    /// Instructions of one frame; none where they cannot be counted.
    pub instructions: Option<u64>,
    /// Milliseconds of one frame; none where they cannot be sampled.
    pub ms: Option<f64>,
}

/// The rows of one view: levels below each other, stages side by side.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    let mut text = String::new();
    let mut levels: Vec<(&str, &str)> = Vec::new();
    for row in rows {
        if !levels.contains(&(&*row.view, &*row.level)) {
            levels.push((&row.view, &row.level));
        }
    }
    let mut last = "";
    for (view, level) in levels {
        if view != last {
            let _ = write!(
                text,
                "\n== {view}, depth: thousands of instructions, and ms, of one frame\n{:22}",
                ""
            );
            for name in Part::ALL.map(Part::name).into_iter().chain(["all"]) {
                let _ = write!(text, " {name:>10}");
            }
            text.push('\n');
            last = view;
        }
        let of = |part| rows.iter().find(|row| row.view == view && row.level == level && row.part == part);
        let instructions = |part| of(part).and_then(|row| Some(row.instructions? as f64 / 1e3));
        line(&mut text, &format!("{level} instructions"), Part::ALL.map(instructions), 0);
        line(&mut text, &format!("{level} ms"), Part::ALL.map(|part| of(part).and_then(|row| row.ms)), 3);
    }
    text
}

fn line(text: &mut String, name: &str, parts: [Option<f64>; Part::ALL.len()], digits: usize) {
    let _ = write!(text, "{name:22}");
    let all = parts.iter().any(Option::is_some).then(|| parts.iter().flatten().sum());
    for part in parts.into_iter().chain([all]) {
        let _ = match part {
            Some(part) => write!(text, " {part:10.digits$}"),
            None => write!(text, " {:>10}", "-"),
        };
    }
    text.push('\n');
}

/// Writes rows as CSV.
///
/// # Errors
///
/// What the file system says.
pub fn write(path: &Path, rows: &[Row]) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    writer.flush()
}

/// Reads what [`write()`] wrote.
///
/// # Errors
///
/// The file, and what is wrong with it.
pub fn read(path: &Path) -> Result<Vec<Row>, String> {
    let read = || -> Result<Vec<Row>, csv::Error> { csv::Reader::from_path(path)?.deserialize().collect() };
    read().map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<Row> {
        let row = |level: &str, part, instructions, ms| Row {
            view: "a \"view\", 1x1".to_owned(),
            level: level.to_owned(),
            part,
            instructions,
            ms,
        };
        vec![
            row("avx512", Part::Cull, None, Some(0.25)),
            row("avx512", Part::SetUp, None, Some(0.5)),
            row("avx2", Part::Cull, Some(1_500_000), None),
        ]
    }

    #[test]
    fn what_is_written_is_read() {
        let path = std::env::temp_dir().join(format!("halfplane-breakdown-{}.csv", std::process::id()));
        write(&path, &rows()).unwrap();
        let read = read(&path);
        std::fs::remove_file(&path).unwrap();
        assert_eq!(read, Ok(rows()));
    }

    #[test]
    fn tables_say_what_is_missing() {
        let table = table(&rows());
        assert_eq!(table.lines().count(), 7, "{table}");
        assert!(table.contains("0.750") && table.contains("1500") && table.contains(" -"), "{table}");
    }
}
