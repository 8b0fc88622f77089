//! One surface in more and more triangles: the time should grow with their number and no faster.

use std::sync::Arc;

use halfplane_cli::mesh::Mesh;

use super::View;

/// How many triangles, about.
pub const COUNTS: [u32; 5] = [1_000, 10_000, 100_000, 1_000_000, 10_000_000];

/// The view's name.
#[must_use]
pub fn name(count: u32) -> String {
    format!("growth 10^{}", count.ilog10())
}

/// The surface's view in about `count` triangles: hills that fill the picture, seen from above.
#[must_use]
pub fn view(count: u32, size: (u32, u32)) -> View {
    // Two triangles a cell; the grid is as much wider than high as the picture.
    let cells = f64::from(count) / 2.0;
    let aspect = f64::from(size.0) / f64::from(size.1);
    let columns = (cells * aspect).sqrt().round().max(1.0) as u32;
    let rows = (cells / f64::from(columns)).round().max(1.0) as u32;
    let mut mesh = Mesh::plain(Vec::new(), Vec::new());
    for row in 0..=rows {
        for column in 0..=columns {
            // A little beyond the picture's border, so that every pixel is covered.
            let u = (column as f32 / columns as f32 * 2.0 - 1.0) * 1.02;
            let v = (row as f32 / rows as f32 * 2.0 - 1.0) * 1.02;
            mesh.positions.push([u, v, height(u, v)]);
        }
    }
    let pitch = columns + 1;
    for row in 0..rows {
        for column in 0..columns {
            // y is up in clip space, so the next row is above.
            let [a, b] = [row * pitch + column, row * pitch + column + 1];
            let [c, d] = [a + pitch, b + pitch];
            mesh.indices.extend([a, c, b, b, c, d]);
        }
    }
    // Perspective: w is the distance, 1 at the highest points and 1.1 at the lowest, so that no slope is
    // seen from behind.
    let mut matrix = [0.0; 16];
    (matrix[0], matrix[5]) = (1.1, 1.1);
    (matrix[10], matrix[11]) = (0.5, 0.1);
    (matrix[14], matrix[15]) = (0.25, 1.0);
    View { name: name(count), mesh: Arc::new(mesh), matrix, size, peers: false, detail: false }
}

/// From 0 (near) to 1 (far): a few waves, made of products so that no library function decides the bits.
fn height(u: f32, v: f32) -> f32 {
    let wave = |t: f32| {
        // A parabola between whole numbers, up and down in turns.
        let (whole, part) = (t.floor(), t - t.floor());
        let arch = 4.0 * part * (1.0 - part);
        if whole as i32 % 2 == 0 { arch } else { -arch }
    };
    let sum = wave(3.0 * u + v) + 0.5 * wave(5.0 * v - 2.0 * u) + 0.25 * wave(11.0 * u + 7.0 * v);
    (0.5 + sum / 3.5).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ours::{self, Attachments, Level, drawn};

    #[test]
    fn the_surface_fills_the_picture_however_it_is_cut() {
        for count in COUNTS.into_iter().take(3) {
            let view = view(count, (320, 180));
            let triangles = view.mesh.triangles() as f64;
            assert!((triangles / f64::from(count) - 1.0).abs() < 0.1, "{triangles} for {count}");
            let mut target = ours::target(&view);
            drawn(target.frame(Level::FALLBACK, Attachments::Depth32, &view.matrix));
            assert_eq!(target.covered(Attachments::Depth32), 320 * 180, "{count}");
        }
    }
}
