//! Tables for people.

use std::fmt::Write as _;

use crate::contest::{MAIN, Outcome, Row};
use crate::ours::{self, Attachments, Level, Preparation};
use crate::peers;
use crate::quoted;
use crate::scenes::View;

/// What is measured, told once before the tables.
#[must_use]
pub fn legend() -> String {
    let mut text = String::from(
        "One thread. Times in ms from object-space positions to the finished buffers, clear included, unless said \
         otherwise.\nclears: the minimum over that of clearing 1280x720 u32 in the same view's run. x ours: a peer's \
         minimum over\nthat of the fastest halfplane depth on the same triangles and camera. px: pixels covered.\nmeshlets: made once of each mesh, \
         before any frame; at the fastest level.\n",
    );
    for (name, what) in peers::WHAT {
        let _ = writeln!(text, "* {name}: {what}.");
    }
    text.push_str(
        "All of it is built for the Rust target's own baseline processor; halfplane chooses its level when it runs, \
         and\nRUSTFLAGS=\"-C target-cpu=native\" gives the other crates what the compiler makes of this one.\n",
    );
    let levels: Vec<&str> = ours::available().into_iter().map(Level::name).collect();
    let _ = writeln!(text, "Levels of halfplane on this machine, fastest first: {}.", levels.join(", "));
    text
}

/// What was prepared of a scene, once for all its views.
#[must_use]
pub fn preparation(view: &View, cost: Preparation) -> String {
    let scene = view.name.split(' ').next().unwrap_or_default();
    format!("\n== {scene}: {} triangles, {cost}; in no frame's time\n", view.mesh.triangles())
}

/// One view's table.
#[must_use]
pub fn table(outcome: &Outcome) -> String {
    let width = outcome.rows.iter().map(|row| label(row).len()).max().unwrap_or(0);
    let mut text = format!("\n== {}\n", outcome.view);
    let _ = writeln!(
        text,
        "{:width$} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>6} {:>8} {:>7} {:>9} {:>8}",
        "",
        "min",
        "25 %",
        "median",
        "75 %",
        "max",
        "mean",
        "sdev",
        "frames",
        "clears",
        "x ours",
        "triangles",
        "px"
    );
    for row in &outcome.rows {
        let s = &row.summary;
        let ratio = outcome.ours_beside(row).map(|ours| format!("{:.1}", s.min / ours.summary.min));
        let triangles = (row.triangles > 0).then(|| row.triangles.to_string());
        let _ = writeln!(
            text,
            "{:width$} {:9.3} {:9.3} {:9.3} {:9.3} {:9.3} {:9.3} {:8.3} {:6} {:8.1} {:>7} {:>9} {:>8}",
            label(row),
            s.min,
            s.p25,
            s.median,
            s.p75,
            s.max,
            s.mean,
            s.sdev,
            s.frames,
            s.min / outcome.clear(),
            ratio.unwrap_or_default(),
            triangles.unwrap_or_default(),
            row.covered.map_or(String::new(), |covered| covered.to_string()),
        );
    }
    if let Some(quoted) = quoted::of(&outcome.view) {
        let [raw, moc, ryg] =
            quoted.peers_ms.map(|ms| format!("{ms:.2} ms = {:.1} clears", ms / quoted::CLEAR_MS));
        let _ = writeln!(text, "quoted, not measured here (see the end): raw {raw}; MOC {moc}; ryg {ryg}");
    }
    text
}

fn label(row: &Row) -> String {
    if row.moving { format!("{}, moving", row.contender) } else { row.contender.clone() }
}

/// All views side by side in clears, then the quoted figures and the targets.
#[must_use]
pub fn summary(outcomes: &[Outcome]) -> String {
    let mut text = String::from("\n== all views, in clears (minima; still camera)\n");
    let levels = ours::available();
    let mut columns: Vec<String> = levels.iter().map(|level| format!("halfplane {}", level.name())).collect();
    let fastest = ours::fastest();
    let with_meshlets = [(MAIN, "meshlets"), (Attachments::Depth16, "D16, meshlets")];
    columns.extend(with_meshlets.map(|(_, name)| name.to_owned()));
    columns.extend(peers::WHAT.map(|(name, _)| name.to_owned()));
    let view_width = outcomes.iter().map(|outcome| outcome.view.len()).max().unwrap_or(0);
    let _ = write!(text, "{:view_width$}", "");
    for column in &columns {
        let _ = write!(text, "  {column:>10}");
    }
    text.push('\n');
    for outcome in outcomes {
        let _ = write!(text, "{:view_width$}", outcome.view);
        let ours = levels.iter().map(|&level| outcome.depth_of(level));
        let meshlets = with_meshlets.map(|(attachments, _)| outcome.meshlets_of(fastest, attachments));
        let peers =
            peers::WHAT.map(|(name, _)| outcome.rows.iter().find(|row| row.contender == name && !row.moving));
        for (column, row) in columns.iter().zip(ours.chain(meshlets).chain(peers)) {
            let clears =
                row.map_or("-".to_owned(), |row| format!("{:.1}", row.summary.min / outcome.clear()));
            let _ = write!(text, "  {clears:>width$}", width = column.len().max(10));
        }
        text.push('\n');
    }
    text + &targets(outcomes)
}

fn targets(outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    let fastest = ours::fastest();
    for outcome in outcomes {
        let (Some(quoted), Some(ours)) = (quoted::of(&outcome.view), outcome.depth_of(fastest)) else {
            continue;
        };
        if text.is_empty() {
            let _ = writeln!(
                text,
                "\n== beside quoted figures, in clears: raw, MOC and ryg were not measured here but on a Zen 3 machine \
                 with AVX2,\n   where a clear took {} ms\n{:32} {:>18} {:>9} {:>8} {:>8} {:>8} {:>12} {:>15}",
                quoted::CLEAR_MS,
                "",
                format!("halfplane {}", fastest.name()),
                "meshlets",
                "raw",
                "MOC",
                "ryg",
                "target AVX2",
                "target AVX-512"
            );
        }
        let [raw, moc, ryg] = quoted.peers_ms.map(|ms| ms / quoted::CLEAR_MS);
        let [avx2, avx512] = quoted.target_clears;
        let meshlets = outcome.meshlets_of(fastest, MAIN);
        let meshlets =
            meshlets.map_or("-".to_owned(), |row| format!("{:.1}", row.summary.min / outcome.clear()));
        let _ = writeln!(
            text,
            "{:32} {:18.1} {meshlets:>9} {raw:8.1} {moc:8.1} {ryg:8.1} {avx2:12.1} {avx512:15.1}",
            outcome.view,
            ours.summary.min / outcome.clear()
        );
    }
    if !text.is_empty() {
        for (name, what) in quoted::WHAT {
            let _ = writeln!(text, "* {name}: {what}.");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::tests::outcome;

    #[test]
    fn tables_have_every_row() {
        let ours = format!("halfplane {} depth", ours::available()[0].name());
        let outcomes = [outcome("castle main 1280x720", &ours)];
        let table = table(&outcomes[0]);
        assert!(
            table.contains("6.5") && table.contains("26.0") && table.contains("quoted, not measured"),
            "{table}"
        );
        let summary = summary(&outcomes);
        // 1.5 ms of 0.5 ms.
        assert_eq!(summary.matches(" 3.0 ").count(), 2, "{summary}");
        assert!(summary.contains(" 4.0") && summary.contains("target AVX2"), "{summary}");
    }
}
