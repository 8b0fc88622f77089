//! Cameras: a 4x4 matrix from model to clip space, by whichever way the command line names it.
//!
//! Row vectors, `clip = [x y z 1] * M`, row-major; in clip space x points right, y up, and z runs
//! from 0 at the near plane to w at the far plane. Right-handed models keep their own coordinates:
//! only the direction that "right" means differs.

mod file;
mod frame;
mod lens;

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use glam::{DMat4, DVec3};

pub use file::{Named, beside, parse};
pub use frame::{frame, near_and_far};
pub use halfplane_measure::Matrix;
pub use lens::{Hand, Lens, View, matrix};

use crate::mesh::Mesh;

/// The vertical field of view when none is given, in degrees.
pub const DEFAULT_FOV: f64 = 45.0;

/// The way a camera is asked for.
#[derive(Debug, Clone, Default)]
pub struct Request {
    /// By name.
    pub name: Option<String>,
    /// From here, in model coordinates.
    pub eye: Option<DVec3>,
    /// Towards this point.
    pub target: Option<DVec3>,
    /// The direction that is up in the picture.
    pub up: Option<DVec3>,
    /// Vertical field of view in degrees.
    pub fov: Option<f64>,
    /// Distance of the near plane.
    pub near: Option<f64>,
    /// Distance of the far plane.
    pub far: Option<f64>,
    /// By its numbers.
    pub matrix: Option<Matrix>,
}

/// A camera that cannot be made.
#[derive(Debug)]
pub enum CameraError {
    /// No camera of that name.
    Name {
        /// What was asked for.
        name: String,
        /// Where cameras were looked for.
        place: String,
        /// The names there are.
        available: Vec<String>,
    },
    /// The model has no camera file.
    NoFile {
        /// The file that was looked for.
        path: PathBuf,
        /// Why it cannot be read.
        error: io::Error,
    },
    /// The model's format knows no named cameras.
    NoNames,
    /// A line of the camera file is not understood.
    Line {
        /// The camera file.
        path: PathBuf,
        /// Counted from 1.
        line: usize,
        /// What should stand there.
        expected: &'static str,
    },
    /// A camera of the file lacks what a picture of this size needs.
    Incomplete {
        /// The camera.
        name: String,
        /// Width and height.
        size: (u32, u32),
    },
    /// The eye and the target are the same point, or so close that no direction is left.
    NoDirection,
    /// The line of sight and the up direction are parallel.
    UpAlongView,
    /// The near and far planes are not 0 < near < far.
    Planes {
        /// The near plane's distance.
        near: f64,
        /// The far plane's distance.
        far: f64,
    },
    /// One of the 16 numbers is NaN or infinite (also: outside what 32-bit floats can hold).
    NotFinite {
        /// Which, counted from 0, row by row.
        at: usize,
    },
    /// The matrix squashes space.
    Singular,
}

/// The matrix for a request: by its numbers, by name, from an eye point, or framing the mesh.
///
/// # Errors
///
/// Every [`CameraError`] that the request and the cameras at hand can give.
pub fn choose(
    request: &Request,
    named: &[Named],
    place: &str,
    mesh: &Mesh,
    hand: Hand,
    size: (u32, u32),
) -> Result<Matrix, CameraError> {
    let chosen = if let Some(matrix) = request.matrix {
        matrix
    } else if let Some(name) = &request.name {
        let found = named.iter().find(|camera| camera.name == *name);
        let camera = found.ok_or_else(|| CameraError::Name {
            name: name.clone(),
            place: place.to_owned(),
            available: named.iter().map(|camera| camera.name.clone()).collect(),
        })?;
        camera.matrix(request, hand, size)?
    } else {
        free(request, mesh, hand, size)?
    };
    checked(chosen)
}

/// A camera from an eye point, or one that frames the mesh.
fn free(request: &Request, mesh: &Mesh, hand: Hand, size: (u32, u32)) -> Result<Matrix, CameraError> {
    let up = request.up.unwrap_or(DVec3::Y);
    let fov = request.fov.unwrap_or(DEFAULT_FOV).to_radians();
    let (view, (near, far)) = match (request.eye, request.target) {
        (Some(eye), Some(target)) => {
            let view = View { eye, forward: target - eye, up };
            (view, near_and_far(mesh, eye))
        }
        _ => frame(mesh, up, fov, hand, size)?,
    };
    let near = request.near.unwrap_or(near);
    let far = request.far.unwrap_or_else(|| far.max(near * 2.0));
    matrix(&view, &Lens { fov, near, far }, hand, size)
}

/// A matrix that draws something: finite and not singular.
fn checked(matrix: Matrix) -> Result<Matrix, CameraError> {
    if let Some(at) = matrix.iter().position(|number| !number.is_finite()) {
        return Err(CameraError::NotFinite { at });
    }
    let m = as_columns(&matrix);
    // Hadamard: no determinant exceeds the product of the lengths of the columns. Rounding while
    // it is computed is of the order of 2^-50 of that, so a smaller one counts as zero.
    let largest: f64 = (0..4).map(|k| m.col(k).length()).product();
    let nothing = largest * f64::from_bits((1023 - 50) << 52);
    if m.determinant().abs() <= nothing { Err(CameraError::Singular) } else { Ok(matrix) }
}

/// The same map for column vectors in `f64`: row-major rows are column-major columns.
#[must_use]
pub fn as_columns(matrix: &Matrix) -> DMat4 {
    DMat4::from_cols_array(&matrix.map(f64::from))
}

/// The camera file that belongs to a model: the same name with the ending `.txt`.
#[must_use]
pub fn file_of(model: &Path) -> PathBuf {
    model.with_extension("txt")
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name { name, place, available } => write!(
                f,
                "no camera \"{name}\" in {place}; it has: {}",
                if available.is_empty() { "none".to_owned() } else { available.join(", ") }
            ),
            Self::NoFile { path, error } => write!(
                f,
                "cannot read the cameras in {}: {error}; use --eye and --target, or --matrix",
                path.display()
            ),
            Self::NoNames => write!(
                f,
                "--camera takes names from the .txt beside an SCN1 file; for this model use --eye and --target, or --matrix"
            ),
            Self::Line { path, line, expected } => {
                write!(f, "{} line {line}: expected {expected}", path.display())
            }
            Self::Incomplete { name, size: (width, height) } => write!(
                f,
                "camera \"{name}\" has neither a matrix for {width}x{height} nor all of eye, dir, up and lens to make one"
            ),
            Self::NoDirection => {
                write!(f, "no direction to look in: --target must be another point than --eye")
            }
            Self::UpAlongView => {
                write!(f, "the camera looks along its up direction; give another --up")
            }
            Self::Planes { near, far } => {
                write!(f, "near {near} and far {far} are not 0 < near < far")
            }
            Self::NotFinite { at } => write!(
                f,
                "number {at} of the camera matrix (row {} column {}, from 0) is not a finite 32-bit float",
                at / 4,
                at % 4
            ),
            Self::Singular => {
                write!(f, "the camera matrix is singular: it must map space onto space, not onto a plane")
            }
        }
    }
}

impl std::error::Error for CameraError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn singular_and_unfinished_matrices_are_refused() {
        let mut matrix = [0.0; 16];
        assert!(matches!(checked(matrix), Err(CameraError::Singular)));
        for k in 0..4 {
            matrix[5 * k] = 1.0;
        }
        assert!(checked(matrix).is_ok());
        matrix[10] = 0.0;
        assert!(matches!(checked(matrix), Err(CameraError::Singular)));
        matrix[6] = f32::NAN;
        assert!(matches!(checked(matrix), Err(CameraError::NotFinite { at: 6 })));
    }
}
