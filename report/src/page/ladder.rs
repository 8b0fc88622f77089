//! The stiffness ladder's part of the page.

use std::fmt::Write as _;

use super::numbers::{figure, ms};
use crate::error::ReportError;
use crate::plots::escaped;
use crate::plots::rungs::{self, Series};
use crate::stiffness::checks::Check;
use crate::stiffness::{Ladder, Promise, Step};

/// What is promised of a depth, in units of 2^-32.
pub(super) const BOUND: f64 = 1.01;

/// Columns of the tables and the file; the first two are about the rung.
pub(super) const COLUMNS: [&str; 14] = [
    "k",
    "samples",
    "wrong samples",
    "wrong, f32 edges",
    "wrong, f64 edges",
    "depth D32",
    "margin to 1.01",
    "depth D16",
    "f32 barycentric",
    "f32 gradient",
    "f64 gradient",
    "exact rational",
    "time (ms)",
    "time, of good ones",
];

/// A rung's numbers in the order of [`COLUMNS`].
pub(super) fn numbers(step: &Step) -> [f64; 14] {
    let [ours32, ours16, bary, grad32, grad64, rational] = step.judged.depth.map(|errors| errors.largest);
    let [wrong, single, double] = step.judged.wrong.map(|count| count as f64);
    [
        f64::from(step.k),
        step.judged.samples as f64,
        wrong,
        single,
        double,
        ours32,
        BOUND - ours32,
        ours16,
        bary,
        grad32,
        grad64,
        rational,
        step.ms,
        step.ratio,
    ]
}

/// The worst of a family, by column.
fn worst(ladder: &Ladder, column: usize) -> f64 {
    ladder.steps.iter().map(|step| numbers(step)[column]).fold(f64::MIN, f64::max)
}

/// The section.
pub(super) fn section(ladders: &[Ladder], checks: &[Check]) -> Result<String, ReportError> {
    let mut html = String::from(
        "<section aria-labelledby=\"stiffness\">\n<h2 id=\"stiffness\">Stiffness ladder</h2>\n<p>Families of triangles \
         that get worse by powers of two, up to what can be represented. Errors are the largest over all samples of a \
         rung: of depth in units of 2<sup>-32</sup> against the exact rational depth of the snapped triangle; of \
         coverage in samples, against the exact triangle. Time is beside that of as many right triangles with equal \
         legs that cover as many samples, plain arrays for lanes.</p>\n",
    );
    html.push_str(&overview(ladders));
    html.push_str(
        "<ul class=\"legend\"><li><i style=\"border-color:var(--series-0)\"></i>halfplane</li>\
         <li><i style=\"border-color:var(--series-1)\"></i>f32 barycentric, or f32 edges</li>\
         <li><i style=\"border-color:var(--series-5)\"></i>f32 gradient</li>\
         <li><i style=\"border-color:var(--series-3)\"></i>f64 gradient, or f64 edges</li>\
         <li><i class=\"line\"></i>dashed: what is promised, 1.01</li></ul>\n<div class=\"grid\">\n",
    );
    for ladder in ladders {
        html.push_str(&figure_of(ladder)?);
    }
    html.push_str("</div>\n");
    for ladder in ladders {
        html.push_str(&table(ladder));
    }
    html.push_str(&of_checks(checks));
    html.push_str("</section>\n");
    Ok(html)
}

fn promise(promise: Promise) -> &'static str {
    match promise {
        Promise::Exact => "samples exact, depth within 1.01",
        Promise::Samples => "samples exact",
        Promise::Measured => "measured only",
    }
}

fn overview(ladders: &[Ladder]) -> String {
    let mut html = String::from(
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Stiffness overview\">\n<table>\n<caption>The \
         worst of each family. Depth errors in units of 2<sup>-32</sup>. <a href=\"stiffness.csv\">CSV</a></caption>\n\
         <thead><tr><th scope=\"col\" class=\"text\">family</th><th scope=\"col\" class=\"text\">promise</th>\
         <th scope=\"col\">wrong samples, of</th><th scope=\"col\">wrong, f32 edges</th>\
         <th scope=\"col\">depth D32</th><th scope=\"col\">margin to 1.01</th><th scope=\"col\">f32 barycentric</th>\
         <th scope=\"col\">f32 gradient</th><th scope=\"col\">f64 gradient</th>\
         <th scope=\"col\">time, of good ones</th></tr></thead>\n<tbody>\n",
    );
    for ladder in ladders {
        let total = |column: usize| ladder.steps.iter().map(|step| numbers(step)[column]).sum::<f64>();
        let depth = worst(ladder, 5);
        let _ = writeln!(
            html,
            "<tr><th scope=\"row\"><a href=\"#family-{}\">{}</a></th><td class=\"text\">{}</td><td>{}, {}</td><td>{}</td>\
             <td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            ladder.id,
            escaped(ladder.title),
            promise(ladder.promise),
            figure(total(2)),
            figure(total(1)),
            figure(total(3)),
            figure(depth),
            figure(BOUND - depth),
            figure(worst(ladder, 8)),
            figure(worst(ladder, 9)),
            figure(worst(ladder, 10)),
            figure((worst(ladder, 13) * 100.0).round() / 100.0)
        );
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
    html
}

fn figure_of(ladder: &Ladder) -> Result<String, ReportError> {
    let line = |name, colour, column: usize| Series {
        name,
        colour,
        points: ladder.steps.iter().map(|step| (step.k, numbers(step)[column])).collect(),
    };
    let (series, axis, bound) = if ladder.promise == Promise::Exact {
        let series = vec![
            line("halfplane", 0, 5),
            line("f32 barycentric", 1, 8),
            line("f32 gradient", 5, 9),
            line("f64 gradient", 3, 10),
        ];
        (series, "largest depth error (2^-32)", Some(BOUND))
    } else {
        let series = vec![line("halfplane", 0, 2), line("f32 edges", 1, 3), line("f64 edges", 3, 4)];
        (series, "wrong samples", None)
    };
    let ends: Vec<String> = series
        .iter()
        .map(|series| {
            format!("{} {}", series.name, figure(series.points.last().map_or(0.0, |point| point.1)))
        })
        .collect();
    let title = format!("{}: {axis} by rung; at the last, {}", ladder.title, ends.join(", "));
    let svg = rungs::draw(&title, ["k", axis], &series, bound)
        .map_err(|error| ReportError::Plot(error.to_string()))?;
    Ok(format!(
        "<figure class=\"small\">\n{svg}\n<figcaption><strong>{}</strong>. {}</figcaption>\n</figure>\n",
        escaped(ladder.title),
        escaped(ladder.about)
    ))
}

fn table(ladder: &Ladder) -> String {
    let mut html = format!(
        "<details id=\"family-{0}\">\n<summary>{1}: every rung</summary>\n<div class=\"scroll\" tabindex=\"0\" role=\"group\" \
         aria-label=\"{1} table\">\n<table>\n<caption>{2}</caption>\n<thead><tr>",
        ladder.id,
        escaped(ladder.title),
        escaped(ladder.about)
    );
    for column in COLUMNS {
        let _ = write!(html, "<th scope=\"col\">{column}</th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for step in &ladder.steps {
        html.push_str("<tr>");
        for (column, number) in numbers(step).into_iter().enumerate() {
            let shown = match column {
                0 => format!("{}", step.k),
                12 => ms(number),
                13 => format!("{number:.2}"),
                _ => figure(number),
            };
            let _ = write!(html, "<td>{shown}</td>");
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n</details>\n");
    html
}

fn of_checks(checks: &[Check]) -> String {
    let mut html = String::from(
        "<h3 id=\"checks\">Order, symmetry, accumulation</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"group\" \
         aria-label=\"Checks\">\n<table>\n<caption>What must change nothing, over every rung of the ladder's window \
         triangles. <a href=\"checks.csv\">CSV</a></caption>\n<thead><tr><th scope=\"col\" class=\"text\">check</th>\
         <th scope=\"col\">compared</th><th scope=\"col\">differ</th></tr></thead>\n<tbody>\n",
    );
    for check in checks {
        let bad = if check.differences == 0 { "" } else { " class=\"bad\"" };
        let _ = writeln!(
            html,
            "<tr><th scope=\"row\">{}</th><td>{} {}</td><td{bad}>{}</td></tr>",
            escaped(check.name),
            figure(check.compared as f64),
            check.unit,
            figure(check.differences as f64)
        );
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
    html
}
