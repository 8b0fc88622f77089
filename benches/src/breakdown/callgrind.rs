//! callgrind: instructions by address.

use std::collections::HashMap;
use std::path::Path;

/// Instructions of one dump: of the program by address, and of all that is not the program's.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Counts {
    /// Instructions executed at each address of the program's file.
    pub addresses: HashMap<u64, u64>,
    /// Those of libraries.
    pub elsewhere: u64,
}

/// The options that make dumps which [`parse`] reads: one for each call of a function whose name matches.
#[must_use]
pub fn options(out: &Path, function: &str) -> Vec<String> {
    vec![
        "--tool=callgrind".to_owned(),
        "--dump-instr=yes".to_owned(),
        "--compress-strings=no".to_owned(),
        "--compress-pos=no".to_owned(),
        format!("--callgrind-out-file={}", out.display()),
        format!("--toggle-collect={function}"),
        format!("--dump-after={function}"),
    ]
}

/// Reads a dump: lines of `address line count` under `ob=` lines that name the object. The line after a
/// `calls=` line repeats what the callee has told already.
///
/// # Errors
///
/// The line that is none of the format.
pub fn parse(text: &str, program: &Path) -> Result<Counts, String> {
    let program = program.to_string_lossy();
    let mut counts = Counts::default();
    let (mut inside, mut skip) = (false, false);
    for line in text.lines() {
        if let Some(object) = line.strip_prefix("ob=") {
            inside = object == program;
        } else if line.starts_with("calls=") {
            skip = true;
        } else if line.starts_with("0x") {
            if std::mem::take(&mut skip) {
                continue;
            }
            let wrong = || format!("not a line of callgrind's: {line:?}");
            let mut words = line.split_ascii_whitespace();
            let address = words.next().and_then(|word| word.strip_prefix("0x")).ok_or_else(wrong)?;
            let address = u64::from_str_radix(address, 16).map_err(|_| wrong())?;
            let count: u64 = words.nth(1).and_then(|word| word.parse().ok()).ok_or_else(wrong)?;
            if inside {
                *counts.addresses.entry(address).or_default() += count;
            } else {
                counts.elsewhere += count;
            }
        }
    }
    Ok(counts)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DUMP: &str = "\
version: 1
positions: instr line
events: Ir
summary: 10

ob=/lib/libc.so
fl=???
fn=memset
0x10 0 3

ob=/program
fl=a.rs
fn=a
0x1000 5 2
fi=b.rs
0x1004 7 2
cob=/lib/libc.so
cfn=memset
calls=1 0x10 0
0x1004 7 3
fe=a.rs
0x1000 6 1
totals: 8
";

    #[test]
    fn own_instructions_are_counted_once() {
        let counts = parse(DUMP, Path::new("/program")).unwrap();
        assert_eq!(counts.elsewhere, 3);
        assert_eq!(counts.addresses, HashMap::from([(0x1000, 3), (0x1004, 2)]));
    }

    #[test]
    fn another_format_is_an_error() {
        assert!(parse("ob=/program\n0xZZ 1 1\n", Path::new("/program")).is_err());
        assert!(parse("ob=/program\n0x10 +1\n", Path::new("/program")).is_err());
    }
}
