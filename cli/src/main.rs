//! The command `halfplane`; everything it does is in the library `halfplane_cli`.

use std::process::ExitCode;

fn main() -> ExitCode {
    halfplane_cli::run(std::env::args_os())
}
