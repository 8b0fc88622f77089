//! Whole frames that leave out what is hidden, and frames by several threads, beside plain ones of the same run.

use std::cell::RefCell;
use std::num::NonZeroUsize;
use std::sync::Arc;

use halfplane::{Cull, D16, D32, Region, Standard, State};
use halfplane_cli::mesh::Mesh;
use halfplane_measure::target::{Banded, Clustered, Occluded};

use crate::contest::{Field, Kind, Outcome, Row, samples};
use crate::limits::{CLEAR_PIXELS, Limit};
use crate::options::Options;
use crate::ours::{self, Attachments, Prepared, drawn};
use crate::protocol::{Frame, Summary, measure};
use crate::scenes::View;

/// Meshlets of the mesh as it is, in its order.
pub const PLAIN: &str = "meshlets";
/// Batches from front to back, with a question before each.
pub const QUERIES: &str = "queries";
/// The same with 16 bits of depth.
pub const D16_QUERIES: &str = "D16, queries";
/// Meshlets by two threads.
pub const THREADS: &str = "meshlets, 2 threads";

/// A mesh in meshlets, as it is and clustered: made once for all views of a scene.
#[derive(Debug, Default)]
pub struct Last(Option<(Arc<Mesh>, Prepared, Clustered)>);

impl Last {
    fn of(&mut self, view: &View) -> (&Prepared, &Clustered) {
        if self.0.as_ref().is_some_and(|(mesh, ..)| !Arc::ptr_eq(mesh, &view.mesh)) {
            self.0 = None;
        }
        let make = || {
            let Mesh { positions, indices, .. } = &*view.mesh;
            let prepared = drawn(Prepared::new(positions, indices));
            (Arc::clone(&view.mesh), prepared, drawn(Clustered::new(positions, indices)))
        };
        let (_, prepared, clustered) = self.0.get_or_insert_with(make);
        (prepared, clustered)
    }
}

/// Measures one view's depth in every way, at the fastest level. All must draw the same picture first.
///
/// # Errors
///
/// Which way drew another picture.
///
/// # Panics
///
/// If the view's size is none that a target can have.
pub fn run(view: &View, last: &mut Last, options: &Options) -> Result<Outcome, String> {
    let (prepared, clustered) = last.of(view);
    let (level, threads) = (ours::fastest(), NonZeroUsize::MIN.saturating_add(1));
    let region = Region::of_size(view.size.0, view.size.1).expect("views have sizes that targets can have");
    let state = State::<Standard> { cull: Cull::Back, ..State::new(region) };
    let unit = RefCell::new(Limit::new(CLEAR_PIXELS));
    let mut plain = ours::target(view);
    plain.set_meshlets(Some(prepared.meshlets()));
    let mut queries = Occluded::<D32>::new(clustered, &state, false);
    let mut small = Occluded::<D16>::new(clustered, &state, false);
    let mut bands = drawn(Banded::<D32>::new(prepared, &state, threads, false));

    // Twice: the second frame may be divided among threads otherwise.
    for _ in 0..2 {
        drawn(queries.frame(level, &view.matrix));
        drawn(small.frame(level, &view.matrix));
        drawn(bands.frame(level, &view.matrix));
        for (way, attachments, depths) in [
            (QUERIES, Attachments::Depth32, drawn(queries.depth_rows())),
            (D16_QUERIES, Attachments::Depth16, drawn(small.depth_rows())),
            (THREADS, Attachments::Depth32, drawn(bands.depth_rows())),
        ] {
            drawn(plain.frame(level, attachments, &view.matrix));
            if depths != drawn(plain.depth_rows(attachments)) {
                return Err(format!("{}: {way} draws another picture than {PLAIN}", view.name));
            }
        }
    }
    let covered = plain.covered(Attachments::Depth32);
    let row = |contender: &str, kind| Row {
        contender: contender.to_owned(),
        kind,
        moving: false,
        triangles: if kind == Kind::Unit { 0 } else { view.mesh.triangles() },
        covered: (kind != Kind::Unit).then_some(covered),
        preparation: None,
        summary: Summary::default(),
    };
    let matrix = &view.matrix;
    let contenders: [(&str, Kind, Frame<'_>); 5] = [
        ("clear of 1280x720 u32", Kind::Unit, Box::new(|_| unit.borrow_mut().clear())),
        (PLAIN, Kind::OursWhole, Box::new(|_| _ = drawn(plain.frame(level, Attachments::Depth32, matrix)))),
        (QUERIES, Kind::OursWhole, Box::new(|_| _ = drawn(queries.frame(level, matrix)))),
        (D16_QUERIES, Kind::OursWhole, Box::new(|_| _ = drawn(small.frame(level, matrix)))),
        (THREADS, Kind::OursWhole, Box::new(|_| drawn(bands.frame(level, matrix)))),
    ];
    let mut field = Field::default();
    for (name, kind, frame) in contenders {
        field.enter(row(name, kind), options.plan, frame);
    }
    let Field { mut rows, mut contenders } = field;
    for (row, summary) in rows.iter_mut().zip(measure(&mut contenders)) {
        row.summary = summary;
    }
    Ok(Outcome { view: view.name.clone(), size: view.size, samples: samples(view), rows })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::growth;

    #[test]
    fn every_way_is_measured() {
        let view = growth::view(1000, (64, 36));
        let options = Options::parse(["--frames", "5", "--seconds", "1"].map(str::to_owned)).unwrap();
        let outcome = run(&view, &mut Last::default(), &options).unwrap();
        for way in [PLAIN, QUERIES, D16_QUERIES, THREADS] {
            let row = outcome.rows.iter().find(|row| row.contender == way).unwrap();
            assert!(row.summary.frames >= 3 && row.summary.min > 0.0, "{row:?}");
            assert_eq!(row.covered, Some(64 * 36));
        }
        assert!(outcome.clear() > 0.0);
    }
}
