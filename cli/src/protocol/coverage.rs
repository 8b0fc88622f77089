//! TRIQUERY: which samples a triangle covers.
//!
//! ```text
//! stdin : "TRIQUERY", u32 n, u32 W, u32 H, u32 S, u32 subbits,
//!         S x (u32 ox, u32 oy)   sample position from the pixel's top-left corner, 1/256 px
//!         n x 6 x i32            x0 y0 x1 y1 x2 y2 in 2^-subbits px, y down
//! stdout: n x S x H x ceil(W/8) bytes: bit b of byte j of a row is pixel 8 j + b
//! ```
//!
//! Both windings are drawn. Up to 16 sub-pixel bits; more than 8 are snapped to 1/256 px, ties to even.

use std::io::{Read, Write};

use halfplane::{Mask, Region, Sample, Standard, Triangle, Vertex, traverse};

use super::input::{Input, write_error};
use super::{Problem, ProtocolError};

const NAME: &str = "TRIQUERY";

/// Answers one request. Nothing is written before all of it is known to be in order.
///
/// # Errors
///
/// [`ProtocolError`].
pub fn coverage(input: impl Read, mut output: impl Write) -> Result<(), ProtocolError> {
    let mut input = Input::open(input, NAME)?;
    let header = input.words(5, "header")?;
    let [count, width, height, samples, bits] = header[..] else {
        return Err(input.error(Problem::Magic));
    };
    let region = input.region(width, height)?;
    if samples == 0 {
        return Err(input.error(Problem::NoSamples));
    }
    if bits > 16 {
        return Err(input.error(Problem::Finer { bits, limit: 16 }));
    }
    let positions = input.words(2 * u64::from(samples), "sample positions")?;
    let samples = positions
        .chunks_exact(2)
        .enumerate()
        .map(|(at, position)| sample(&input, at, position[0], position[1]))
        .collect::<Result<Vec<_>, _>>()?;
    let corners = input.words(6 * u64::from(count), "triangles")?;
    let triangles = corners
        .chunks_exact(6)
        .enumerate()
        .map(|(at, c)| {
            let vertex = |k: usize| input.vertex((at, k), [c[2 * k], c[2 * k + 1]], 0, bits);
            Ok([vertex(0)?, vertex(1)?, vertex(2)?])
        })
        .collect::<Result<Vec<_>, _>>()?;

    let mut bitmap = Bitmap::new(region);
    for vertices in triangles {
        for &sample in &samples {
            bitmap.draw(vertices, sample);
            output.write_all(&bitmap.bytes).map_err(write_error(NAME))?;
        }
    }
    output.flush().map_err(write_error(NAME))
}

fn sample<R: Read>(input: &Input<R>, at: usize, x: u32, y: u32) -> Result<Sample<Standard>, ProtocolError> {
    let steps = |word: u32| i32::try_from(word).ok();
    steps(x)
        .zip(steps(y))
        .and_then(|(x, y)| Sample::new(x, y))
        .ok_or_else(|| input.error(Problem::Sample { at, x, y }))
}

/// One bit per pixel, rows from the top.
struct Bitmap {
    region: Region<Standard>,
    stride: usize,
    bytes: Vec<u8>,
}

impl Bitmap {
    fn new(region: Region<Standard>) -> Self {
        let stride = region.width().div_ceil(8) as usize;
        Self { region, stride, bytes: vec![0; stride * region.height() as usize] }
    }

    fn draw(&mut self, vertices: [Vertex<Standard>; 3], sample: Sample<Standard>) {
        self.bytes.fill(0);
        let Some(triangle) = Triangle::new(vertices, sample) else {
            return;
        };
        let Ok(bounds) = triangle.bounds(self.region) else {
            return;
        };
        let (stride, bytes) = (self.stride, &mut self.bytes);
        traverse(&triangle, bounds, |x, y, Mask(mask)| {
            // A block is half a byte wide and begins at its low or its high half.
            let (column, shift) = (x as usize / 8, x % 8);
            for row in 0..4 {
                let four = (mask >> (4 * row) & 0xF) as u8;
                if four != 0 {
                    bytes[(y as usize + row) * stride + column] |= four << shift;
                }
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(size: [u32; 2], bits: u32, samples: &[[u32; 2]], triangles: &[[i32; 6]]) -> Vec<u8> {
        let mut bytes = NAME.as_bytes().to_vec();
        let words = [triangles.len() as u32, size[0], size[1], samples.len() as u32, bits];
        let words = words.into_iter().chain(samples.iter().flatten().copied());
        bytes.extend(words.flat_map(u32::to_le_bytes));
        bytes.extend(triangles.iter().flatten().flat_map(|c| c.to_le_bytes()));
        bytes
    }

    fn answer(request: &[u8]) -> Result<Vec<u8>, u8> {
        let mut output = Vec::new();
        coverage(request, &mut output).map(|()| output).map_err(|error| error.exit_status())
    }

    #[test]
    fn a_right_triangle_in_both_windings_and_two_samples() {
        // The diagonal from (0, 4) to (4, 0) is a right edge: pixel centres on it are out, samples in
        // the top-left corner are in below it.
        let corner = [[128, 128], [0, 0]];
        let both = [[0, 0, 4, 0, 0, 4], [0, 0, 0, 4, 4, 0]];
        let expected = [[7u8, 3, 1, 0], [15, 7, 3, 1]].concat();
        let got = answer(&request([4, 4], 0, &corner, &both)).unwrap();
        assert_eq!(got, [expected.clone(), expected].concat());
    }

    #[test]
    fn rows_are_padded_to_bytes() {
        let whole = [[-100, -100, 200, -100, -100, 200]];
        assert_eq!(answer(&request([10, 2], 0, &[[128, 128]], &whole)).unwrap(), [255, 3, 255, 3]);
    }

    #[test]
    fn beyond_and_wrong() {
        let triangle = [[0, 0, 4, 0, 0, 4]];
        let good = request([4, 4], 8, &[[128, 128]], &triangle);
        assert!(answer(&good).is_ok());
        for end in 0..good.len() {
            assert_eq!(answer(&good[..end]), Err(2), "{end} bytes");
        }
        assert_eq!(answer(&request([0, 4], 8, &[[128, 128]], &triangle)), Err(2));
        assert_eq!(answer(&request([4, 16385], 8, &[[128, 128]], &triangle)), Err(2));
        assert_eq!(answer(&request([4, 4], 8, &[], &triangle)), Err(2));
        assert_eq!(answer(&request([4, 4], 17, &[[128, 128]], &triangle)), Err(77));
        assert_eq!(answer(&request([4, 4], 8, &[[256, 0]], &triangle)), Err(77));
        assert_eq!(answer(&request([4, 4], 0, &[[0, 0]], &[[0, 0, 32769, 0, 0, 4]])), Err(77));
        assert_eq!(answer(&request([4, 4], 8, &[[0, 0]], &[])), Ok(Vec::new()));
    }
}
