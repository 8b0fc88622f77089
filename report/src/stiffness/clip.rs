//! Families of triangles through a matrix.

use super::{Family, Promise, Rung, Shapes};

const SIZE: (u32, u32) = (64, 64);

/// All families of clip-space triangles.
#[must_use]
pub fn families() -> Vec<Family> {
    vec![ratios(), near(), scales(), denormal(), distant()]
}

/// Window places in 1/4 px off the samples' rows and columns, in normalised device coordinates: exact.
fn place([x, y]: [i32; 2]) -> [f32; 2] {
    [(x * 4 + 1) as f32 / 128.0 - 1.0, 1.0 - (y * 4 + 1) as f32 / 128.0]
}

/// Triangles of about 20 px, in pixels.
const TRIANGLES: [[[i32; 2]; 3]; 6] = [
    [[2, 2], [30, 5], [7, 29]],
    [[33, 3], [61, 9], [40, 30]],
    [[3, 34], [29, 40], [6, 61]],
    [[34, 35], [60, 36], [45, 60]],
    [[12, 20], [52, 23], [30, 50]],
    [[20, 4], [44, 58], [8, 44]],
];

/// w is z, and the near plane is at 1: clip z is z - 1.
const PERSPECTIVE: [f32; 16] =
    [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -1.0, 0.0];

/// The triangles with these w at their corners, which corner has which going round.
fn with_w(w: [f32; 3]) -> Vec<[f32; 3]> {
    let mut positions = Vec::new();
    for (number, triangle) in TRIANGLES.iter().enumerate() {
        for (corner, &at) in triangle.iter().enumerate() {
            let [x, y] = place(at);
            let w = w[(corner + number) % 3];
            positions.push([x * w, y * w, w]);
        }
    }
    positions
}

fn family(
    [id, title, about]: [&'static str; 3],
    promise: Promise,
    exponents: impl Iterator<Item = i32>,
    shapes: impl Fn(i32) -> (Vec<[f32; 3]>, [f32; 16]),
) -> Family {
    let rung = |k| {
        let (positions, matrix) = shapes(k);
        Rung { k, size: SIZE, shapes: Shapes::Model { positions, matrix } }
    };
    Family { id, title, about, promise, rungs: exponents.map(rung).collect() }
}

fn power(k: i32) -> f32 {
    2f64.powi(k) as f32
}

fn ratios() -> Family {
    let words = ["w-ratios", "Ratios of w", "One corner 2^k times as far from the eye as another."];
    family(words, Promise::Samples, (0..=100).step_by(5), |k| {
        (with_w([2.0, 2.0 * power(k), 2.0 * power(k / 2)]), PERSPECTIVE)
    })
}

fn near() -> Family {
    let about = "One corner 2^-k before the near plane, one as much behind it, one far behind. The corners that the cut \
                 makes are snapped as all are.";
    family(["near-plane", "At the near plane", about], Promise::Measured, 1..=23, |k| {
        (with_w([1.0 - power(-k), 1.0 + power(-k), 8.0]), PERSPECTIVE)
    })
}

/// All clip coordinates times 2^k.
fn scaled(k: i32) -> (Vec<[f32; 3]>, [f32; 16]) {
    let positions = with_w([1.0; 3]).into_iter().map(|[x, y, _]| [x, y, 0.5]).collect();
    let mut matrix = [0.0; 16];
    (0..4).for_each(|diagonal| matrix[5 * diagonal] = power(k));
    (positions, matrix)
}

fn scales() -> Family {
    let about =
        "All clip coordinates times 2^k: x, y and z denormal at the one end, nearly infinite at the other.";
    let exponents = [-126, -110, -96, -64, -32, 0, 32, 64, 96, 110, 120, 126];
    family(["scales", "Tiny and huge", about], Promise::Samples, exponents.into_iter(), scaled)
}

fn denormal() -> Family {
    let about =
        "The same with a denormal w: nearer to the eye than 2^-126 counts as behind it, so nothing is drawn.";
    family(["denormal", "Denormal w", about], Promise::Measured, -134..=-127, scaled)
}

fn distant() -> Family {
    let about = "A model 2^k of its sizes away from its origin, and a camera there: what the floats of its vertices \
                 and of the product still hold.";
    family(["distant", "Far from the origin", about], Promise::Measured, 0..=20, |k| {
        let away = power(k);
        let positions = with_w([1.0; 3]).into_iter().map(|[x, y, _]| [x + away, y + away, 0.5]).collect();
        // No power of two: the product rounds.
        let scale = 0.9;
        let mut matrix = [0.0; 16];
        matrix[0] = scale;
        matrix[5] = scale;
        matrix[10] = 1.0;
        matrix[15] = 1.0;
        // The camera's place, as it would be computed: in f64, rounded once.
        matrix[12] = (-f64::from(scale) * f64::from(away)) as f32;
        matrix[13] = matrix[12];
        (positions, matrix)
    })
}
