//! The triangles that need no clipping and no culling: what 2D crates are given.

use crate::view::View;

/// The triangles of a view that lie wholly inside the view volume, face the viewer and have an area.
#[derive(Debug, Clone)]
pub struct Visible {
    /// Their vertices, three each.
    pub indices: Vec<u32>,
    /// Their corners in pixels, y down.
    pub corners: Vec<[[f32; 2]; 3]>,
}

impl Visible {
    /// Those of a view.
    #[must_use]
    pub fn new(view: &View<'_>) -> Self {
        let mut visible = Self { indices: Vec::new(), corners: Vec::new() };
        for triangle in view.indices.as_chunks::<3>().0 {
            let clip = triangle.map(|index| view.clip(view.positions[index as usize]));
            let inside =
                |[x, y, z, w]: [f32; 4]| w > 0.0 && x.abs() <= w && y.abs() <= w && z >= 0.0 && z <= w;
            if !clip.into_iter().all(inside) {
                continue;
            }
            let corners @ [a, b, c] = clip.map(|point| view.window(point));
            let clockwise = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            if clockwise > 0.0 {
                visible.indices.extend(triangle);
                visible.corners.push(corners);
            }
        }
        visible
    }
}
