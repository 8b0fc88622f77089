//! The comparison: every view, everybody in turns, by the protocol. `--help` tells the options.

use std::process::ExitCode;
use std::time::Instant;

use halfplane_benches::contest::{self, Outcome};
use halfplane_benches::options::{Options, start};
use halfplane_benches::ours::Last;
use halfplane_benches::scenes::{View, files, growth, micro, pixels};
use halfplane_benches::{machine, record, report};

fn main() -> ExitCode {
    start("compare", run)
}

fn run(options: &Options) -> Result<(), String> {
    let started = Instant::now();
    let machine = machine::describe();
    print!("{}", report::legend());
    println!("Measured on: {machine}.");
    let mut scenes = files::built_in();
    for name in files::FILES {
        match files::from_file(&options.scenes, name) {
            Ok(views) => scenes.extend(views),
            Err(reason) => println!("SKIPPED: {name}: {reason}"),
        }
    }
    scenes.retain(|view| options.wants(&view.name));
    let mut made = micro::views();
    made.extend(growth::COUNTS.map(|count| micro::Later {
        name: growth::name(count),
        make: Box::new(move |_| growth::view(count, micro::SIZE)),
    }));
    made.extend(pixels::COUNTS.map(|samples| micro::Later {
        name: pixels::name(samples),
        make: Box::new(move |_| pixels::view(samples, micro::SIZE)),
    }));
    made.retain(|later| options.wants(&later.name));
    if scenes.is_empty() && made.is_empty() {
        // `cargo bench -- NAME` may mean one of the other benchmarks.
        println!("no view has such a name; --help tells some");
        return Ok(());
    }
    let most = contest::most_seconds(scenes.len(), made.len(), options);
    println!("{} views; at most about {:.0} min.", scenes.len() + made.len(), (most / 60.0).ceil());

    let mut outcomes: Vec<Outcome> = Vec::new();
    let mut last = Last::default();
    let mut measure = |view: &View| -> Result<(), String> {
        let prepared =
            view.detail.then(|| last.of(view, |cost| print!("{}", report::preparation(view, cost))));
        let outcome = contest::run(view, prepared, options)?;
        print!("{}", report::table(&outcome));
        outcomes.push(outcome);
        // A run that is broken off leaves what it has.
        record::write(&options.csv, &record::records(&outcomes, &machine))
            .map_err(|error| format!("{}: {error}", options.csv.display()))
    };
    scenes.iter().try_for_each(&mut measure)?;
    made.iter().try_for_each(|later| measure(&(later.make)(&later.name)))?;
    print!("{}", report::summary(&outcomes));
    let seconds = started.elapsed().as_secs();
    println!("\ntook {} min {} s; written: {}", seconds / 60, seconds % 60, options.csv.display());
    Ok(())
}
