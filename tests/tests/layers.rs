//! The core's imports run downwards.

use halfplane_tests::layers::{ORDER, Source, sources, violations};
use std::path::Path;

fn source(module: &[&str], text: &str) -> Source {
    Source { module: module.iter().map(|&part| part.to_owned()).collect(), text: text.to_owned() }
}

#[test]
fn the_core_imports_downwards() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src");
    let sources = sources(&folder).unwrap();
    for layer in ORDER.iter().chain(&["transform", "simd"]) {
        let files = sources.iter().filter(|source| source.module.first().is_some_and(|m| m == layer)).count();
        assert!(files > 1, "layer {layer} has {files} files: the reader has lost its way");
    }
    assert_eq!(violations(&sources), Vec::<String>::new());
}

#[test]
fn upward_imports_are_found() {
    let root = source(&[], "pub use draw::{State, draw};\npub use numbers::unorm16;");
    let cases = [
        ("use crate::draw::State;", "geometry/edge names draw of draw"),
        (
            "use crate::{\n    numbers::{Format, Wide},\n    traversal::Mask,\n};",
            "geometry/edge names traversal of traversal",
        ),
        ("use super::super::lanes::Lanes;", "geometry/edge names lanes of lanes"),
        ("fn f() -> crate::State { loop {} }", "geometry/edge names State of draw"),
    ];
    for (text, expected) in cases {
        assert_eq!(violations(&[root.clone(), source(&["geometry", "edge"], text)]), [expected]);
    }
    // Nothing may name the vector code, which may name all.
    let simd = "use crate::{simd::Level, numbers::Standard};";
    for (layer, file) in [("transform", "model"), ("draw", "state"), ("attachments", "depth")] {
        let expected = format!("{layer}/{file} names simd of simd");
        assert_eq!(violations(&[root.clone(), source(&[layer, file], simd)]), [expected]);
    }
    let all = "use crate::{numbers, geometry, lanes, traversal, attachments, draw, transform, State};";
    assert_eq!(violations(&[root.clone(), source(&["simd", "rows"], all)]), Vec::<String>::new());
    let transform = source(&["transform", "clip"], "use crate::traversal::Mask;");
    assert_eq!(violations(&[root, transform]), ["transform/clip names traversal of traversal"]);
}

#[test]
fn downward_imports_and_comments_are_not() {
    let root = source(&[], "pub use numbers::{unorm16, Small};");
    let text = "//! [`crate::draw`]\n/// See [`State`](crate::State).\nuse crate::{geometry::Region, numbers};\n\
                use super::{storage::Tiled, mask::Mask}; // crate::draw\n\
                pub mod sealed { fn f() { super::super::mask::g() } }\nfn f() { crate::unorm16(1); self::g(); }";
    assert_eq!(violations(&[root, source(&["attachments", "ids"], text)]), Vec::<String>::new());
}

#[test]
fn unknown_layers_are_found() {
    let text = "use crate::numbers::Format;";
    assert_eq!(violations(&[source(&["tricks"], text)]), ["tricks is no known layer"]);
}
