//! What a program does not have when it does not ask for it: code, constants, static memory and instructions of
//! linked programs without std, a libc or a panic handler (`tests/bare-metal`).

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use object::{Object as _, ObjectSection as _, ObjectSymbol as _};

/// The programs, and what each has.
pub const PROGRAMS: [(&str, &str); 9] = [
    ("nothing", "window vertices, nothing written"),
    ("coverage", "coverage"),
    ("ids", "ids"),
    ("depth", "depth D32"),
    ("depth_ids", "depth D32 and ids"),
    ("small_coverage", "small format: coverage"),
    ("small_depth", "small format: depth D16"),
    ("clip", "depth D32, clip-space vertices"),
    ("simd", "the same in vector registers"),
];

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
    /// Bytes of static memory.
    pub statics: u64,
    /// What it is made of, where it could be disassembled.
    pub instructions: Option<Instructions>,
    /// Functions of the compiler's own that stand for arithmetic the processor has not; only where there are such.
    pub helpers: Vec<String>,
}

/// Instructions of a program, by kind.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Instructions {
    /// All.
    pub total: u64,
    /// Integer divisions.
    pub divisions: u64,
    /// Arithmetic of floats.
    pub floats: u64,
    /// What touches a vector register.
    pub vectors: u64,
    /// The largest stack frame in bytes, the program's own buffers included.
    pub frame: u64,
}

/// Links the programs for this machine and, if `BARE_TARGET` names one, for that target, and looks into them.
///
/// # Errors
///
/// Why it cannot be done here, as a sentence.
pub fn programs() -> Result<Vec<Program>, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let sources = root.join("tests/bare-metal");
    if !sources.is_dir() {
        return Err("the programs' sources (tests/bare-metal) are not there".to_owned());
    }
    let told = Command::new("rustc").arg("-vV").output().map_err(|error| format!("rustc: {error}"))?;
    let told = String::from_utf8_lossy(&told.stdout).into_owned();
    let host = told.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc names no host")?;
    let folder = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let folder = folder.join("bare-metal");
    let mut programs = of_target(&sources, &folder, host, "simd")?;
    if let Ok(target) = env::var("BARE_TARGET") {
        programs.extend(of_target(&sources, &folder, &target, "transform")?);
    }
    Ok(programs)
}

fn of_target(sources: &Path, folder: &Path, target: &str, features: &str) -> Result<Vec<Program>, String> {
    let built = Command::new("cargo")
        .args(["build", "--release", "--quiet", "--features", features, "--target", target])
        .current_dir(sources)
        .env("CARGO_TARGET_DIR", folder)
        .output()
        .map_err(|error| format!("cargo: {error}"))?;
    if !built.status.success() {
        let why = String::from_utf8_lossy(&built.stderr);
        let why = why.lines().find(|line| line.starts_with("error")).unwrap_or("cargo fails").to_owned();
        return Err(format!("the programs do not link for {target}: {why}"));
    }
    let mut programs = Vec::new();
    for (name, what) in PROGRAMS {
        let path = folder.join(target).join("release").join(name);
        // `simd` is not linked for small targets.
        if let Ok(bytes) = fs::read(&path) {
            let mut program = look(name, what, target, &bytes)?;
            program.instructions = disassembled(&path, target);
            programs.push(program);
        }
    }
    Ok(programs)
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
        helpers,
    })
}

/// `None` where there is no `objdump` that reads the program, or it is not for x86-64.
fn disassembled(path: &Path, target: &str) -> Option<Instructions> {
    if !target.starts_with("x86_64") {
        return None;
    }
    let output = Command::new("objdump").args(["-d", "--no-show-raw-insn"]).arg(path).output().ok()?;
    output.status.success().then(|| count(&String::from_utf8_lossy(&output.stdout)))
}

/// Counts the instructions of a disassembly.
fn count(text: &str) -> Instructions {
    let mut found = Instructions::default();
    for line in text.lines() {
        // `  401000:\tsub    $0x28,%rsp`
        let Some((_, instruction)) = line.split_once(":\t") else { continue };
        let mut words = instruction.split_whitespace();
        let Some(name) = words.next() else { continue };
        let operands = words.next().unwrap_or_default();
        found.total += 1;
        let plain = name.trim_end_matches(['b', 'w', 'l', 'q']);
        found.divisions += u64::from(matches!(plain, "div" | "idiv"));
        found.floats += u64::from(is_float(name));
        found.vectors +=
            u64::from(operands.contains("%xmm") || operands.contains("%ymm") || operands.contains("%zmm"));
        if matches!(name, "sub" | "subq")
            && let Some(bytes) = operands.strip_prefix("$0x").and_then(|rest| rest.strip_suffix(",%rsp"))
            && let Ok(bytes) = u64::from_str_radix(bytes, 16)
        {
            found.frame = found.frame.max(bytes);
        }
    }
    found
}

fn is_float(name: &str) -> bool {
    let name = name.strip_prefix('v').unwrap_or(name);
    let is_float = ["ss", "sd", "ps", "pd"].iter().any(|kind| name.ends_with(kind));
    let kinds = ["add", "sub", "mul", "div", "ucomi", "comi", "cvt", "cmp", "min", "max", "sqrt"];
    // Not `cvttps2dq` and its like: without AVX2, shifts of lanes by different numbers are made of them.
    is_float && kinds.iter().any(|kind| name.starts_with(kind))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_disassembly_is_counted() {
        let text = "\n0000000000401000 <_start>:\n  401000:\tsub    $0x28,%rsp\n  401004:\tidivl  (%rax)\n  \
                    401008:\tdiv    %rcx\n  40100c:\tvaddps %ymm1,%ymm2,%ymm3\n  401010:\tcvtsi2ss %eax,%xmm0\n  \
                    401014:\tpaddd  %xmm1,%xmm2\n  401018:\tsub    $0x1000,%rsp\n  40101c:\tret\n";
        let expected = Instructions { total: 8, divisions: 2, floats: 2, vectors: 3, frame: 0x1000 };
        assert_eq!(count(text), expected);
    }

    #[test]
    fn what_is_no_program_is_named() {
        assert!(look("depth", "", "here", b"no program").is_err_and(|error| error.starts_with("depth: ")));
    }
}
