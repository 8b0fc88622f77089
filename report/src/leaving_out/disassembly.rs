//! What a linked program is made of: its instructions by kind, from a disassembly.

use std::path::Path;
use std::process::Command;

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
}

/// `None` where there is no `objdump` that reads the program, or it is not for x86-64.
pub(super) fn disassembled(path: &Path, target: &str) -> Option<Instructions> {
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
                    401014:\tpaddd  %xmm1,%xmm2\n  401018:\tcvttps2dq %xmm0,%xmm1\n  40101c:\tret\n";
        assert_eq!(count(text), Instructions { total: 8, divisions: 2, floats: 2, vectors: 4 });
    }
}
