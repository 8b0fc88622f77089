//! One question's plot and table.

use std::fmt::Write as _;

use super::Report;
use super::numbers::{bytes, figure, ms};
use crate::error::ReportError;
use crate::plots::escaped;
use crate::plots::scatter::{self, Dot};
use crate::plots::svg::Place;
use crate::row::{Answer, Whose};

/// The colour of whose a row is.
const fn colour(whose: Whose) -> usize {
    match whose {
        Whose::Ours => 0,
        Whose::Textbook => 1,
        Whose::Peer => 2,
    }
}

/// Error against time.
///
/// # Errors
///
/// [`ReportError::Plot`].
pub fn plot(answer: &Answer, scene: &str, place: Place) -> Result<String, ReportError> {
    let front = answer.front();
    let dot = |(number, row): (usize, &crate::row::Row)| {
        let time = row.time.as_ref()?;
        Some(Dot {
            number: number + 1,
            name: row.name.clone(),
            x: time.min,
            spread: [time.p25, time.p75],
            y: row.error?,
            colour: colour(row.whose),
            front: front.contains(&number),
        })
    };
    let dots: Vec<Dot> = answer.rows.iter().enumerate().filter_map(dot).collect();
    let names: Vec<&str> = front.iter().map(|&place| answer.rows[place].name.as_str()).collect();
    let title = format!(
        "{}, {scene}: {} against time of a frame. Not beaten: {}",
        answer.question.title,
        answer.question.error.label(),
        names.join("; ")
    );
    let axes = ["time of a frame (ms, shortest of the run)", &answer.question.error.label()];
    scatter::draw(&title, axes, &dots, place).map_err(|error| ReportError::Plot(error.to_string()))
}

/// The plot that says most, by itself: depth of the first scene.
pub(super) fn main_plot(report: &Report) -> Result<Option<String>, ReportError> {
    let found = report.scenes.first().and_then(|scene| Some((scene, scene.answer("depth")?)));
    found.map(|(scene, answer)| plot(answer, &scene.name, Place::Alone)).transpose()
}

/// The section of one question.
pub(super) fn section(answer: &Answer, scene: &str, id: &str) -> Result<String, ReportError> {
    let question = &answer.question;
    let mut html = format!(
        "<section aria-labelledby=\"{id}\">\n<h3 id=\"{id}\">{}</h3>\n<p>{}</p>\n",
        escaped(question.title),
        escaped(question.about)
    );
    let svg = plot(answer, scene, Place::Page)?;
    let _ = write!(
        html,
        "<figure>\n<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{} plot\">\n{svg}\n</div>\n{}\
         <figcaption>{}, {}: {} against the time of a frame. Numbers are rows of the table. Bars: half of all frames \
         lie between their ends.</figcaption>\n</figure>\n",
        escaped(question.title),
        legend(answer),
        escaped(scene),
        answer.size,
        escaped(&question.error.label())
    );
    html.push_str(&table(answer, scene));
    html.push_str("</section>\n");
    Ok(html)
}

fn legend(answer: &Answer) -> String {
    let mut html = String::from("<ul class=\"legend\">");
    for (whose, name) in [
        (Whose::Ours, "halfplane"),
        (Whose::Textbook, "textbook, for comparison"),
        (Whose::Peer, "other crates"),
    ] {
        if answer.rows.iter().any(|row| row.whose == whose && row.point().is_some()) {
            let _ =
                write!(html, "<li><i style=\"border-color:var(--series-{})\"></i>{name}</li>", colour(whose));
        }
    }
    html.push_str(
        "<li><i class=\"line\"></i>Pareto front: nothing has both less error and less time</li></ul>\n",
    );
    html
}

/// Letters of a note that stands in the table; longer ones stand below it.
const LONGEST_NOTE: usize = 40;

fn table(answer: &Answer, scene: &str) -> String {
    let question = &answer.question;
    let has_bytes = answer.rows.iter().any(|row| row.bytes.is_some());
    let has_notes = answer.rows.iter().any(|row| !row.note.is_empty());
    let mut html = format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{0} table\">\n<table>\n<caption>{0}, {1}, {2}. \
         Marked rows (★) are on the Pareto front. <a href=\"{3}.csv\">CSV</a></caption>\n<thead><tr>\
         <th scope=\"col\">#</th><th scope=\"col\" class=\"text\">choice</th><th scope=\"col\">{4}</th>",
        escaped(question.title),
        escaped(scene),
        answer.size,
        question.id,
        escaped(&question.error.label())
    );
    for column in question.details {
        let _ = write!(html, "<th scope=\"col\">{}</th>", escaped(&column.label()));
    }
    if has_bytes {
        html.push_str("<th scope=\"col\">memory</th>");
    }
    html.push_str(
        "<th scope=\"col\">time (ms, min)</th><th scope=\"col\">25 % (ms)</th><th scope=\"col\">median (ms)</th>\
         <th scope=\"col\">75 % (ms)</th><th scope=\"col\">frames</th>",
    );
    if has_notes {
        html.push_str("<th scope=\"col\" class=\"text\">note</th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    let front = answer.front();
    // Notes that would make a column too wide, or rows too tall.
    let mut below = Vec::new();
    for (place, row) in answer.rows.iter().enumerate() {
        let (class, star) = if front.contains(&place) { (" class=\"front\"", " ★") } else { ("", "") };
        let _ = write!(
            html,
            "<tr{class}><td>{}</td><th scope=\"row\">{}{star}</th>",
            place + 1,
            escaped(&row.name)
        );
        let number = |value: Option<f64>| value.map_or("–".to_owned(), figure);
        let _ = write!(html, "<td>{}</td>", number(row.error));
        for column in 0..question.details.len() {
            let _ = write!(html, "<td>{}</td>", number(row.details.get(column).copied().flatten()));
        }
        if has_bytes {
            let _ = write!(html, "<td>{}</td>", row.bytes.map_or("–".to_owned(), bytes));
        }
        match &row.time {
            Some(time) => {
                let [min, p25, median, p75] = [time.min, time.p25, time.median, time.p75].map(ms);
                let _ = write!(
                    html,
                    "<td>{min}</td><td>{p25}</td><td>{median}</td><td>{p75}</td><td>{}</td>",
                    time.frames
                );
            }
            None => html.push_str("<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td>"),
        }
        if has_notes {
            let is_long = row.note.chars().count() > LONGEST_NOTE;
            if is_long {
                below.push(row.note.as_str());
            }
            let place = format!("[{}]", below.len());
            let note = if is_long { &place } else { &row.note };
            let _ = write!(html, "<td class=\"note\">{}</td>", escaped(note));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
    for (place, note) in below.into_iter().enumerate() {
        let _ = writeln!(html, "<p class=\"note\">[{}] {}</p>", place + 1, escaped(note));
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::row::tests::answer;

    #[test]
    fn long_notes_stand_below_the_table() {
        let mut answer = answer();
        let long = "no such <format>, and so nothing that could be measured at all";
        answer.rows[0].note = long.to_owned();
        answer.rows[2].note = long.replace("nothing", "not a thing");
        let html = table(&answer, "a scene");
        let (inside, below) = html.split_once("</table>").unwrap();
        assert!(inside.contains("<td class=\"note\">[1]</td>") && inside.contains(">[2]</td>"), "{inside}");
        assert!(inside.contains("not there</td>") && !inside.contains("could be measured"), "{inside}");
        assert!(below.contains("[1] no such &lt;format&gt;, and so nothing"), "{below}");
        assert!(below.contains("[2] no such &lt;format&gt;, and so not a thing"), "{below}");
    }
}
