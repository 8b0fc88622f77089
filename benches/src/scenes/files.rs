//! The built-in scene, and scenes from files with every camera they bring.

use std::path::Path;
use std::sync::Arc;

use halfplane_cli::camera::{self, Hand, Named, Request};
use halfplane_cli::load;
use halfplane_cli::mesh::Mesh;
use halfplane_cli::scene;

use super::View;

/// The sizes of every view.
pub const SIZES: [(u32, u32); 2] = [(1280, 720), (1920, 1080)];

/// The scenes looked for beside the repository.
pub const FILES: [&str; 2] = ["castle", "sponza"];

/// Every camera of the built-in scene at every size.
#[must_use]
pub fn built_in() -> Vec<View> {
    views("built-in", &Arc::new(scene::evening()), &scene::cameras())
        .unwrap_or_else(|problem| unreachable!("the built-in scene has whole cameras: {problem}"))
}

/// Every camera of a scene file at every size.
///
/// # Errors
///
/// Why there are none, as a sentence.
pub fn from_file(folder: &Path, name: &str) -> Result<Vec<View>, String> {
    let path = folder.join(name).with_extension("bin");
    if !path.exists() {
        return Err(format!("there is no {}", path.display()));
    }
    let (mesh, _) = load::load(&path).map_err(|error| error.to_string())?;
    let cameras = camera::beside(&path).map_err(|error| error.to_string())?;
    views(name, &Arc::new(mesh), &cameras)
}

fn views(scene: &str, mesh: &Arc<Mesh>, cameras: &[Named]) -> Result<Vec<View>, String> {
    let mut views = Vec::new();
    for camera in cameras {
        for size @ (width, height) in SIZES {
            let request = Request { name: Some(camera.name.clone()), ..Request::default() };
            let matrix = camera::choose(&request, cameras, scene, mesh, Hand::Left, size)
                .map_err(|error| error.to_string())?;
            let name = format!("{scene} {} {width}x{height}", camera.name);
            views.push(View { name, mesh: Arc::clone(mesh), matrix, size, peers: true, detail: true });
        }
    }
    Ok(views)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_scene_has_views() {
        let views = built_in();
        assert_eq!(views.len(), SIZES.len() * scene::cameras().len());
        assert!(views[0].name.starts_with("built-in terrace 1280x720"));
    }

    #[test]
    fn a_missing_scene_says_so() {
        assert!(from_file(Path::new("/nowhere"), "castle").unwrap_err().contains("there is no"));
    }
}
