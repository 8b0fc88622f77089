//! From an instruction's address to the stage it was inlined from.

use std::collections::{BTreeSet, HashMap};
use std::path::Path;

use addr2line::Loader;

use super::Part;

/// A program's debug information.
pub struct Lines {
    loader: Loader,
    known: HashMap<u64, Part>,
    strangers: BTreeSet<String>,
}

impl Lines {
    /// That of a program's file.
    ///
    /// # Errors
    ///
    /// Why it cannot be read.
    pub fn new(program: &Path) -> Result<Self, String> {
        let loader = Loader::new(program).map_err(|error| format!("{}: {error}", program.display()))?;
        Ok(Self { loader, known: HashMap::new(), strangers: BTreeSet::new() })
    }

    /// The stage of an instruction: of the innermost function whose file belongs to one.
    pub fn part(&mut self, address: u64) -> Part {
        if let Some(&part) = self.known.get(&address) {
            return part;
        }
        let mut part = Part::Other;
        if !self.has(address) {
            return part;
        }
        if let Ok(mut frames) = self.loader.find_frames(address) {
            while let Ok(Some(frame)) = frames.next() {
                let Some(file) = frame.location.and_then(|location| location.file) else { continue };
                if !Part::knows(file) {
                    self.strangers.insert(file.to_owned());
                }
                let function = frame.function.as_ref().and_then(|function| function.raw_name().ok());
                if let Some(found) =
                    by_function(&function.unwrap_or_default(), file).or_else(|| Part::of(file))
                {
                    part = found;
                    break;
                }
            }
        }
        self.known.insert(address, part);
        part
    }

    /// Whether an address is one of the program's own instructions.
    #[must_use]
    pub fn has(&self, address: u64) -> bool {
        self.loader.get_section_range(b".text").is_some_and(|text| (text.begin..text.end).contains(&address))
    }

    /// Files of the core that no stage is known for, among the addresses so far.
    #[must_use]
    pub fn strangers(&self) -> Vec<String> {
        self.strangers.iter().cloned().collect()
    }
}

/// Two stages that share their files with others: the clear of attachments, and the fallback level's
/// transform, which is the caller's.
fn by_function(name: &str, file: &str) -> Option<Part> {
    let ours = file.contains("core/src/attachments/") || file.contains("measure/src/target/");
    if ours && name.contains("clear") {
        Some(Part::Clear)
    } else if name.contains("transform_fallback") {
        Some(Part::Transform)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_decide_where_files_cannot() {
        assert_eq!(by_function("_ZN..5clear17h..E", "/x/core/src/attachments/depth.rs"), Some(Part::Clear));
        assert_eq!(by_function("clear", "/x/core/src/simd/queue.rs"), None);
        assert_eq!(by_function("transform_fallback", "/x/measure/src/target/mod.rs"), Some(Part::Transform));
    }

    #[test]
    fn a_program_without_the_address_says_other() {
        let program = std::env::current_exe().unwrap();
        let mut lines = Lines::new(&program).unwrap();
        assert!(!lines.has(u64::MAX));
        assert_eq!(lines.part(u64::MAX), Part::Other);
    }
}
