//! The page itself.

use std::fmt::Write as _;

use super::Report;
use super::absent;
use super::answer;
use super::ladder;
use super::numbers::{figure, ms};
use super::summary;
use crate::error::ReportError;
use crate::plots::escaped;
use crate::recommendation::recommend;
use crate::run::SceneReport;

const STYLE: &str = include_str!("style.css");

/// The whole page.
pub(super) fn page(report: &Report) -> Result<String, ReportError> {
    let mut html = String::from("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\" />\n");
    html.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n");
    html.push_str("<title>halfplane: error against run time</title>\n<style>\n");
    html.push_str(STYLE);
    html.push_str("</style>\n</head>\n<body>\n<header>\n<h1>halfplane: error against run time</h1>\n");
    let _ = write!(
        html,
        "<p>What each choice costs and what it gives. Every error is against an exact reference in integers and \
         fractions of unbounded size; all times of a scene were taken in turns in one run, one thread.</p>\n\
         <p class=\"soft\">Made by <code>{}</code>. Measured on: {}.</p>\n</header>\n",
        escaped(&report.command),
        escaped(&report.machine)
    );
    html.push_str(&choose(report));
    html.push_str(&contents(report));
    html.push_str("<main>\n");
    for (place, scene) in report.scenes.iter().enumerate() {
        html.push_str(&of_scene(scene, place)?);
    }
    if !report.ladders.is_empty() {
        html.push_str(&ladder::section(&report.ladders, &report.checks)?);
    }
    html.push_str(&absent::programs(&report.programs));
    html.push_str("</main>\n");
    html.push_str(&how(report));
    html.push_str("</body>\n</html>\n");
    Ok(html)
}

/// What to choose.
fn choose(report: &Report) -> String {
    let mut html = String::from(
        "<section class=\"card\" aria-labelledby=\"choose\">\n<h2 id=\"choose\" style=\"border:0;margin-top:.3em\">Which configuration to \
         choose</h2>\n<p>The fastest configuration within the error that is allowed, as measured here, and for each question \
         what nothing else beats in both error and time (the Pareto front), from the fastest to the most exact.</p>\n",
    );
    for scene in &report.scenes {
        let _ = writeln!(html, "<h3>{}, {}x{}</h3>", escaped(&scene.name), scene.size.0, scene.size.1);
        if let Some(recommended) = recommend(scene, report.max_error) {
            let text = recommended.text();
            let (first, rest) = text.split_once('\n').unwrap_or((&text, ""));
            let _ = writeln!(
                html,
                "<p><strong>Take {}</strong>: {}.</p>\n<pre tabindex=\"0\">{}</pre>",
                escaped(recommended.row.name.as_str()),
                escaped(first),
                escaped(rest)
            );
        }
        html.push_str("<details><summary>Front of every question</summary>\n<ul>\n");
        for (answer, front) in summary::fronts(scene) {
            let lines: Vec<String> = front.iter().map(|line| escaped(line)).collect();
            let _ = writeln!(
                html,
                "<li><strong>{}</strong>: {}</li>",
                escaped(answer.question.title),
                lines.join("; then ")
            );
        }
        html.push_str("</ul>\n</details>\n");
    }
    html.push_str("</section>\n");
    html
}

fn anchor(scene: usize, question: &str) -> String {
    format!("scene-{}-{question}", scene + 1)
}

fn contents(report: &Report) -> String {
    let mut html = String::from("<nav aria-label=\"Contents\">\n<ul>\n");
    for (place, scene) in report.scenes.iter().enumerate() {
        let _ = writeln!(html, "<li><a href=\"#{}\">{}</a></li>", anchor(place, "top"), escaped(&scene.name));
    }
    if !report.ladders.is_empty() {
        html.push_str("<li><a href=\"#stiffness\">Stiffness ladder</a></li>\n");
    }
    html.push_str("<li><a href=\"#programs\">What a program does not have</a></li>\n");
    html.push_str("<li><a href=\"#how\">How it was measured</a></li>\n</ul>\n</nav>\n");
    html
}

fn of_scene(scene: &SceneReport, place: usize) -> Result<String, ReportError> {
    let id = anchor(place, "top");
    let (width, height) = scene.size;
    let mut html = format!(
        "<section aria-labelledby=\"{id}\">\n<h2 id=\"{id}\">{}</h2>\n<p>{} triangles, {} vertices, {width}x{height} \
         pixels; {} triangles cover a sample, {} are clipped. In the picture without rounding, floats left {} \
         comparisons to integers of unbounded size. Clearing 1280x720 numbers of 32 bits takes {} ms in the same \
         run.</p>\n",
        escaped(&scene.name),
        figure(scene.triangles as f64),
        figure(scene.vertices as f64),
        figure(f64::from(scene.statistics.drawn)),
        figure(f64::from(scene.statistics.clipped)),
        figure(scene.decided_in_integers as f64),
        ms(scene.clear.min)
    );
    html.push_str("<nav aria-label=\"Questions\">\n<ul>\n");
    for answer in &scene.answers {
        let question = &answer.question;
        let _ = writeln!(
            html,
            "<li><a href=\"#{}\">{}</a></li>",
            anchor(place, question.id),
            escaped(question.title)
        );
    }
    html.push_str("</ul>\n</nav>\n");
    for answer in &scene.answers {
        html.push_str(&answer::section(answer, &scene.name, &anchor(place, answer.question.id))?);
    }
    html.push_str(&absent::savings(&scene.savings, &scene.name, &anchor(place, "savings")));
    html.push_str("</section>\n");
    Ok(html)
}

fn how(report: &Report) -> String {
    let mut html = String::from(
        "<footer aria-labelledby=\"how\">\n<h2 id=\"how\">How it was measured</h2>\n<ul>\n\
         <li>A frame is everything from positions and a matrix to finished buffers: clear, transform, draw. One thread. \
         Plots show the shortest frame of the run, tables also the quartiles: what lies far apart was disturbed.</li>\n\
         <li>The picture without rounding takes positions and matrix as they are and real numbers from there on; \
         comparisons are decided in f64 with a bound of the error, and in integers of unbounded size where that does not \
         decide. Of two surfaces equally near, the earlier is seen.</li>\n\
         <li>Exact depths are fractions of 128-bit integers, through the snapped corners.</li>\n\
         <li>The error axis is logarithmic, with a place of its own for 0 below the break.</li>\n",
    );
    for scene in &report.scenes {
        let _ = writeln!(html, "<li>{} took {:.0} s.</li>", escaped(&scene.name), scene.seconds);
    }
    for absent in &report.absent {
        let _ = writeln!(html, "<li>Left out: {}.</li>", escaped(absent));
    }
    html.push_str("</ul>\n</footer>\n");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every tag that is opened is closed, in order, and every link leads somewhere.
    #[test]
    fn the_page_is_well_formed() {
        let page = page(&super::super::tests::report()).unwrap();
        let body = page.strip_prefix("<!DOCTYPE html>\n").unwrap();
        let document = roxmltree::Document::parse(body).unwrap_or_else(|error| panic!("{error}\n{page}"));
        let mut ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
        for node in document.descendants() {
            if let Some(anchor) = node.attribute("href").and_then(|link| link.strip_prefix('#')) {
                assert!(ids.contains(&anchor), "{anchor}");
            }
            for source in ["src", "href"] {
                let outside = node.attribute(source).is_some_and(|link| link.contains("//"));
                assert!(!outside, "{node:?}");
            }
        }
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count, "an id stands twice");
        let named = |node: &roxmltree::Node<'_, '_>| {
            node.children().any(|child| child.has_tag_name(("http://www.w3.org/2000/svg", "title")))
        };
        let mut plots = document.descendants().filter(|node| node.tag_name().name() == "svg");
        assert!(plots.all(|plot| plot.attribute("role") == Some("img") && named(&plot)));
        assert!(!page.contains("<b>") && page.contains("fast &lt;b&gt;"), "names are escaped");
    }
}
