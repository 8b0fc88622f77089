//! The command `bench`: frames of one scene by the protocol, in turns with what the machine can do at
//! best.

mod report;

use std::cell::RefCell;
use std::hint::black_box;
use std::time::Duration;

use halfplane::bins::TileOrder;
use halfplane::simd::{Occlusion, RowAttachment};
use halfplane::{D16, D32, Depth, DepthFormat, HierarchicalDepth, Standard, Statistics};

use crate::args::{self, Attachments, Bench};
use crate::camera::Matrix;
use crate::command::{self, Subject};
use crate::error::Error;
use crate::level::Level;
use crate::measure::limits::{CLEAR_PIXELS, Limit};
use crate::measure::motion::Motion;
use crate::measure::protocol::{Contender, Frame, Plan, Summary, measure};
use crate::mesh::Mesh;
use crate::render::Settings;
use crate::target::{Banded, Binned, Occluded, Preparation, Prepared, Stage, Target, TargetError};
use crate::way::{BINNED, Way};

/// What was measured, and of what.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The mesh's file, or the built-in scene.
    pub scene: String,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The level's name.
    pub level: &'static str,
    /// What the frames write.
    pub attachments: Attachments,
    /// Bits of a depth.
    pub depth_bits: u32,
    /// Whether the camera moved.
    pub moving: bool,
    /// Frames before the measured ones.
    pub warm_up: u32,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// What the meshlets cost, if they were made.
    pub preparation: Option<Preparation>,
    /// Threads that draw.
    pub threads: usize,
    /// What was asked where the camera stands, if frames ask what is hidden.
    pub asked: Option<Occlusion>,
    /// What became of the triangles, where the camera stands.
    pub statistics: Statistics,
    /// Pixels covered there.
    pub covered: usize,
    /// Whole frames: clear, transform, draw.
    pub frame: Summary,
    /// The limits.
    pub limits: Limits,
}

/// What the machine can do at best.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// The clear of 1280x720 numbers of 32 bits.
    pub clear: Summary,
    /// Reading, changing and writing them.
    pub read_modify_write: Summary,
    /// The vertex stage alone.
    pub transform: Summary,
}

/// Measures, and prints a table or JSON.
///
/// # Errors
///
/// [`Error`] for a mesh or camera that is no good.
pub fn run_bench(arguments: &Bench) -> Result<(), Error> {
    let Bench { picture, json, .. } = arguments;
    let (subject, matrix, settings) =
        command::prepare(picture.file.as_deref(), &picture.options, &mut |_| ())?;
    let outcome = run(&subject, &matrix, &settings, arguments)?;
    command::print(&if *json { outcome.json() } else { outcome.table() })
}

/// A frame that is no plain draw: what became of the triangles, where one thread knows, and what was asked.
type WholeFrame<'m> =
    Box<dyn FnMut(Level, &Matrix) -> Result<(Option<Statistics>, Option<Occlusion>), TargetError> + 'm>;

/// The frame of a way; nothing for plain draws.
fn whole_frame<'m, D: DepthFormat<Standard, Texel: Send>>(
    way: &'m Way,
    mesh: &'m Mesh,
    settings: &Settings,
    arguments: &Bench,
) -> Result<Option<WholeFrame<'m>>, Error>
where
    for<'a> Depth<'a, Standard, D>: RowAttachment,
    for<'a> HierarchicalDepth<'a, Standard, D>: RowAttachment,
{
    let (state, with_ids) = (settings.state(), arguments.attachments == Attachments::DepthIds);
    let written = matches!(arguments.attachments, Attachments::Depth | Attachments::DepthIds);
    let order = if arguments.hilbert { TileOrder::Hilbert } else { TileOrder::Rows };
    Ok(Some(match way {
        Way::Triangles | Way::Meshlets(_) => return Ok(None),
        Way::Bins(_) if !with_ids => {
            let message = "--binned is measured with depth and ids: add --attachments depth+ids";
            return Err(Error::Usage(message.to_owned()));
        }
        _ if !written => {
            let message = "--queries and --threads are measured with --attachments depth or depth+ids";
            return Err(Error::Usage(message.to_owned()));
        }
        Way::Queries(clustered) => {
            let mut target = Occluded::<D>::new(clustered, &state, with_ids);
            Box::new(move |level, matrix| {
                let (statistics, occlusion) = target.frame(level, matrix)?;
                Ok((Some(statistics), Some(occlusion)))
            })
        }
        Way::Bins(threads) => {
            let (positions, indices) = (&mesh.positions, &mesh.indices);
            let mut target = Binned::<D>::new(positions, indices, &state, order, *threads, BINNED)?;
            Box::new(move |level, matrix| Ok((Some(target.frame(level, matrix)?.0), None)))
        }
        Way::Bands(prepared, threads) => {
            let mut target = Banded::<D>::new(prepared, &state, *threads, with_ids)?;
            Box::new(move |level, matrix| {
                target.frame(level, matrix)?;
                Ok((None, None))
            })
        }
    }))
}

fn run(subject: &Subject, matrix: &Matrix, settings: &Settings, arguments: &Bench) -> Result<Outcome, Error> {
    let size = (settings.region.width(), settings.region.height());
    let mesh = &subject.mesh;
    let (level, attachments) = (settings.level, arguments.attachments.in_format(settings.depth));
    let way = Way::of(mesh, &arguments.picture.options)?;
    let mut target = Target::new(&mesh.positions, &mesh.indices, &settings.state())?;
    target.set_meshlets(way.meshlets().map(Prepared::meshlets));
    let mut statistics = target.frame(level, attachments, matrix)?;
    let covered = target.covered(attachments);
    let mut whole = match settings.depth {
        args::DepthFormat::D32 => whole_frame::<D32>(&way, mesh, settings, arguments)?,
        args::DepthFormat::D16 => whole_frame::<D16>(&way, mesh, settings, arguments)?,
    };
    let mut asked = None;
    if let Some(whole) = &mut whole {
        let (drawn, occlusion) = whole(level, matrix)?;
        statistics = drawn.unwrap_or(statistics);
        asked = occlusion;
    }
    let whole = RefCell::new(whole);

    let motion = arguments.moving.then(|| Motion::new(&mesh.positions, matrix, size));
    let target = RefCell::new(target);
    let limit = RefCell::new(Limit::new(CLEAR_PIXELS));
    let frames: [Frame<'_>; 4] = [
        Box::new(|_| limit.borrow_mut().clear()),
        Box::new(|_| limit.borrow_mut().read_modify_write()),
        Box::new(|_| {
            // What it refuses it would have refused above.
            let _ = black_box(target.borrow_mut().stage(level, Stage::Transform, matrix));
        }),
        Box::new(|number| {
            let matrix = motion.as_ref().map_or(*matrix, |motion| motion.at(number));
            match &mut *whole.borrow_mut() {
                Some(whole) => drop(black_box(whole(level, &matrix))),
                None => drop(black_box(target.borrow_mut().frame(level, attachments, &matrix))),
            }
        }),
    ];
    let plan = Plan {
        warm_up: arguments.warm_up,
        frames: arguments.frames,
        rounds: Plan::CLASSIC.rounds.min(arguments.frames),
        limit: Duration::MAX,
    };
    let mut contenders = frames.map(|frame| Contender { plan, frame });
    let summaries = measure(&mut contenders);
    let summary = |place: usize| summaries.get(place).copied().unwrap_or_default();
    Ok(Outcome {
        scene: subject.name.clone(),
        size,
        level: level.name(),
        attachments: arguments.attachments,
        depth_bits: settings.depth.bits(),
        moving: arguments.moving,
        warm_up: arguments.warm_up,
        vertices: mesh.positions.len(),
        triangles: mesh.triangles(),
        preparation: way.preparation(),
        threads: arguments.picture.options.threads.get(),
        asked,
        statistics,
        covered,
        limits: Limits { clear: summary(0), read_modify_write: summary(1), transform: summary(2) },
        frame: summary(3),
    })
}
