//! Whole frames with questions, and by two threads: every camera of the scenes. `--help` tells the options.

use std::process::ExitCode;

use halfplane_benches::contest::Outcome;
use halfplane_benches::options::{Options, default_csv, start, whole_frames_csv};
use halfplane_benches::scenes::files;
use halfplane_benches::whole::{self, Last};
use halfplane_benches::{machine, record};

fn main() -> ExitCode {
    start("whole_frames", run)
}

fn run(options: &Options) -> Result<(), String> {
    let csv = if options.csv == default_csv() { whole_frames_csv() } else { options.csv.clone() };
    let machine = machine::describe();
    println!("Measured on: {machine}.");
    let mut views = files::built_in();
    for name in files::FILES {
        match files::from_file(&options.scenes, name) {
            Ok(more) => views.extend(more),
            Err(reason) => println!("SKIPPED: {name}: {reason}"),
        }
    }
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut last = Last::default();
    for view in views.iter().filter(|view| options.wants(&view.name)) {
        let outcome = whole::run(view, &mut last, options)?;
        let clear = outcome.clear();
        for row in &outcome.rows {
            let (ms, median) = (row.summary.min, row.summary.median);
            println!(
                "{}: {}: {ms:.4} ms, median {median:.4}, {:.1} clears",
                view.name,
                row.contender,
                ms / clear
            );
        }
        outcomes.push(outcome);
        // A run that is broken off leaves what it has.
        record::write(&csv, &record::records(&outcomes, &machine))
            .map_err(|error| format!("{}: {error}", csv.display()))?;
    }
    if outcomes.is_empty() {
        // `cargo bench -- NAME` may mean one of the other benchmarks.
        println!("no view has such a name; --help tells some");
    } else {
        println!("written: {}", csv.display());
    }
    Ok(())
}
