//! Runs the enumerations of `halfplane_tests::properties::exhaustive` whole, on all cores.

use clap::Parser;
use halfplane_tests::{
    Failure,
    properties::exhaustive::{ALL, Enumeration},
};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use std::{
    io::{IsTerminal, stderr},
    process::ExitCode,
    sync::{
        Mutex,
        atomic::{AtomicU32, Ordering::Relaxed},
    },
    time::{Duration, Instant},
};

/// Tries all of what is small enough to be tried completely; exits with 1 where something is wrong.
///
/// With `--profile checked` overflow checks and debug assertions are on.
#[derive(Parser)]
#[command(name = "enumerate")]
struct Arguments {
    /// Which ones: `all` or names of the list.
    #[arg(required_unless_present = "list")]
    names: Vec<String>,
    /// Lists what there is.
    #[arg(long)]
    list: bool,
}

/// How often there is news where there is no terminal.
const NEWS: Duration = Duration::from_secs(30);

/// How many failures are shown.
const SHOWN: u32 = 5;

fn main() -> ExitCode {
    let Arguments { names, list } = Arguments::parse();
    if list {
        for Enumeration { name, statement, parts, .. } in ALL {
            println!("{name:14}  {parts:>6} parts  {statement}");
        }
        return ExitCode::SUCCESS;
    }
    let wanted = |name: &str| names.iter().any(|wanted| wanted == name || wanted == "all");
    if let Some(unknown) =
        names.iter().find(|name| *name != "all" && !ALL.iter().any(|listed| listed.name == *name))
    {
        eprintln!("there is no enumeration {unknown:?}; --list lists them");
        return ExitCode::FAILURE;
    }
    let mut right = true;
    for enumeration in ALL.iter().filter(|listed| wanted(listed.name)) {
        right &= run(enumeration);
    }
    if right { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Whether nothing was wrong.
fn run(enumeration: &Enumeration) -> bool {
    let Enumeration { name, statement, parts, part } = *enumeration;
    println!("{name}: {statement}");
    let start = Instant::now();
    let news = News::new(name, parts);
    let outcomes: Vec<Option<u64>> = (0..parts)
        .into_par_iter()
        .map(|number| {
            let outcome = part(number);
            news.done(number, outcome.as_ref().err());
            outcome.ok()
        })
        .collect();
    news.end();
    let seconds = start.elapsed().as_secs_f64();
    let cases: u64 = outcomes.iter().flatten().sum();
    let wrong = outcomes.iter().filter(|outcome| outcome.is_none()).count();
    match wrong {
        0 => println!("{name}: {cases} cases, {seconds:.1} s, 0 wrong"),
        _ => println!("{name}: {wrong} of {parts} parts have something wrong, {seconds:.1} s"),
    }
    wrong == 0
}

/// A bar on a terminal, a line now and then elsewhere.
struct News {
    name: &'static str,
    bar: ProgressBar,
    start: Instant,
    /// Parts with something wrong, of which the first are shown.
    failures: AtomicU32,
    /// When the last line was printed; `None` on a terminal.
    last: Option<Mutex<Instant>>,
}

impl News {
    fn new(name: &'static str, parts: u32) -> Self {
        let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len} {elapsed} (still {eta})");
        let bar = ProgressBar::new(parts.into()).with_prefix(name);
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let start = Instant::now();
        let last = if stderr().is_terminal() { None } else { Some(Mutex::new(start)) };
        Self { name, bar, start, failures: AtomicU32::new(0), last }
    }

    fn done(&self, part: u32, failure: Option<&Failure>) {
        self.bar.inc(1);
        if let Some(failure) = failure.filter(|_| self.failures.fetch_add(1, Relaxed) < SHOWN) {
            self.bar.suspend(|| println!("{}: part {part}: {failure:?}", self.name));
        }
        // Whoever holds the lock prints.
        let Some(Ok(mut last)) = self.last.as_ref().map(Mutex::try_lock) else { return };
        if last.elapsed() >= NEWS {
            *last = Instant::now();
            let (done, all) = (self.bar.position(), self.bar.length().unwrap_or_default());
            eprintln!(
                "{}: {done} of {all} parts after {:.0} s",
                self.name,
                self.start.elapsed().as_secs_f64()
            );
        }
    }

    fn end(&self) {
        self.bar.finish_and_clear();
    }
}
