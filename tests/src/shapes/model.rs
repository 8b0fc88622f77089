//! Object-space meshes whose snapped window positions are chosen.

use super::{Corners, ORDERS, Random, clip_bits, numbers::pick};
use crate::Frame;

/// Extents from here on take another path through the vector code, in steps.
pub const LARGE_EXTENT: i64 = 120 * 256;

/// How corners get to clip space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// w = 1: the snapped positions are the wanted ones, where the viewport's sides are powers of two.
    Flat,
    /// The same, but moved by half a step, and by the next floats to that.
    HalfSteps,
    /// All of clip space times one factor, of any magnitude.
    Scaled,
    /// Each vertex has its own w; some are before the near or beyond the far plane, or behind the eye.
    Perspective,
    /// A matrix near a shear and a translation with all entries in use: the order of additions shows.
    Skewed,
    /// Any bits.
    Bits,
}

impl Projection {
    /// All projections.
    pub const ALL: [Self; 6] =
        [Self::Flat, Self::HalfSteps, Self::Scaled, Self::Perspective, Self::Skewed, Self::Bits];
}

/// Vertices, three for each triangle, and the matrix that takes them to clip space.
#[derive(Clone, Debug)]
pub struct Model {
    /// Object-space positions.
    pub vertices: Vec<[f32; 3]>,
    /// Rows, for row vectors.
    pub matrix: [[f32; 4]; 4],
}

const IDENTITY: [[f32; 4]; 4] = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];

/// Factors of [`Projection::Scaled`] at which something changes.
const FACTORS: [f32; 12] = [
    1e30,
    1.000_000_1e30,
    9.999_999e29,
    f32::MIN_POSITIVE,
    1.175_494_2e-38,
    1e-38,
    1e-45,
    1e38,
    3e38,
    f32::MAX,
    f32::INFINITY,
    -1.0,
];

/// Vertices that appear at those corners of the window (in steps), with those depths (in units of
/// 2^-32), seen through `[x0, y0, x1, y1]`.
pub fn model(
    projection: Projection,
    [x0, y0, x1, y1]: [u32; 4],
    triangles: &[(Corners, [u32; 3])],
    numbers: [u32; 4],
) -> Model {
    let half = |v: u32| f64::from(v) / 2.0;
    let (half_width, half_height) = (half(x1 - x0), half(y1 - y0));
    let (center_x, center_y) = (half(x0 + x1), half(y0 + y1));
    let [a, b, c, d] = numbers;
    let mut random = Random(u64::from(a) << 32 | u64::from(b));
    let mut matrix = IDENTITY;
    // What x and y grow by for z, and at z = 0.
    let [mut shear, mut shift] = [[0.0; 2]; 2];
    match projection {
        Projection::Flat | Projection::HalfSteps => {}
        Projection::Scaled => {
            let factor = match d % 3 {
                0 => FACTORS[c as usize % FACTORS.len()],
                1 => 2f32.powi(pick(c, -127, 127) as i32),
                // Any positive float.
                _ => f32::from_bits(c % 0x7F80_0000),
            };
            matrix = IDENTITY.map(|row| row.map(|v| v * factor));
            if factor.is_infinite() {
                matrix = IDENTITY;
                matrix[3][3] = factor;
            }
        }
        Projection::Perspective => {
            let near = pick(c, 0, 64) as f32 / 16.0;
            matrix[2] = [0.0, 0.0, [1.0, 0.5, 2.0][d as usize % 3], 1.0];
            matrix[3] = [0.0, 0.0, -near, 0.0];
        }
        Projection::Skewed => {
            for entry in matrix.as_flattened_mut() {
                *entry += random.between(-1000, 1000) as f32 / (1 << (d % 20)) as f32 / 1000.0;
            }
            [shear, shift] =
                [[0; 2]; 2].map(|pair| pair.map(|_: i32| random.between(-999, 999) as f32 / 999.0));
            for axis in 0..2 {
                matrix[2][axis] += shear[axis];
                matrix[3][axis] += shift[axis];
            }
        }
        Projection::Bits => {
            // w is constant, or any of the others.
            if let Some(row) = matrix.get_mut(c as usize % 4)
                && c % 4 != 3
            {
                row[3] = 1.0;
            }
        }
    }
    let mut vertices = Vec::new();
    for (corners, z) in triangles {
        let bits = clip_bits(random.words());
        for ((&[x, y], &z), bits) in corners.iter().zip(z).zip(bits) {
            let nudge = |random: &mut Random| match projection {
                Projection::HalfSteps => random.between(-1, 1) as f64 / 2.0,
                _ => 0.0,
            };
            let x = ((f64::from(x) + nudge(&mut random)) / 256.0 - center_x) / half_width;
            let y = (center_y - (f64::from(y) + nudge(&mut random)) / 256.0) / half_height;
            let z = (f64::from(z) / f64::from(u32::MAX)) as f32;
            let [mut x, mut y] = [x as f32 - shear[0] * z - shift[0], y as f32 - shear[1] * z - shift[1]];
            vertices.push(match projection {
                Projection::Perspective => {
                    let w = random.between(-40, 600) as f32 / 16.0;
                    [x * w, y * w, w]
                }
                Projection::Bits => [bits[0], bits[1], bits[2]],
                Projection::HalfSteps => {
                    match random.below(3) {
                        0 => {}
                        1 => (x, y) = (x.next_up(), y.next_down()),
                        _ => (x, y) = (x.next_down(), y.next_up()),
                    }
                    [x, y, z]
                }
                _ => [x, y, z],
            });
        }
    }
    Model { vertices, matrix }
}

/// A triangle whose extent is a step below, at, or a step above [`LARGE_EXTENT`], in x, in y or in both.
pub fn at_the_limit(frame: &Frame, numbers: [u32; 8]) -> Corners {
    let [a, b, c, d, e, f, g, h] = numbers;
    let [x0, y0, x1, y1] = frame.scissor.map(|v| i64::from(v) * 256);
    let extent = |number: u32| LARGE_EXTENT + pick(number, -1, 1);
    let (width, height) = match a % 3 {
        0 => (extent(b), pick(c, 0, LARGE_EXTENT - 1)),
        1 => (pick(c, 0, LARGE_EXTENT - 1), extent(b)),
        _ => (extent(b), extent(c)),
    };
    let left = pick(d, x0 - width, x1);
    let top = pick(e, y0 - height, y1);
    let (x, y) = (left + pick(f, 0, width), top + pick(g, 0, height));
    // Two corners of the bounds and a point between, or one on each of three sides.
    let corners = match h % 4 {
        0 => [[left, top], [left + width, top + height], [x, y]],
        1 => [[left + width, top], [left, top + height], [x, y]],
        2 => [[left, y], [left + width, top], [x, top + height]],
        _ => [[left, top], [left + width, y], [x, top + height]],
    };
    let order = ORDERS[h as usize / 4 % 6];
    super::bezout::clamped::<halfplane::Standard>(order.map(|k| corners[k]))
}
