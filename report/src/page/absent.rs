//! What scenes and programs do without: the savings of a scene, and the programs' sizes.

use std::fmt::Write as _;

use super::numbers::figure;
use crate::leaving_out::Program;
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
pub(super) fn programs(programs: &Result<Vec<Program>, String>) -> String {
    let mut html = String::from(
        "<section aria-labelledby=\"programs\">\n<h2 id=\"programs\">What a program does not have</h2>\n<p>Programs that \
         are linked without std, a libc, an allocator or a panic handler, each with one part of the crate. What a program \
         does not ask for is not in it: no division without depth, no float without clip space, no vector instruction of \
         the fast path without the feature; helpers are the compiler's functions for arithmetic that a small processor \
         has not. Stack frames hold the programs' own buffers, of 320x16 texels.</p>\n",
    );
    let programs = match programs {
        Ok(programs) => programs,
        Err(reason) => {
            let _ = write!(html, "<p>pending: {}</p>\n</section>\n", escaped(reason));
            return html;
        }
    };
    html.push_str(
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Programs table\">\n<table>\n<caption>Linked \
         programs. <a href=\"programs.csv\">CSV</a></caption>\n<thead><tr><th scope=\"col\" class=\"text\">program</th>\
         <th scope=\"col\" class=\"text\">has</th><th scope=\"col\" class=\"text\">target</th><th scope=\"col\">code (B)</th>\
         <th scope=\"col\">constants (B)</th><th scope=\"col\">static (B)</th><th scope=\"col\">instructions</th>\
         <th scope=\"col\">divisions</th><th scope=\"col\">of floats</th><th scope=\"col\">in vector registers</th>\
         <th scope=\"col\">largest frame (B)</th><th scope=\"col\" class=\"text\">helpers</th></tr></thead>\n<tbody>\n",
    );
    for program in programs {
        let _ = write!(
            html,
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td>\
             <td>{}</td>",
            program.name,
            program.what,
            escaped(&program.target),
            figure(program.code as f64),
            figure(program.constants as f64),
            figure(program.statics as f64)
        );
        match program.instructions {
            Some(of) => {
                for number in [of.total, of.divisions, of.floats, of.vectors, of.frame] {
                    let _ = write!(html, "<td>{}</td>", figure(number as f64));
                }
            }
            None => html.push_str("<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td>"),
        }
        let helpers = if program.helpers.is_empty() { "none".to_owned() } else { program.helpers.join(", ") };
        let _ = writeln!(html, "<td class=\"note\">{}</td></tr>", escaped(&helpers));
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
    if !programs.iter().any(|program| program.target.starts_with("thumb")) {
        html.push_str("<p class=\"soft\">Cortex-M0 (thumbv6m): pending in this run; it needs that target's core library and BARE_TARGET=thumbv6m-none-eabi.</p>\n");
    }
    html.push_str("</section>\n");
    html
}
