//! What the project set out to reach, and whether it does: tables of `docs/performance.md`.

use super::data::Data;
use super::markdown::{cell, head, markdown};
use crate::contest::Kind;
use crate::peers;
use crate::quoted::{self, Machine, ZEN3, ZEN4};
use crate::record::Record;

/// Depth and ids over depth alone, at most.
const IDS: f64 = 1.35;
/// 16-bit depth over 32-bit depth, at most.
const D16: f64 = 0.85;
/// Crates over the fastest level, at least.
const CRATES: f64 = 5.0;
/// The level without vectors over euc, at most.
const FALLBACK: f64 = 1.0;
/// Triangles that are [`LARGE`] over the read-modify-write limit, at most.
const OVER_LIMIT: f64 = 1.5;
/// Samples of a large triangle.
const LARGE: f64 = 10_000.0;
/// The exponent of the time's growth with the number of triangles, at most: 1 is a straight line.
const EXPONENT: f64 = 1.1;

/// Whether a figure that should be small is, and by what factor.
pub(super) fn at_most(value: f64, target: f64) -> String {
    verdict(target / value)
}

/// The same for one that should be large.
pub(super) fn at_least(value: f64, target: f64) -> String {
    verdict(value / target)
}

fn verdict(better: f64) -> String {
    if better >= 1.0 { format!("met, {better:.2}×") } else { format!("**missed, {:.2}×**", 1.0 / better) }
}

pub(super) fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| "–".to_owned())
}

fn min_ms(record: Option<&Record>) -> Option<f64> {
    record.map(|record| record.min_ms)
}

fn quotient(above: Option<f64>, below: Option<f64>) -> Option<f64> {
    above.zip(below).map(|(above, below)| above / below)
}

/// A quoted time with its peer, and in clears.
fn best(peers_ms: [Option<f64>; 3], machine: &Machine) -> Option<String> {
    let (name, ms) = quoted::best(peers_ms)?;
    Some(format!("*{name} {ms:.2} ms = {:.1}*", ms / machine.clear_ms))
}

fn about(machine: &Machine) -> String {
    let Machine { name, level, what, clear_ms } = machine;
    format!("{name} with {level}, {what}; a clear took {clear_ms} ms")
}

/// The figures of C++ programs: whole frames, in clears.
pub(super) fn frames(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    // The target of the vectors that ran; anything but AVX-512 is held to that of AVX2.
    let column = usize::from(level == "avx512");
    let mut names = head(&["clears"]);
    for (machine, mark) in [(&ZEN3, '¹'), (&ZEN4, '²')] {
        names.push(format!("best C++ peer, {} {} {mark}", machine.name, machine.level));
    }
    names.extend(head(&["target, AVX2", "target, AVX-512"]));
    let ways = [("depth", false), ("depth", true), ("depth D16", false), ("depth D16", true)];
    names.extend(ways.map(|(attachments, meshlets)| {
        format!("{level} {attachments}{}", if meshlets { ", meshlets" } else { "" })
    }));
    names.extend(head(&["depth", "depth, meshlets"]));
    let rows = quoted::QUOTED.iter().filter_map(|quoted| {
        let view = quoted.view;
        data.depth(view, level)?;
        let target = quoted.target_clears[column];
        let mut row = vec![
            view.to_owned(),
            or_dash(best(quoted.peers_ms.map(Some), &ZEN3)),
            or_dash(quoted::on_zen4(view).and_then(|other| best(other.peers_ms, &ZEN4))),
        ];
        for (place, clears) in quoted.target_clears.into_iter().enumerate() {
            row.push(if place == column { format!("**{clears:.1}**") } else { format!("{clears:.1}") });
        }
        let records = ways.map(|(attachments, meshlets)| data.way(view, level, attachments, meshlets));
        row.extend(records.map(|record| {
            or_dash(record.map(|record| format!("{:.1} = {:.3} ms", record.clears, record.min_ms)))
        }));
        let [depth, meshlets, ..] = records;
        row.extend(
            [depth, meshlets].map(|record| or_dash(record.map(|record| at_most(record.clears, target)))),
        );
        Some(row)
    });
    let table = markdown(&names, &rows.collect::<Vec<_>>())?;
    let clear = data.records.iter().filter(|record| record.kind == Kind::Unit).map(|record| record.min_ms);
    Some(format!(
        "{table}\nThe target in bold counts: the one for the level that ran. Clears here took {} ms at least.\n\n\
         ¹ Quoted, not measured here: {}; the better of raw, MOC and ryg.\n\n\
         ² Quoted, not measured here: {}; the same peers.",
        cell(clear.reduce(f64::min), 4),
        about(&ZEN3),
        about(&ZEN4),
    ))
}

/// What making the meshlets of a scene takes.
pub(super) fn meshlets(data: &Data) -> Option<String> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for record in data.records.iter().filter(|record| record.kind == Kind::OursMeshlets) {
        let scene = record.view.split(' ').next().unwrap_or_default();
        if rows.iter().any(|row| row.first().is_some_and(|name| name == scene)) {
            continue;
        }
        let (meshlets, bytes) = (record.meshlets?, record.meshlet_bytes?);
        rows.push(vec![
            scene.to_owned(),
            record.triangles.to_string(),
            meshlets.to_string(),
            cell(Some(record.triangles as f64 / meshlets as f64), 1),
            cell(record.prepare_ms, 3),
            bytes.to_string(),
            cell(Some(bytes as f64 / record.triangles as f64), 1),
        ]);
    }
    let names =
        ["scene", "triangles", "meshlets", "triangles each", "made in, ms", "bytes", "bytes/triangle"];
    markdown(&head(&names), &rows)
}

/// Ids beside depth, and half the depth.
pub(super) fn attachments(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let names = head(&[
        "ms",
        "depth",
        "depth+ids",
        "ids cost",
        "at most 1.35",
        "depth D16",
        "D16 / D32",
        "at most 0.85",
        "D16 / D32, meshlets",
        "at most 0.85",
    ]);
    let rows = data.scenes().into_iter().filter_map(|view| {
        let of = |attachments, meshlets| min_ms(data.way(view, level, attachments, meshlets));
        let depth = Some(of("depth", false)?);
        let (ids, d16) = (of("depth+ids", false), of("depth D16", false));
        let half = quotient(of("depth D16", true), of("depth", true));
        let [cost, small] = [ids, d16].map(|ms| quotient(ms, depth));
        Some(vec![
            view.to_owned(),
            cell(depth, 3),
            cell(ids, 3),
            cell(cost, 2),
            or_dash(cost.map(|cost| at_most(cost, IDS))),
            cell(d16, 3),
            cell(small, 2),
            or_dash(small.map(|small| at_most(small, D16))),
            cell(half, 2),
            or_dash(half.map(|half| at_most(half, D16))),
        ])
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

/// Crates over ours, on the same triangles.
pub(super) fn crates(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let mut names = head(&["× ours"]);
    names.extend(peers::WHAT.map(|(name, _)| name.to_owned()));
    names.extend(head(&["least", "at least 5"]));
    let rows = data.views("").into_iter().filter_map(|view| {
        let ratios = peers::WHAT.map(|(name, _)| {
            let peer = data.of(view, name, false)?;
            let ours = match peer.kind {
                Kind::Peer2d => data.of(view, &format!("halfplane {level} depth, visible only"), false),
                _ => data.depth(view, level),
            };
            Some(peer.min_ms / ours?.min_ms)
        });
        let least = ratios.into_iter().flatten().reduce(f64::min)?;
        let mut row = vec![view.to_owned()];
        row.extend(ratios.map(|ratio| cell(ratio, 1)));
        row.extend([cell(Some(least), 1), at_least(least, CRATES)]);
        Some(row)
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

/// The level without vectors beside euc.
pub(super) fn fallback(data: &Data) -> Option<String> {
    let names = head(&["ms", "fallback", "euc", "fallback / euc", "at most 1"]);
    let rows = data.views("").into_iter().filter_map(|view| {
        let ours = data.depth(view, "fallback")?.min_ms;
        let euc = data.of(view, "euc", false)?.min_ms;
        let ratio = ours / euc;
        let cells = [ours, euc].map(|ms| cell(Some(ms), 3));
        let [ours, euc] = cells;
        Some(vec![view.to_owned(), ours, euc, cell(Some(ratio), 2), at_most(ratio, FALLBACK)])
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

/// Large triangles against what memory allows.
pub(super) fn large(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let names = head(&["view", "samples/triangle", "ns/sample", "limit, ns/pixel", "× limit", "at most 1.5"]);
    let views = data.views("pixels ").into_iter().chain(data.views("micro "));
    let rows = views.filter_map(|view| {
        let record = data.depth(view, level)?;
        let samples = record.samples as f64;
        let each = samples / record.triangles as f64;
        let limit = data.read_modify_write(view).filter(|_| each >= LARGE)? * 1e6;
        let time = record.min_ms * 1e6 / samples;
        Some(vec![
            view.to_owned(),
            cell(Some(each), 0),
            cell(Some(time), 4),
            cell(Some(limit), 4),
            cell(Some(time / limit), 2),
            at_most(time / limit, OVER_LIMIT),
        ])
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

/// From one number of triangles to the next.
pub(super) fn growth(data: &Data) -> Option<String> {
    let level = *data.levels().first()?;
    let names = head(&["from", "to", "triangles ×", "time ×", "exponent", "at most 1.1"]);
    let views = data.views("growth ");
    let rows = views.windows(2).filter_map(|pair| {
        let [from, to] = pair else { return None };
        let (less, more) = (data.depth(from, level)?, data.depth(to, level)?);
        let triangles = more.triangles as f64 / less.triangles as f64;
        let time = more.min_ms / less.min_ms;
        let exponent = time.ln() / triangles.ln();
        Some(vec![
            (*from).to_owned(),
            (*to).to_owned(),
            cell(Some(triangles), 2),
            cell(Some(time), 2),
            cell(Some(exponent), 2),
            at_most(exponent.max(f64::MIN_POSITIVE), EXPONENT),
        ])
    });
    markdown(&names, &rows.collect::<Vec<_>>())
}

/// Everything that is quoted of C++ programs.
pub(super) fn all_quoted(_: &Data) -> Option<String> {
    let mut names = head(&["ms, quoted"]);
    let peers = quoted::WHAT.map(|(name, _)| name);
    let [queries, quads, first, llvmpipe] = quoted::MORE.map(|(name, _)| name);
    let on_zen3 = peers.into_iter().chain([queries, quads]);
    let on_zen4 = peers.into_iter().chain([queries, first, llvmpipe]);
    names.extend(on_zen3.map(|name| format!("{name} ¹")));
    names.extend(on_zen4.map(|name| format!("{name} ²")));
    let mut views: Vec<&str> = quoted::QUOTED.iter().map(|quoted| quoted.view).collect();
    views.extend(quoted::ON_ZEN4.iter().map(|other| other.view).filter(|view| quoted::of(view).is_none()));
    let rows = views.into_iter().map(|view| {
        let mut cells = [None; 11];
        if let Some(quoted) = quoted::of(view) {
            let all = quoted.peers_ms.into_iter().chain(quoted.queries_ms);
            cells.iter_mut().zip(all).for_each(|(cell, ms)| *cell = Some(ms));
        }
        if let Some(other) = quoted::on_zen4(view) {
            let all = other.peers_ms.into_iter().chain([Some(other.queries_ms)]).chain(other.others_ms);
            cells.iter_mut().skip(5).zip(all).for_each(|(cell, ms)| *cell = ms);
        }
        [view.to_owned()].into_iter().chain(cells.map(|ms| cell(ms, 2))).collect()
    });
    let table = markdown(&names, &rows.collect::<Vec<_>>())?;
    Some(format!("{table}\n¹ {}.\n\n² {}.", about(&ZEN3), about(&ZEN4)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contest::{Outcome, READ_MODIFY_WRITE};
    use crate::record::{records, tests::row};

    fn data(level: &str) -> Data {
        let ours = |name: &str, ms| row(&format!("halfplane {level} {name}"), Kind::Ours, ms);
        let meshlets =
            |name: &str, ms| row(&format!("halfplane {level} {name}, meshlets"), Kind::OursMeshlets, ms);
        let outcome = |view: &str, samples, more: Vec<crate::contest::Row>| {
            let rows = [row("clear", Kind::Unit, 0.1)].into_iter().chain(more).collect();
            Outcome { view: view.to_owned(), size: (1280, 720), samples, rows }
        };
        let scene = vec![
            ours("depth", 1.2),
            ours("depth D16", 1.08),
            ours("depth+ids", 1.5),
            meshlets("depth", 1.0),
            meshlets("depth D16", 0.8),
            ours("depth, visible only", 0.5),
            row("halfplane fallback depth", Kind::Ours, 6.0),
            row("euc", Kind::Peer, 8.0),
            row("tiny-skia", Kind::Peer2d, 2.0),
        ];
        let limit = row(READ_MODIFY_WRITE, Kind::Limit, 1280.0 * 720.0 / 1e6);
        let mut more = ours("depth", 16.0);
        more.triangles = 100;
        let outcomes = [
            outcome("castle main 1280x720", 1, scene),
            outcome("growth 10^1", 1, vec![ours("depth", 1.0)]),
            outcome("growth 10^2", 1, vec![more]),
            outcome("pixels 10^6", 1_000_000, vec![limit.clone(), ours("depth", 1.2)]),
            outcome("pixels 10^4", 10_000, vec![limit, ours("depth", 1.2)]),
        ];
        Data { records: records(&outcomes, ""), ..Data::default() }
    }

    #[track_caller]
    fn has(table: Option<String>, parts: &[&str]) {
        let table = table.unwrap();
        for part in parts {
            assert!(table.contains(part), "{part}: {table}");
        }
    }

    #[test]
    fn the_target_of_the_level_that_ran_counts() {
        // 12 clears, of 13.0 and of 10.9; with meshlets 10.
        let figures = ["| 12.0 = 1.200 ms | 10.0 = 1.000 ms | 10.8 = 1.080 ms | 8.0 = 0.800 ms |"];
        has(frames(&data("avx2")), &[figures[0], "| **13.0** | 10.9 |", "| met, 1.08× | met, 1.30× |"]);
        has(
            frames(&data("avx512")),
            &[figures[0], "| 13.0 | **10.9** |", "| **missed, 1.10×** | met, 1.09× |"],
        );
        has(
            frames(&data("avx2")),
            &["*raw 0.74 ms = 13.7* | *MOC 0.70 ms = 11.7*", "Zen 4 with AVX-512, medians"],
        );
    }

    #[test]
    fn every_other_target_has_its_figures() {
        let data = data("avx2");
        has(meshlets(&data), &["| castle | 10 | 3 | 3.3 | 0.250 | 4800 | 480.0 |"]);
        has(
            attachments(&data),
            &["| 1.500 | 1.25 | met, 1.08× | 1.080 | 0.90 | **missed, 1.06×** | 0.80 | met, 1.06× |"],
        );
        has(crates(&data), &["| 6.7 | – | 4.0 | – | 4.0 | **missed, 1.25×** |"]);
        has(fallback(&data), &["| 6.000 | 8.000 | 0.75 | met, 1.33× |"]);
        has(large(&data), &["| pixels 10^6 | 100000 | 1.2000 | 1.0000 | 1.20 | met, 1.25× |"]);
        assert!(!large(&data).unwrap().contains("10^4"));
        has(growth(&data), &["| 10.00 | 16.00 | 1.20 | **missed, 1.09×** |"]);
        has(
            all_quoted(&data),
            &[
                "| castle main 1280x720 | 0.74 | 0.74 | 1.42 | 0.51 | 0.33 | 0.72 | 0.70 | 1.88 | 0.41 | 3.67 | 7.60 |",
                "| sponza main 1280x720 | – | – | – | – | – | 1.39 |",
            ],
        );
    }
}
