//! Tables as Markdown.

use std::fmt::Write as _;

/// A Markdown table: the first column to the left, the others to the right. None without rows.
pub(super) fn markdown(head: &[String], rows: &[Vec<String>]) -> Option<String> {
    if rows.is_empty() {
        return None;
    }
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(head);
    let _ = writeln!(text, "|---|{}", "---:|".repeat(head.len() - 1));
    rows.iter().for_each(|row| text.push_str(&line(row)));
    Some(text)
}

/// The names of columns.
pub(super) fn head(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.to_owned()).collect()
}

/// A number, or nothing.
pub(super) fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format!("{value:.digits$}"))
}
