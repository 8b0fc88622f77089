//! The reader of the core's imports: which module names which, against the order of the layers.

use crate::Failure;
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// The layers; a module may name itself and those before it.
pub const ORDER: [&str; 6] = ["numbers", "geometry", "lanes", "traversal", "attachments", "draw"];

/// What a module may name besides itself.
fn allowed(module: &str) -> Option<Vec<&'static str>> {
    match module {
        // Beside `draw`, and knows only these.
        "transform" => Some(vec!["numbers", "geometry"]),
        // Above `draw`, and beside `transform`.
        "bins" => Some(ORDER.to_vec()),
        // Above all others, if it is there: no layer may know of it.
        "simd" => Some(ORDER.into_iter().chain(["transform", "bins"]).collect()),
        _ => ORDER.iter().position(|&layer| layer == module).map(|place| ORDER[..place].to_vec()),
    }
}

/// One source file: its path below `src` without the extension, and its text.
#[derive(Clone, Debug)]
pub struct Source {
    /// For instance `["geometry", "edge"]`; `mod` and `lib` are left out.
    pub module: Vec<String>,
    /// The text.
    pub text: String,
}

/// All Rust files below a folder.
pub fn sources(folder: &Path) -> Result<Vec<Source>, Failure> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(below) = folders.pop() {
        for entry in fs::read_dir(folder.join(&below))? {
            let entry = entry?;
            let path = below.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let stem = path.with_extension("");
                let parts = stem.iter().map(|part| part.to_string_lossy().into_owned());
                let module = parts.filter(|part| part != "mod" && part != "lib").collect();
                found.push(Source { module, text: fs::read_to_string(entry.path())? });
            }
        }
    }
    Ok(found)
}

/// Every import against the order: `module/file names layer`. The crate's root may name all.
pub fn violations(sources: &[Source]) -> Vec<String> {
    let empty = Source { module: Vec::new(), text: String::new() };
    let root = sources.iter().find(|source| source.module.is_empty()).unwrap_or(&empty);
    let exported = exports(&strip(&root.text));
    let mut violations = Vec::new();
    for source in sources {
        let Some(own) = source.module.first() else { continue };
        // What proofs are stated with is below all layers, and only they may name it.
        if own == "proof" {
            continue;
        }
        let is_proofs = source.module.iter().any(|part| part == "proofs");
        let Some(allowed) = allowed(own) else {
            violations.push(format!("{} is no known layer", source.module.join("/")));
            continue;
        };
        for name in named(&strip(&source.text), &source.module) {
            let layer = exported.get(&name).unwrap_or(&name);
            if is_proofs && layer == "proof" {
                continue;
            }
            if layer != own && !allowed.contains(&layer.as_str()) {
                violations.push(format!("{} names {name} of {layer}", source.module.join("/")));
            }
        }
    }
    violations.sort();
    violations.dedup();
    violations
}

/// The text without comments; string literals of the core hold no `//`.
fn strip(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// What the root exports under another name: `pub use layer::{Name, ...}` as name to layer.
fn exports(root: &str) -> BTreeMap<String, String> {
    let mut exported = BTreeMap::new();
    for statement in root.split(';') {
        let Some(path) = statement.split("pub use ").nth(1) else { continue };
        let Some((layer, names)) = path.trim().split_once("::") else { continue };
        for name in names.split(['{', '}', ',']).map(str::trim).filter(|name| !name.is_empty()) {
            exported.insert(name.to_owned(), layer.to_owned());
        }
    }
    exported
}

/// The first names of all paths from the crate's root in a text: after `crate::`, and after as many
/// `super::` as lead there; groups in braces included.
fn named(text: &str, module: &[String]) -> Vec<String> {
    let mut names = Vec::new();
    let mut rest = text;
    while let Some((start, root)) = next_path(rest) {
        let (kind, tail) = (root, &rest[start..]);
        rest = &tail[1..];
        let after = match kind {
            Root::Crate => tail.trim_start_matches("crate").trim_start(),
            Root::Super => {
                let mut after = tail;
                let mut ups = 0;
                while let Some(next) =
                    after.strip_prefix("super").and_then(|t| t.trim_start().strip_prefix("::"))
                {
                    after = next.trim_start();
                    ups += 1;
                }
                rest = after;
                // A file a/b is module a::b: two ups lead to the root; a/mod is a: one does. Modules
                // within the file are further steps.
                let at = text.len() - rest.len() - ups * "super::".len();
                if ups < module.len() + inline_modules(&text[..at.min(text.len())]) {
                    continue;
                }
                names.extend(first_names(after));
                continue;
            }
        };
        if let Some(path) = after.strip_prefix("::") {
            names.extend(first_names(path.trim_start()));
        }
    }
    names
}

/// How many `mod name { ... }` are open at the end of a text.
fn inline_modules(text: &str) -> usize {
    let mut open = Vec::new();
    for (at, c) in text.char_indices() {
        match c {
            '{' => {
                let words: Vec<&str> = text[..at].split_whitespace().rev().take(2).collect();
                open.push(words.get(1) == Some(&"mod"));
            }
            '}' => {
                open.pop();
            }
            _ => {}
        }
    }
    open.into_iter().filter(|&module| module).count()
}

#[derive(Clone, Copy)]
enum Root {
    Crate,
    Super,
}

/// Where the next word `crate` or `super` begins.
fn next_path(text: &str) -> Option<(usize, Root)> {
    let word = |name: &str| {
        text.match_indices(name).map(|(at, _)| at).find(|&at| {
            let before = text[..at].chars().next_back();
            !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    };
    match (word("crate::"), word("super::")) {
        (Some(a), Some(b)) if b < a => Some((b, Root::Super)),
        (Some(a), _) => Some((a, Root::Crate)),
        (None, Some(b)) => Some((b, Root::Super)),
        (None, None) => None,
    }
}

/// The name that a path begins with, or those of its group.
fn first_names(path: &str) -> Vec<String> {
    let identifier = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let Some(group) = path.strip_prefix('{') else { return vec![identifier(path)] };
    let mut depth = 0;
    let mut item = String::new();
    let mut names = Vec::new();
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(identifier(&std::mem::take(&mut item))),
            _ => {}
        }
        item.push(c);
        if c == ',' && depth == 0 {
            item.clear();
        }
    }
    names.push(identifier(&item));
    names.retain(|name| !name.is_empty());
    names
}
