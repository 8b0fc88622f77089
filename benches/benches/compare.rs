//! The comparison: every view, everybody in turns, by the protocol. `--help` tells the options.

use std::env;
use std::process::ExitCode;

use halfplane_benches::contest::{self, Outcome};
use halfplane_benches::options::Options;
use halfplane_benches::report;
use halfplane_benches::scenes::{View, files, growth, micro};

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    // Run by a test command, not by `cargo bench`.
    if !arguments.iter().any(|argument| argument == "--bench") && cfg!(debug_assertions) {
        println!("compare: measures nothing without optimisation; use cargo bench");
        return ExitCode::SUCCESS;
    }
    match Options::parse(arguments).and_then(|options| run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), String> {
    print!("{}", report::legend());
    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut measure = |view: &View| -> Result<(), String> {
        if options.wants(&view.name) {
            let outcome = contest::run(view, options)?;
            print!("{}", report::table(&outcome));
            outcomes.push(outcome);
            // A run that is broken off leaves what it has.
            report::write_csv(&options.csv, &outcomes)
                .map_err(|error| format!("{}: {error}", options.csv.display()))?;
        }
        Ok(())
    };
    files::built_in().iter().try_for_each(&mut measure)?;
    for name in files::FILES {
        match files::from_file(&options.scenes, name) {
            Ok(views) => views.iter().try_for_each(&mut measure)?,
            Err(reason) => println!("\nSKIPPED: {name}: {reason}"),
        }
    }
    for view in micro::views() {
        if options.wants(&view.name) {
            measure(&(view.make)(&view.name))?;
        }
    }
    for count in growth::COUNTS {
        if options.wants(&growth::name(count)) {
            measure(&growth::view(count, micro::SIZE))?;
        }
    }
    if outcomes.is_empty() {
        return Err("no view has such a name; --help tells some".to_owned());
    }
    print!("{}", report::summary(&outcomes));
    println!("\nwritten: {}", options.csv.display());
    Ok(())
}
