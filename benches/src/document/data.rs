//! What was measured, to be asked for.

use crate::breakdown::table::Row;
use crate::contest::Kind;
use crate::record::Record;

/// The CSV files.
#[derive(Debug, Clone, Default)]
pub struct Data {
    /// Of the comparison.
    pub records: Vec<Record>,
    /// Of the whole frames.
    pub whole: Vec<Record>,
    /// Of the breakdown.
    pub stages: Vec<Row>,
}

impl Data {
    /// The views whose names begin so, in order.
    #[must_use]
    pub fn views(&self, start: &str) -> Vec<&str> {
        let mut views: Vec<&str> = Vec::new();
        for record in self.records.iter().filter(|record| record.view.starts_with(start)) {
            if views.last() != Some(&&*record.view) {
                views.push(&record.view);
            }
        }
        views
    }

    /// The scenes' views: all that are not made up.
    #[must_use]
    pub fn scenes(&self) -> Vec<&str> {
        let made_up =
            |view: &&str| ["micro ", "growth ", "pixels "].iter().any(|start| view.starts_with(start));
        self.views("").into_iter().filter(|view| !made_up(view)).collect()
    }

    /// The levels that drew depth, the fastest first.
    #[must_use]
    pub fn levels(&self) -> Vec<&str> {
        let mut levels: Vec<&str> = Vec::new();
        for record in self.records.iter().filter(|record| record.kind == Kind::Ours) {
            let name =
                record.contender.strip_prefix("halfplane ").and_then(|name| name.strip_suffix(" depth"));
            if let Some(level) = name.filter(|level| !levels.contains(level)) {
                levels.push(level);
            }
        }
        levels
    }

    /// What somebody took for a view.
    #[must_use]
    pub fn of(&self, view: &str, contender: &str, moving: bool) -> Option<&Record> {
        self.records
            .iter()
            .find(|record| record.view == view && record.contender == contender && record.moving == moving)
    }

    /// What a level took for a view's depth, with the camera standing still.
    #[must_use]
    pub fn depth(&self, view: &str, level: &str) -> Option<&Record> {
        self.of(view, &format!("halfplane {level} depth"), false)
    }

    /// What a level took for a view by attachments (`depth`, `depth D16`), with or without meshlets, with the
    /// camera standing still.
    #[must_use]
    pub fn way(&self, view: &str, level: &str, attachments: &str, meshlets: bool) -> Option<&Record> {
        let with = if meshlets { ", meshlets" } else { "" };
        self.of(view, &format!("halfplane {level} {attachments}{with}"), false)
    }

    /// Milliseconds of the read-modify-write of a 32-bit pixel in a view's run.
    #[must_use]
    pub fn read_modify_write(&self, view: &str) -> Option<f64> {
        let record = self.of(view, crate::contest::READ_MODIFY_WRITE, false)?;
        Some(record.min_ms / crate::limits::CLEAR_PIXELS as f64)
    }
}
