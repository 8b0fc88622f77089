//! What a run of `compare` measures, from its arguments.

use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::Parser;

use crate::protocol::Plan;

/// The run.
#[derive(Debug, Clone)]
pub struct Options {
    /// Frames and rounds; the limit holds for each contender in each view.
    pub plan: Plan,
    /// The same for peers, whose frames are long.
    pub peers: Option<Plan>,
    /// Only views whose names contain one of these; all if there are none.
    pub only: Vec<String>,
    /// The folder with `castle.bin`, `sponza.bin` and their cameras.
    pub scenes: PathBuf,
    /// The CSV file.
    pub csv: PathBuf,
}

/// Draws every view whose name contains one of the NAMEs (all, if there is none), everybody in turns, and
/// prints times. Names are such as "castle main 1280x720", "built-in terrace 1920x1080", "micro slivers",
/// "growth 10^5".
///
/// A contender that reaches its time limit is cut short and shows its number of frames; never fewer than 3.
#[derive(Debug, Parser)]
#[command(name = "cargo bench -p halfplane-benches --bench compare --", no_binary_name = true)]
struct Arguments {
    /// Only views whose names contain one of these
    #[arg(value_name = "NAME")]
    only: Vec<String>,
    /// 30 frames, at most 0.15 s for each contender and view: a look, not a measurement
    #[arg(long, conflicts_with_all = ["full", "frames", "seconds", "peer_seconds"])]
    quick: bool,
    /// Limits so long (8 s, peers 2 s) that all vector levels draw all their frames
    #[arg(long, conflicts_with_all = ["seconds", "peer_seconds"])]
    full: bool,
    /// Measured frames; a tenth of it before, to warm up
    #[arg(long, value_name = "N", default_value_t = Plan::CLASSIC.frames, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    frames: u32,
    /// Time limit for each of our rows in each view
    #[arg(long, value_name = "S", default_value = "0.7", value_parser = seconds, allow_hyphen_values = true)]
    seconds: Duration,
    /// Time limit for each peer in each view
    #[arg(long, value_name = "S", default_value = "0.4", value_parser = seconds, allow_hyphen_values = true)]
    peer_seconds: Duration,
    /// Leave the other crates out
    #[arg(long)]
    no_peers: bool,
    /// Where castle.bin, sponza.bin and their cameras are [default: ../shared/scenes]
    #[arg(long, value_name = "DIR")]
    scenes: Option<PathBuf>,
    /// Where the CSV goes [default: target/halfplane-benches.csv]
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// What cargo itself adds.
    #[arg(long = "bench", hide = true)]
    _bench: bool,
}

impl Options {
    /// From the arguments after the program's name.
    ///
    /// # Errors
    ///
    /// clap's, which are help and version, too.
    pub fn parse(arguments: impl IntoIterator<Item = String>) -> Result<Self, clap::Error> {
        let arguments = Arguments::try_parse_from(arguments)?;
        let (frames, seconds, peer_seconds) = match (arguments.quick, arguments.full) {
            (true, _) => (30, Duration::from_millis(150), Duration::from_millis(150)),
            (_, true) => (arguments.frames, Duration::from_secs(8), Duration::from_secs(2)),
            _ => (arguments.frames, arguments.seconds, arguments.peer_seconds),
        };
        let plan = |limit| Plan { warm_up: frames.div_ceil(10), frames, limit, ..Plan::CLASSIC };
        Ok(Self {
            plan: plan(seconds),
            peers: (!arguments.no_peers).then(|| plan(peer_seconds)),
            only: arguments.only,
            scenes: arguments.scenes.unwrap_or_else(|| root().join("../shared/scenes")),
            csv: arguments.csv.unwrap_or_else(default_csv),
        })
    }

    /// Whether a view of that name is asked for.
    #[must_use]
    pub fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|part| name.contains(part.as_str()))
    }
}

/// What the main function of a benchmark does with the program's arguments; `name` is the benchmark's.
#[must_use]
pub fn start(name: &str, run: impl FnOnce(&Options) -> Result<(), String>) -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    // Run by a test command, not by `cargo bench`.
    if !arguments.iter().any(|argument| argument == "--bench") && cfg!(debug_assertions) {
        println!("{name}: measures nothing without optimisation; use cargo bench");
        return ExitCode::SUCCESS;
    }
    let options = match Options::parse(arguments) {
        Ok(options) => options,
        // Help goes to standard output and is no failure.
        Err(message) => message.exit(),
    };
    match run(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// The repository.
#[must_use]
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.parent().unwrap_or(package).to_owned()
}

/// A file in cargo's target folder.
#[must_use]
pub fn in_target(name: &str) -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from).join(name)
}

/// Where `compare` writes its CSV, unless told otherwise.
#[must_use]
pub fn default_csv() -> PathBuf {
    in_target("halfplane-benches.csv")
}

/// Where `whole_frames` writes its CSV, unless told otherwise.
#[must_use]
pub fn whole_frames_csv() -> PathBuf {
    in_target("halfplane-whole-frames.csv")
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().map_err(|_| format!("{text:?} is not a number of seconds"))?;
    Duration::try_from_secs_f64(seconds).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    fn parse(arguments: &[&str]) -> Result<Options, clap::Error> {
        Options::parse(arguments.iter().map(|&a| a.to_owned()))
    }

    #[test]
    fn the_definition_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn arguments_are_understood() {
        let options = parse(&["--bench", "castle main", "--frames", "50", "--no-peers"]).unwrap();
        assert_eq!((options.plan.frames, options.plan.warm_up), (50, 5));
        assert!(options.peers.is_none());
        assert!(options.wants("castle main 1280x720") && !options.wants("castle aerial 1280x720"));
        for wrong in [
            &["--frames"][..],
            &["--frames", "x"],
            &["--frames", "0"],
            &["--what"],
            &["--seconds", "-1"],
            &["--quick", "--full"],
        ] {
            assert!(parse(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn the_classic_protocol_is_the_default_and_limits_differ() {
        let [quick, plain, full] = [&["--quick"][..], &[], &["--full"]].map(|a| parse(a).unwrap());
        for options in [&plain, &full] {
            let Plan { warm_up, frames, rounds, .. } = options.plan;
            assert_eq!(Plan { warm_up, frames, rounds, ..Plan::CLASSIC }, Plan::CLASSIC);
        }
        assert_eq!(quick.plan.frames, 30);
        assert!(quick.plan.limit < plain.plan.limit && plain.plan.limit < full.plan.limit);
        assert!(plain.peers.unwrap().limit < plain.plan.limit);
    }
}
