//! A scene from its truth to its rows: errors first, then all times in turns, in one go.

use std::time::{Duration, Instant};

use halfplane::Statistics;
use halfplane_measure::level::Level;
use halfplane_measure::limits::{CLEAR_PIXELS, Limit};
use halfplane_measure::protocol::{Contender, Plan, Summary, measure_and_tell};
use halfplane_measure::target::{Attachments, Prepared, Target};
use halfplane_reference::unsnapped;

use crate::choices;
use crate::error::ReportError;
use crate::row::{Answer, Entry};
use crate::savings::{Saving, savings};
use crate::scene::Scene;
use crate::truth::Truth;

/// What is told while a report is made.
pub trait Progress: Sync {
    /// What is being done, and the part of the whole that is done, from 0 to 1.
    fn at(&self, doing: &str, done: f64);
}

/// Tells nobody.
#[derive(Debug, Clone, Copy)]
pub struct Silent;

impl Progress for Silent {
    fn at(&self, _: &str, _: f64) {}
}

/// What a scene's page has.
#[derive(Debug, Clone)]
pub struct SceneReport {
    /// The scene's name.
    pub name: String,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Its vertices.
    pub vertices: usize,
    /// What became of the triangles.
    pub statistics: Statistics,
    /// Comparisons of the unsnapped picture that needed integers of unbounded size.
    pub decided_in_integers: u64,
    /// The clear of 1280x720 numbers of 32 bits: what tells machines apart.
    pub clear: Summary,
    /// What it did not need.
    pub savings: Vec<Saving>,
    /// The answers.
    pub answers: Vec<Answer>,
    /// How long all of this took, in seconds.
    pub seconds: f64,
}

impl SceneReport {
    /// The answer to a question.
    #[must_use]
    pub fn answer(&self, id: &str) -> Option<&Answer> {
        self.answers.iter().find(|answer| answer.question.id == id)
    }
}

/// How long each row is timed: at most `limit`, never fewer than 3 frames.
#[must_use]
pub fn plan(limit: Duration) -> Plan {
    Plan { warm_up: 6, frames: 120, rounds: 3, limit }
}

/// Measures one scene.
///
/// # Errors
///
/// [`ReportError`] where a scene cannot be drawn, or is not drawn as specified.
pub fn scene(scene: &Scene, limit: Duration, progress: &dyn Progress) -> Result<SceneReport, ReportError> {
    if scene.triangles() == 0 {
        return Err(ReportError::NoTriangles { scene: scene.name.clone() });
    }
    let started = Instant::now();
    let tell = |doing: &str, done: f64| progress.at(&format!("{}: {doing}", scene.name), done);
    tell("the exact picture", 0.0);
    let truth = Truth::new(scene, &|done| tell("the exact picture", 0.2 * done))?;
    let prepared = Prepared::new(&scene.positions, &scene.indices)?;
    let small = scene.resized(choices::FORMAT_SIZE);
    let small_truth = unsnapped(&small.model(&small.indices), &|_| ())?;
    let statistics = {
        let mut target = Target::new(&scene.positions, &scene.indices, &scene.state()?)?;
        target.frame(Level::detect(), Attachments::Depth32, &scene.matrix)?
    };

    let mut asked: Vec<(Answer, usize)> = Vec::new();
    let mut entries: Vec<Entry<'_>> = Vec::new();
    let questions = choices::QUESTIONS;
    for (place, question) in questions.iter().enumerate() {
        tell(question.title, 0.2 + 0.4 * place as f64 / questions.len() as f64);
        let (of, found) = match question.id {
            id if id == choices::SUBPIXEL.id => (scene, choices::subpixel(scene, &truth)?),
            id if id == choices::DEPTH.id => (scene, choices::depth(scene, &truth)?),
            id if id == choices::TRANSFORM.id => (scene, choices::transform(scene, &truth)?),
            id if id == choices::ANTIALIASING.id => (scene, choices::antialiasing(scene, &truth)?),
            id if id == choices::LEVELS.id => (scene, choices::levels(scene, &truth, &prepared)?),
            id if id == choices::FORMAT.id => (&small, choices::format(&small, &small_truth.ids)?),
            id if id == choices::CONFIGURATIONS.id => {
                (scene, choices::configurations(scene, &truth, &prepared)?)
            }
            id if id == choices::ABLATION.id => (scene, choices::ablation(scene, &small, &truth, &prepared)?),
            _ => (scene, choices::peers(scene, &truth)?),
        };
        asked.push((Answer { question: *question, size: of.dimensions(), rows: Vec::new() }, found.len()));
        entries.extend(found);
    }
    let clear = time(&mut entries, limit, &tell);
    let mut rows = entries.into_iter().map(|entry| entry.row);
    let answers = asked
        .into_iter()
        .map(|(answer, count)| Answer { rows: rows.by_ref().take(count).collect(), ..answer })
        .collect();
    tell("done", 1.0);
    Ok(SceneReport {
        name: scene.name.clone(),
        size: scene.size,
        triangles: scene.triangles(),
        vertices: scene.positions.len(),
        statistics,
        decided_in_integers: truth.unsnapped.decided_in_integers,
        clear,
        savings: savings(scene)?,
        answers,
        seconds: started.elapsed().as_secs_f64(),
    })
}

/// Times all frames in turns and enters the times into the rows; returns those of the clear.
fn time(entries: &mut [Entry<'_>], limit: Duration, tell: &dyn Fn(&str, f64)) -> Summary {
    let mut clear = Limit::new(CLEAR_PIXELS);
    let mut frames = vec![Contender { plan: plan(limit), frame: Box::new(move |_| clear.clear()) }];
    let mut places = Vec::new();
    for (place, entry) in entries.iter_mut().enumerate() {
        let Some(mut frame) = entry.frame.take() else { continue };
        let started = Instant::now();
        frame(0);
        let plan = plan(limit).for_frames_of(started.elapsed());
        frames.push(Contender { plan, frame });
        places.push(place);
    }
    tell("times, in turns", 0.6);
    let times = measure_and_tell(&mut frames, &mut |done| tell("times, in turns", 0.6 + 0.4 * done));
    let mut times = times.into_iter();
    let clear = times.next().unwrap_or_default();
    for (place, summary) in places.into_iter().zip(times) {
        entries[place].row.time = Some(summary);
    }
    clear
}
