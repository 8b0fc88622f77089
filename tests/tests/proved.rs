//! Every function of the core with arithmetic has a proof, but for a list that may only become shorter.

use halfplane_tests::{
    layers::{Source, sources},
    proofs::{Function, arithmetic, properties, unknown, unproved},
};
use std::path::Path;

fn core() -> Vec<Source> {
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../core/src")).unwrap()
}

fn function(layer: &str, name: &str) -> Function {
    Function { layer: layer.to_owned(), name: name.to_owned() }
}

#[test]
fn arithmetic_functions_are_named_by_proofs() {
    let sources = core();
    let (functions, properties) = (arithmetic(&sources).unwrap(), properties(&sources).unwrap());
    assert!(functions.contains(&function("geometry", "Edge::at")), "the reader has lost its way");
    assert!(properties.len() > 50, "{} properties: the reader has lost its way", properties.len());
    let listed: Vec<Function> = include_str!("../unproved.txt")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .filter_map(|line| line.split_once(' '))
        .map(|(layer, name)| function(layer, name))
        .collect();
    assert_eq!(unproved(&functions, &properties), listed, "tests/unproved.txt");
    assert_eq!(unknown(&sources, &properties).unwrap(), Vec::<String>::new());
}

#[test]
fn functions_and_properties_are_found() {
    let source = |module: &[&str], text: &str| Source {
        module: module.iter().map(|&part| part.to_owned()).collect(),
        text: text.to_owned(),
    };
    let code = "
        const WIDE: i32 = 1 + 1;
        fn plain(a: u32) -> u32 { a & 3 }
        fn adds(a: u32) -> u32 { a + 1 }
        struct T;
        impl T { fn casts(self, a: u32) -> u8 { a as u8 } fn is(self) -> bool { true } }
        impl Trait for T { fn negates(a: i32) -> i32 { -a } }
        trait Trait { fn indexes(a: &[u8]) -> u8 { a[0] } fn none(); }";
    let proofs = "prove! {
        /// It holds.
        #[kani::unwind(3)]
        [adds, T::casts]
        fn holds(a: u32 = 0..=8, b: [i32; 2]) { assume!(a > 1); assert!(true); }
    }";
    let sources = [source(&["layer", "code"], code), source(&["layer", "proofs"], proofs)];
    let functions = arithmetic(&sources).unwrap();
    let names: Vec<&str> = functions.iter().map(|function| function.name.as_str()).collect();
    assert_eq!(names, ["T::casts", "T::negates", "Trait::indexes", "adds"]);
    let properties = properties(&sources).unwrap();
    assert_eq!(properties.len(), 1);
    assert_eq!(properties[0].path, "layer::proofs::holds");
    assert_eq!((properties[0].doc.as_str(), properties[0].assumptions), ("It holds.", 1));
    let missing = unproved(&functions, &properties);
    assert_eq!(missing, [function("layer", "T::negates"), function("layer", "Trait::indexes")]);
    assert_eq!(unknown(&sources[1..], &properties).unwrap(), ["T::casts", "adds"]);
}
