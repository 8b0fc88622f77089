//! What programs execute, in an emulator that tells every instruction: counts that are the same in every run.

use std::fs;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use super::workload::{Corners, Workload};

/// What a program executes: differences between runs that differ in one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Executed {
    /// Sixteenths of instructions for each further triangle, which covers one sample.
    triangle16: u64,
    /// 1024ths of instructions for each further pixel of a large triangle.
    pixel1024: u64,
    /// The deepest stack of the runs in bytes, from the program's entry down.
    pub stack: u64,
}

impl Executed {
    /// 1288 instructions per triangle, 15.5 per pixel, 96 bytes.
    #[cfg(test)]
    pub(crate) const KNOWN: Self = Self { triangle16: 16 * 1288, pixel1024: 15 * 1024 + 512, stack: 96 };

    /// Instructions for each further triangle that covers one sample.
    #[must_use]
    pub fn per_triangle(&self) -> f64 {
        self.triangle16 as f64 / 16.0
    }

    /// Instructions for each further pixel of a large triangle.
    #[must_use]
    pub fn per_pixel(&self) -> f64 {
        self.pixel1024 as f64 / 1024.0
    }
}

/// Instructions of a run that does not end.
const ENDLESS: u64 = 10_000_000;

/// One run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Run {
    instructions: u64,
    /// Bytes of the deepest stack, where it was looked for.
    stack: u64,
    /// What the program ended with: triangles drawn.
    drawn: Option<i32>,
}

impl Run {
    fn count(&mut self) -> io::Result<()> {
        self.instructions += 1;
        if self.instructions > ENDLESS { Err(io::Error::other("the program does not end")) } else { Ok(()) }
    }
}

/// Runs a program with its workloads.
///
/// # Errors
///
/// Why it was not measured, as a sentence.
pub(super) fn measure(path: &Path, bytes: &[u8], target: &str, corners: Corners) -> Result<Executed, String> {
    let emulator =
        Emulator::of(target).ok_or_else(|| format!("not measured: no emulator is known for {target}"))?;
    let run = |workload: Workload, stack: bool| -> Result<Run, String> {
        let given = path.with_extension("run");
        let written = workload.written(bytes, corners).map_err(|error| format!("not measured: {error}"))?;
        // A copy can be executed as what it is copied from.
        fs::copy(path, &given)
            .and_then(|_| fs::write(&given, written))
            .map_err(|error| format!("not measured: {error}"))?;
        let found = emulator.run(&given, stack);
        let _ = fs::remove_file(&given);
        let found = found?;
        if found.drawn != Some(workload.times as i32) {
            return Err(format!(
                "not measured: of {} triangles, {:?} are drawn",
                workload.times, found.drawn
            ));
        }
        Ok(found)
    };
    let [few, many] = [run(Workload::small(16), true)?, run(Workload::small(32), false)?];
    let [narrow, wide] = [run(Workload::large(64), true)?, run(Workload::large(128), false)?];
    let mut stack = few.stack.max(narrow.stack);
    if corners == Corners::Float {
        stack = stack.max(run(Workload::clipped(), true)?.stack);
    }
    let more = |less: Run, more: Run| {
        let difference =
            more.instructions.checked_sub(less.instructions).filter(|&difference| difference > 0);
        difference.ok_or_else(|| "not measured: more work takes no more instructions".to_owned())
    };
    Ok(Executed { triangle16: more(few, many)?, pixel1024: more(narrow, wide)?, stack })
}

/// Who executes a program and tells about it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Emulator {
    /// valgrind's lackey: every instruction and every access of memory.
    Valgrind,
    /// QEMU with a Cortex-M board, a block for each instruction.
    Qemu,
}

impl Emulator {
    fn of(target: &str) -> Option<Self> {
        match target {
            "x86_64-unknown-linux-gnu" => Some(Self::Valgrind),
            _ if target.starts_with("thumbv6m-") => Some(Self::Qemu),
            _ => None,
        }
    }

    /// Runs a program; `stack` says whether its depth is looked for.
    fn run(self, program: &Path, stack: bool) -> Result<Run, String> {
        let (name, mut command) = match self {
            Self::Valgrind => {
                let mut command = Command::new("valgrind");
                command.args(["--tool=lackey", "--trace-mem=yes", "--basic-counts=no", "--log-fd=1"]);
                ("valgrind", command)
            }
            Self::Qemu => {
                let mut command = Command::new("qemu-system-arm");
                command.args("-M mps2-an385 -display none -monitor none -serial none".split(' '));
                command.args(if qemu_is_before_8() {
                    &["-singlestep"][..]
                } else {
                    &["-accel", "tcg,one-insn-per-tb=on"]
                });
                command.args(["-semihosting-config", "enable=on,target=native", "-D", "/dev/stdout"]);
                command.args(["-d", if stack { "exec,nochain,cpu" } else { "exec,nochain" }, "-kernel"]);
                ("qemu-system-arm", command)
            }
        };
        let told = |error: io::Error| match error.kind() {
            io::ErrorKind::NotFound => format!("not measured: {name} is not installed"),
            _ => format!("not measured: {name}: {error}"),
        };
        command.arg(program).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = command.spawn().map_err(told)?;
        let trace = child.stdout.take().map(BufReader::new);
        let run = trace.map_or(Ok(Run::default()), |trace| match self {
            Self::Valgrind => lackey(trace),
            Self::Qemu => qemu(trace),
        });
        if run.is_err() {
            let _ = child.kill();
        }
        let status = child.wait().map_err(told)?;
        Ok(Run { drawn: status.code(), ..run.map_err(told)? })
    }
}

/// QEMU's version 8 gave the option of blocks of one instruction another name.
fn qemu_is_before_8() -> bool {
    let output = Command::new("qemu-system-arm").arg("--version").output();
    let told = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    let version =
        told.split_once("version ").and_then(|(_, version)| version.split('.').next()?.parse().ok());
    version.is_none_or(|major: u32| major < 8)
}

/// Reads lackey's trace: `I  address,size` for an instruction; ` L`, ` S` and ` M` for what it loads, stores, modifies.
/// The first access is the entry's: it puts the return address, 8 bytes, on the stack.
fn lackey(trace: impl BufRead) -> io::Result<Run> {
    /// Farther from the entry's stack is other memory.
    const FAR: u64 = 1 << 23;
    let mut run = Run::default();
    let mut top = None;
    for line in trace.lines() {
        let line = line?;
        if line.starts_with("I ") {
            run.count()?;
        } else if let Some(access) = [" L ", " S ", " M "].iter().find_map(|kind| line.strip_prefix(kind))
            && let Some((address, _)) = access.split_once(',')
            && let Ok(address) = u64::from_str_radix(address, 16)
        {
            let depth = top.get_or_insert(address + 8).wrapping_sub(address);
            run.stack = run.stack.max(if depth < FAR { depth } else { 0 });
        }
    }
    Ok(run)
}

/// Reads QEMU's log: `Trace` before each instruction and, where registers are told, `R13=` with the stack pointer, at
/// first as the entry finds it.
fn qemu(trace: impl BufRead) -> io::Result<Run> {
    let mut run = Run::default();
    let mut top = None;
    for line in trace.lines() {
        let line = line?;
        if line.starts_with("Trace ") {
            run.count()?;
        } else if let Some((_, register)) = line.split_once("R13=")
            && let Some(Ok(pointer)) = register.get(..8).map(|register| u64::from_str_radix(register, 16))
        {
            run.stack = run.stack.max(top.get_or_insert(pointer).saturating_sub(pointer));
        }
    }
    Ok(run)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn traces_are_counted() {
        let text = "==7== Lackey\nI  00401000,4\nI  00401004,5\n S 1ffeffe108,8\nI  00401010,3\n L 00402000,4\n \
                    M 1ffeffe100,8\n L 1ffeffe110,8\n";
        assert_eq!(lackey(text.as_bytes()).unwrap(), Run { instructions: 3, stack: 16, drawn: None });
        let text = "Trace 0: 0x7ff [0/1/2/3] _start\nR12=00000000 R13=20400000 R14=ffffffff R15=00000110\n\
                    Trace 0: 0x7ff [0/1/2/3] main\nR12=00000000 R13=203fffd8 R14=ffffffff R15=00000110\n\
                    Trace 0: 0x7ff [0/1/2/3] main\nR12=00000000 R13=203ffff8 R14=ffffffff R15=00000110\n";
        assert_eq!(qemu(text.as_bytes()).unwrap(), Run { instructions: 3, stack: 0x28, drawn: None });
    }

    #[test]
    fn what_cannot_be_run_is_told() {
        let unknown = measure(Path::new("depth"), b"", "sparc-unknown-none-elf", Corners::Float);
        assert_eq!(unknown, Err("not measured: no emulator is known for sparc-unknown-none-elf".to_owned()));
        let broken = measure(Path::new("depth"), b"", "thumbv6m-none-eabi", Corners::Float);
        assert!(broken.is_err_and(|reason| reason.starts_with("not measured: ")));
    }
}
