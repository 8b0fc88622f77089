//! The comparison as CSV: a record for each contender and view.

use std::fs;
use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::contest::{Kind, Outcome};

/// A line of the file; times in milliseconds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The view's name.
    pub view: String,
    /// Its size in pixels.
    pub width: u32,
    /// Its size in pixels.
    pub height: u32,
    /// Samples that the view's triangles cover, each as often as it is covered.
    pub samples: u64,
    /// What was measured.
    pub contender: String,
    /// What it is.
    pub kind: Kind,
    /// Whether the camera moved.
    pub moving: bool,
    /// Triangles it was given.
    pub triangles: usize,
    /// Pixels covered in the view's own frame.
    pub covered: Option<usize>,
    /// Meshlets that were made beforehand, if any were.
    pub meshlets: Option<usize>,
    /// How long making them took, in milliseconds; in no other time.
    pub prepare_ms: Option<f64>,
    /// What they take.
    pub meshlet_bytes: Option<usize>,
    /// How many frames were measured.
    pub frames: u32,
    /// The shortest.
    pub min_ms: f64,
    /// A quarter took no longer.
    pub p25_ms: f64,
    /// Half of them took no longer.
    pub median_ms: f64,
    /// Three quarters took no longer.
    pub p75_ms: f64,
    /// The longest.
    pub max_ms: f64,
    /// The mean.
    pub mean_ms: f64,
    /// The standard deviation.
    pub sdev_ms: f64,
    /// The minimum over that of the clear of 1280x720 u32 in the same view's run.
    pub clears: f64,
    /// What it was measured on.
    pub machine: String,
}

/// Everything that was measured, as records.
#[must_use]
pub fn records(outcomes: &[Outcome], machine: &str) -> Vec<Record> {
    let of_outcome = |outcome: &Outcome| {
        let clear = outcome.clear();
        let of_row = |row: &crate::contest::Row| Record {
            view: outcome.view.clone(),
            width: outcome.size.0,
            height: outcome.size.1,
            samples: outcome.samples,
            contender: row.contender.clone(),
            kind: row.kind,
            moving: row.moving,
            triangles: row.triangles,
            covered: row.covered,
            meshlets: row.preparation.map(|cost| cost.meshlets),
            prepare_ms: row.preparation.map(|cost| cost.ms),
            meshlet_bytes: row.preparation.map(|cost| cost.bytes),
            frames: row.summary.frames,
            min_ms: row.summary.min,
            p25_ms: row.summary.p25,
            median_ms: row.summary.median,
            p75_ms: row.summary.p75,
            max_ms: row.summary.max,
            mean_ms: row.summary.mean,
            sdev_ms: row.summary.sdev,
            clears: row.summary.min / clear,
            machine: machine.to_owned(),
        };
        outcome.rows.iter().map(of_row).collect::<Vec<_>>()
    };
    outcomes.iter().flat_map(of_outcome).collect()
}

/// Writes the file, with its folder.
///
/// # Errors
///
/// What the file system says.
pub fn write(path: &Path, records: &[Record]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut writer = csv::Writer::from_path(path)?;
    records.iter().try_for_each(|record| writer.serialize(record))?;
    writer.flush()
}

/// Reads what [`write()`] wrote.
///
/// # Errors
///
/// The file, and what is wrong with it.
pub fn read(path: &Path) -> Result<Vec<Record>, String> {
    let read =
        || -> Result<Vec<Record>, csv::Error> { csv::Reader::from_path(path)?.deserialize().collect() };
    read().map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::contest::Row;
    use crate::ours::Preparation;
    use crate::protocol::Summary;

    /// A row of 10 triangles.
    pub(crate) fn row(contender: &str, kind: Kind, min: f64) -> Row {
        let preparation = Preparation { meshlets: 3, ms: 0.25, bytes: 4800 };
        Row {
            contender: contender.to_owned(),
            kind,
            moving: false,
            triangles: 10,
            covered: (kind != Kind::Unit).then_some(5),
            preparation: (kind == Kind::OursMeshlets).then_some(preparation),
            summary: Summary { frames: 3, min, median: min * 1.1, ..Summary::default() },
        }
    }

    /// An outcome of a clear, some of ours and a peer.
    pub(crate) fn outcome(view: &str, ours: &str) -> Outcome {
        Outcome {
            view: view.to_owned(),
            size: (1280, 720),
            samples: 7,
            rows: vec![
                row("clear", Kind::Unit, 0.5),
                row(ours, Kind::Ours, 2.0),
                row(&format!("{ours}, meshlets"), Kind::OursMeshlets, 1.5),
                row("halfplane fallback depth", Kind::Ours, 20.0),
                row("euc, \"quoted\"", Kind::Peer, 13.0),
            ],
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let expected = records(&[outcome("castle main 1280x720", "halfplane avx2 depth")], "here, now");
        assert_eq!(expected.len(), 5);
        assert_eq!((expected[1].meshlets, expected[2].meshlet_bytes), (None, Some(4800)));
        assert_eq!(expected[1].clears, 4.0);
        let folder = std::env::temp_dir().join(format!("halfplane-record-{}", std::process::id()));
        let path = folder.join("a.csv");
        write(&path, &expected).unwrap();
        let read = read(&path);
        fs::remove_dir_all(&folder).unwrap();
        assert_eq!(read, Ok(expected));
    }

    #[test]
    fn a_file_that_is_none_is_named() {
        assert!(read(Path::new("/nowhere/a.csv")).is_err_and(|message| message.contains("a.csv")));
    }
}
