//! tiny-skia: 2D paths.

use tiny_skia::{BlendMode, Color, FillRule, Paint, Path, PathBuilder, Pixmap, Transform};

use super::{Peer, Shown, visible::Visible};
use crate::Matrix;
use crate::view::View;

/// A view for tiny-skia.
pub struct TinySkia {
    paths: Vec<Path>,
    indices: Vec<u32>,
    paint: Paint<'static>,
    pixels: Pixmap,
}

impl TinySkia {
    /// A path for each visible triangle; those without width or height, which it refuses, are left out.
    ///
    /// # Panics
    ///
    /// If there is no memory for the pixels.
    #[must_use]
    pub fn new(view: &View<'_>, visible: &Visible) -> Self {
        let path = |[a, b, c]: &[[f32; 2]; 3]| {
            let mut path = PathBuilder::new();
            path.move_to(a[0], a[1]);
            path.line_to(b[0], b[1]);
            path.line_to(c[0], c[1]);
            path.close();
            path.finish()
        };
        let mut paint = Paint { anti_alias: false, blend_mode: BlendMode::Source, ..Paint::default() };
        paint.set_color(Color::WHITE);
        Self {
            paths: visible.corners.iter().filter_map(path).collect(),
            indices: visible.indices.clone(),
            paint,
            pixels: Pixmap::new(view.size.0, view.size.1).expect("memory for a picture"),
        }
    }
}

impl Peer for TinySkia {
    fn name(&self) -> &'static str {
        "tiny-skia"
    }

    fn frame(&mut self, _: &Matrix) {
        self.pixels.fill(Color::TRANSPARENT);
        for path in &self.paths {
            self.pixels.fill_path(path, &self.paint, FillRule::Winding, Transform::identity(), None);
        }
    }

    fn moves(&self) -> bool {
        false
    }

    fn triangles(&self) -> usize {
        self.paths.len()
    }

    fn indices(&self) -> &[u32] {
        &self.indices
    }

    fn covered(&self) -> usize {
        self.pixels.pixels().iter().filter(|pixel| pixel.alpha() != 0).count()
    }

    fn shown(&self) -> Vec<Shown> {
        let pixels = self.pixels.pixels().iter();
        pixels.map(|pixel| if pixel.alpha() == 0 { Shown::Nothing } else { Shown::Something }).collect()
    }
}
