//! perf: samples of where the processor is, by address.

use std::path::Path;
use std::process::{Command, Stdio};

/// Samples a second: not a divisor of anything that frames are made of.
const FREQUENCY: u32 = 3989;

/// Samples a running process for some seconds; the addresses, as the process sees them. The clock is a
/// timer, so that this works on virtual machines without performance counters.
///
/// # Errors
///
/// Why there are none.
pub fn sample(process: u32, seconds: f64, file: &Path) -> Result<Vec<u64>, String> {
    let run = |command: &mut Command| {
        let output = command.stdin(Stdio::null()).output().map_err(|error| format!("perf: {error}"))?;
        if output.status.success() {
            return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
        }
        let message = String::from_utf8_lossy(&output.stderr);
        Err(format!("perf: {}", message.lines().next().unwrap_or("failed")))
    };
    let record = ["record", "--quiet", "--event", "cpu-clock:u", "--freq", &FREQUENCY.to_string()];
    run(Command::new("perf")
        .args(record)
        .args(["--pid", &process.to_string(), "--output"])
        .arg(file)
        .args(["--", "sleep", &seconds.to_string()]))?;
    parse(&run(Command::new("perf").args(["script", "--fields", "ip", "--input"]).arg(file))?)
}

/// Whether perf is there at all.
#[must_use]
pub fn installed() -> bool {
    Command::new("perf")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|s| s.success())
}

/// One hexadecimal address a line.
fn parse(text: &str) -> Result<Vec<u64>, String> {
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    lines
        .map(|line| u64::from_str_radix(line, 16).map_err(|_| format!("not an address of perf's: {line:?}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_read() {
        assert_eq!(parse("    55d0c0 \n\n ffff000012345678\n"), Ok(vec![0x55d0c0, 0xffff_0000_1234_5678]));
        assert!(parse("perf: error").is_err());
    }
}
