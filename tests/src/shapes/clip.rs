//! Clip-space triangles and meshes.

use super::{Mesh, Random, grid, numbers::pick, triangulation};

/// Floats that have gone wrong before: zeros, denormals, powers of two, the largest, infinities, NaN.
const SPECIAL: [f32; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    1e-45,
    -1e-45,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    16_777_216.0,
    1e30,
    -1e30,
    1e-30,
    0.999_999_94,
];

/// A triangle of any bit patterns: special values, arbitrary bits and ordinary numbers mixed.
pub fn clip_bits(numbers: [u32; 13]) -> [[f32; 4]; 3] {
    let [.., kind] = numbers;
    let value = |k: usize| {
        let number = numbers[k];
        match (kind >> (2 * k)) & 3 {
            0 => f32::from_bits(number),
            1 => SPECIAL[number as usize % SPECIAL.len()],
            2 => pick(number, -300, 300) as f32 / 100.0,
            // w of a vertex: ordinary more often than not, or hardly any triangle is visible.
            _ if k % 4 == 3 => 1.0,
            _ => pick(number, -1000, 1000) as f32 / 1000.0,
        }
    };
    [0, 4, 8].map(|k| [value(k), value(k + 1), value(k + 2), value(k + 3)])
}

/// z of a whole-numbered vertex: the near plane cuts at `w = near`, the far plane at `w = 2 near` where
/// `steep` is 2 and nowhere where it is 1.
fn depth(w: i64, near: i64, steep: i64) -> f32 {
    (steep * (w - near)) as f32
}

/// A triangle of whole numbers about the view frustum; it can cross any plane.
pub fn clip_triangle(numbers: [u32; 10]) -> [[f32; 4]; 3] {
    let [.., kind] = numbers;
    let near = pick(kind / 8, 1, [1, 5, 30, 200][kind as usize / 2 % 4]);
    let steep = 1 + i64::from(kind % 2);
    let vertex = |k: usize| {
        let w = pick(numbers[k + 2] / 2, -200, 600) / [1, 20][numbers[k + 2] as usize % 2];
        // Mostly about the screen, sometimes far beyond the guard band.
        let reach = 600 << [0, 0, 1, 3, 6][numbers[k] as usize % 5];
        let (x, y) = (pick(numbers[k] / 5, -reach, reach), pick(numbers[k + 1], -reach, reach));
        [x as f32, y as f32, depth(w, near, steep), w as f32]
    };
    [vertex(0), vertex(3), vertex(6)]
}

/// Fine units on a side of a [`Ground`].
const SIDE: i32 = 512;

/// A mesh that lies in one plane of clip space, with whole-numbered vertices that floats hold
/// exactly: whatever the near plane and the guard band do to it, inside it has no seam.
#[derive(Clone, Debug)]
pub struct Ground {
    /// Clip-space vertices.
    pub vertices: Vec<[f32; 4]>,
    /// Triangles, all of one orientation in the plane.
    pub triangles: Vec<[u32; 3]>,
    /// The corners of the plane's piece, in order round it.
    pub corners: [[f32; 4]; 4],
}

impl Ground {
    /// A plane and a mesh in it, chosen by any numbers; cells of many pixels down to slivers.
    pub fn from_numbers(numbers: [u32; 12], seed: u64) -> Self {
        let mut random = Random(seed);
        let [ox, oy, ow, ux, uy, uw, vx, vy, vw, near, kind, count] = numbers;
        let (near, steep) = (pick(near / 2, 1, 2000), 1 + i64::from(near % 2));
        let origin = [pick(ox, -9000, 9000), pick(oy, -9000, 9000), pick(ow, -9000, 9000)];
        let u = [pick(ux, -40, 40), pick(uy, -40, 40), pick(uw, -40, 40)];
        let v = [pick(vx, -40, 40), pick(vy, -40, 40), pick(vw, -40, 40)];
        let outline = [0, 0, SIDE, SIDE];
        let Mesh { xy, triangles, .. } = if kind % 2 == 0 {
            grid(outline, 1 + count % 10, 1 + count / 10 % 10, &mut random)
        } else {
            let points: Vec<_> = (0..count % 40)
                .map(|_| [0, 0].map(|_: i32| random.between(0, i64::from(SIDE)) as i32))
                .collect();
            triangulation(outline, &points)
        };
        let at = |[i, j]: [i32; 2]| {
            // Below 9000 + 2 x 512 x 40 < 2^16, z below 2^18: exact.
            let [x, y, w] = [0, 1, 2].map(|k| origin[k] + i64::from(i) * u[k] + i64::from(j) * v[k]);
            [x as f32, y as f32, depth(w, near, steep), w as f32]
        };
        Self {
            vertices: xy.into_iter().map(at).collect(),
            triangles,
            corners: [[0, 0], [SIDE, 0], [SIDE, SIDE], [0, SIDE]].map(at),
        }
    }
}
