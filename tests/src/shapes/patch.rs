//! Meshes of which all triangles face much the same way, and cameras at any distance from them.

use super::{Model, Random};

/// What a patch is like: how far normals are spread, how thin and how small its triangles are, how near the camera is,
/// from where it looks, and how large the picture of the patch.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Triangles.
    pub count: usize,
    /// Of unit normals, about.
    pub spread: f64,
    /// Powers of two: length of triangles to the patch's, height to length, the patch's to its distance, its middle's
    /// distance from 0 to its size, its size in pixels.
    pub powers: [i32; 5],
    /// The cosine between the normals and the way to the eye: negative for back faces.
    pub cosine: f64,
    /// No perspective.
    pub orthographic: bool,
    /// Everything else.
    pub seed: u64,
}

type Vector = [f64; 3];

fn add([a, b, c]: Vector, [x, y, z]: Vector, factor: f64) -> Vector {
    [a + factor * x, b + factor * y, c + factor * z]
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn dot([a, b, c]: Vector, [x, y, z]: Vector) -> f64 {
    a * x + b * y + c * z
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|v| v / length) } else { [0.0, 0.0, 1.0] }
}

fn direction(random: &mut Random) -> Vector {
    unit([0; 3].map(|_| random.between(-1000, 1000) as f64 / 1000.0))
}

/// A unit vector across another.
fn across(v: Vector, random: &mut Random) -> Vector {
    let side = cross(v, direction(random));
    if dot(side, side) > 1e-6 { unit(side) } else { unit(cross(v, [v[1], v[2], -v[0]])) }
}

impl Patch {
    /// The mesh and the matrix, for a viewport of so many pixels; three vertices to a triangle.
    pub fn model(&self, [width, height]: [u32; 2]) -> Model {
        let mut random = Random(self.seed);
        let [length, thin, near, place, zoom] = self.powers.map(|power| f64::from(power).exp2());
        let normal = direction(&mut random);
        let middle = direction(&mut random).map(|v| v * place);
        let side = across(normal, &mut random);
        let other = cross(normal, side);
        let part = |random: &mut Random| random.between(-1000, 1000) as f64 / 1000.0;
        let mut vertices = Vec::new();
        for _ in 0..self.count {
            let way = unit(add(normal, direction(&mut random), self.spread * part(&mut random)));
            let along = across(way, &mut random);
            let up = cross(way, along);
            // Somewhere in the patch, which is curved where normals are spread.
            let corner = add(middle, side, 0.5 * part(&mut random));
            let corner = add(corner, other, 0.5 * part(&mut random));
            let corner = add(corner, normal, 0.5 * self.spread * part(&mut random));
            let end = add(corner, along, length);
            let apex = add(add(corner, along, length * part(&mut random)), up, length * thin);
            vertices.extend([corner, end, apex].map(|v| v.map(|v| v as f32)));
        }
        // The eye's way, and the picture's right and top.
        let tilt = across(normal, &mut random);
        let sine = (1.0 - self.cosine * self.cosine).max(0.0).sqrt();
        let eye = unit(add(normal.map(|v| v * self.cosine), tilt, sine));
        let right = across(eye, &mut random);
        let top = cross(eye, right);
        let distance = 1.0 / near;
        let at = add(middle, eye, distance);
        // Of the picture at that distance.
        let scale = |pixels: u32| 2.0 * zoom / f64::from(pixels);
        let depth = eye.map(|v| -v);
        let column = |[a, b, c]: Vector, factor: f64| [a, b, c, -dot([a, b, c], at)].map(|v| v * factor);
        let (x, y, w) = if self.orthographic {
            (column(right, scale(width)), column(top, scale(height)), [0.0, 0.0, 0.0, 1.0])
        } else {
            (
                column(right, scale(width) * distance),
                column(top, scale(height) * distance),
                column(depth, 1.0),
            )
        };
        // Half at the middle, whatever is before and behind it.
        let mut z = column(depth, 0.25 / distance.max(4.0));
        if self.orthographic {
            z[3] += 0.5 - distance * 0.25 / distance.max(4.0);
        } else {
            z = w.map(|v| v * 0.5);
        }
        let matrix = [0, 1, 2, 3].map(|row| [x[row], y[row], z[row], w[row]].map(|v| v as f32));
        Model { vertices, matrix }
    }
}
