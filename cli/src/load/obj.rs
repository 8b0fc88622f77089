//! Wavefront OBJ: the positions and faces; materials, normals and texture coordinates are ignored.

use tobj::LoadOptions;

use crate::mesh::Mesh;

use super::{Problem, not_finite, one_line};

/// Reads a whole file.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, Problem> {
    // Names and comments may be in any encoding; what matters is ASCII.
    let text = String::from_utf8_lossy(bytes);
    let options =
        LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    // Colours come from the program's own clay: no material library is opened.
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let kept = positions_and_faces(&text)?;
    let mut reader = kept.as_bytes();
    let (models, _) = tobj::load_obj_buf(&mut reader, &options, no_materials)
        .map_err(|error| locate(&text).unwrap_or_else(|| malformed(error)))?;
    let (mut positions, mut indices) = (Vec::new(), Vec::new());
    for mesh in models.into_iter().map(|model| model.mesh) {
        let first = u32::try_from(positions.len()).ok();
        for index in mesh.indices {
            let index = first.and_then(|first| first.checked_add(index));
            indices.push(index.ok_or(Problem::TooLarge { what: "vertices", count: 1 << 32 })?);
        }
        positions.extend(mesh.positions.chunks_exact(3).map(|p| [p[0], p[1], p[2]]));
    }
    if positions.iter().flatten().all(|c: &f32| c.is_finite()) {
        return Ok(Mesh::plain(positions, indices));
    }
    // The general check finds it too, but only this one knows the line.
    locate(&text).map_or_else(|| Ok(Mesh::plain(positions, indices)), Err)
}

/// The lines that matter, corners with their vertex alone. The crate multiplies indices before it looks whether they
/// are in range, and indices of texture coordinates and normals as well: none that is wrong may come to it.
fn positions_and_faces(text: &str) -> Result<String, Problem> {
    let all = vertices(text);
    let mut so_far = 0;
    let mut kept = String::with_capacity(text.len());
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("f") => {
                kept.push('f');
                for corner in words {
                    if let Some(problem) = bad_corner(number, corner, so_far, all) {
                        // There may be another fault before it.
                        return Err(locate(text).unwrap_or(problem));
                    }
                    kept.push(' ');
                    kept.push_str(vertex_of(corner));
                }
            }
            Some(word @ ("v" | "o" | "g" | "usemtl")) => {
                so_far += usize::from(word == "v");
                kept.push_str(line);
            }
            _ => {}
        }
        kept.push('\n');
    }
    Ok(kept)
}

fn malformed(error: tobj::LoadError) -> Problem {
    Problem::Malformed { at: "not a well-formed OBJ file".to_owned(), expected: one_line(error) }
}

/// The line of the first `v` that is not three finite numbers or `f` that names a vertex which is
/// not there, for the error message; `None` where the fault is of another kind.
fn locate(text: &str) -> Option<Problem> {
    let all = vertices(text);
    let mut so_far = 0;
    for (number, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        let problem = match words.next() {
            Some("v") => {
                so_far += 1;
                bad_vertex(format!("line {}", number + 1), line, words)
            }
            Some("f") => words.find_map(|corner| bad_corner(number, corner, so_far, all)),
            _ => None,
        };
        if problem.is_some() {
            return problem;
        }
    }
    None
}

/// How many vertices there are.
fn vertices(text: &str) -> usize {
    text.lines().filter(|line| line.split_whitespace().next() == Some("v")).count()
}

/// A corner's vertex, without its texture coordinate and normal.
fn vertex_of(corner: &str) -> &str {
    corner.split('/').next().unwrap_or(corner)
}

fn bad_vertex<'a>(at: String, line: &str, words: impl Iterator<Item = &'a str>) -> Option<Problem> {
    let numbers: Option<Vec<f32>> = words.take(3).map(|word| word.parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) if [x, y, z].iter().all(|c| c.is_finite()) => None,
        Some(&[x, y, z]) => Some(not_finite(at, [x, y, z])),
        _ => Some(Problem::Malformed {
            at: format!("{at}, \"{}\"", one_line(line)),
            expected: "a vertex is \"v\" and three numbers".to_owned(),
        }),
    }
}

/// Indices count from 1, or back from the last vertex so far when negative.
fn bad_corner(number: usize, corner: &str, so_far: usize, all: usize) -> Option<Problem> {
    let at = || format!("line {}", number + 1);
    let Ok(index) = vertex_of(corner).parse::<i64>() else {
        return Some(Problem::Malformed {
            at: format!("{}, \"{}\"", at(), one_line(corner)),
            expected: "a face's corner is a vertex number, or vertex/texture/normal".to_owned(),
        });
    };
    let right = if index < 0 {
        index.unsigned_abs() <= so_far as u64
    } else {
        index > 0 && index.unsigned_abs() <= all as u64
    };
    (!right).then(|| Problem::Index { at: at(), index, vertices: all })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_become_triangles_and_negative_indices_count_back() {
        let mesh = parse(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n").unwrap();
        assert_eq!((mesh.positions.len(), mesh.triangles()), (4, 2));
    }

    #[test]
    fn texture_coordinates_and_normals_do_not_matter() {
        let mesh = parse(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn x\nf 1/1/1 2/1/1 3/-3\np 1\n").unwrap();
        assert_eq!((mesh.positions.len(), mesh.triangles()), (3, 1));
    }

    #[test]
    fn indices_beyond_all_numbers_are_told() {
        let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9223372036854775807\n";
        assert!(format!("{:?}", parse(text).unwrap_err()).contains("line 4"));
    }

    #[test]
    fn faults_are_located_by_line() {
        let cases: [(&[u8], &str); 4] = [
            (b"v 0 0 0\nv 1 x 0\n", "line 2"),
            (b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n", "line 4"),
            (b"v 0 0 0\nv 1 0 0\nv 1 1 0\n\nf 1 2 0\n", "line 5"),
            (b"v 0 0 0\nv 1 nan 0\nv 1 1 0\nf 1 2 3\n", "line 2"),
        ];
        for (text, line) in cases {
            let problem = parse(text).unwrap_err();
            assert!(format!("{problem:?}").contains(line), "{problem:?}");
        }
    }
}
