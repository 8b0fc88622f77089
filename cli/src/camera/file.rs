//! The `.txt` beside an SCN1 file: cameras by name.
//!
//! ```text
//! camera NAME
//! eye X Y Z
//! dir X Y Z
//! up X Y Z
//! lens fovy RADIANS near N far F
//! mvp WxH m00 m01 m02 m03 m10 ... m33
//! ```
//!
//! Lines that begin with `#` and empty lines mean nothing.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::str::SplitWhitespace;

use glam::DVec3;

use super::{CameraError, Hand, Lens, Matrix, Request, View, file_of, matrix};

/// A camera with a name.
#[derive(Debug, Clone, Default)]
pub struct Named {
    /// What `--camera` calls it.
    pub name: String,
    /// Where it stands.
    pub eye: Option<DVec3>,
    /// Where it looks.
    pub forward: Option<DVec3>,
    /// What is up there.
    pub up: Option<DVec3>,
    /// Its lens.
    pub lens: Option<Lens>,
    /// Ready matrices for sizes.
    pub matrices: Vec<((u32, u32), Matrix)>,
}

impl Named {
    /// The matrix for a picture of `size`: the ready one if there is one and nothing of it is to be
    /// changed, otherwise made from the view and the lens.
    pub(super) fn matrix(
        &self,
        request: &Request,
        hand: Hand,
        size: (u32, u32),
    ) -> Result<Matrix, CameraError> {
        let changed =
            request.fov.is_some() || request.near.is_some() || request.far.is_some() || request.up.is_some();
        let ready = self.matrices.iter().find(|(of, _)| *of == size);
        if let (Some((_, ready)), false) = (ready, changed) {
            return Ok(*ready);
        }
        let (Some(eye), Some(forward), Some(up), Some(lens)) =
            (self.eye, self.forward, request.up.or(self.up), self.lens)
        else {
            return Err(CameraError::Incomplete { name: self.name.clone(), size });
        };
        let lens = Lens {
            fov: request.fov.map_or(lens.fov, f64::to_radians),
            near: request.near.unwrap_or(lens.near),
            far: request.far.unwrap_or(lens.far),
        };
        matrix(&View { eye, forward, up }, &lens, hand, size)
    }
}

/// The cameras in the file beside `model`.
///
/// # Errors
///
/// [`CameraError::NoFile`] or [`CameraError::Line`].
pub fn beside(model: &Path) -> Result<Vec<Named>, CameraError> {
    let path = file_of(model);
    let text =
        fs::read_to_string(&path).map_err(|error| CameraError::NoFile { path: path.clone(), error })?;
    parse(&text).map_err(|(line, expected)| CameraError::Line { path, line, expected })
}

/// The cameras in a text.
///
/// # Errors
///
/// The number of the first line that is not understood, and what should stand there.
pub fn parse(text: &str) -> Result<Vec<Named>, (usize, &'static str)> {
    let mut cameras: Vec<Named> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        let Some(key) = words.next().filter(|key| !key.starts_with('#')) else {
            continue;
        };
        let fault = |expected| (number + 1, expected);
        if key == "camera" {
            let name = words.next().ok_or(fault("\"camera\" and a name"))?;
            cameras.push(Named { name: name.to_owned(), ..Named::default() });
            continue;
        }
        let camera = cameras.last_mut().ok_or(fault("\"camera NAME\" before anything else"))?;
        entry(camera, key, words).map_err(fault)?;
    }
    Ok(cameras)
}

fn entry(camera: &mut Named, key: &str, mut words: SplitWhitespace<'_>) -> Result<(), &'static str> {
    match key {
        "eye" => camera.eye = Some(point(words).ok_or("\"eye\" and three numbers")?),
        "dir" => camera.forward = Some(point(words).ok_or("\"dir\" and three numbers")?),
        "up" => camera.up = Some(point(words).ok_or("\"up\" and three numbers")?),
        "lens" => {
            let expected = "\"lens fovy RADIANS near N far F\" with 0 < fovy < pi";
            let lens = lens(words).ok_or(expected)?;
            camera.lens = Some(lens);
        }
        "mvp" => {
            let expected = "\"mvp WxH\" and 16 numbers";
            let size = words.next().and_then(size).ok_or(expected)?;
            let numbers: Option<Vec<f32>> = words.map(|word| word.parse().ok()).collect();
            let matrix = numbers.and_then(|n| Matrix::try_from(n).ok()).ok_or(expected)?;
            camera.matrices.push((size, matrix));
        }
        _ => return Err("one of camera, eye, dir, up, lens, mvp, or a line that begins with #"),
    }
    Ok(())
}

fn point(words: SplitWhitespace<'_>) -> Option<DVec3> {
    let numbers: Option<Vec<f64>> = words.map(number).collect();
    Some(DVec3::from(<[f64; 3]>::try_from(numbers?).ok()?))
}

fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

fn lens(mut words: SplitWhitespace<'_>) -> Option<Lens> {
    let mut value = |key| (words.next()? == key).then(|| words.next().and_then(number))?;
    let lens = Lens { fov: value("fovy")?, near: value("near")?, far: value("far")? };
    (lens.fov > 0.0 && lens.fov < PI).then_some(lens)
}

fn size(word: &str) -> Option<(u32, u32)> {
    let (width, height) = word.split_once('x')?;
    Some((width.parse().ok()?, height.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# a comment\n\ncamera one\neye 1 2 3\ndir 0 0 1\nup 0 1 0\n\
        lens fovy 1 near 0.5 far 50\nmvp 4x2 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\ncamera two\n";

    #[test]
    fn the_ready_matrix_is_for_its_size_only() {
        let cameras = parse(TEXT).unwrap();
        assert_eq!(cameras.len(), 2);
        let request = Request::default();
        let ready = cameras[0].matrix(&request, Hand::Left, (4, 2)).unwrap();
        assert_eq!(ready[15], 16.0);
        let made = cameras[0].matrix(&request, Hand::Left, (8, 4)).unwrap();
        assert_eq!((made[3], made[7], made[11], made[15]), (0.0, 0.0, 1.0, -3.0));
        let incomplete = cameras[1].matrix(&request, Hand::Left, (4, 2));
        assert!(matches!(incomplete, Err(CameraError::Incomplete { .. })));
        let request = Request { near: Some(1.0), ..request };
        assert_ne!(cameras[0].matrix(&request, Hand::Left, (4, 2)).unwrap(), ready);
    }

    #[test]
    fn faults_name_their_line() {
        for (text, line) in [
            ("eye 1 2 3", 1),
            ("camera a\n\neye 1 2", 3),
            ("camera a\nlens fovy 4 near 1 far 2", 2),
            ("camera a\nmvp 4x4 1 2 3", 2),
            ("camera", 1),
            ("camera a\nfocus 3", 2),
        ] {
            assert_eq!(parse(text).unwrap_err().0, line, "{text}");
        }
    }
}
