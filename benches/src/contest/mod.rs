//! One view: machine limits, the rasterizer and its peers, all in turns.

mod same;

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use halfplane::{ClipPositions, Count, Cull, Region, Standard, State, Viewport, draw};
use halfplane_measure::clip;
use serde::{Deserialize, Serialize};

use crate::limits::{CLEAR_PIXELS, Limit};
use crate::options::Options;
use crate::ours::{self, Attachments, Level, MEASURED, Preparation, Prepared, Stage, Target, drawn};
use crate::peers::{self, Peer, visible::Visible};
use crate::protocol::{Contender, Frame, Plan, Summary, measure};
use crate::scenes::View;
use same::same_picture;

/// What the rows of a contest are about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The unit of all times: the clear of 1280x720 pixels of 32 bits.
    Unit,
    /// Another limit of the machine.
    Limit,
    /// The rasterizer.
    Ours,
    /// The rasterizer with meshlets that were made beforehand.
    OursMeshlets,
    /// The rasterizer in another way of drawing whole frames.
    OursWhole,
    /// The rasterizer on the triangles that 2D crates are given.
    OursVisible,
    /// A crate that draws the mesh from object space.
    Peer,
    /// A crate that draws window triangles.
    Peer2d,
}

/// The times of one contender.
#[derive(Debug, Clone)]
pub struct Row {
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
    /// What was prepared once and is not in the times.
    pub preparation: Option<Preparation>,
    /// The times.
    pub summary: Summary,
}

/// All rows of one view.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The view.
    pub view: String,
    /// Its size in pixels.
    pub size: (u32, u32),
    /// Samples that its triangles cover, each as often as it is covered.
    pub samples: u64,
    /// In the order they were measured in.
    pub rows: Vec<Row>,
}

/// The contender that is the limit of what a depth test can be.
pub const READ_MODIFY_WRITE: &str = "read-modify-write of 1280x720 u32";

/// The row of the fastest level's depth.
pub const MAIN: Attachments = Attachments::Depth32;

impl Outcome {
    /// Milliseconds of one clear of 1280x720, the shortest of this run.
    #[must_use]
    pub fn clear(&self) -> f64 {
        self.rows.iter().find(|row| row.kind == Kind::Unit).map_or(f64::NAN, |row| row.summary.min)
    }

    /// The row that a row is compared with: the fastest of ours on the same triangles.
    #[must_use]
    pub fn ours_beside(&self, row: &Row) -> Option<&Row> {
        let kind = match row.kind {
            Kind::Peer => Kind::Ours,
            Kind::Peer2d => Kind::OursVisible,
            _ => return None,
        };
        let same = |ours: &&Row| ours.kind == kind && ours.moving == row.moving;
        self.rows
            .iter()
            .filter(same)
            .find(|ours| ours.contender.ends_with(MAIN.name()))
            .or_else(|| self.rows.iter().find(same))
    }

    /// The row of a level's depth or 16-bit depth with meshlets, of the view's own camera.
    #[must_use]
    pub fn meshlets_of(&self, level: Level, attachments: Attachments) -> Option<&Row> {
        let name = meshlets_name(level, attachments);
        self.rows.iter().find(|row| row.kind == Kind::OursMeshlets && !row.moving && row.contender == name)
    }

    /// The row of a level's depth, of the view's own camera.
    #[must_use]
    pub fn depth_of(&self, level: Level) -> Option<&Row> {
        let name = ours_name(level, MAIN);
        self.rows.iter().find(|row| row.kind == Kind::Ours && !row.moving && row.contender == name)
    }
}

fn ours_name(level: Level, attachments: Attachments) -> String {
    format!("halfplane {} {}", level.name(), attachments.name())
}

fn meshlets_name(level: Level, attachments: Attachments) -> String {
    format!("{}, meshlets", ours_name(level, attachments))
}

/// The attachments that are measured with meshlets, at the fastest level.
const WITH_MESHLETS: [Attachments; 2] = [MAIN, Attachments::Depth16];

/// Contenders, and what is known of them before they are timed.
#[derive(Default)]
pub(crate) struct Field<'a> {
    pub(crate) rows: Vec<Row>,
    pub(crate) contenders: Vec<Contender<'a>>,
}

impl<'a> Field<'a> {
    /// Draws the first frame, and enters the contender with a plan for frames of that length.
    pub(crate) fn enter(&mut self, row: Row, plan: Plan, mut frame: Frame<'a>) {
        let started = Instant::now();
        frame(0);
        let plan = plan.for_frames_of(started.elapsed());
        self.rows.push(row);
        self.contenders.push(Contender { plan, frame });
    }
}

/// Measures one view, with meshlets too if there are any. All levels must draw the same picture first, in
/// every way.
///
/// # Errors
///
/// Which level drew another picture.
pub fn run(view: &View, prepared: Option<&Prepared>, options: &Options) -> Result<Outcome, String> {
    let levels = ours::available();
    let target = RefCell::new(ours::target(view));
    let covered = same_picture(view, prepared, &mut target.borrow_mut(), &levels)?;
    let visible = Visible::new(&view.plain());
    let (unit, same_size) = (RefCell::new(Limit::new(CLEAR_PIXELS)), RefCell::new(Limit::new(view.pixels())));
    let visible_target = RefCell::new(ours::with_indices(view, &visible.indices));
    let peers = RefCell::new(Vec::new());
    if options.peers.is_some() && view.peers {
        *peers.borrow_mut() = ready(view, &visible);
    }

    let mut field = Field::default();
    enter_limits(&mut field, view, options.plan, &unit, &same_size, &target);
    let row = Row {
        contender: String::new(),
        kind: Kind::Ours,
        moving: false,
        triangles: view.mesh.triangles(),
        covered: Some(covered),
        preparation: None,
        summary: Summary::default(),
    };
    for (place, &level) in levels.iter().enumerate() {
        // In between, the still camera of whole scenes says enough.
        let middle = place > 0 && place + 1 < levels.len();
        if middle && !view.detail {
            continue;
        }
        let all = view.detail && place == 0;
        for attachments in MEASURED.into_iter().filter(|&a| a == MAIN || all) {
            for moving in [false, true] {
                if moving && (middle || !view.detail || attachments != MAIN) {
                    continue;
                }
                let row = Row { contender: ours_name(level, attachments), moving, ..row.clone() };
                field.enter(row, options.plan, frames(view, &target, None, (level, attachments), moving));
            }
        }
        let Some(prepared) = prepared.filter(|_| place == 0) else { continue };
        for attachments in WITH_MESHLETS {
            for moving in [false, true] {
                if moving && !(view.detail && attachments == MAIN) {
                    continue;
                }
                let row = Row {
                    contender: meshlets_name(level, attachments),
                    kind: Kind::OursMeshlets,
                    moving,
                    preparation: Some(prepared.preparation()),
                    ..row.clone()
                };
                let frame = frames(view, &target, Some(prepared), (level, attachments), moving);
                field.enter(row, options.plan, frame);
            }
        }
    }
    let count = peers.borrow().len();
    if let (Some(plan), Some(&level), false) = (options.peers, levels.first(), count == 0) {
        if !visible.indices.is_empty() {
            drawn(visible_target.borrow_mut().frame(level, MAIN, &view.matrix));
            let row = Row {
                contender: format!("{}, visible only", ours_name(level, MAIN)),
                kind: Kind::OursVisible,
                triangles: visible.corners.len(),
                covered: Some(visible_target.borrow().covered(MAIN)),
                ..row.clone()
            };
            let target = &visible_target;
            let frame = Box::new(move |_| {
                drawn(target.borrow_mut().frame(level, MAIN, &view.matrix));
            });
            field.enter(row, options.plan, frame);
        }
        for place in 0..count {
            enter_peer(&mut field, view, plan, &peers, place);
        }
    }
    let Field { mut rows, mut contenders } = field;
    for (row, summary) in rows.iter_mut().zip(measure(&mut contenders)) {
        row.summary = summary;
    }
    Ok(Outcome { view: view.name.clone(), size: view.size, samples: samples(view), rows })
}

/// Frames of ours.
fn frames<'a>(
    view: &'a View,
    target: &'a RefCell<Target<'a>>,
    prepared: Option<&'a Prepared>,
    (level, attachments): (Level, Attachments),
    moving: bool,
) -> Frame<'a> {
    let motion = view.motion();
    let meshlets = prepared.map(Prepared::meshlets);
    Box::new(move |number| {
        let matrix = if moving { motion.at(number) } else { view.matrix };
        let mut target = target.borrow_mut();
        target.set_meshlets(meshlets);
        drawn(target.frame(level, attachments, &matrix));
    })
}

/// Samples that a view's triangles cover, each as often as it is covered.
///
/// # Panics
///
/// If the view's size is none that a target can have.
#[must_use]
pub fn samples(view: &View) -> u64 {
    let region = Region::of_size(view.size.0, view.size.1).expect("views have sizes that targets can have");
    let state = State { cull: Cull::Back, ..State::<Standard>::new(region) };
    let vertices: Vec<_> = view.mesh.positions.iter().map(|&position| clip(position, &view.matrix)).collect();
    let positions = ClipPositions::new(&vertices, Viewport::new(region));
    let mut count = Count::default();
    draw(&positions, &view.mesh.indices, 0, &state, &mut count).expect("views have indices that exist");
    count.samples
}

/// About how long that many whole scenes and made-up views take at most, in seconds.
#[must_use]
pub fn most_seconds(scenes: usize, made: usize, options: &Options) -> f64 {
    let middle = ours::available().len().saturating_sub(2);
    let (limits, ends, meshlets, visible, peers, moving_peers) = (5, 2, 3, 1, 4, 2);
    let of_scene = limits + MEASURED.len() + ends + middle + meshlets + visible;
    let ours = (scenes * of_scene + made * (limits + ends)) as f64 * options.plan.limit.as_secs_f64();
    let peers = (scenes * (peers + moving_peers) + made * peers / 2) as f64
        * options.peers.map_or(0.0, |plan| plan.limit.as_secs_f64());
    // Made-up views have a few frames that are longer than any limit.
    ours + peers + made as f64 * 8.0
}

/// The peers that draw something of the view; those that panic are left out, with a message.
fn ready(view: &View, visible: &Visible) -> Vec<Box<dyn Peer>> {
    let mut peers = peers::all(&view.plain(), visible);
    peers.retain_mut(|peer| {
        let drawn = catch_unwind(AssertUnwindSafe(|| peer.frame(&view.matrix))).is_ok();
        if !drawn {
            eprintln!("{}: {} panics and is left out", view.name, peer.name());
        }
        drawn && peer.triangles() > 0
    });
    peers
}

fn enter_limits<'a>(
    field: &mut Field<'a>,
    view: &'a View,
    plan: Plan,
    unit: &'a RefCell<Limit>,
    same_size: &'a RefCell<Limit>,
    target: &'a RefCell<Target<'a>>,
) {
    let fastest = ours::fastest();
    let (width, height) = view.size;
    let mut contenders: Vec<(String, Kind, Frame<'a>)> = vec![
        ("clear of 1280x720 u32".to_owned(), Kind::Unit, Box::new(|_| unit.borrow_mut().clear())),
        (READ_MODIFY_WRITE.to_owned(), Kind::Limit, Box::new(|_| unit.borrow_mut().read_modify_write())),
        (
            "clear of the frame's own depth".to_owned(),
            Kind::Limit,
            Box::new(move |_| drawn(target.borrow_mut().stage(fastest, Stage::Clear(MAIN), &view.matrix))),
        ),
        (
            "transform of all vertices".to_owned(),
            Kind::Limit,
            Box::new(move |_| drawn(target.borrow_mut().stage(fastest, Stage::Transform, &view.matrix))),
        ),
    ];
    if view.pixels() != CLEAR_PIXELS {
        let name = format!("read-modify-write of {width}x{height} u32");
        contenders.insert(2, (name, Kind::Limit, Box::new(|_| same_size.borrow_mut().read_modify_write())));
    }
    for (contender, kind, frame) in contenders {
        let row = Row {
            contender,
            kind,
            moving: false,
            triangles: 0,
            covered: None,
            preparation: None,
            summary: Summary::default(),
        };
        field.enter(row, plan, frame);
    }
}

fn enter_peer<'a>(
    field: &mut Field<'a>,
    view: &'a View,
    plan: Plan,
    peers: &'a RefCell<Vec<Box<dyn Peer>>>,
    place: usize,
) {
    let (row, moves) = {
        let peer = &peers.borrow()[place];
        let row = Row {
            contender: peer.name().to_owned(),
            kind: if peer.moves() { Kind::Peer } else { Kind::Peer2d },
            moving: false,
            triangles: peer.triangles(),
            covered: Some(peer.covered()),
            preparation: None,
            summary: Summary::default(),
        };
        (row, peer.moves())
    };
    for moving in [false, true] {
        if moving && !(moves && view.detail) {
            continue;
        }
        let motion = view.motion();
        let frame = Box::new(move |number| {
            let matrix = if moving { motion.at(number) } else { view.matrix };
            peers.borrow_mut()[place].frame(&matrix);
        });
        field.enter(Row { moving, ..row.clone() }, plan, frame);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::growth;

    #[test]
    fn everybody_is_measured() {
        let view = View { peers: true, detail: true, ..growth::view(1000, (64, 36)) };
        let options = Options::parse(["--frames", "5", "--seconds", "1"].map(str::to_owned)).unwrap();
        let mut last = ours::Last::default();
        let prepared = last.of(&view, |_| ());
        let outcome = run(&view, Some(prepared), &options).unwrap();
        for name in ["clear of 1280x720 u32", "halfplane fallback depth", "euc", "retrofire", "tiny-skia"] {
            let row = outcome.rows.iter().find(|row| row.contender == name).unwrap();
            assert!(row.summary.frames >= 3 && row.summary.min > 0.0, "{row:?}");
        }
        for attachments in WITH_MESHLETS {
            let row = outcome.meshlets_of(ours::fastest(), attachments).unwrap();
            assert!(row.summary.min > 0.0 && row.preparation == Some(prepared.preparation()), "{row:?}");
            assert_eq!(row.covered, outcome.depth_of(ours::fastest()).unwrap().covered);
        }
        let without = run(&view, None, &options).unwrap();
        assert!(without.meshlets_of(ours::fastest(), MAIN).is_none());
        assert!(outcome.clear() > 0.0);
        assert!(outcome.rows.iter().any(|row| row.contender == "euc" && row.moving));
        let euc = outcome.rows.iter().find(|row| row.contender == "euc" && !row.moving).unwrap();
        let beside = outcome.ours_beside(euc).unwrap();
        assert_eq!(beside.contender, ours_name(ours::available()[0], MAIN));
    }
}
