#!/bin/bash -eu
# Builds every target with the sanitizer and the compiler of the base image, and packs its seeds. Runs in
# the container of .clusterfuzzlite/Dockerfile; the checks of fuzz/Cargo.toml's profile are on.
cd "$SRC/halfplane"
cargo fuzz build --release --debug-assertions
for target in $(cargo fuzz list); do
    cp "fuzz/target/x86_64-unknown-linux-gnu/release/$target" "$OUT/"
    zip -jq "$OUT/${target}_seed_corpus.zip" "fuzz/seeds/$target"/*
done
