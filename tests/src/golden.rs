//! The reader of TRIGOLD1 files: coverage that third-party rasterizers produced.

use crate::Failure;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// A file of goldens.
#[derive(Clone, Debug)]
pub struct Golden {
    /// Target size in pixels.
    pub size: [u32; 2],
    /// Coordinates are in units of 2^-`subpixel_bits` px.
    pub subpixel_bits: u32,
    /// Sample positions from the pixel's top-left corner, in 1/256 px.
    pub samples: Vec<[u16; 2]>,
    /// The triangles and what they cover.
    pub cases: Vec<Case>,
}

/// One triangle.
#[derive(Clone, Debug)]
pub struct Case {
    /// Corners.
    pub corners: [[i32; 2]; 3],
    /// For each sample the covered rows: `(y, first column, column after the last)`, never empty.
    pub spans: Vec<Vec<(u32, u32, u32)>>,
}

/// The goldens' folder, if it is there: beside the repository.
pub fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/goldens");
    folder.is_dir().then_some(folder)
}

/// The golden files in a folder, in order of their names.
pub fn files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "bin") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Little-endian numbers from the front of a slice.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Failure> {
        let (first, rest) =
            self.0.split_first_chunk().ok_or_else(|| Failure::new("the golden file is truncated"))?;
        self.0 = rest;
        Ok(*first)
    }

    fn u16(&mut self) -> Result<u16, Failure> {
        Ok(u16::from_le_bytes(self.take()?))
    }

    fn u32(&mut self) -> Result<u32, Failure> {
        Ok(u32::from_le_bytes(self.take()?))
    }
}

impl Golden {
    /// Reads a file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::parse(&fs::read(path)?)
    }

    /// Reads a file's contents.
    pub fn parse(contents: &[u8]) -> Result<Self, Failure> {
        let mut bytes = Bytes(contents);
        if &bytes.take()? != b"TRIGOLD1" {
            return Err(Failure::new("no TRIGOLD1 file"));
        }
        let (count, width, height, samples) = (bytes.u32()?, bytes.u32()?, bytes.u32()?, bytes.u32()?);
        let subpixel_bits = bytes.u32()?;
        let [_grid, _producers, _flags] = [bytes.u32()?, bytes.u32()?, bytes.u32()?];
        let mut golden =
            Self { size: [width, height], subpixel_bits, samples: Vec::new(), cases: Vec::new() };
        for _ in 0..samples {
            golden.samples.push([bytes.u16()?, bytes.u16()?]);
        }
        for _ in 0..count {
            golden.cases.push(Case::parse(&mut bytes, samples)?);
        }
        if !bytes.0.is_empty() {
            return Err(Failure::new(format_args!("{} bytes after the last case", bytes.0.len())));
        }
        Ok(golden)
    }
}

impl Case {
    fn parse(bytes: &mut Bytes<'_>, samples: u32) -> Result<Self, Failure> {
        let mut corners = [[0; 2]; 3];
        for value in corners.as_flattened_mut() {
            *value = i32::from_le_bytes(bytes.take()?);
        }
        let mut spans = Vec::new();
        for _ in 0..samples {
            let (first, rows) = (u32::from(bytes.u16()?), u32::from(bytes.u16()?));
            let mut covered = Vec::new();
            for y in first..first + rows {
                let (start, end) = (u32::from(bytes.u16()?), u32::from(bytes.u16()?));
                if start < end {
                    covered.push((y, start, end));
                }
            }
            spans.push(covered);
        }
        Ok(Self { corners, spans })
    }
}
