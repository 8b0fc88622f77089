//! Meshes from files: Wavefront OBJ, glTF 2.0 (`.gltf`, `.glb`) and the scene format SCN1.
//!
//! The kind is recognised by the first bytes where the format has a mark (SCN1, GLB), by the name's
//! ending otherwise. Whatever the format, a loaded mesh has at least one triangle, finite positions
//! and indices that exist.

mod gltf;
mod obj;
mod scn1;

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::mesh::Mesh;

/// The file formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ: right-handed, front faces counter-clockwise.
    Obj,
    /// glTF 2.0, text or binary: right-handed, y up, front faces counter-clockwise.
    Gltf,
    /// SCN1: left-handed, front faces clockwise.
    Scn1,
}

/// A file that is not a mesh this program can draw.
#[derive(Debug)]
pub struct LoadError {
    path: PathBuf,
    problem: Problem,
}

/// What is wrong with the contents of a file.
#[derive(Debug)]
pub(crate) enum Problem {
    /// It cannot be read at all.
    Read(io::Error),
    /// Neither its first bytes nor its name tell a known format.
    Unknown,
    /// It is shorter or longer than its own header says.
    Length { given: u64, needed: u64, of: String },
    /// The index list is not made of triangles.
    IndexCount { count: usize, of: String },
    /// An index points past the vertices.
    Index { at: String, index: i64, vertices: usize },
    /// A position is NaN or infinite.
    NotFinite { at: String, position: String },
    /// There is no triangle in it.
    Empty,
    /// There are more vertices or triangles than 32-bit ids can name.
    TooLarge { what: &'static str, count: u64 },
    /// The format's own rules are broken.
    Malformed { at: String, expected: String },
}

/// Reads the mesh in `path`.
///
/// # Errors
///
/// [`LoadError`] says what is wrong, where in the file, and what would be right.
pub fn load(path: &Path) -> Result<(Mesh, Format), LoadError> {
    let bytes =
        fs::read(path).map_err(|error| LoadError { path: path.to_owned(), problem: Problem::Read(error) })?;
    parse(path, &bytes, path.parent())
}

/// The mesh in `bytes`, the contents of a file at `path`; buffers in files of their own are looked for in
/// `folder`, and refused without one.
///
/// # Errors
///
/// As [`load`].
pub fn parse(path: &Path, bytes: &[u8], folder: Option<&Path>) -> Result<(Mesh, Format), LoadError> {
    let fail = |problem| LoadError { path: path.to_owned(), problem };
    let format = recognise(path, bytes).ok_or_else(|| fail(Problem::Unknown))?;
    let mesh = match format {
        Format::Obj => obj::parse(bytes),
        Format::Gltf => gltf::parse(bytes, folder),
        Format::Scn1 => scn1::parse(bytes),
    };
    let mesh = mesh.and_then(check).map_err(fail)?;
    Ok((mesh, format))
}

fn recognise(path: &Path, bytes: &[u8]) -> Option<Format> {
    if bytes.starts_with(b"SCN1") {
        return Some(Format::Scn1);
    }
    if bytes.starts_with(b"glTF") {
        return Some(Format::Gltf);
    }
    let ending = path.extension()?.to_str()?.to_ascii_lowercase();
    match ending.as_str() {
        "obj" => Some(Format::Obj),
        "gltf" | "glb" => Some(Format::Gltf),
        _ => None,
    }
}

/// What must hold for a mesh from any format.
fn check(mesh: Mesh) -> Result<Mesh, Problem> {
    let vertices = mesh.positions.len();
    if !mesh.indices.len().is_multiple_of(3) {
        return Err(Problem::IndexCount { count: mesh.indices.len(), of: "the file".to_owned() });
    }
    if mesh.indices.is_empty() {
        return Err(Problem::Empty);
    }
    // The last id stands for "no triangle".
    for (what, count) in [("vertices", vertices), ("triangles", mesh.triangles())] {
        if count >= u32::MAX as usize {
            return Err(Problem::TooLarge { what, count: count as u64 });
        }
    }
    if let Some(at) = mesh.indices.iter().position(|&index| index as usize >= vertices) {
        let index = i64::from(mesh.indices[at]);
        return Err(Problem::Index { at: format!("index {at}"), index, vertices });
    }
    for (at, position) in mesh.positions.iter().enumerate() {
        if !position.iter().all(|c| c.is_finite()) {
            return Err(not_finite(format!("vertex {at}"), *position));
        }
    }
    Ok(mesh)
}

fn not_finite(at: String, [x, y, z]: [f32; 3]) -> Problem {
    Problem::NotFinite { at, position: format!("({x}, {y}, {z})") }
}

/// Other people's messages may have several lines or end in a full stop; ours are one line.
fn one_line(message: impl fmt::Display) -> String {
    let text = message.to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ").trim_end_matches('.').to_owned()
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        match &self.problem {
            Problem::Read(error) => {
                write!(f, "cannot read {path}: {error}; give the path of an OBJ, glTF, GLB or SCN1 file")
            }
            Problem::Unknown => write!(
                f,
                "{path} is not a mesh: it must end in .obj, .gltf or .glb, or begin with \"SCN1\" or \"glTF\""
            ),
            Problem::Length { given, needed, of } => {
                write!(f, "{path}: {of} has {given} bytes, it must have {needed}")
            }
            Problem::IndexCount { count, of } => {
                write!(f, "{path}: {of} has {count} indices, a triangle list has a multiple of 3")
            }
            Problem::Index { at, index, vertices } => {
                write!(f, "{path}: {at} names vertex {index}, ")?;
                match vertices {
                    0 => write!(f, "but there are no vertices there"),
                    n => write!(f, "but the {n} vertices are numbered {}", range(*n, at)),
                }
            }
            Problem::NotFinite { at, position } => {
                write!(f, "{path}: {at} lies at {position}, positions must be finite numbers")
            }
            Problem::Empty => write!(f, "{path} is not a mesh: there is no triangle in it"),
            Problem::TooLarge { what, count } => {
                write!(f, "{path} has {count} {what}, at most {} can be numbered", u32::MAX - 1)
            }
            Problem::Malformed { at, expected } => write!(f, "{path}: {at}: {expected}"),
        }
    }
}

/// OBJ counts from 1 (and is reported by line), the other formats from 0.
fn range(vertices: usize, at: &str) -> String {
    if at.starts_with("line") { format!("1 to {vertices}") } else { format!("0 to {}", vertices - 1) }
}

impl std::error::Error for LoadError {}
