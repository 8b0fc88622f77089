//! Where a frame's instructions and time go, stage by stage, at every level.
//!
//! A draw is one function of everything inlined into everything, so nothing can be measured apart without
//! changing it. Here it is left as it is: callgrind counts every instruction of it and perf samples where
//! the processor is, and the debug information tells from which file of the core an instruction was
//! inlined. The innermost file that belongs to a stage decides ([`Part::of`]).

pub mod callgrind;
pub mod child;
pub mod lines;
pub mod perf;
pub mod table;

/// The stages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Part {
    /// The clear of the attachment.
    Clear,
    /// Vertices: product with the matrix, division, snapping; clipping where needed.
    Transform,
    /// Fetching indices and vertices, rejecting, counting, queueing.
    Cull,
    /// Edges, bounds and planes of the triangles that are left.
    SetUp,
    /// From a triangle to masks.
    Traversal,
    /// Depth of the samples, test and write.
    Depth,
    /// What belongs to none: dispatch, and functions of other crates that are called and not inlined, such as
    /// `floor` where the level has no instruction for it.
    Other,
}

impl Part {
    /// All, in the order of the pipeline.
    pub const ALL: [Self; 7] =
        [Self::Clear, Self::Transform, Self::Cull, Self::SetUp, Self::Traversal, Self::Depth, Self::Other];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Clear => "clear",
            Self::Transform => "transform",
            Self::Cull => "cull",
            Self::SetUp => "set-up",
            Self::Traversal => "traversal",
            Self::Depth => "depth",
            Self::Other => "other",
        }
    }

    /// The stage that a source file belongs to. Files that serve several (numbers, lanes, operations) belong
    /// to none: their code is its caller's.
    #[must_use]
    pub fn of(file: &str) -> Option<Self> {
        let file = file.replace('\\', "/");
        let (_, inside) = file.rsplit_once("core/src/")?;
        FILES.iter().find(|(start, _)| inside.starts_with(start)).and_then(|&(_, part)| part)
    }

    /// Whether a file of the core is one that [`of`](Self::of) knows; the others are told to whoever reads
    /// the table.
    #[must_use]
    pub fn knows(file: &str) -> bool {
        let file = file.replace('\\', "/");
        let Some((_, inside)) = file.rsplit_once("core/src/") else { return true };
        // The standard library's core has the same folder.
        file.contains("/rustc/")
            || file.contains("/library/core/src/")
            || FILES.iter().any(|(start, _)| inside.starts_with(start))
    }
}

/// The files and folders of the core, and what their code does.
const FILES: [(&str, Option<Part>); 48] = [
    ("simd/vertex", Some(Part::Transform)),
    ("simd/binned.rs", Some(Part::Cull)),
    ("simd/batch", Some(Part::Cull)),
    ("simd/cluster", Some(Part::Cull)),
    ("simd/cone", Some(Part::Cull)),
    ("simd/lists", Some(Part::Cull)),
    ("simd/volume", Some(Part::Cull)),
    ("simd/occluded", Some(Part::Cull)),
    ("simd/questions", Some(Part::Cull)),
    ("simd/sort", Some(Part::Cull)),
    ("simd/meshlet", Some(Part::Cull)),
    // Before `window`, which it begins with.
    ("simd/windows", Some(Part::Traversal)),
    // Its vertices are transformed in `vertex`; the rest is indices.
    ("simd/window", Some(Part::Cull)),
    ("simd/source", Some(Part::Cull)),
    ("simd/fetch", Some(Part::Cull)),
    ("simd/cull", Some(Part::Cull)),
    ("simd/queue", Some(Part::Cull)),
    ("simd/setup", Some(Part::SetUp)),
    ("simd/blocks", Some(Part::Traversal)),
    ("simd/rows", Some(Part::Traversal)),
    ("simd/attachment", Some(Part::Depth)),
    ("simd/hierarchical", Some(Part::Depth)),
    // Of cull and of set-up.
    ("simd/extent", None),
    ("simd/draw", None),
    ("simd/pipeline", None),
    ("simd/any", None),
    ("simd/ops", None),
    ("simd/level", None),
    ("simd/mod", None),
    ("transform/frustum", Some(Part::Cull)),
    ("transform/bound", Some(Part::Cull)),
    ("transform/sphere", Some(Part::Cull)),
    ("transform/", Some(Part::Transform)),
    ("geometry/positions", Some(Part::Transform)),
    ("geometry/facing", Some(Part::Cull)),
    ("geometry/edge", Some(Part::SetUp)),
    ("geometry/plane", Some(Part::SetUp)),
    ("geometry/triangle", Some(Part::SetUp)),
    ("geometry/", None),
    ("traversal/", Some(Part::Traversal)),
    ("attachments/", Some(Part::Depth)),
    ("draw/index", Some(Part::Cull)),
    ("draw/statistics", Some(Part::Cull)),
    ("draw/", None),
    ("numbers/", None),
    ("lanes/", None),
    ("bins", Some(Part::Cull)),
    ("lib.rs", None),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    #[test]
    fn files_belong_to_stages() {
        assert_eq!(Part::of("/somewhere/core/src/simd/rows.rs"), Some(Part::Traversal));
        assert_eq!(Part::of("core/src/simd/rows/solve.rs"), Some(Part::Traversal));
        assert_eq!(Part::of("core/src/simd/windows.rs"), Some(Part::Traversal));
        assert_eq!(Part::of("core/src/simd/window.rs"), Some(Part::Cull));
        assert_eq!(Part::of("C:\\x\\core\\src\\transform\\clip.rs"), Some(Part::Transform));
        assert_eq!(Part::of("core/src/numbers/wide.rs"), None);
        assert_eq!(Part::of("/rustc/abc/library/core/src/slice/mod.rs"), None);
        assert!(Part::knows("/rustc/abc/library/core/src/slice/mod.rs"));
        assert!(!Part::knows("core/src/simd/new.rs"));
    }

    /// A file that is new in the core needs a stage here.
    #[test]
    fn every_file_of_the_core_is_known() {
        fn check(folder: &Path, unknown: &mut Vec<String>) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                // Proofs are in no program.
                if path.file_stem().is_some_and(|name| name == "proofs" || name == "proof") {
                    continue;
                }
                if path.is_dir() {
                    check(&path, unknown);
                } else if !Part::knows(&path.to_string_lossy()) {
                    unknown.push(path.display().to_string());
                }
            }
        }
        let mut unknown = Vec::new();
        check(&crate::options::root().join("core/src"), &mut unknown);
        assert!(unknown.is_empty(), "give these a stage in FILES, or None, above: {unknown:?}");
    }
}
