//! The document's table of whole frames.

use super::data::Data;
use super::markdown::{cell, head, markdown};
use super::targets::{at_least, at_most, or_dash};
use crate::contest::Kind;
use crate::quoted::{self, ZEN3};
use crate::record::Record;
use crate::whole::{D16_QUERIES, PLAIN, QUERIES, THREADS};

/// Frames with questions over those of raw, both in clears, at most.
const QUESTIONS: f64 = 0.9;
/// Two threads over one, at least, on the largest pictures of the largest scene.
const SPEED_UP: f64 = 1.8;

/// Frames with questions beside plain ones and raw's, and frames by two threads.
pub(super) fn frames(data: &Data) -> Option<String> {
    let mut names = head(&["view"]);
    names.extend([PLAIN, QUERIES, D16_QUERIES].map(|way| format!("{way}, ms")));
    names.extend([QUERIES, D16_QUERIES].map(|way| format!("{way}, clears")));
    names.extend(
        ["*raw + queries* ¹", "target, clears", "better of both", THREADS, "speed-up"].map(str::to_owned),
    );
    let mut rows = Vec::new();
    let views = data.whole.iter().filter(|record| record.contender == PLAIN);
    for view in views.map(|record| &*record.view) {
        let of = |way: &str| data.whole.iter().find(|r| r.view == view && r.contender == way);
        let ms = |way| of(way).map(|record: &Record| record.min_ms);
        let clears = |way| of(way).map(|record: &Record| record.clears);
        let mut row = vec![view.to_owned()];
        row.extend([PLAIN, QUERIES, D16_QUERIES].map(|way| cell(ms(way), 3)));
        row.extend([QUERIES, D16_QUERIES].map(|way| cell(clears(way), 1)));
        let raw = quoted::of(view).map(|quoted| quoted.queries_ms[0]);
        row.push(or_dash(raw.map(|raw| format!("*{raw:.2} ms = {:.1}*", raw / ZEN3.clear_ms))));
        let target = raw.map(|raw| QUESTIONS * raw / ZEN3.clear_ms);
        row.push(cell(target, 1));
        let best = clears(QUERIES).into_iter().chain(clears(D16_QUERIES)).reduce(f64::min);
        row.push(or_dash(best.zip(target).map(|(best, target)| at_most(best, target))));
        row.push(cell(ms(THREADS), 3));
        let speed_up = ms(PLAIN).zip(ms(THREADS)).map(|(one, two)| one / two);
        let large = view.starts_with("sponza") && view.ends_with("1920x1080");
        row.push(or_dash(speed_up.map(|speed_up| {
            let verdict = if large { format!(", {}", at_least(speed_up, SPEED_UP)) } else { String::new() };
            format!("{speed_up:.2}{verdict}")
        })));
        rows.push(row);
    }
    let table = markdown(&names, &rows)?;
    let clear = data.whole.iter().filter(|record| record.kind == Kind::Unit).map(|record| record.min_ms);
    let first = data.whole.first()?;
    Some(format!(
        "Measured on: {}. Depth, one thread unless said, minima of {} frames; a clear of 1280x720 took {} ms at \
         least.\n\n{table}\n¹ Quoted, not measured here: {}, 16-bit depth, where a clear took {} ms. The target \
         is a tenth less than that in clears.",
        first.machine,
        first.frames,
        cell(clear.reduce(f64::min), 4),
        ZEN3.name,
        ZEN3.clear_ms,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contest::Outcome;
    use crate::record::{records, tests::row};

    #[test]
    fn figures_and_verdicts() {
        let rows = vec![
            row("clear of 1280x720 u32", Kind::Unit, 0.1),
            row(PLAIN, Kind::OursWhole, 0.9),
            row(QUERIES, Kind::OursWhole, 0.88),
            row(D16_QUERIES, Kind::OursWhole, 0.84),
            row(THREADS, Kind::OursWhole, 0.45),
        ];
        let outcome =
            |view: &str| Outcome { view: view.to_owned(), size: (1280, 720), samples: 1, rows: rows.clone() };
        let outcomes = [outcome("castle main 1280x720"), outcome("sponza main 1920x1080")];
        let data = Data { whole: records(&outcomes, "here"), ..Data::default() };
        let table = frames(&data).unwrap();
        for part in [
            "| castle main 1280x720 | 0.900 | 0.880 | 0.840 | 8.8 | 8.4 | *0.51 ms = 9.4* | 8.5 | met, 1.01× | 0.450 | 2.00 |",
            "| sponza main 1920x1080 | 0.900 | 0.880 | 0.840 | 8.8 | 8.4 | – | – | – | 0.450 | 2.00, met, 1.11× |",
            "Measured on: here. ",
            "took 0.1000 ms at least",
        ] {
            assert!(table.contains(part), "{part}: {table}");
        }
        assert_eq!(frames(&Data::default()), None);
    }
}
