//! The fuzzer's seeds for the parsers, replayed.

mod parsers;

use std::{fs, path::Path};

#[test]
fn seeds_of_parsers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds/parsers");
    let mut replayed = 0;
    for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.unwrap().path();
        if let Err(failure) = parsers::parsers(&fs::read(&path).unwrap()) {
            panic!("{}: {failure}", path.display());
        }
        replayed += 1;
    }
    assert!(replayed > 0, "{} is empty", folder.display());
}
