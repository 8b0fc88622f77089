//! The document's tables.

use std::fmt::Write as _;

use super::data::Data;
use super::markdown::{cell, head, markdown};
use super::{targets, whole};
use crate::breakdown::Part;
use crate::contest::Kind;
use crate::peers;
use crate::quoted;

/// Makes a table, or says what has to be run for it.
pub type Table = fn(&Data) -> Option<String>;

/// The tables, by the names of their markers, in the document's order.
pub const ALL: [(&str, Table); 19] = [
    ("machine", machine),
    ("comparison", comparison),
    ("times", times),
    ("meshlets", targets::meshlets),
    ("targets", targets::frames),
    ("targets-attachments", targets::attachments),
    ("targets-crates", targets::crates),
    ("targets-fallback", targets::fallback),
    ("targets-large", targets::large),
    ("targets-growth", targets::growth),
    ("stages", stages),
    ("growth", growth),
    ("pixels", pixels),
    ("micro", micro),
    ("attachments", attachments),
    ("limits", limits),
    ("peers", about_peers),
    ("quoted", targets::all_quoted),
    ("whole-frames", whole::frames),
];

fn machine(data: &Data) -> Option<String> {
    let mut machines: Vec<&str> = data.records.iter().map(|record| &*record.machine).collect();
    machines.dedup();
    let most = data.records.iter().filter(|record| record.kind == Kind::Ours).map(|record| record.frames);
    Some(format!("Measured on: {}. Frames of our rows: up to {}.", machines.join("; "), most.max()?))
}

fn comparison(data: &Data) -> Option<String> {
    let levels = data.levels();
    let mut names = vec!["clears".to_owned()];
    names.extend(levels.iter().map(|level| format!("halfplane {level}")));
    let fastest = *levels.first()?;
    names.extend(["meshlets", "D16, meshlets"].map(|way| format!("halfplane {fastest}, {way}")));
    names.extend(peers::WHAT.map(|(name, _)| name.to_owned()));
    names.extend(quoted::WHAT.map(|(name, _)| format!("*{name}* ¹")));
    let rows = data.scenes().into_iter().map(|view| {
        let ours = levels.iter().map(|level| data.depth(view, level));
        let meshlets = ["depth", "depth D16"].map(|attachments| data.way(view, fastest, attachments, true));
        let peers = peers::WHAT.map(|(name, _)| data.of(view, name, false));
        let measured =
            ours.chain(meshlets).chain(peers).map(|record| cell(record.map(|record| record.clears), 1));
        let quoted = quoted::of(view).map_or([None; 3], |quoted| quoted.peers_ms.map(Some));
        let quoted =
            quoted.map(|ms| ms.map_or("–".to_owned(), |ms| format!("*{:.1}*", ms / quoted::CLEAR_MS)));
        [view.to_owned()].into_iter().chain(measured).chain(quoted).collect()
    });
    let table = markdown(&names, &rows.collect::<Vec<_>>())?;
    Some(format!(
        "{table}\n¹ Quoted, not measured here: another machine (Zen 3, AVX2), where a clear took {} ms.",
        quoted::CLEAR_MS
    ))
}

fn times(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let names = head(&[
        "ms",
        "camera",
        "min",
        "25 %",
        "median",
        "75 %",
        "max",
        "mean",
        "sdev",
        "frames",
        "triangles",
        "pixels",
    ]);
    let mut rows = Vec::new();
    for view in data.scenes() {
        for (with, moving) in [("", false), ("", true), (", meshlets", false), (", meshlets", true)] {
            let Some(r) = data.of(view, &format!("halfplane {level} depth{with}"), moving) else { continue };
            let times = [r.min_ms, r.p25_ms, r.median_ms, r.p75_ms, r.max_ms, r.mean_ms, r.sdev_ms];
            let mut row = vec![view.to_owned(), format!("{}{with}", if moving { "moving" } else { "still" })];
            row.extend(times.map(|time| cell(Some(time), 3)));
            row.extend([r.frames.to_string(), r.triangles.to_string()]);
            row.push(r.covered.map_or(String::new(), |covered| covered.to_string()));
            rows.push(row);
        }
    }
    markdown(&names, &rows)
}

fn stages(data: &Data) -> Option<String> {
    let mut names = head(&["view", "level", "of a frame"]);
    names.extend(Part::ALL.map(|part| part.name().to_owned()));
    names.push("all".to_owned());
    let mut seen: Vec<(&str, &str)> = Vec::new();
    let mut rows = Vec::new();
    for row in &data.stages {
        let key = (&*row.view, &*row.level);
        if seen.contains(&key) {
            continue;
        }
        seen.push(key);
        let of = |part| data.stages.iter().find(|row| (&*row.view, &*row.level) == key && row.part == part);
        let instructions = Part::ALL.map(|part| of(part)?.instructions.map(|n| n as f64 / 1e3));
        let ms = Part::ALL.map(|part| of(part)?.ms);
        for (what, parts, digits) in [("10³ instructions", instructions, 0), ("ms", ms, 3)] {
            let all = parts.iter().any(Option::is_some).then(|| parts.iter().flatten().sum());
            let mut line = vec![key.0.to_owned(), key.1.to_owned(), what.to_owned()];
            line.extend(parts.into_iter().chain([all]).map(|part| cell(part, digits)));
            rows.push(line);
        }
    }
    markdown(&names, &rows)
}

fn growth(data: &Data) -> Option<String> {
    let levels = ends(data);
    let mut names = head(&["view", "triangles"]);
    names.extend(levels.iter().flat_map(|level| [format!("{level}, ms"), format!("{level}, ns/triangle")]));
    let rows = data.views("growth ").into_iter().filter_map(|view| {
        let triangles = data.depth(view, levels.first()?)?.triangles;
        let mut row = vec![view.to_owned(), triangles.to_string()];
        for level in &levels {
            let ms = data.depth(view, level).map(|record| record.min_ms);
            row.extend([cell(ms, 3), cell(ms.map(|ms| ms * 1e6 / triangles as f64), 2)]);
        }
        Some(row)
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

fn pixels(data: &Data) -> Option<String> {
    let levels = ends(data);
    let mut names = head(&["view", "samples", "read-modify-write, ns/pixel"]);
    for level in &levels {
        names.extend(["ms", "ns/sample", "× read-modify-write"].map(|name| format!("{level}, {name}")));
    }
    let views = data.views("pixels ").into_iter().chain(data.views("micro fullscreen back-to-front"));
    let rows = views.filter_map(|view| {
        let record = data.depth(view, levels.first()?)?;
        let samples = record.samples as f64;
        let limit = data.read_modify_write(view).map(|ms| ms * 1e6);
        let mut row = vec![view.to_owned(), record.samples.to_string(), cell(limit, 3)];
        for level in &levels {
            let ms = data.depth(view, level).map(|record| record.min_ms);
            let each = ms.map(|ms| ms * 1e6 / samples);
            row.extend([
                cell(ms, 3),
                cell(each, 3),
                cell(each.zip(limit).map(|(each, limit)| each / limit), 2),
            ]);
        }
        Some(row)
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

fn micro(data: &Data) -> Option<String> {
    let levels = ends(data);
    let mut names = head(&["ns/triangle", "samples/triangle"]);
    names.extend(levels.iter().map(|level| format!("halfplane {level}")));
    names.extend(peers::WHAT.map(|(name, _)| name.to_owned()));
    let rows = data.views("micro ").into_iter().filter_map(|view| {
        let triangles = data.depth(view, levels.first()?)?.triangles as f64;
        let each = |ms: f64, digits| cell(Some(ms * 1e6 / triangles), digits);
        let samples = data.depth(view, levels.first()?)?.samples as f64;
        let mut row = vec![view.to_owned(), cell(Some(samples / triangles), 0)];
        let ours = levels.iter().map(|level| data.depth(view, level));
        let peers = peers::WHAT.map(|(name, _)| data.of(view, name, false));
        row.extend(ours.chain(peers).map(|r| r.map_or("–".to_owned(), |r| each(r.min_ms, 1))));
        Some(row)
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

fn attachments(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let kinds = crate::ours::MEASURED.map(|attachments| attachments.name());
    let kinds = kinds.into_iter().chain(["depth, meshlets", "depth D16, meshlets"]);
    let mut names = head(&["ms (× depth)"]);
    names.extend(kinds.clone().map(str::to_owned));
    let rows = data.scenes().into_iter().filter_map(|view| {
        let depth = data.depth(view, level)?.min_ms;
        let mut row = vec![view.to_owned()];
        row.extend(kinds.clone().map(|kind| {
            let record = data.of(view, &format!("halfplane {level} {kind}"), false);
            record.map_or("–".to_owned(), |r| format!("{:.3} ({:.2})", r.min_ms, r.min_ms / depth))
        }));
        Some(row)
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

fn limits(data: &Data) -> Option<String> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for view in data.scenes() {
        let limits = data.records.iter().filter(|record| record.view == view);
        for r in limits.filter(|record| matches!(record.kind, Kind::Unit | Kind::Limit)) {
            rows.push(vec![
                view.to_owned(),
                r.contender.clone(),
                cell(Some(r.min_ms), 4),
                cell(Some(r.median_ms), 4),
                cell(Some(r.clears), 2),
            ]);
        }
    }
    markdown(&head(&["view", "limit", "min, ms", "median, ms", "clears"]), &rows)
}

fn about_peers(_: &Data) -> Option<String> {
    let mut text = String::new();
    for (name, what) in peers::WHAT {
        let _ = writeln!(text, "* **{name}**: {what}.");
    }
    for (name, what) in quoted::WHAT.into_iter().chain(quoted::MORE) {
        let _ = writeln!(text, "* *{name}* (quoted): {what}.");
    }
    Some(text)
}

/// The fastest level, and the one without vectors.
fn ends(data: &Data) -> Vec<&str> {
    let mut levels = data.levels();
    if levels.len() > 2 {
        levels.drain(1..levels.len() - 1);
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breakdown::table::Row;
    use crate::record::{
        records,
        tests::{outcome, row},
    };

    fn data() -> Data {
        let views = ["castle main 1280x720", "growth 10^3", "pixels 10^4", "micro slivers", "growth 10^4"];
        let mut outcomes = views.map(|view| outcome(view, "halfplane avx2 depth"));
        for outcome in &mut outcomes {
            let limit = crate::contest::READ_MODIFY_WRITE;
            outcome.rows.push(row(limit, Kind::Limit, 1.0));
            outcome.rows.push(row("euc", Kind::Peer, 13.0));
            outcome.samples = 1_000_000;
        }
        let stage = |part, ms| Row {
            view: views[0].to_owned(),
            level: "avx2".to_owned(),
            part,
            instructions: Some(2000),
            ms,
        };
        Data {
            records: records(&outcomes, "a machine"),
            whole: records(&[outcome(views[0], crate::whole::PLAIN)], "a machine"),
            stages: vec![stage(Part::Cull, Some(0.25)), stage(Part::Depth, None)],
        }
    }

    #[test]
    fn every_table_is_made_of_what_it_needs() {
        let data = data();
        for (name, table) in ALL {
            let table = table(&data).unwrap_or_else(|| panic!("{name}"));
            let columns: Vec<_> = table
                .lines()
                .filter(|line| line.starts_with('|'))
                .map(|line| line.matches('|').count())
                .collect();
            assert!(columns.iter().all(|count| *count == columns[0]), "{name}: {table}");
        }
        assert!(times(&data).unwrap().contains("| castle main 1280x720 | still, meshlets | 1.500 |"));
        assert!(attachments(&data).unwrap().contains("| 1.500 (0.75) |"));
        let comparison = comparison(&data).unwrap();
        // 0.74 ms of 0.054 ms.
        assert!(comparison.contains("| castle main 1280x720 | 4.0 | 40.0 | 3.0 | – |"), "{comparison}");
        assert!(comparison.contains("*13.7*"), "{comparison}");
        // 2 ms for 10 triangles.
        assert!(growth(&data).unwrap().contains("| growth 10^3 | 10 | 2.000 | 200000.00 |"));
        assert!(stages(&data).unwrap().contains("| ms | – | – | 0.250 | – | – | – | – | 0.250 |"));
    }

    #[test]
    fn nothing_measured_is_no_table() {
        for (name, table) in ALL.into_iter().filter(|(name, _)| !["peers", "quoted"].contains(name)) {
            assert_eq!(table(&Data::default()), None, "{name}");
        }
    }
}
