//! TRIDEPTH: the depth of every pixel of a triangle.
//!
//! ```text
//! stdin : "TRIDEPTH", u32 n, u32 W, u32 H, u32 subbits (at most 8),
//!         n x 3 x (i32 x, i32 y in 2^-subbits px, y down; u32 z)
//! stdout: n x H x W x u32: the depth where the triangle, alone, covers the pixel's centre,
//!         0xFFFFFFFF elsewhere
//! ```
//!
//! Both windings are drawn.

use std::io::{Read, Write};

use halfplane::{Compare, Depth, DepthTest, Standard, State, draw, texels};

use super::input::{Input, write_error};
use super::{Problem, ProtocolError};

const NAME: &str = "TRIDEPTH";

/// Answers one request. Nothing is written before all of it is known to be in order.
///
/// # Errors
///
/// [`ProtocolError`].
pub fn depth(input: impl Read, mut output: impl Write) -> Result<(), ProtocolError> {
    let mut input = Input::open(input, NAME)?;
    let header = input.words(4, "header")?;
    let [count, width, height, bits] = header[..] else {
        return Err(input.error(Problem::Magic));
    };
    let region = input.region(width, height)?;
    if bits > 8 {
        return Err(input.error(Problem::SubpixelBits(bits)));
    }
    let corners = input.words(9 * u64::from(count), "triangles")?;
    let triangles = corners
        .chunks_exact(9)
        .enumerate()
        .map(|(at, c)| {
            let vertex = |k: usize| input.vertex((at, k), [c[3 * k], c[3 * k + 1]], c[3 * k + 2], bits);
            Ok([vertex(0)?, vertex(1)?, vertex(2)?])
        })
        .collect::<Result<Vec<_>, _>>()?;

    let test = DepthTest { compare: Compare::Always, write: true };
    let mut storage = vec![0; texels(width, height)];
    let mut target =
        Depth::<Standard>::new(region, &mut storage, test).expect("the storage was made for the region");
    let mut rows = vec![0; width as usize * height as usize];
    let mut bytes = Vec::with_capacity(4 * rows.len());
    for vertices in triangles {
        target.clear(u32::MAX);
        draw(&vertices[..], &[0u16, 1, 2], 0, &State::new(region), &mut target)
            .expect("three vertices, three indices, and a target of the region's size");
        target.to_linear(&mut rows).expect("as many texels as the region has");
        bytes.clear();
        bytes.extend(rows.iter().flat_map(|depth| depth.to_le_bytes()));
        output.write_all(&bytes).map_err(write_error(NAME))?;
    }
    output.flush().map_err(write_error(NAME))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(size: [u32; 2], bits: u32, triangles: &[[[i64; 3]; 3]]) -> Vec<u8> {
        let mut bytes = NAME.as_bytes().to_vec();
        let header = [triangles.len() as u32, size[0], size[1], bits];
        bytes.extend(header.into_iter().flat_map(u32::to_le_bytes));
        let words = triangles.iter().flatten().flatten();
        bytes.extend(words.flat_map(|&word| (word as u32).to_le_bytes()));
        bytes
    }

    fn answer(request: &[u8]) -> Result<Vec<u32>, u8> {
        let mut output = Vec::new();
        depth(request, &mut output).map_err(|error| error.exit_status())?;
        Ok(output.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
    }

    #[test]
    fn a_slope_of_whole_numbers_is_exact_in_both_windings() {
        const NONE: u32 = u32::MAX;
        // z = 1000 + 100 x + 10 y at pixel corners; at centres half of each more.
        let front = [[0, 0, 1000], [4, 0, 1400], [0, 4, 1040]];
        let back = [front[0], front[2], front[1]];
        let expected =
            [1055, 1155, 1255, NONE, 1065, 1165, NONE, NONE, 1075, NONE, NONE, NONE, NONE, NONE, NONE, NONE];
        let got = answer(&request([4, 4], 0, &[front, back, [front[0]; 3]])).unwrap();
        assert_eq!(got, [expected, expected, [NONE; 16]].concat());
    }

    #[test]
    fn beyond_and_wrong() {
        let triangle = [[[0, 0, 5], [8, 0, 5], [0, 8, 5]]];
        let good = request([2, 2], 2, &triangle);
        assert_eq!(answer(&good).unwrap(), [5, u32::MAX, u32::MAX, u32::MAX]);
        for end in 0..good.len() {
            assert_eq!(answer(&good[..end]), Err(2), "{end} bytes");
        }
        assert_eq!(answer(&request([2, 0], 2, &triangle)), Err(2));
        assert_eq!(answer(&request([16385, 1], 2, &triangle)), Err(2));
        assert_eq!(answer(&request([2, 2], 9, &triangle)), Err(2));
        assert_eq!(answer(&request([2, 2], 0, &[[[40_000, 0, 5], [8, 0, 5], [0, 8, 5]]])), Err(77));
    }
}
