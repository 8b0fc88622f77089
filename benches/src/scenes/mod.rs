//! The views that are drawn: a mesh, a matrix and a size.

pub mod files;
pub mod growth;
pub mod micro;
pub mod pixels;

use std::path::Path;
use std::sync::Arc;

use halfplane_cli::mesh::Mesh;
use halfplane_measure::{Matrix, view};

pub use halfplane_measure::motion::Motion;

/// A mesh seen by a camera. Front faces wind clockwise on the screen; the others are culled.
#[derive(Debug, Clone)]
pub struct View {
    /// Scene, camera and size, such as `castle main 1280x720`.
    pub name: String,
    /// What is drawn; positions and indices are all that is used of it.
    pub mesh: Arc<Mesh>,
    /// Object space to clip space, row vectors, row-major.
    pub matrix: Matrix,
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// Whether other crates are measured on it.
    pub peers: bool,
    /// Whether all attachments and a moving camera are measured, or the fastest depth only.
    pub detail: bool,
}

/// The view of that name, whatever it is of; nothing else is made or loaded.
///
/// # Errors
///
/// That there is none, or why its scene cannot be had.
pub fn named(folder: &Path, name: &str) -> Result<View, String> {
    let file = files::FILES.into_iter().find(|file| name.starts_with(&format!("{file} ")));
    let view = if let Some(file) = file {
        files::from_file(folder, file)?.into_iter().find(|view| view.name == name)
    } else if let Some(later) = micro::views().into_iter().find(|later| later.name == name) {
        Some((later.make)(name))
    } else if let Some(count) = growth::COUNTS.into_iter().find(|&count| growth::name(count) == name) {
        Some(growth::view(count, micro::SIZE))
    } else if let Some(samples) = pixels::COUNTS.into_iter().find(|&samples| pixels::name(samples) == name) {
        Some(pixels::view(samples, micro::SIZE))
    } else {
        files::built_in().into_iter().find(|view| view.name == name)
    };
    view.ok_or_else(|| format!("there is no view {name:?}"))
}

impl View {
    /// The matrix of this view's camera while it moves a little.
    #[must_use]
    pub fn motion(&self) -> Motion {
        Motion::new(&self.mesh.positions, &self.matrix, self.size)
    }

    /// The same as plain data, which is what other crates are given.
    #[must_use]
    pub fn plain(&self) -> view::View<'_> {
        let Self { mesh, matrix, size, .. } = self;
        view::View { positions: &mesh.positions, indices: &mesh.indices, matrix: *matrix, size: *size }
    }

    /// Pixels.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.size.0 as usize * self.size.1 as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_are_found_by_their_names() {
        let folder = Path::new("/nowhere");
        for name in ["growth 10^3", "pixels 10^4", "micro slivers, 1000", "built-in temple 1920x1080"] {
            assert_eq!(named(folder, name).map(|view| view.name), Ok(name.to_owned()));
        }
        assert!(named(folder, "castle main 1280x720").is_err_and(|reason| reason.contains("there is no")));
        assert!(named(folder, "growth 10^99").is_err());
    }
}
