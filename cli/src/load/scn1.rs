//! SCN1, little endian: `"SCN1"`, u32 vertices, u32 indices, the positions as 3 x f32, the indices as
//! u32 (a triangle list).

use crate::mesh::Mesh;

use super::Problem;

const HEADER: usize = 12;

/// Reads a whole file.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, Problem> {
    let length = |needed, of: &str| Problem::Length { given: bytes.len() as u64, needed, of: of.to_owned() };
    let Some((header, body)) = bytes.split_at_checked(HEADER) else {
        return Err(length(HEADER as u64, "an SCN1 header"));
    };
    let header = words(header);
    let (vertices, indices) = (header[1], header[2]);
    let needed = HEADER as u64 + 12 * u64::from(vertices) + 4 * u64::from(indices);
    if bytes.len() as u64 != needed {
        return Err(length(needed, &format!("an SCN1 file of {vertices} vertices and {indices} indices")));
    }
    let (positions, triangles) = body.split_at(12 * vertices as usize);
    let positions = positions
        .chunks_exact(12)
        .map(|point| {
            let bits = words(point);
            [0, 1, 2].map(|k| f32::from_bits(bits[k]))
        })
        .collect();
    Ok(Mesh::plain(positions, words(triangles)))
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(vertices: &[[f32; 3]], indices: &[u32]) -> Vec<u8> {
        let mut bytes = b"SCN1".to_vec();
        bytes.extend((vertices.len() as u32).to_le_bytes());
        bytes.extend((indices.len() as u32).to_le_bytes());
        bytes.extend(vertices.iter().flatten().flat_map(|c| c.to_le_bytes()));
        bytes.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
        bytes
    }

    #[test]
    fn reads_back_what_was_written() {
        let vertices = [[0.5, -1.0, 2.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let mesh = parse(&file(&vertices, &[2, 0, 1])).unwrap();
        assert_eq!(mesh.positions, vertices);
        assert_eq!(mesh.indices, [2, 0, 1]);
    }

    #[test]
    fn a_length_that_disagrees_with_the_header_is_an_error() {
        let whole = file(&[[0.0; 3]; 3], &[0, 1, 2]);
        for wrong in [&whole[..5], &whole[..whole.len() - 1], &[whole.as_slice(), &[0]].concat()] {
            assert!(matches!(parse(wrong), Err(Problem::Length { .. })), "{} bytes", wrong.len());
        }
    }
}
