//! The preview: every pixel shaded from the visibility buffer, by nothing but its triangle's id.
//!
//! Id to corners, corners to plane and normal; where the pixel's line of sight meets the plane is the
//! point that is lit.

use glam::{DMat4, DVec3, DVec4};
use halfplane::{NO_ID, Region, Standard};
use rayon::prelude::*;

use crate::args::DepthFormat;
use crate::camera::{Matrix, as_columns};
use crate::level::Level;
use crate::mesh::{Finish, Mesh};
use crate::render::{Picture, RenderError, Settings, render};
use crate::way::Way;

use super::light::{Light, Look, to_byte};
use super::shadow::Shadows;

/// One colour per pixel.
///
/// # Errors
///
/// [`RenderError`] where a shadow or a mirror image cannot be drawn.
pub fn shaded(
    mesh: &Mesh,
    matrix: &Matrix,
    picture: &Picture,
    look: Look,
) -> Result<Vec<[u8; 3]>, RenderError> {
    let rays = Rays::new(matrix, picture.width, picture.height);
    let light = Light::new(look, rays.axes(), distances(mesh, &rays));
    let (shadows, mirror) = match look {
        Look::Studio => (None, None),
        Look::Evening => {
            let mirror = mirror(mesh, matrix, picture)?;
            (Some(Shadows::new(mesh, light.sun)?), Some(mirror))
        }
    };
    let shader = Shader { mesh, rays, light, shadows, mirror };
    let mut colours = vec![[0; 3]; picture.ids.len()];
    let width = picture.width as usize;
    colours.par_chunks_mut(width).zip(picture.ids.par_chunks(width)).enumerate().for_each(
        |(y, (row, ids))| {
            for (x, (colour, &id)) in row.iter_mut().zip(ids).enumerate() {
                *colour = shader.pixel(x as u32, y as u32, id).to_array().map(to_byte);
            }
        },
    );
    Ok(colours)
}

struct Shader<'a> {
    mesh: &'a Mesh,
    rays: Rays,
    light: Light,
    shadows: Option<Shadows>,
    /// Ids of the scene mirrored in the water.
    mirror: Option<Picture>,
}

/// Where a line of sight meets a triangle.
struct Hit {
    point: DVec3,
    /// Towards the viewer's side.
    normal: DVec3,
    distance: f64,
}

impl Shader<'_> {
    fn pixel(&self, x: u32, y: u32, id: u32) -> DVec3 {
        let (origin, towards) = self.rays.through(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let Some(hit) = self.hit(id, origin, towards) else {
            return self.light.sky(towards);
        };
        if self.mesh.surface(id).finish == Finish::Water {
            let water = self.water(x, y, &hit, towards);
            return self.light.through_air(water, towards, hit.distance);
        }
        self.light.through_air(self.surface(id, &hit), towards, hit.distance)
    }

    /// The light that a dry surface sends out.
    fn surface(&self, id: u32, hit: &Hit) -> DVec3 {
        let surface = self.mesh.surface(id);
        let colour = DVec3::from(surface.colour.map(f64::from));
        if surface.finish == Finish::Glow {
            return colour * 2.2;
        }
        let open = self.shadows.as_ref().map_or(1.0, |shadows| shadows.open(hit.point, hit.normal));
        colour * self.light.on(hit.normal, open)
    }

    /// Water mirrors what the mirror image has at the same pixel, or the sky; small waves stretch it.
    fn water(&self, x: u32, y: u32, hit: &Hit, towards: DVec3) -> DVec3 {
        let wave = ripple(hit.point) * (24.0 / (24.0 + hit.distance * 0.25));
        let mirrored = DVec3::new(towards.x, -towards.y + wave * 0.03, towards.z);
        let mirrored = mirrored.normalize_or(DVec3::Y);
        let row = f64::from(y) + wave * 7.0;
        let reflection = self.mirror.as_ref().and_then(|mirror| {
            let row = (row.max(0.0) as u32).min(mirror.height - 1);
            let id = mirror.ids[row as usize * mirror.width as usize + x as usize];
            // The mirrored line of sight starts at the water.
            let seen = self.hit(id, hit.point, mirrored)?;
            Some(self.light.through_air(self.surface(id, &seen), mirrored, seen.distance))
        });
        let reflection = reflection.unwrap_or_else(|| self.light.sky(mirrored));
        let steep = 1.0 - (-towards.y).clamp(0.0, 1.0);
        let fresnel = 0.04 + 0.92 * steep * steep * steep * steep * steep;
        let open = self.shadows.as_ref().map_or(1.0, |shadows| shadows.open(hit.point, DVec3::Y));
        let deep = DVec3::new(0.016, 0.060, 0.078) * (0.7 + 0.8 * open);
        deep.lerp(reflection, fresnel)
    }

    fn hit(&self, id: u32, origin: DVec3, towards: DVec3) -> Option<Hit> {
        if id == NO_ID {
            return None;
        }
        let corners = self.mesh.corners(id)?;
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).try_normalize()?;
        let normal = if normal.dot(towards) > 0.0 { -normal } else { normal };
        // Seen edge-on a plane can be met anywhere; the triangle itself is between its corners.
        let reach = corners.map(|corner| (corner - origin).dot(towards));
        let (near, far) =
            reach.iter().fold((f64::MAX, f64::MIN), |(near, far), &r| (near.min(r), far.max(r)));
        let met = normal.dot(a - origin) / normal.dot(towards);
        let distance = if met.is_finite() { met.clamp(near, far) } else { near };
        Some(Hit { point: origin + towards * distance, normal, distance: distance.max(0.0) })
    }
}

/// Long low waves, -1 to 1, from four folded lines.
fn ripple(point: DVec3) -> f64 {
    let fold = |v: f64| {
        let t = v - v.floor();
        let s = if t < 0.5 { t * 4.0 - 1.0 } else { 3.0 - t * 4.0 };
        s * (1.5 - 0.5 * s * s)
    };
    let DVec3 { x, z, .. } = point;
    let bend = fold(0.021 * x + 0.034 * z) * 0.9;
    (fold(0.09 * x + 0.61 * z + bend)
        + 0.7 * fold(0.33 * x - 0.87 * z + 2.0 * bend)
        + 0.5 * fold(1.3 * z - 0.7 * x))
        / 2.2
}

/// The scene under the water, upside down, without what is below the surface itself.
fn mirror(mesh: &Mesh, matrix: &Matrix, picture: &Picture) -> Result<Picture, RenderError> {
    let positions = mesh.positions.iter().map(|&[x, y, z]| [x, -y, z]).collect();
    let mut indices = mesh.indices.clone();
    for triangle in indices.chunks_exact_mut(3) {
        let dry = triangle.iter().any(|&index| mesh.positions[index as usize][1] > 0.05);
        if !dry {
            // Kept in its place, so that ids do not move, but of no area.
            triangle[1] = triangle[0];
            triangle[2] = triangle[0];
        }
    }
    let settings = Settings {
        region: Region::<Standard>::of_size(picture.width, picture.height)?,
        cull: halfplane::Cull::None,
        front: halfplane::Winding::Clockwise,
        depth: DepthFormat::D32,
        level: Level::detect(),
    };
    render(&Mesh::plain(positions, indices), matrix, &settings, &Way::Triangles)
}

/// The nearest and farthest corner along the sight in the middle of the picture.
fn distances(mesh: &Mesh, rays: &Rays) -> (f64, f64) {
    let (origin, forward) = rays.middle();
    let along = mesh.used().map(|corner| (corner - origin).dot(forward));
    along.fold((f64::MAX, f64::MIN), |(near, far), d| (near.min(d.max(0.0)), far.max(d)))
}

/// Lines of sight through pixels, for any camera matrix that can be inverted.
struct Rays {
    inverse: DMat4,
    width: f64,
    height: f64,
}

impl Rays {
    fn new(matrix: &Matrix, width: u32, height: u32) -> Self {
        let inverse = as_columns(matrix).inverse();
        Self { inverse, width: f64::from(width), height: f64::from(height) }
    }

    /// Where the line through a point of the window crosses the near plane, and its direction.
    fn through(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let (x, y) = (2.0 * x / self.width - 1.0, 1.0 - 2.0 * y / self.height);
        let near = self.inverse * DVec4::new(x, y, 0.0, 1.0);
        let far = self.inverse * DVec4::new(x, y, 1.0, 1.0);
        // far/far.w - near/near.w, times near.w far.w: no division where the far plane is at infinity.
        let along = far.truncate() * near.w - near.truncate() * far.w;
        let along = if near.w * far.w < 0.0 { -along } else { along };
        (near.truncate() / near.w, along.normalize_or(DVec3::Z))
    }

    fn middle(&self) -> (DVec3, DVec3) {
        self.through(self.width * 0.5, self.height * 0.5)
    }

    /// Right, up and forward as they are in the picture.
    fn axes(&self) -> [DVec3; 3] {
        let (centre, forward) = self.middle();
        let across = |x: f64, y: f64| {
            let (point, towards) = self.through(self.width * x, self.height * y);
            let offset = point + towards - centre - forward;
            (offset - forward * offset.dot(forward)).normalize_or(DVec3::ZERO)
        };
        [across(1.0, 0.5), across(0.5, 0.0), forward]
    }
}
