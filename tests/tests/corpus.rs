//! The fuzzer's targets without a fuzzer: its seeds, replayed, and random bytes.
//!
//! `HALFPLANE_CORPUS` names another folder to replay, a campaign's, for instance to measure its coverage.

use halfplane_tests::{failure::Verdict, fuzzing::TARGETS, run::check, sizes};
use proptest::{collection::vec, prelude::*};
use std::{
    env, fs,
    path::{Path, PathBuf},
};

#[test]
fn seeds_hold() {
    let seeds = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/seeds");
    let seeds = env::var_os("HALFPLANE_CORPUS").map_or(seeds, PathBuf::from);
    for (name, target) in TARGETS {
        let folder = seeds.join(name);
        let mut replayed = 0;
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.unwrap().path();
            if let Err(failure) = target(&fs::read(&path).unwrap()) {
                panic!("{}: {failure:?}", path.display());
            }
            replayed += 1;
        }
        println!("{name}: {replayed} seeds");
        assert!(replayed > 0, "{} is empty", folder.display());
    }
}

#[test]
fn random_bytes_hold() {
    for (name, target) in TARGETS {
        check(sizes::BYTES, vec(any::<u8>(), 0..500), |data| -> Verdict {
            target(&data).map_err(|failure| halfplane_tests::Failure(format!("{name}: {}", failure.0)))
        });
    }
}
