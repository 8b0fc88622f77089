//! Fixed work whose instructions are counted from outside (`.ci/instructions`).
//!
//! ```text
//! instructions levels                    the levels that this machine (or its emulator) can run
//! instructions workloads LEVEL           the names of the level's workloads
//! instructions run LEVEL WORKLOAD TIMES  draws it that often, after one time that is always the same
//! ```
//!
//! A made-up mixture of triangles at 1280x720: little to prepare. The instructions of TIMES repetitions,
//! taken from those of twice as many, leave what one repetition costs: whatever happens before and after
//! is in both.

use std::env;
use std::process::ExitCode;

use halfplane_benches::ours::{self, Attachments, Level, Stage, Target, drawn};
use halfplane_benches::scenes::micro;

/// See [`Stage`] for what holds what. A frame is the clear, at the fallback level the transform, and a draw.
/// The clear is a `memset`: where that is one `rep stosb`, an emulator counts an instruction for each byte.
const WORKLOADS: [(&str, Stage); 9] = [
    ("clear_depth", Stage::Clear(Attachments::Depth32)),
    ("transform", Stage::Transform),
    ("setup", Stage::Setup),
    ("traverse", Stage::Traverse),
    ("draw_coverage", Stage::Draw(Attachments::Coverage)),
    ("draw_depth", Stage::Draw(Attachments::Depth32)),
    ("draw_depth16", Stage::Draw(Attachments::Depth16)),
    ("draw_ids", Stage::Draw(Attachments::Ids)),
    ("draw_depth_ids", Stage::Draw(Attachments::DepthIds32)),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        ["levels"] => ours::available().iter().for_each(|level| println!("{}", level.name())),
        ["workloads", level] => {
            let Some(level) = ours::from_name(level) else {
                eprintln!("no such level here: {level}");
                return ExitCode::FAILURE;
            };
            for (name, _) in WORKLOADS.iter().filter(|(_, stage)| Target::has(level, *stage)) {
                println!("{name}");
            }
        }
        ["run", level, workload, times] => {
            let stage = WORKLOADS.iter().find(|(name, _)| *name == workload).map(|(_, stage)| *stage);
            let (Some(level), Some(stage), Ok(times)) = (ours::from_name(level), stage, times.parse::<u32>())
            else {
                eprintln!("no such level here, no such workload, or no such number: {arguments:?}");
                return ExitCode::FAILURE;
            };
            run(level, stage, times);
        }
        _ => {
            eprintln!("instructions levels | workloads LEVEL | run LEVEL WORKLOAD TIMES");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn run(level: Level, stage: Stage, times: u32) {
    let view = micro::mixed();
    let mut target = ours::target(&view);
    // Every page touched, every vertex transformed.
    drawn(target.frame(level, Attachments::DepthIds32, &view.matrix));
    for _ in 0..times {
        drawn(target.stage(level, stage, &view.matrix));
    }
}
