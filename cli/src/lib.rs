//! The command `halfplane`: renders meshes with the rasterizer of the same name and verifies every
//! pixel against the exact reference.
//!
//! | module | what |
//! |---|---|
//! | [`args`] | the command line |
//! | [`load`], [`scene`] | where meshes come from: files, or the built-in scene |
//! | [`camera`] | where matrices come from |
//! | [`level`], [`target`] | the vector levels, and the only place that calls the rasterizer's draw |
//! | [`way`], [`render`] | mesh and matrix to depth and ids |
//! | [`picture`] | depth and ids to pictures |
//! | [`verify`] | depth and ids against the reference |
//! | [`measure`], [`mod@bench`] | times of frames, beside the machine's limits |
//! | [`occlusion`] | what is hidden, as a picture and a table |
//! | [`report`] | error against run time, as a page |
//! | [`protocol`] | the doors for conformance kits |
//! | [`output`] | files, whole or not at all |
//! | [`command`] | all of that, in order |

#![forbid(unsafe_code)]

pub mod args;
pub mod bench;
pub mod camera;
pub mod command;
pub mod error;
pub mod load;
pub mod mesh;
pub mod occlusion;
pub mod output;
pub mod picture;
pub mod protocol;
pub mod render;
pub mod report;
pub mod scene;
pub mod verify;
pub mod way;

pub use halfplane_measure::{self as measure, level, target};

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use error::Error;

/// Runs the command line and returns the process's exit status: 0 done, 1 a verification found a
/// difference, 2 bad input, 77 a conformance request beyond this program.
pub fn run<I, T>(arguments: I) -> ExitCode
where
    I: IntoIterator<Item = T>,
    T: Into<OsString> + Clone,
{
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(message) if !message.use_stderr() => {
            // Help or the version; there is nobody to tell if nobody reads it.
            let _ = message.print();
            return ExitCode::SUCCESS;
        }
        Err(message) => return fail(&Error::Usage(usage(&message))),
    };
    match execute(cli) {
        Ok(right) => ExitCode::from(u8::from(!right)),
        Err(error) => fail(&error),
    }
}

/// Returns whether all is right; only a verification can find that it is not.
fn execute(cli: Cli) -> Result<bool, Error> {
    let output = || BufWriter::with_capacity(1 << 16, io::stdout().lock());
    match cli.command {
        None => command::run_render(None, &cli.options)?,
        Some(Command::Render(picture)) => command::run_render(picture.file.as_deref(), &picture.options)?,
        Some(Command::Verify(picture)) => {
            return command::run_verify(picture.file.as_deref(), &picture.options);
        }
        Some(Command::Occlusion(picture)) => {
            return occlusion::run_occlusion(picture.file.as_deref(), &picture.options);
        }
        Some(Command::Bench(arguments)) => bench::run_bench(&arguments)?,
        Some(Command::Report(arguments)) => report::run_report(&arguments)?,
        Some(Command::Coverage) => protocol::coverage(io::stdin().lock(), output())?,
        Some(Command::Depth) => protocol::depth(io::stdin().lock(), output())?,
    }
    Ok(true)
}

fn fail(error: &Error) -> ExitCode {
    // One line, whatever a file name or a foreign message contains.
    let line = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let _ = writeln!(io::stderr(), "halfplane: {line}");
    ExitCode::from(error.exit_status())
}

/// The first paragraph of clap's message in one line, and where to find more.
fn usage(message: &clap::Error) -> String {
    let text = message.to_string();
    let paragraph = text.split("\n\n").next().unwrap_or(&text);
    let line = paragraph.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("{} (see halfplane --help)", line.trim_start_matches("error: "))
}
