//! Fixed work whose instructions are counted from outside (`.ci/instructions`).
//!
//! ```text
//! instructions levels                    the levels that this machine (or its emulator) can run
//! instructions workloads                 the names of the workloads
//! instructions run LEVEL WORKLOAD TIMES  draws it that often, after one time that is always the same
//! ```
//!
//! The built-in scene at 1280x720, seen from its first camera. The instructions of TIMES repetitions,
//! taken from those of twice as many, leave what one repetition costs: whatever happens before and after
//! is in both.

use std::env;
use std::process::ExitCode;

use halfplane_benches::ours::{Attachments, Level, Stage, Target};
use halfplane_benches::scenes::files;

/// Each of `setup`, `traverse` and the draws holds the work of those before it.
const WORKLOADS: [(&str, Stage); 11] = [
    ("clear_depth", Stage::Clear(Attachments::Depth32)),
    ("transform", Stage::Transform),
    ("setup", Stage::Setup),
    ("traverse", Stage::Traverse),
    ("draw_coverage", Stage::Draw(Attachments::Coverage)),
    ("draw_depth", Stage::Draw(Attachments::Depth32)),
    ("draw_depth16", Stage::Draw(Attachments::Depth16)),
    ("draw_ids", Stage::Draw(Attachments::Ids)),
    ("draw_depth_ids", Stage::Draw(Attachments::DepthIds)),
    ("frame_depth", Stage::Frame(Attachments::Depth32)),
    ("frame_depth_ids", Stage::Frame(Attachments::DepthIds)),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["levels"] => Level::available().iter().for_each(|level| println!("{}", level.name())),
        ["workloads"] => WORKLOADS.iter().for_each(|(name, _)| println!("{name}")),
        ["run", level, workload, times] => {
            let stage = WORKLOADS.iter().find(|(name, _)| *name == workload).map(|(_, stage)| *stage);
            let (Some(level), Some(stage), Ok(times)) =
                (Level::from_name(level), stage, times.parse::<u32>())
            else {
                eprintln!("no such level here, no such workload, or no such number: {arguments:?}");
                return ExitCode::FAILURE;
            };
            run(level, stage, times);
        }
        _ => {
            eprintln!("instructions levels | workloads | run LEVEL WORKLOAD TIMES");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn run(level: Level, stage: Stage, times: u32) {
    let views = files::built_in();
    let view = &views[0];
    let mut target = Target::new(view);
    // Every page touched, every vertex transformed.
    target.frame(level, Attachments::DepthIds, &view.matrix);
    for _ in 0..times {
        target.stage(level, stage, &view.matrix);
    }
}
