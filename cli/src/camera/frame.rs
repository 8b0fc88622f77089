//! A camera for a model of which nothing is known: from the front, right and above, as near as shows
//! all of it.

use glam::DVec3;

use crate::mesh::{Bounds, Mesh};

use super::{CameraError, Hand, View};

/// Free space round the model, as a part of the distance.
const MARGIN: f64 = 1.05;

/// The view that frames `mesh`, and near and far planes that keep all of it.
///
/// # Errors
///
/// [`CameraError`] where `up` is no direction.
pub fn frame(
    mesh: &Mesh,
    up: DVec3,
    fov: f64,
    hand: Hand,
    (width, height): (u32, u32),
) -> Result<(View, (f64, f64)), CameraError> {
    let bounds = mesh.bounds().unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO });
    let centre = bounds.centre();
    // A point or a model of points still needs a camera that is somewhere else.
    let radius = if bounds.radius() > 0.0 { bounds.radius() } else { 1.0 };
    let up = up.try_normalize().ok_or(CameraError::UpAlongView)?;
    // The side that faces the viewer: z points towards him or away from him; where z is up, it is -y.
    let towards = match hand {
        Hand::Left => -DVec3::Z,
        Hand::Right => DVec3::Z,
    };
    let front = towards - up * towards.dot(up);
    let front = front.try_normalize().unwrap_or(-DVec3::Y);
    let side = match hand {
        Hand::Left => front.cross(up),
        Hand::Right => up.cross(front),
    };
    let forward = -(front * 1.0 + side * 0.6 + up * 0.5);
    let mut view = View { eye: centre, forward, up };
    let [right, above, forward] = view.axes(hand)?;

    let tall = libm::tan(fov * 0.5);
    let wide = tall * f64::from(width) / f64::from(height);
    let (mut distance, mut nearest, mut farthest) = (0.0f64, 0.0f64, 0.0f64);
    for point in mesh.used() {
        let offset = point - centre;
        let along = offset.dot(forward);
        let needed = (offset.dot(right).abs() / wide).max(offset.dot(above).abs() / tall);
        distance = distance.max(needed - along);
        nearest = nearest.min(along);
        farthest = farthest.max(along);
    }
    let distance = (distance * MARGIN).max(radius * 0.01 - nearest);
    view.eye = centre - forward * distance;
    let near = (distance + nearest) * 0.95;
    let far = (distance + farthest) * 1.05;
    Ok((view, (near, far.max(near * 2.0))))
}

/// Planes for a camera at `eye`: far behind the last vertex, near a ten-thousandth of that, or a
/// thousandth of the model's radius if that is less.
#[must_use]
pub fn near_and_far(mesh: &Mesh, eye: DVec3) -> (f64, f64) {
    let Some(bounds) = mesh.bounds() else {
        return (0.1, 1000.0);
    };
    let reach = bounds.corners().iter().map(|corner| corner.distance(eye)).fold(0.0, f64::max);
    if reach == 0.0 {
        return (0.1, 1000.0);
    }
    let far = reach * 1.01;
    let near = far / 10_000.0;
    (if bounds.radius() > 0.0 { near.min(bounds.radius() / 1000.0) } else { near }, far)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::{Lens, as_columns, matrix};

    #[test]
    fn every_vertex_is_inside_the_picture() {
        let positions = vec![[0.0, 0.0, 0.0], [10.0, 1.0, -2.0], [3.0, 40.0, 5.0], [1.0, 1.0, 9.0]];
        let mesh = Mesh::plain(positions, vec![0, 1, 2, 1, 2, 3]);
        for hand in [Hand::Left, Hand::Right] {
            for (size, up) in [((64, 64), DVec3::Y), ((300, 50), DVec3::Z), ((20, 90), DVec3::X)] {
                let fov = 0.8;
                let (view, (near, far)) = frame(&mesh, up, fov, hand, size).unwrap();
                let m = as_columns(&matrix(&view, &Lens { fov, near, far }, hand, size).unwrap());
                for point in mesh.used() {
                    let clip = m * point.extend(1.0);
                    assert!(clip.w > 0.0 && clip.z > 0.0 && clip.z < clip.w, "{clip}");
                    assert!(clip.x.abs() < clip.w && clip.y.abs() < clip.w, "{clip}");
                }
            }
        }
    }
}
