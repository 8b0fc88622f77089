//! The stages of a frame, by instructions (callgrind) and by time (perf), at every level:
//!
//! ```text
//! cargo run --profile counted -p halfplane-benches --example breakdown
//! ```
//!
//! `--help` tells the rest. Without valgrind or perf, their half of the table is empty.

use std::collections::HashMap;
use std::env;
use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;

use clap::Parser;
use halfplane_benches::breakdown::lines::Lines;
use halfplane_benches::breakdown::table::{self, Row};
use halfplane_benches::breakdown::{Part, callgrind, child, perf};
use halfplane_benches::contest::MAIN;
use halfplane_benches::options::{in_target, root};
use halfplane_benches::ours::{self, Level, Stage, drawn};
use halfplane_benches::protocol::{Contender, Frame, Plan, measure};
use halfplane_benches::scenes;

/// Prints where a frame's instructions and time go, stage by stage, at every level, and writes them as CSV.
#[derive(Debug, Parser)]
struct Arguments {
    /// Views, by their whole names
    #[arg(value_name = "VIEW", default_values = ["built-in terrace 1280x720", "castle main 1280x720", "sponza gallery 1280x720"])]
    views: Vec<String>,
    /// Seconds of samples for each level
    #[arg(long, value_name = "S", default_value_t = 2.0)]
    seconds: f64,
    /// Where castle.bin, sponza.bin and their cameras are [default: ../shared/scenes]
    #[arg(long, value_name = "DIR")]
    scenes: Option<PathBuf>,
    /// Where the CSV goes [default: target/halfplane-breakdown.csv]
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Not for people: be the process that is counted.
    #[arg(long, hide = true)]
    count: bool,
    /// Not for people: be the process that is sampled, at this level.
    #[arg(long, hide = true)]
    sample: Option<String>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let folder = arguments.scenes.clone().unwrap_or_else(|| root().join("../shared/scenes"));
    if arguments.count || arguments.sample.is_some() {
        let view = scenes::named(&folder, arguments.views.first().map_or("", String::as_str))?;
        let watched = match &arguments.sample {
            None => child::count(&view),
            Some(name) => {
                let level = ours::from_name(name).ok_or_else(|| format!("no such level: {name}"))?;
                child::draw_for(&view, level, arguments.seconds)
            }
        };
        return watched.map_err(|error| error.to_string());
    }
    let program = env::current_exe().map_err(|error| error.to_string())?;
    let mut lines = Lines::new(&program)?;
    let dumps = in_target("halfplane-breakdown");
    fs::create_dir_all(&dumps).map_err(|error| format!("{}: {error}", dumps.display()))?;
    let mut watch = Watch { program, lines: &mut lines, folder, dumps, seconds: arguments.seconds };
    let mut rows = Vec::new();
    for name in &arguments.views {
        match watch.view(name) {
            Ok(view) => {
                print!("{}", table::table(&view));
                rows.extend(view);
            }
            Err(reason) => println!("\nSKIPPED: {name}: {reason}"),
        }
    }
    let csv = arguments.csv.clone().unwrap_or_else(|| in_target("halfplane-breakdown.csv"));
    table::write(&csv, &rows).map_err(|error| format!("{}: {error}", csv.display()))?;
    println!(
        "\nInstructions are callgrind's, which emulates AVX2 at most. Times are those of a whole frame, divided by \
         {} samples.\nAn instruction belongs to the stage from whose file it was inlined; transform holds clipping, \
         cull the fetch of\nindices and vertices, other what is the standard library's or nobody's.",
        if perf::installed() { "perf's" } else { "no (perf is not installed: apt-get install linux-perf)" }
    );
    for stranger in lines.strangers() {
        println!("WARNING: no stage is known for {stranger} (benches/src/breakdown/mod.rs)");
    }
    println!("written: {}", csv.display());
    Ok(())
}

/// What watching takes.
struct Watch<'l> {
    program: PathBuf,
    lines: &'l mut Lines,
    folder: PathBuf,
    dumps: PathBuf,
    seconds: f64,
}

impl Watch<'_> {
    fn view(&mut self, name: &str) -> Result<Vec<Row>, String> {
        let view = scenes::named(&self.folder, name)?;
        let counted = self.count(name).unwrap_or_else(|reason| {
            println!("SKIPPED: instructions of {name}: {reason}");
            HashMap::new()
        });
        let mut rows = Vec::new();
        for level in ours::available() {
            let sampled = if perf::installed() {
                self.sample(name, level).unwrap_or_else(|reason| {
                    println!("SKIPPED: time of {name}, {}: {reason}", level.name());
                    HashMap::new()
                })
            } else {
                HashMap::new()
            };
            let (clear, frame) = times(&view, level);
            let drawing: u64 = sampled.iter().filter(|(part, _)| **part != Part::Clear).map(|(_, n)| n).sum();
            for part in Part::ALL {
                let share = *sampled.get(&part).unwrap_or(&0) as f64 / drawing as f64;
                let ms = if part == Part::Clear { clear } else { (frame - clear) * share };
                rows.push(Row {
                    view: name.to_owned(),
                    level: level.name().to_owned(),
                    part,
                    instructions: counted.get(level.name()).map(|of| *of.get(&part).unwrap_or(&0)),
                    ms: (drawing > 0).then_some(ms),
                });
            }
        }
        Ok(rows)
    }

    /// Instructions of each stage at each level that valgrind has.
    fn count(&mut self, name: &str) -> Result<HashMap<String, HashMap<Part, u64>>, String> {
        let out = self.dumps.join("callgrind.out");
        let output = Command::new("valgrind")
            .args(callgrind::options(&out, child::COUNTED))
            .arg(&self.program)
            .args(["--count", "--scenes"])
            .arg(&self.folder)
            .arg(name)
            .output()
            .map_err(|error| format!("valgrind: {error} (apt-get install valgrind)"))?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        if !output.status.success() {
            return Err(format!("valgrind: {}", String::from_utf8_lossy(&output.stderr)));
        }
        let mut dump = 0;
        let mut counted = HashMap::new();
        for name in said.lines() {
            let level = ours::from_name(name).ok_or_else(|| format!("no such level: {name}"))?;
            let parts: &mut HashMap<Part, u64> = counted.entry(name.to_owned()).or_default();
            for stage in child::stages(level) {
                dump += 1;
                let path = self.dumps.join(format!("callgrind.out.{dump}"));
                let text =
                    fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
                let counts = callgrind::parse(&text, &self.program)?;
                let whole = match stage {
                    Stage::Clear(_) => Some(Part::Clear),
                    Stage::Transform => Some(Part::Transform),
                    _ => None,
                };
                *parts.entry(whole.unwrap_or(Part::Other)).or_default() += counts.elsewhere;
                for (address, count) in counts.addresses {
                    *parts.entry(whole.unwrap_or_else(|| self.lines.part(address))).or_default() += count;
                }
            }
        }
        Ok(counted)
    }

    /// Samples of each stage.
    fn sample(&mut self, name: &str, level: Level) -> Result<HashMap<Part, u64>, String> {
        let said = |error: std::io::Error| error.to_string();
        let mut watched = Command::new(&self.program)
            .args(["--sample", level.name(), "--seconds", &(self.seconds + 1.0).to_string(), "--scenes"])
            .arg(&self.folder)
            .arg(name)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(said)?;
        let mut place = String::new();
        if let Some(output) = watched.stdout.take() {
            BufReader::new(output).read_line(&mut place).map_err(said)?;
        }
        if let Some(mut input) = watched.stdin.take() {
            input.write_all(b"\n").map_err(said)?;
        }
        let samples = perf::sample(watched.id(), self.seconds, &self.dumps.join("perf.data"));
        watched.wait().map_err(said)?;
        let place = u64::from_str_radix(place.trim(), 16).map_err(|_| format!("not a place: {place:?}"))?;
        let mut parts = HashMap::new();
        for address in samples? {
            let address = address.wrapping_sub(place);
            if self.lines.has(address) {
                *parts.entry(self.lines.part(address)).or_default() += 1;
            }
        }
        Ok(parts)
    }
}

/// Milliseconds of a clear and of a whole frame: minima, so that they add up as well as can be.
fn times(view: &scenes::View, level: Level) -> (f64, f64) {
    let target = std::cell::RefCell::new(ours::target(view));
    let plan = Plan { limit: Duration::from_secs(1), ..Plan::CLASSIC };
    let mut contenders = [Stage::Clear(MAIN), Stage::Frame(MAIN)].map(|stage| {
        let target = &target;
        let frame: Frame<'_> =
            Box::new(move |_| drawn(target.borrow_mut().stage(level, stage, &view.matrix)));
        Contender { plan, frame }
    });
    let summaries = measure(&mut contenders);
    (summaries[0].min, summaries[1].min)
}
