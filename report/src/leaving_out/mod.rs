//! What a program does not have when it does not ask for it: code, constants, static memory, instructions and stack of
//! linked programs without std, a libc or a panic handler (`tests/bare-metal`).

mod disassembly;
mod executed;
mod workload;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::{Object as _, ObjectSection as _, ObjectSymbol as _};
use rayon::prelude::*;

pub use disassembly::Instructions;
pub use executed::Executed;
use workload::Corners;

/// The programs, what each has, and what its vertices are.
const PROGRAMS: [(&str, &str, Corners); 11] = [
    ("nothing", "window vertices, nothing written", Corners::Window { steps: 256 }),
    ("coverage", "coverage", Corners::Window { steps: 256 }),
    ("ids", "ids", Corners::Window { steps: 256 }),
    ("depth", "depth D32", Corners::Window { steps: 256 }),
    ("depth16", "depth D16", Corners::Window { steps: 256 }),
    ("depth_ids", "depth D32 and ids", Corners::Window { steps: 256 }),
    ("small_coverage", "small format: coverage", Corners::Window { steps: 16 }),
    ("small_depth", "small format: depth D16", Corners::Window { steps: 16 }),
    ("clip", "depth D32, clip-space vertices", Corners::Float),
    ("simd_one", "depth D32 and ids, object space, vector registers: one level", Corners::Float),
    ("simd", "the same with every level, and meshlets", Corners::Float),
];

/// A program of a rasterizer with a shortcut left out: the `cfg` that does it, the program, its name here, what it has, and
/// its vertices.
const WITHOUT: (&str, &str, (&str, &str, Corners)) = (
    "halfplane_without_small",
    "depth",
    ("depth_tiles", "depth D32, tiles for small triangles too", Corners::Window { steps: 256 }),
);

/// The target that programs are linked for beside this machine, unless `BARE_TARGET` names another.
const SMALL_TARGET: &str = "thumbv6m-none-eabi";

/// What was linked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Programs {
    /// The compiler that did it.
    pub compiler: String,
    /// The programs of every target.
    pub linked: Vec<Program>,
    /// The target without an operating system for which there are none, and why.
    pub skipped: Option<String>,
}

/// A linked program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program {
    /// Its name.
    pub name: &'static str,
    /// What it has.
    pub what: &'static str,
    /// What it was linked for.
    pub target: String,
    /// Bytes of `.text`.
    pub code: u64,
    /// Bytes of constants.
    pub constants: u64,
    /// Bytes of static memory: the buffers, and 1 KiB of values to read.
    pub statics: u64,
    /// What it is made of, where it could be disassembled.
    pub instructions: Option<Instructions>,
    /// What it executes, or why that was not measured.
    pub executed: Result<Executed, String>,
    /// Functions of the compiler's own that stand for arithmetic the processor has not; only where there are such.
    pub helpers: Vec<String>,
}

/// Links the programs for this machine and, where its core library is installed, for a target without an operating
/// system, looks into them and runs them in an emulator.
///
/// # Errors
///
/// Why it cannot be done here, as a sentence.
pub fn programs() -> Result<Programs, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let sources = root.join("tests/bare-metal");
    if !sources.is_dir() {
        return Err("the programs' sources (tests/bare-metal) are not there".to_owned());
    }
    let told = rustc(&["-vV"])?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc names no host")?;
    let folder = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let folder = folder.join("bare-metal");
    let mut linked = of_target(&sources, &folder, host, "simd")?;
    let place = linked.iter().position(|program| program.name == WITHOUT.1).map_or(0, |place| place + 1);
    linked.insert(place, without(&sources, &folder.join("without"), host)?);
    let small = env::var("BARE_TARGET").unwrap_or_else(|_| SMALL_TARGET.to_owned());
    let of_small = installed(&small).and_then(|()| of_target(&sources, &folder, &small, "transform"));
    let skipped = match of_small {
        Ok(programs) => {
            linked.extend(programs);
            None
        }
        Err(reason) => Some(format!("{small}: skipped, because {reason}")),
    };
    let compiler = told.lines().next().unwrap_or_default().to_owned();
    Ok(Programs { compiler, linked, skipped })
}

/// The compiler that cargo takes.
fn rustc(arguments: &[&str]) -> Result<String, String> {
    let name = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(name).args(arguments).output().map_err(|error| format!("rustc: {error}"))?;
    if !output.status.success() {
        let why = String::from_utf8_lossy(&output.stderr);
        return Err(format!("rustc says {}", why.lines().next().unwrap_or("nothing")));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Whether there is a core library for a target.
fn installed(target: &str) -> Result<(), String> {
    let folder = rustc(&["--print", "target-libdir", "--target", target])?;
    let is_core = |entry: fs::DirEntry| entry.file_name().to_string_lossy().starts_with("libcore-");
    let is_there =
        fs::read_dir(folder.trim()).is_ok_and(|mut files| files.any(|entry| entry.is_ok_and(is_core)));
    let missing = || format!("its core library is not installed (rustup target add {target})");
    if is_there { Ok(()) } else { Err(missing()) }
}

fn of_target(sources: &Path, folder: &Path, target: &str, features: &str) -> Result<Vec<Program>, String> {
    build(sources, folder, target, &["--features", features])?;
    // Those in vector registers are not linked for small targets.
    let is_linked =
        |&(name, ..): &(&str, &str, Corners)| folder.join(target).join("release").join(name).exists();
    let of = |program: (&'static str, _, _)| {
        read(&folder.join(target).join("release").join(program.0), target, program)
    };
    PROGRAMS.into_par_iter().filter(is_linked).map(of).collect()
}

/// [`WITHOUT`], in a folder of its own, as flags make other files of the same names.
fn without(sources: &Path, folder: &Path, target: &str) -> Result<Program, String> {
    let (cfg, name, program) = WITHOUT;
    let flags = format!("target.{target}.rustflags=[\"--cfg\", \"{cfg}\"]");
    build(sources, folder, target, &["--bin", name, "--config", &flags])?;
    read(&folder.join(target).join("release").join(name), target, program)
}

fn build(sources: &Path, folder: &Path, target: &str, more: &[&str]) -> Result<(), String> {
    let built = Command::new("cargo")
        .args(["build", "--release", "--quiet", "--target", target])
        .args(more)
        .current_dir(sources)
        .env("CARGO_TARGET_DIR", folder)
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    if built.status.success() {
        return Ok(());
    }
    let why = String::from_utf8_lossy(&built.stderr);
    let why = why.lines().find(|line| line.starts_with("error")).unwrap_or("cargo fails");
    Err(format!("the programs do not link for {target}: {why}"))
}

fn read(
    path: &Path,
    target: &str,
    (name, what, corners): (&'static str, &'static str, Corners),
) -> Result<Program, String> {
    let bytes = fs::read(path).map_err(|error| format!("{name}: {error}"))?;
    Ok(Program {
        instructions: disassembly::disassembled(path, target),
        executed: executed::measure(path, &bytes, target, corners),
        ..look(name, what, target, &bytes)?
    })
}

fn look(name: &'static str, what: &'static str, target: &str, bytes: &[u8]) -> Result<Program, String> {
    let file = object::File::parse(bytes).map_err(|error| format!("{name}: {error}"))?;
    let size = |wanted: &[&str]| -> u64 {
        let matching = file.sections().filter(|section| {
            section.name().is_ok_and(|name| wanted.iter().any(|wanted| name.starts_with(wanted)))
        });
        matching.map(|section| section.size()).sum()
    };
    let is_helper =
        |name: &&str| name.starts_with("__aeabi_") || name.starts_with("__") && name.ends_with("di3");
    let mut helpers: Vec<String> = file
        .symbols()
        .filter(|symbol| symbol.is_definition())
        .filter_map(|symbol| symbol.name().ok())
        .filter(is_helper)
        .map(str::to_owned)
        .collect();
    helpers.sort_unstable();
    helpers.dedup();
    Ok(Program {
        name,
        what,
        target: target.to_owned(),
        code: size(&[".text"]),
        constants: size(&[".rodata"]),
        statics: size(&[".data", ".bss"]),
        instructions: None,
        executed: Err("not measured: it was not run".to_owned()),
        helpers,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_program_is_named() {
        assert!(look("depth", "", "here", b"no program").is_err_and(|error| error.starts_with("depth: ")));
    }

    #[test]
    fn a_target_that_is_not_there_is_told() {
        let told = rustc(&["-vV"]).unwrap();
        let host = told.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
        // This test is compiled for it.
        assert_eq!(installed(host), Ok(()));
        assert!(installed("no-such-target").is_err_and(|reason| reason.starts_with("rustc says ")));
        if let Err(reason) = installed("msp430-none-elf") {
            assert!(reason.contains("rustup target add msp430-none-elf"), "{reason}");
        }
    }
}
