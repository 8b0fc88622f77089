//! The command `report`: error against run time of every choice, as a page.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use halfplane_report::leaving_out;
use halfplane_report::page::Report;
use halfplane_report::run::{self, Progress};
use halfplane_report::scene::Scene;
use halfplane_report::stiffness;
use indicatif::{ProgressBar, ProgressStyle};

use crate::args::{self, Options};
use crate::command;
use crate::error::Error;
use crate::measure::machine;
use crate::output::Outputs;

/// Scenes that are reported on where they are, and the camera of each.
const BESIDE: [(&str, &str); 2] = [("castle", "main"), ("sponza", "gallery")];

/// Measures, writes the page, prints a summary.
///
/// # Errors
///
/// [`Error`] for a mesh or camera that is no good, or a page that cannot be written.
pub fn run_report(arguments: &args::Report) -> Result<(), Error> {
    let (scenes, absent) = scenes(arguments)?;
    let bar = Bar::new(scenes.len() + 1);
    let mut reports = Vec::new();
    for scene in &scenes {
        reports.push(run::scene(scene, Duration::from_secs_f64(arguments.seconds), &bar)?);
        bar.next();
    }
    let ladders = stiffness::climb(&bar)?;
    let checks = stiffness::checks::all()?;
    let programs = if arguments.no_programs {
        Err("left out, as --no-programs asks".to_owned())
    } else {
        bar.at("linking programs", 1.0);
        leaving_out::programs()
    };
    bar.bar.finish_and_clear();
    let report = Report {
        command: command_line(arguments),
        machine: machine::describe(),
        scenes: reports,
        ladders,
        checks,
        programs,
        max_error: arguments.max_error,
        absent,
    };
    let mut outputs = Outputs::new(&arguments.picture.options.out);
    for file in report.files()? {
        outputs.add(&file.name, file.text.into_bytes());
    }
    let paths: Vec<String> = outputs.paths().map(|path| path.display().to_string()).collect();
    outputs.commit()?;
    command::print(&format!("{}\nwrote {}\n", halfplane_report::page::terminal(&report), paths.join(", ")))
}

/// The model that is asked for; without one, the built-in scene and those beside it.
fn scenes(arguments: &args::Report) -> Result<(Vec<Scene>, Vec<String>), Error> {
    let args::Picture { file, options } = &arguments.picture;
    if file.is_some() {
        return Ok((vec![scene(file.as_deref(), options)?], Vec::new()));
    }
    let (mut scenes, mut absent) = (vec![scene(None, options)?], Vec::new());
    for (name, camera) in BESIDE {
        let path = arguments.scenes.join(name).with_extension("bin");
        if !path.exists() {
            absent.push(format!("{name}: there is no {}", path.display()));
            continue;
        }
        let options = Options { camera: Some(camera.to_owned()), ..Options::of_size(options.size) };
        let loaded = scene(Some(&path), &options)?;
        scenes.push(Scene { name: format!("{name} {camera}"), ..loaded });
    }
    Ok((scenes, absent))
}

fn scene(file: Option<&Path>, options: &Options) -> Result<Scene, Error> {
    let (subject, matrix, settings) = command::prepare(file, options, &mut |_| ())?;
    let name = match file {
        Some(path) => {
            path.file_name().map_or_else(|| subject.name.clone(), |name| name.to_string_lossy().into_owned())
        }
        None => subject.name.clone(),
    };
    let scene = Scene {
        name,
        positions: subject.mesh.positions,
        indices: subject.mesh.indices,
        matrix,
        size: options.size,
        two_sided: false,
    };
    Ok(scene.wound(settings.cull, settings.front))
}

/// As one would type it, without where it was written.
fn command_line(arguments: &args::Report) -> String {
    let args::Picture { file, options } = &arguments.picture;
    let mut line = "cargo run --release -- report".to_owned();
    if let Some(name) = file.as_ref().and_then(|path| path.file_name()) {
        line.push_str(&format!(" {}", name.to_string_lossy()));
    }
    let (width, height) = options.size;
    let plain = Options::of_size(options.size);
    if options.size != Options::DEFAULT_SIZE {
        line.push_str(&format!(" --size {width}x{height}"));
    }
    if let (Some(camera), None) = (&options.camera, &plain.camera) {
        line.push_str(&format!(" --camera {camera}"));
    }
    if arguments.seconds != args::Report::SECONDS {
        line.push_str(&format!(" --seconds {}", arguments.seconds));
    }
    if let Some(most) = arguments.max_error {
        line.push_str(&format!(" --max-error {most}"));
    }
    line
}

/// On standard error, and only where that is a terminal.
struct Bar {
    bar: ProgressBar,
    /// Scenes that are done; the ladder is as long as one.
    done: AtomicU64,
}

/// Steps of the bar for each scene.
const STEPS: u64 = 1000;

impl Bar {
    fn new(scenes: usize) -> Self {
        let bar = ProgressBar::new(scenes as u64 * STEPS);
        let style = ProgressStyle::with_template("{bar:30} {percent:>3} % ({elapsed}) {msg}");
        let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        Self { bar, done: AtomicU64::new(0) }
    }

    fn next(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}

impl Progress for Bar {
    fn at(&self, doing: &str, done: f64) {
        let steps = self.done.load(Ordering::Relaxed) * STEPS;
        self.bar.set_position(steps + (done * STEPS as f64) as u64);
        self.bar.set_message(doing.to_owned());
    }
}
