//! The fuzzer's target for everything the command reads: meshes, cameras, requests of the protocols.
//!
//! What is read is well-formed, and read again after it was written; what an answer says is what the
//! reference says; what is refused is refused with one line. The drivers are `main.rs` beside this file,
//! which replays the seeds, and `fuzz/fuzz_targets/parsers.rs`.

use std::fmt::{Display, Write as _};
use std::path::Path;

use halfplane_cli::camera::{self, Hand, Named, Request};
use halfplane_cli::load::{self, Format};
use halfplane_cli::mesh::Mesh;
use halfplane_cli::protocol::{self, ProtocolError};
use halfplane_reference::{DepthSpec, Grid, Rect, SpecifiedPlane, cover_rows, from_steps, snap};
use num_traits::ToPrimitive;

/// Why a property does not hold.
type Verdict = Result<(), String>;

/// Most triangles that are written as text and read again.
const MOST_TEXT: usize = 300;
/// Most pixels of all answers to a request: they are compared one by one.
const MOST_PIXELS: u64 = 1 << 16;

/// Bytes by what they are: an SCN1, GLB, glTF or OBJ file, a camera file, a TRIQUERY or TRIDEPTH request.
pub(crate) fn parsers(data: &[u8]) -> Verdict {
    if data.starts_with(b"TRIQUERY") {
        return coverage(data);
    }
    if data.starts_with(b"TRIDEPTH") {
        return depth(data);
    }
    if data.starts_with(b"SCN1") || data.starts_with(b"glTF") {
        return mesh("model", data);
    }
    if data.trim_ascii_start().starts_with(b"{") {
        return mesh("model.gltf", data);
    }
    cameras(&String::from_utf8_lossy(data))?;
    mesh("model.obj", data)
}

fn holds(condition: bool, what: impl Display) -> Verdict {
    if condition { Ok(()) } else { Err(what.to_string()) }
}

/// A message that the command can print in one line.
fn message(error: impl Display, names: &str) -> Verdict {
    let text = error.to_string();
    holds(text.contains(names) && text.trim() == text, format_args!("a message that helps nobody: {text:?}"))
}

fn parse(name: &str, data: &[u8]) -> Result<(Mesh, Format), load::LoadError> {
    load::parse(Path::new(name), data, None)
}

/// A loaded mesh has triangles of finite vertices that exist, and is the same after it was written as SCN1
/// and as OBJ.
fn mesh(name: &str, data: &[u8]) -> Verdict {
    let (mesh, _) = match parse(name, data) {
        Ok(loaded) => loaded,
        Err(error) => return message(error, name),
    };
    let (vertices, indices) = (mesh.positions.len(), &mesh.indices);
    holds(!indices.is_empty() && indices.len().is_multiple_of(3), "indices that are no triangles")?;
    holds(indices.iter().all(|&index| (index as usize) < vertices), "an index without a vertex")?;
    holds(mesh.positions.as_flattened().iter().all(|v| v.is_finite()), "a vertex that is not finite")?;
    holds(mesh.bounds().is_some() && !mesh.surfaces.is_empty(), "a mesh that cannot be shown")?;

    let (again, format) =
        parse("again", &scn1(&mesh)).map_err(|error| format!("written as SCN1: {error}"))?;
    holds(format == Format::Scn1, "SCN1 that is not recognised")?;
    holds(again.indices == mesh.indices, "other indices, written as SCN1")?;
    holds(bits(&again.positions) == bits(&mesh.positions), "other vertices, written as SCN1")?;
    if mesh.triangles() <= MOST_TEXT && vertices <= MOST_TEXT {
        let again = parse("again.obj", obj(&mesh).as_bytes());
        let (again, _) = again.map_err(|error| format!("written as OBJ: {error}"))?;
        holds(bits(&corners(&again)) == bits(&corners(&mesh)), "other corners, written as OBJ")?;
    }
    Ok(())
}

fn corners(mesh: &Mesh) -> Vec<[f32; 3]> {
    mesh.indices.iter().map(|&index| mesh.positions[index as usize]).collect()
}

fn bits(positions: &[[f32; 3]]) -> Vec<u32> {
    positions.as_flattened().iter().map(|v| v.to_bits()).collect()
}

fn scn1(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = b"SCN1".to_vec();
    let counts = [mesh.positions.len() as u32, mesh.indices.len() as u32];
    bytes.extend(counts.into_iter().chain(bits(&mesh.positions)).flat_map(u32::to_le_bytes));
    bytes.extend(mesh.indices.iter().copied().flat_map(u32::to_le_bytes));
    bytes
}

fn obj(mesh: &Mesh) -> String {
    let mut text = String::new();
    for [x, y, z] in &mesh.positions {
        let _ = writeln!(text, "v {x:?} {y:?} {z:?}");
    }
    for triangle in mesh.indices.chunks(3) {
        let _ = writeln!(text, "f {} {} {}", triangle[0] + 1, triangle[1] + 1, triangle[2] + 1);
    }
    text
}

/// Cameras are the same after they were written, and give a finite matrix or say why not.
fn cameras(text: &str) -> Verdict {
    let Ok(named) = camera::parse(text) else { return Ok(()) };
    let again = camera::parse(&camera_file(&named)).map_err(|at| format!("written again, fault {at:?}"))?;
    let (again, first) = (format!("{again:?}"), format!("{named:?}"));
    holds(again == first, format_args!("written again {again}, at first {first}"))?;
    let mesh = Mesh::default();
    for one in &named {
        let ready = one.matrices.first().map(|(size, _)| *size);
        for size in ready.into_iter().chain([(640, 480)]) {
            let request = Request { name: Some(one.name.clone()), ..Request::default() };
            match camera::choose(&request, &named, "cameras", &mesh, Hand::Left, size) {
                Ok(matrix) => holds(matrix.iter().all(|v| v.is_finite()), "a matrix that is not finite")?,
                Err(error) => message(error, "")?,
            }
        }
    }
    Ok(())
}

fn camera_file(cameras: &[Named]) -> String {
    let mut text = String::new();
    for one in cameras {
        let _ = writeln!(text, "camera {}", one.name);
        for (key, point) in [("eye", one.eye), ("dir", one.forward), ("up", one.up)] {
            if let Some(point) = point {
                let _ = writeln!(text, "{key} {:?} {:?} {:?}", point.x, point.y, point.z);
            }
        }
        if let Some(lens) = &one.lens {
            let _ = writeln!(text, "lens fovy {:?} near {:?} far {:?}", lens.fov, lens.near, lens.far);
        }
        for ((width, height), matrix) in &one.matrices {
            let numbers: Vec<String> = matrix.iter().map(|number| format!("{number:?}")).collect();
            let _ = writeln!(text, "mvp {width}x{height} {}", numbers.join(" "));
        }
    }
    text
}

/// A request's numbers after its name, and the rest.
fn header<const N: usize>(data: &[u8]) -> Option<([u32; N], Vec<u32>)> {
    let mut words = data.get(8..)?.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    let mut header = [0; N];
    for word in &mut header {
        *word = words.next()?;
    }
    Some((header, words.collect()))
}

/// Whether comparing all that is answered would take too long.
fn too_much(size: [u32; 2], pictures: u64) -> bool {
    let [width, height] = size.map(u64::from);
    width.max(height) <= 16384 && (width * height).saturating_mul(pictures.max(1)) > MOST_PIXELS
}

/// A refusal: one line, a status of its own, and nothing was answered.
fn refused(error: &ProtocolError, answer: &[u8]) -> Verdict {
    message(error, "")?;
    holds(matches!(error.exit_status(), 2 | 77), "an exit status that says nothing")?;
    holds(answer.is_empty(), "an answer to a request that was refused")
}

/// An answer to TRIQUERY is the reference's.
fn coverage(data: &[u8]) -> Verdict {
    let request = header::<5>(data);
    if let Some(([count, width, height, samples, _], _)) = &request
        && too_much([*width, *height], u64::from(*count) * u64::from(*samples))
    {
        return Ok(());
    }
    let mut answer = Vec::new();
    if let Err(error) = protocol::coverage(data, &mut answer) {
        return refused(&error, &answer);
    }
    let Some(([count, width, height, samples, bits], words)) = request else {
        return Err("a request without a header was answered".to_owned());
    };
    let stride = width.div_ceil(8) as usize;
    let (positions, triangles) = words.split_at(2 * samples as usize);
    let mut expected = Vec::new();
    for corners in triangles.chunks_exact(6).take(count as usize) {
        let mut xy = [[0; 2]; 3];
        for (to, &word) in xy.as_flattened_mut().iter_mut().zip(corners) {
            let steps = snap(&from_steps(i64::from(word as i32), bits), 8).to_i32();
            *to = steps.ok_or("a corner beyond all bounds was taken")?;
        }
        for sample in positions.chunks_exact(2) {
            let grid = Grid::new(8, (sample[0], sample[1])).map_err(|error| error.to_string())?;
            let start = expected.len();
            expected.resize(start + stride * height as usize, 0u8);
            let rect = Rect { x0: 0, y0: 0, x1: width, y1: height };
            cover_rows(&xy, grid, rect, |y, columns| {
                for x in columns {
                    expected[start + y as usize * stride + x as usize / 8] |= 1 << (x % 8);
                }
            });
        }
    }
    holds(answer == expected, format_args!("TRIQUERY: {answer:02X?}, but the reference {expected:02X?}"))
}

/// An answer to TRIDEPTH is the reference's.
fn depth(data: &[u8]) -> Verdict {
    let request = header::<4>(data);
    if let Some(([count, width, height, _], _)) = &request
        && too_much([*width, *height], (*count).into())
    {
        return Ok(());
    }
    let mut answer = Vec::new();
    if let Err(error) = protocol::depth(data, &mut answer) {
        return refused(&error, &answer);
    }
    let Some(([count, width, height, bits], words)) = request else {
        return Err("a request without a header was answered".to_owned());
    };
    let grid = Grid::new(8, (128, 128)).map_err(|error| error.to_string())?;
    let mut expected: Vec<u32> = Vec::new();
    for corners in words.chunks_exact(9).take(count as usize) {
        let (mut xy, mut z) = ([[0; 2]; 3], [0; 3]);
        for ((xy, z), corner) in xy.iter_mut().zip(&mut z).zip(corners.chunks_exact(3)) {
            *xy = [0, 1].map(|axis| (corner[axis] as i32) << (8 - bits));
            *z = DepthSpec::D32.keep(corner[2]);
        }
        let start = expected.len();
        expected.resize(start + (width * height) as usize, u32::MAX);
        let Some(plane) = SpecifiedPlane::new(&xy, &z, grid, DepthSpec::D32) else { continue };
        cover_rows(&xy, grid, Rect { x0: 0, y0: 0, x1: width, y1: height }, |y, columns| {
            for x in columns {
                expected[start + (y * width + x) as usize] = plane.at(x, y);
            }
        });
    }
    let answer: Vec<u32> =
        answer.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
    holds(answer == expected, format_args!("TRIDEPTH: {answer:X?}, but the reference {expected:X?}"))
}
