//! What scenes and programs do without: the savings of a scene, and the programs' sizes.

use std::fmt::Write as _;

use super::numbers::figure;
use crate::leaving_out::{Program, Programs};
use crate::plots::escaped;
use crate::savings::Saving;

/// A scene's savings.
pub(super) fn savings(savings: &[Saving], scene: &str, id: &str) -> String {
    let mut html = format!(
        "<section aria-labelledby=\"{id}\">\n<h3 id=\"{id}\">What this scene does not need</h3>\n<div class=\"scroll\" \
         tabindex=\"0\" role=\"group\" aria-label=\"Savings table\">\n<table>\n<caption>Work that did not happen, {}. \
         <a href=\"savings.csv\">CSV</a></caption>\n<thead><tr><th scope=\"col\" class=\"text\">saved</th>\
         <th scope=\"col\">part (%)</th><th scope=\"col\">number</th><th scope=\"col\">of</th>\
         <th scope=\"col\" class=\"text\">what</th></tr></thead>\n<tbody>\n",
        escaped(scene)
    );
    for Saving { name, saved, of, unit } in savings {
        let part = 100.0 * *saved as f64 / (*of).max(1) as f64;
        let _ = writeln!(
            html,
            "<tr><th scope=\"row\">{}</th><td>{part:.1}</td><td>{}</td><td>{}</td><td class=\"text\">{unit}</td></tr>",
            escaped(name),
            figure(*saved as f64),
            figure(*of as f64)
        );
    }
    html.push_str("</tbody>\n</table>\n</div>\n</section>\n");
    html
}

/// The programs, or why there are none.
pub(super) fn programs(programs: &Result<Programs, String>) -> String {
    let mut html = String::from(
        "<section aria-labelledby=\"programs\">\n<h2 id=\"programs\">What a program does not have</h2>\n<p>Programs that \
         are linked without std, a libc, an allocator or a panic handler, each with one part of the crate. What a program \
         does not ask for is not in it: no division without depth, no float without clip space, no vector instruction of \
         the fast path without the feature; helpers are the compiler's functions for arithmetic that a small processor \
         has not. Static memory holds the buffers, of 320x16 texels.</p>\n\
         <p>The same linked files are run in an emulator that tells every instruction (valgrind's lackey; QEMU's Cortex-M), \
         so counts are exact and equal in every run, and say nothing of time. Instructions per triangle: 32 triangles \
         less 16 over 16, each set up and walked, covering one sample and hidden after the first; vertices are \
         transformed for each corner in <code>clip</code> and once for all in vector \
         registers. Instructions per pixel: a triangle over 128 columns of the target less one over 64, over 1024 \
         pixels; they pass. Deepest stack: from the program's entry to the lowest byte used (on Cortex-M the \
         lowest stack pointer) in these runs, and where there is clip space in one with a clipped triangle; the worst \
         of these runs, not of all inputs.</p>\n",
    );
    let Programs { compiler, linked, skipped } = match programs {
        Ok(programs) => programs,
        Err(reason) => {
            let _ = write!(html, "<p>pending: {}</p>\n</section>\n", escaped(reason));
            return html;
        }
    };
    let _ = write!(
        html,
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Programs table\">\n<table>\n<caption>Programs \
         linked by {}. <a href=\"programs.csv\">CSV</a></caption>\n<thead><tr><th scope=\"col\" class=\"text\">program</th>\
         <th scope=\"col\" class=\"text\">has</th><th scope=\"col\" class=\"text\">target</th><th scope=\"col\">code (B)</th>\
         <th scope=\"col\">constants (B)</th><th scope=\"col\">static (B)</th><th scope=\"col\">deepest stack (B)</th>\
         <th scope=\"col\">instructions per triangle</th><th scope=\"col\">per pixel</th>\
         <th scope=\"col\">instructions in the file</th><th scope=\"col\">divisions</th><th scope=\"col\">of floats</th>\
         <th scope=\"col\">in vector registers</th><th scope=\"col\" class=\"text\">helpers</th></tr></thead>\n<tbody>\n",
        escaped(compiler)
    );
    linked.iter().for_each(|program| html.push_str(&row(program)));
    html.push_str("</tbody>\n</table>\n</div>\n");
    if let Some(skipped) = skipped {
        let _ = writeln!(html, "<p class=\"soft\">{}.</p>", escaped(skipped));
    }
    html.push_str("</section>\n");
    html
}

fn row(program: &Program) -> String {
    let mut html = format!(
        "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td>",
        program.name,
        escaped(program.what),
        escaped(&program.target)
    );
    let mut cell = |number: f64| {
        let _ = write!(html, "<td>{}</td>", figure(number));
    };
    [program.code, program.constants, program.statics].into_iter().for_each(|bytes| cell(bytes as f64));
    match &program.executed {
        Ok(of) => [of.stack as f64, of.per_triangle(), of.per_pixel()].into_iter().for_each(cell),
        Err(reason) => {
            let _ = write!(html, "<td class=\"note\" colspan=\"3\">{}</td>", escaped(reason));
        }
    }
    match program.instructions {
        Some(of) => {
            for number in [of.total, of.divisions, of.floats, of.vectors] {
                let _ = write!(html, "<td>{}</td>", figure(number as f64));
            }
        }
        None => html.push_str("<td>–</td><td>–</td><td>–</td><td>–</td>"),
    }
    let helpers = if program.helpers.is_empty() { "none".to_owned() } else { program.helpers.join(", ") };
    let _ = writeln!(html, "<td class=\"note\">{}</td></tr>", escaped(&helpers));
    html
}
