//! glTF 2.0: every triangle primitive of the default scene, placed by its node's transform.
//!
//! Buffers are read here rather than by the crate's own iterators, because a file may promise more
//! elements than its buffers hold and that must be an error message.

use std::path::Path;

use glam::{DMat4, DVec3};
use gltf::accessor::{Accessor, DataType, Dimensions};
use gltf::buffer::{Data, View};
use gltf::json::Root;
use gltf::mesh::{Mode, Primitive};
use gltf::{Document, Gltf, Node, Semantic};

use crate::mesh::Mesh;

use super::{Problem, one_line};

/// Reads a whole file; `folder` is where buffers in files of their own are looked for.
pub(super) fn parse(bytes: &[u8], folder: Option<&Path>) -> Result<Mesh, Problem> {
    let malformed = |error: gltf::Error| Problem::Malformed {
        at: "not a well-formed glTF 2.0 file".to_owned(),
        expected: one_line(error),
    };
    check_length(bytes)?;
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(malformed)?;
    let root = document.into_json();
    check_attributes(&root)?;
    check_uris(&root)?;
    let document = Document::from_json(root).map_err(malformed)?;
    let buffers = gltf::import_buffers(&document, folder, blob).map_err(malformed)?;
    let mut reader = Reader {
        buffers,
        mesh: Mesh::plain(Vec::new(), Vec::new()),
        seen: vec![false; document.nodes().len()],
    };
    let Some(scene) = document.default_scene().or_else(|| document.scenes().next()) else {
        return Err(Problem::Empty);
    };
    for node in scene.nodes() {
        reader.walk(&node)?;
    }
    Ok(reader.mesh)
}

/// The length in a GLB header covers the header itself; the crate takes that for granted.
fn check_length(bytes: &[u8]) -> Result<(), Problem> {
    let Some(&[a, b, c, d]) = bytes.strip_prefix(b"glTF").and_then(|rest| rest.get(4..8)) else {
        return Ok(());
    };
    match u32::from_le_bytes([a, b, c, d]) {
        length @ ..12 => Err(Problem::Malformed {
            at: "the GLB header".to_owned(),
            expected: format!("its length is {length} bytes, it must be at least 12, the header's own"),
        }),
        _ => Ok(()),
    }
}

/// Attributes name accessors that exist; the crate's validation takes that for granted.
fn check_attributes(root: &Root) -> Result<(), Problem> {
    for (mesh, primitives) in root.meshes.iter().map(|mesh| &mesh.primitives).enumerate() {
        for (primitive, attributes) in primitives.iter().map(|primitive| &primitive.attributes).enumerate() {
            if let Some(at) = attributes.values().find(|at| at.value() >= root.accessors.len()) {
                return Err(Problem::Malformed {
                    at: format!("mesh {mesh} primitive {primitive}"),
                    expected: format!(
                        "accessor {} is not there, the file has {}",
                        at.value(),
                        root.accessors.len()
                    ),
                });
            }
        }
    }
    Ok(())
}

/// The names of buffers' files are UTF-8 without their percent-escapes; the crate takes that for granted.
fn check_uris(root: &Root) -> Result<(), Problem> {
    for (buffer, uri) in
        root.buffers.iter().map(|buffer| buffer.uri.as_deref().unwrap_or_default()).enumerate()
    {
        if !uri.contains(':') && urlencoding::decode(uri).is_err() {
            return Err(Problem::Malformed {
                at: format!("buffer {buffer}"),
                expected: "its URI has to be UTF-8 when percent-escapes are decoded".to_owned(),
            });
        }
    }
    Ok(())
}

struct Reader {
    buffers: Vec<Data>,
    mesh: Mesh,
    /// By node: a tree reaches each at most once.
    seen: Vec<bool>,
}

impl Reader {
    /// Adds a root node and all below it, without recursion: the depth is the file's choice.
    fn walk(&mut self, root: &Node<'_>) -> Result<(), Problem> {
        let mut open = vec![(root.clone(), DMat4::IDENTITY)];
        while let Some((node, parent)) = open.pop() {
            if std::mem::replace(&mut self.seen[node.index()], true) {
                return Err(Problem::Malformed {
                    at: format!("node {}", node.index()),
                    expected: "nodes form trees, each has at most one parent".to_owned(),
                });
            }
            let columns = node.transform().matrix().map(|column| column.map(f64::from));
            let place = parent * DMat4::from_cols_array_2d(&columns);
            if let Some(mesh) = node.mesh() {
                for primitive in mesh.primitives() {
                    let at = format!("mesh {} primitive {}", mesh.index(), primitive.index());
                    self.primitive(&primitive, &place, &at)?;
                }
            }
            open.extend(node.children().map(|child| (child, place)));
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Primitive<'_>, place: &DMat4, at: &str) -> Result<(), Problem> {
        if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            return Ok(());
        }
        let Some(accessor) = primitive.get(&Semantic::Positions) else {
            return Err(Problem::Malformed {
                at: at.to_owned(),
                expected: "a primitive needs the attribute POSITION".to_owned(),
            });
        };
        let points = self.positions(&accessor, at)?;
        let indices = match primitive.indices() {
            Some(accessor) => self.indices(&accessor, at)?,
            None => (0..points.len() as u32).collect(),
        };
        if let Some(&index) = indices.iter().find(|&&index| index as usize >= points.len()) {
            let (index, vertices) = (i64::from(index), points.len());
            return Err(Problem::Index { at: at.to_owned(), index, vertices });
        }
        let first = u32::try_from(self.mesh.positions.len()).ok();
        let too_large = || Problem::TooLarge { what: "vertices", count: 1 << 32 };
        for index in triangles(primitive.mode(), &indices, at)? {
            let index = first.and_then(|first| first.checked_add(index)).ok_or_else(too_large)?;
            self.mesh.indices.push(index);
        }
        self.mesh.positions.extend(
            points
                .iter()
                .map(|&point| place.transform_point3(DVec3::from(point.map(f64::from))).as_vec3().to_array()),
        );
        Ok(())
    }

    fn positions(&self, accessor: &Accessor<'_>, at: &str) -> Result<Vec<[f32; 3]>, Problem> {
        if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
            return Err(Problem::Malformed {
                at: format!("{at}, POSITION"),
                expected: "positions are three 32-bit floats".to_owned(),
            });
        }
        self.elements(accessor, 12, &format!("{at}, POSITION"))?
            .chunks_exact(12)
            .map(|b| {
                let point = [0, 4, 8].map(|k| f32::from_le_bytes([b[k], b[k + 1], b[k + 2], b[k + 3]]));
                if point.iter().all(|c| c.is_finite()) {
                    Ok(point)
                } else {
                    Err(super::not_finite(format!("a vertex of {at}"), point))
                }
            })
            .collect()
    }

    fn indices(&self, accessor: &Accessor<'_>, at: &str) -> Result<Vec<u32>, Problem> {
        let at = format!("{at}, indices");
        let size = match (accessor.data_type(), accessor.dimensions()) {
            (DataType::U8, Dimensions::Scalar) => 1,
            (DataType::U16, Dimensions::Scalar) => 2,
            (DataType::U32, Dimensions::Scalar) => 4,
            _ => {
                let expected = "indices are unsigned 8, 16 or 32-bit scalars".to_owned();
                return Err(Problem::Malformed { at, expected });
            }
        };
        Ok(integers(&self.elements(accessor, size, &at)?, size))
    }

    /// The elements of an accessor, `size` bytes each, one behind the other.
    fn elements(&self, accessor: &Accessor<'_>, size: usize, at: &str) -> Result<Vec<u8>, Problem> {
        let count = accessor.count();
        let mut elements = match accessor.view() {
            Some(view) => self.slice(&view, accessor.offset(), count, size, at)?,
            // No view: zeros, and as many as the file likes to promise; the sparse part names a few.
            None => {
                let largest = self.buffers.iter().map(|data| data.len()).sum::<usize>();
                if count > largest.max(1 << 16) {
                    return Err(Problem::TooLarge { what: "zero elements", count: count as u64 });
                }
                vec![0; count * size]
            }
        };
        let Some(sparse) = accessor.sparse() else {
            return Ok(elements);
        };
        let (places, values) = (sparse.indices(), sparse.values());
        let width = places.index_type().size();
        let at = format!("{at}, sparse");
        let targets = self.slice(&places.view(), places.offset(), sparse.count(), width, &at)?;
        let values = self.slice(&values.view(), values.offset(), sparse.count(), size, &at)?;
        for (target, value) in integers(&targets, width).into_iter().zip(values.chunks_exact(size)) {
            let start = target as usize * size;
            match elements.get_mut(start..start + size) {
                Some(element) => element.copy_from_slice(value),
                None => {
                    let (index, vertices) = (i64::from(target), count);
                    return Err(Problem::Index { at, index, vertices });
                }
            }
        }
        Ok(elements)
    }

    /// `count` elements of `size` bytes from `offset` bytes into a view.
    fn slice(
        &self,
        view: &View<'_>,
        offset: usize,
        count: usize,
        size: usize,
        at: &str,
    ) -> Result<Vec<u8>, Problem> {
        let stride = view.stride().unwrap_or(size);
        let wrong = |given: usize, needed: Option<usize>| Problem::Length {
            given: given as u64,
            needed: needed.map_or(u64::MAX, |needed| needed as u64),
            of: format!("the buffer behind {at}"),
        };
        if stride < size {
            return Err(Problem::Malformed {
                at: at.to_owned(),
                expected: format!("the stride is {stride}, it must be at least {size}"),
            });
        }
        let Some(last) = count.checked_sub(1) else {
            return Ok(Vec::new());
        };
        let length = last.checked_mul(stride).and_then(|n| n.checked_add(size));
        let needed = length.and_then(|n| n.checked_add(offset));
        if needed.is_none_or(|needed| needed > view.length()) {
            return Err(wrong(view.length(), needed));
        }
        let buffer = &self.buffers[view.buffer().index()];
        let end = view.offset().checked_add(view.length());
        let Some(bytes) = end.and_then(|end| buffer.get(view.offset()..end)) else {
            return Err(wrong(buffer.len(), end));
        };
        let bytes = &bytes[offset..];
        Ok(bytes.chunks(stride).take(count).flat_map(|element| &element[..size]).copied().collect())
    }
}

/// Little-endian unsigned integers of 1, 2 or 4 bytes.
fn integers(bytes: &[u8], size: usize) -> Vec<u32> {
    bytes
        .chunks_exact(size)
        .map(|b| b.iter().rev().fold(0, |value, &byte| value << 8 | u32::from(byte)))
        .collect()
}

/// The triangle list of a list, strip or fan, with the winding that glTF gives each.
fn triangles(mode: Mode, indices: &[u32], at: &str) -> Result<Vec<u32>, Problem> {
    let list = match mode {
        Mode::TriangleStrip => indices
            .windows(3)
            .enumerate()
            .flat_map(|(k, w)| if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] })
            .collect(),
        Mode::TriangleFan => match indices.split_first() {
            Some((&hub, rim)) => rim.windows(2).flat_map(|w| [w[0], w[1], hub]).collect(),
            None => Vec::new(),
        },
        _ => indices.to_vec(),
    };
    if list.len().is_multiple_of(3) {
        Ok(list)
    } else {
        Err(Problem::IndexCount { count: list.len(), of: at.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_that_leaves_no_room_for_its_header_is_an_error() {
        for length in 0..12 {
            let file = [b"glTF\x02\0\0\0".as_slice(), &[length, 0, 0, 0]].concat();
            assert!(matches!(parse(&file, None), Err(Problem::Malformed { .. })), "{length}");
        }
    }

    #[test]
    fn an_attribute_without_its_accessor_is_an_error() {
        let file =
            br#"{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]}"#;
        let Err(Problem::Malformed { at, .. }) = parse(file, None) else { panic!("not refused") };
        assert_eq!(at, "mesh 0 primitive 0");
    }

    #[test]
    fn a_name_that_is_not_utf_8_is_an_error() {
        let file = br#"{"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"%BA"}]}"#;
        let Err(Problem::Malformed { at, .. }) = parse(file, None) else { panic!("not refused") };
        assert_eq!(at, "buffer 0");
    }

    #[test]
    fn strips_and_fans_keep_their_winding() {
        let strip = triangles(Mode::TriangleStrip, &[0, 1, 2, 3], "").unwrap();
        assert_eq!(strip, [0, 1, 2, 1, 3, 2]);
        let fan = triangles(Mode::TriangleFan, &[0, 1, 2, 3], "").unwrap();
        assert_eq!(fan, [1, 2, 0, 2, 3, 0]);
        assert!(triangles(Mode::Triangles, &[0, 1], "").is_err());
    }

    #[test]
    fn integers_are_little_endian() {
        assert_eq!(integers(&[1, 2, 3, 4], 2), [0x0201, 0x0403]);
    }
}
