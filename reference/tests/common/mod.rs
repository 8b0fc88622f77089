//! What the property tests share: run sizes, and triangles by kind, the hard kinds on purpose.
#![allow(dead_code, unreachable_pub)] // every test file uses its own part

use halfplane_reference::{Grid, Point, Rational, Rect};
use num_integer::Integer;
use proptest::prelude::*;
use proptest::test_runner::Config;

/// How many cases each property is tried on.
pub fn cases(count: u32) -> Config {
    Config { cases: count, failure_persistence: None, ..Config::default() }
}

/// A triangle in sub-pixel steps.
pub type Steps = [[i32; 2]; 3];

/// A triangle, its grid and a rectangle of pixels that it probably reaches.
#[derive(Clone, Debug)]
pub struct Case {
    pub xy: Steps,
    pub grid: Grid,
    pub rect: Rect,
}

impl Case {
    /// Every pixel of the rectangle.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let rect = self.rect;
        (rect.y0..rect.y1).flat_map(move |y| (rect.x0..rect.x1).map(move |x| (x, y)))
    }
}

pub fn integer(value: i64) -> Rational {
    Rational::from_integer(value.into())
}

/// A triangle's corners for the definitions, in steps.
pub fn corners(xy: &Steps) -> [Point; 3] {
    xy.map(|[x, y]| Point::from_integers(x.into(), y.into()))
}

/// A pixel's sample for the definitions, in steps.
pub fn sample(grid: Grid, (x, y): (u32, u32)) -> Point {
    let (x, y) = grid.sample_at(x, y);
    Point::from_integers(x, y)
}

/// Any grid: 0 to 8 sub-pixel bits, a sample anywhere in its pixel, half of them at the centre.
pub fn grids() -> impl Strategy<Value = Grid> {
    (0..=8_u32, any::<u32>(), any::<u32>(), any::<bool>()).prop_map(|(bits, x, y, centre)| {
        let last = (1 << bits) - 1;
        let middle = (1 << bits) / 2;
        let sample = if centre { (middle, middle) } else { (x & last, y & last) };
        Grid::new(bits, sample).expect("in its pixel")
    })
}

/// Triangles of every kind with coordinates up to 2^23 steps, on any grid.
pub fn any_case() -> impl Strategy<Value = Case> {
    (grids(), steps(), any::<[u32; 3]>()).prop_map(|(grid, kind, [turn, column, row])| {
        let mut xy = kind.place(grid);
        xy.rotate_left(turn as usize % 3);
        if turn & 4 != 0 {
            xy.swap(0, 1);
        }
        let rect = rect_at(&xy, grid, column, row);
        Case { xy, grid, rect }
    })
}

/// Up to 14 x 14 pixels about a point in the triangle's bounding box.
fn rect_at(xy: &Steps, grid: Grid, column: u32, row: u32) -> Rect {
    let range = |axis: usize, pick: u32| {
        let values = xy.map(|corner| i64::from(corner[axis]));
        let (low, high) = (values.iter().min().unwrap(), values.iter().max().unwrap());
        // Half of them at a corner, where the hard samples are.
        let inside = if pick.is_multiple_of(2) {
            values[(pick / 2 % 3) as usize]
        } else {
            low + i64::from(pick / 2) % (high - low + 1)
        };
        let pixel = (inside >> grid.subpixel_bits()).clamp(0, 1 << 16) as u32;
        (pixel.saturating_sub(7), pixel + 7)
    };
    let ((x0, x1), (y0, y1)) = (range(0, column), range(1, row));
    Rect { x0, y0, x1, y1 }
}

/// A triangle before it is placed on a grid.
#[derive(Clone, Debug)]
pub enum Kind {
    /// As it is.
    Free(Steps),
    /// Corners on the samples of these pixels.
    OnSamples([[u8; 2]; 3]),
    /// Doubled area 1 or 2, an edge through a pixel's sample (at its end or in its middle).
    Needle { pixel: [u8; 2], direction: [i32; 2], half_way: bool, far: i32, flip: bool },
    /// All corners on one line.
    Collinear { start: [i32; 2], direction: [i32; 2], at: [i16; 3] },
    /// Two sides along the axes.
    AxisAligned { corner: [i32; 2], size: [i32; 2] },
}

fn coordinate(limit: i32) -> impl Strategy<Value = i32> {
    -limit..=limit
}

/// All kinds.
fn steps() -> impl Strategy<Value = Kind> {
    let free = |limit| prop::array::uniform3(prop::array::uniform2(coordinate(limit))).prop_map(Kind::Free);
    prop_oneof![
        2 => free(24),
        2 => free(2_000),
        2 => free(1 << 23),
        2 => thin(),
        2 => prop::array::uniform3(prop::array::uniform2(0..12_u8)).prop_map(Kind::OnSamples),
        4 => needle(),
        1 => (prop::array::uniform2(0..4_000), prop::array::uniform2(-300..300), any::<[i16; 3]>())
            .prop_map(|(start, direction, at)| Kind::Collinear { start, direction, at: at.map(|at| at / 8) }),
        1 => (prop::array::uniform2(0..4_000), prop::array::uniform2(-3_000..3_000))
            .prop_map(|(corner, size)| Kind::AxisAligned { corner, size }),
    ]
}

/// A long edge and a third corner a few steps from one of its points.
fn thin() -> impl Strategy<Value = Kind> {
    let ends = prop::array::uniform2(prop::array::uniform2(coordinate(1 << 23)));
    (ends, 0.0..=1.0, prop::array::uniform2(-3..=3_i32)).prop_map(|([a, b], along, near)| {
        let between = |axis: usize| -> i32 {
            let point = f64::from(a[axis]) + along * (f64::from(b[axis]) - f64::from(a[axis]));
            (point as i32 + near[axis]).clamp(-(1 << 23), 1 << 23)
        };
        Kind::Free([a, b, [between(0), between(1)]])
    })
}

fn needle() -> impl Strategy<Value = Kind> {
    let direction =
        prop_oneof![prop::array::uniform2(coordinate(40)), prop::array::uniform2(coordinate(1 << 20)),];
    (prop::array::uniform2(2..60_u8), direction, any::<bool>(), -2..2, any::<bool>()).prop_map(
        |(pixel, direction, half_way, far, flip)| Kind::Needle { pixel, direction, half_way, far, flip },
    )
}

impl Kind {
    fn place(&self, grid: Grid) -> Steps {
        let on_sample = |[x, y]: [u8; 2]| {
            let (x, y) = grid.sample_at(x.into(), y.into());
            [x as i32, y as i32]
        };
        match *self {
            Kind::Free(xy) => xy,
            Kind::OnSamples(pixels) => pixels.map(on_sample),
            Kind::Collinear { start, direction, at } => {
                at.map(|at| [0, 1].map(|axis| start[axis] + direction[axis] * i32::from(at)))
            }
            Kind::AxisAligned { corner: [x, y], size: [width, height] } => {
                [[x, y], [x + width, y], [x, y + height]]
            }
            Kind::Needle { pixel, direction: [x, y], half_way, far, flip } => {
                let through = on_sample(pixel);
                let bezout = i64::from(x).extended_gcd(&i64::from(y));
                if bezout.gcd == 0 {
                    return [through; 3];
                }
                // d and v with cross product 1: v = (-s, r) where r d.x + s d.y = 1.
                let d = [i64::from(x) / bezout.gcd, i64::from(y) / bezout.gcd];
                let v = [-bezout.y + d[0] * i64::from(far), bezout.x + d[1] * i64::from(far)];
                let sign = if flip { -1 } else { 1 };
                let at = |along: i64, beside: i64| {
                    [0, 1].map(|axis| (i64::from(through[axis]) + along * d[axis] + beside * v[axis]) as i32)
                };
                [at(if half_way { -1 } else { 0 }, 0), at(1, 0), at(0, sign)]
            }
        }
    }
}
