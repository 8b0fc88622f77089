//! The matrix of a view and a lens, computed in `f64` and rounded once.

use glam::{DMat4, DVec3, DVec4};

use super::{CameraError, Matrix};

/// Which way a model's z axis points when x is right and y is up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hand {
    /// Away from the viewer (Direct3D, SCN1).
    Left,
    /// Towards the viewer (OpenGL, glTF, OBJ).
    Right,
}

/// Where a camera stands and looks; directions need not have length 1.
#[derive(Debug, Clone, Copy)]
pub struct View {
    /// The camera's place.
    pub eye: DVec3,
    /// The direction of sight.
    pub forward: DVec3,
    /// A direction that is up in the picture.
    pub up: DVec3,
}

/// A perspective lens.
#[derive(Debug, Clone, Copy)]
pub struct Lens {
    /// The vertical field of view in radians.
    pub fov: f64,
    /// Distance of the plane with depth 0.
    pub near: f64,
    /// Distance of the plane with depth 1.
    pub far: f64,
}

impl View {
    /// The directions right, up and forward in the picture, each of length 1.
    ///
    /// # Errors
    ///
    /// [`CameraError::NoDirection`] or [`CameraError::UpAlongView`].
    pub fn axes(&self, hand: Hand) -> Result<[DVec3; 3], CameraError> {
        let forward = self.forward.try_normalize().ok_or(CameraError::NoDirection)?;
        let up = self.up.try_normalize().ok_or(CameraError::UpAlongView)?;
        let across = match hand {
            Hand::Left => up.cross(forward),
            Hand::Right => forward.cross(up),
        };
        if across.length_squared() < 1e-12 {
            return Err(CameraError::UpAlongView);
        }
        let right = across.normalize();
        let up = match hand {
            Hand::Left => forward.cross(right),
            Hand::Right => right.cross(forward),
        };
        Ok([right, up, forward])
    }
}

/// Model space to clip space.
///
/// # Errors
///
/// [`CameraError`] where the view has no direction or the planes are not 0 < near < far.
pub fn matrix(
    view: &View,
    lens: &Lens,
    hand: Hand,
    (width, height): (u32, u32),
) -> Result<Matrix, CameraError> {
    let Lens { fov, near, far } = *lens;
    if !(near > 0.0 && near < far && far.is_finite()) {
        return Err(CameraError::Planes { near, far });
    }
    let [right, up, forward] = view.axes(hand)?;
    let tall = 1.0 / libm::tan(fov * 0.5);
    let wide = tall * f64::from(height) / f64::from(width);
    let range = far / (far - near);
    let row = |axis: DVec3, scale: f64| (axis * scale).extend(-axis.dot(view.eye) * scale);
    let (x, y) = (row(right, wide), row(up, tall));
    let w = row(forward, 1.0);
    let z = w * range - DVec4::new(0.0, 0.0, 0.0, near * range);
    // Each of x, y, z, w is a column of the matrix for row vectors.
    Ok(DMat4::from_cols(x, y, z, w).transpose().to_cols_array().map(|number| number as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From a scene's camera file: what Direct3D's own functions made of the same view and lens.
    #[test]
    fn agrees_with_direct3d() {
        let view = View {
            eye: DVec3::new(120.0, 60.0, -130.0),
            forward: DVec3::new(-0.3, -0.35, 0.88),
            up: DVec3::Y,
        };
        let lens = Lens { fov: 1.0, near: 1.0, far: 5000.0 };
        let made = matrix(&view, &lens, Hand::Left, (1280, 720)).unwrap();
        let expected = "0.974573612 -0.208095253 -0.302044928 -0.301984519 \
            0 1.71311939 -0.352385759 -0.352315277 \
            0.332240999 0.610412717 0.885998487 0.885821283 \
            -73.7575073 1.53792298 171.568146 172.533829";
        let expected = expected.split(' ').map(|number| number.parse::<f32>().unwrap());
        for (made, expected) in made.iter().zip(expected) {
            assert!((made - expected).abs() <= 2e-5 * expected.abs().max(1.0), "{made} {expected}");
        }
    }

    #[test]
    fn the_right_hand_only_mirrors_x() {
        let view = View { eye: DVec3::ZERO, forward: DVec3::Z, up: DVec3::Y };
        let lens = Lens { fov: 1.0, near: 1.0, far: 9.0 };
        let left = matrix(&view, &lens, Hand::Left, (3, 2)).unwrap();
        let right = matrix(&view, &lens, Hand::Right, (3, 2)).unwrap();
        assert_eq!(left[0], -right[0]);
        assert_eq!(left[1..], right[1..]);
    }
}
