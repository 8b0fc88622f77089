//! What a run of `compare` measures, from its arguments and the environment.

use std::env;
use std::path::PathBuf;
use std::time::Duration;

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

/// Told by `--help`.
pub const USAGE: &str = "\
cargo bench -p halfplane-benches --bench compare -- [OPTIONS] [NAME]...

Draws every view whose name contains one of the NAMEs (all, if there is none), everybody in turns, and
prints times. Names are such as \"castle main 1280x720\", \"built-in terrace 1920x1080\", \"micro slivers\",
\"growth 10^5\".

  --quick            30 frames, at most 0.15 s for each contender and view
  --frames N         measured frames, a tenth of it to warm up [HALFPLANE_BENCH_FRAMES; 600]
  --seconds S        time limit for each of our rows in each view [HALFPLANE_BENCH_SECONDS; 1.5]
  --peer-seconds S   time limit for each peer in each view [HALFPLANE_BENCH_PEER_SECONDS; 0.8]
  --no-peers         leave the other crates out [HALFPLANE_BENCH_PEERS=0]
  --scenes DIR       castle.bin, sponza.bin and cameras [HALFPLANE_BENCH_SCENES; ../shared/scenes]
  --csv FILE         where the CSV goes [target/halfplane-benches.csv]

A contender cut short by the limit shows its number of frames; never fewer than 3.
";

impl Options {
    /// From the arguments after the program's name.
    ///
    /// # Errors
    ///
    /// A sentence about an argument that is no good; [`USAGE`] where help is asked for.
    pub fn parse(arguments: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let mut frames: u32 = from_environment("HALFPLANE_BENCH_FRAMES")?.unwrap_or(600);
        let mut seconds = from_environment("HALFPLANE_BENCH_SECONDS")?.unwrap_or(1.5);
        let mut peer_seconds = from_environment("HALFPLANE_BENCH_PEER_SECONDS")?.unwrap_or(0.8);
        let mut peers = from_environment::<u32>("HALFPLANE_BENCH_PEERS")?.unwrap_or(1) != 0;
        let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
        let mut scenes = env::var_os("HALFPLANE_BENCH_SCENES")
            .map_or_else(|| root.join("../shared/scenes"), PathBuf::from);
        let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
        let mut csv = target.join("halfplane-benches.csv");
        let mut only = Vec::new();
        let mut arguments = arguments.into_iter();
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                // What cargo itself adds.
                "--bench" => {}
                "--help" | "-h" => return Err(USAGE.to_owned()),
                "--quick" => (frames, seconds, peer_seconds) = (30, 0.15, 0.15),
                "--frames" => frames = number("--frames", &value()?)?,
                "--seconds" => seconds = number("--seconds", &value()?)?,
                "--peer-seconds" => peer_seconds = number("--peer-seconds", &value()?)?,
                "--no-peers" => peers = false,
                "--scenes" => scenes = value()?.into(),
                "--csv" => csv = value()?.into(),
                unknown if unknown.starts_with('-') => {
                    return Err(format!("{unknown} is no option\n\n{USAGE}"));
                }
                name => only.push(name.to_owned()),
            }
        }
        let plan = |seconds: f64| -> Result<Plan, String> {
            let limit =
                Duration::try_from_secs_f64(seconds).map_err(|error| format!("{seconds} s: {error}"))?;
            Ok(Plan { warm_up: frames.div_ceil(10), frames: frames.max(1), limit, ..Plan::CLASSIC })
        };
        let ours = plan(seconds)?;
        let peers = if peers { Some(plan(peer_seconds)?) } else { None };
        Ok(Self { plan: ours, peers, only, scenes, csv })
    }

    /// Whether a view of that name is asked for.
    #[must_use]
    pub fn wants(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|part| name.contains(part.as_str()))
    }
}

fn from_environment<T: std::str::FromStr>(name: &str) -> Result<Option<T>, String> {
    env::var(name).ok().map(|text| number(name, &text)).transpose()
}

fn number<T: std::str::FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name}: {text:?} is not such a number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(arguments: &[&str]) -> Result<Options, String> {
        Options::parse(arguments.iter().map(|&a| a.to_owned()))
    }

    #[test]
    fn arguments_are_understood() {
        let options = parse(&["--bench", "castle main", "--frames", "50", "--no-peers"]).unwrap();
        assert_eq!((options.plan.frames, options.plan.warm_up), (50, 5));
        assert!(options.peers.is_none());
        assert!(options.wants("castle main 1280x720") && !options.wants("castle aerial 1280x720"));
        for wrong in [&["--frames"][..], &["--frames", "x"], &["--what"], &["--seconds", "-1"]] {
            assert!(parse(wrong).is_err(), "{wrong:?}");
        }
    }
}
