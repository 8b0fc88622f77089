//! Writes the tables and plots of `docs/performance.md` from what was measured:
//!
//! ```text
//! cargo run --release -p halfplane-benches --example document
//! ```

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use halfplane_benches::breakdown::table;
use halfplane_benches::document::{self, data::Data, figures, tables};
use halfplane_benches::options::{default_csv, in_target, root, whole_frames_csv};
use halfplane_benches::record;

/// Writes the tables and plots of docs/performance.md from the CSV files of `cargo bench` (compare and whole_frames) and of the
/// example breakdown. What was not measured keeps the table it has.
#[derive(Debug, Parser)]
struct Arguments {
    /// The comparison [default: target/halfplane-benches.csv]
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// The whole frames [default: target/halfplane-whole-frames.csv]
    #[arg(long, value_name = "FILE")]
    whole: Option<PathBuf>,
    /// The breakdown [default: target/halfplane-breakdown.csv]
    #[arg(long, value_name = "FILE")]
    breakdown: Option<PathBuf>,
    /// The document; plots go into a folder of the same name without .md [default: docs/performance.md]
    #[arg(long, value_name = "FILE")]
    document: Option<PathBuf>,
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
    let records = record::read(&arguments.csv.clone().unwrap_or_else(default_csv));
    let whole = record::read(&arguments.whole.clone().unwrap_or_else(whole_frames_csv));
    let breakdown = arguments.breakdown.clone().unwrap_or_else(|| in_target("halfplane-breakdown.csv"));
    let stages = table::read(&breakdown);
    for reason in [records.as_ref().err(), whole.as_ref().err(), stages.as_ref().err()].into_iter().flatten()
    {
        println!("SKIPPED: {reason}");
    }
    let data = Data {
        records: records.unwrap_or_default(),
        whole: whole.unwrap_or_default(),
        stages: stages.unwrap_or_default(),
    };
    let path = arguments.document.clone().unwrap_or_else(|| root().join("docs/performance.md"));
    let mut text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    for (name, table) in tables::ALL {
        match table(&data) {
            Some(table) => text = document::replace(&text, name, &table)?,
            None => println!("SKIPPED: {name}: not measured"),
        }
    }
    let folder = path.with_extension("");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for file in figures::draw(&data, &folder).map_err(|error| error.to_string())? {
        println!("drawn: {}", file.display());
    }
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("written: {}", path.display());
    Ok(())
}
