//! The transform: a snapped vertex against the exact rational position.

use crate::{Failure, ensure, ensure_eq, failure::Verdict};
use halfplane::{
    Assembly, Bounds, ClipPositions, Format, ModelPositions, Positions, Region, Vertex, Viewport,
};
use halfplane_reference::{Rational, from_f32, from_steps, to_window};
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

/// How far a projected vertex was from the exact one: in steps (x or y, the larger) and in units of
/// 2^-32 (depth).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distance {
    /// Steps, half a step of which is the snapping's.
    pub steps: f64,
    /// Units of 2^-32.
    pub depth: f64,
}

impl Distance {
    /// The larger of each.
    pub fn max(self, other: Self) -> Self {
        Self { steps: self.steps.max(other.steps), depth: self.depth.max(other.depth) }
    }
}

/// A vertex inside the guard band is snapped to within half a step plus the float error of the exact
/// position; its depth is within half a unit plus the float error of z/w.
///
/// The float error from first principles. With u = 2^-24 every operation gives its exact result times
/// 1 + e, abs e <= u, while nothing underflows:
/// * X = c + (x/w) h, c and h exact: the product has relative error at most 2u + u², the sum u more:
///   `abs error <= ((2u + u²) abs(X - c)) (1 + u) + u abs X`, X exact;
/// * z/w has relative error u;
/// * a quotient below 2^-126 loses at most 2^-150 absolutely; h <= 2^13 makes that 2^-137 px.
///
/// For a target of 1280 pixels X is at most 1280 and abs(X - c) 640 on screen: 2560 x 2^-24 px, which is
/// 0.039 steps of 2^-8 px; at 16384 pixels half a step.
pub fn snapped_is_near_exact<F: Format>(
    vertex: [f32; 4],
    [x0, y0, x1, y1]: [u32; 4],
) -> Result<Option<Distance>, Failure> {
    let viewport = Viewport::new(Region::<F>::new(x0, y0, x1, y1)?);
    let Some(exact) = vertex.map(from_f32).into_iter().collect::<Option<Vec<_>>>() else {
        ensure!(viewport.project(vertex).is_none_or(|_| true), "not finite");
        return Ok(None);
    };
    let exact: [Rational; 4] = exact.try_into().map_err(|_| Failure::new("four components"))?;
    let (width, height) = (x1 - x0, y1 - y0);
    let place = halfplane_reference::Viewport { x: x0.into(), y: y0.into(), width, height };
    let Some(window) = to_window(&exact, place) else { return Ok(None) };
    let limit = whole(Bounds::<F>::CLIP_PIXELS.into());
    let (x, y) = (&window.position.x, &window.position.y);
    let one = whole(1);
    if x.abs() > limit || y.abs() > limit || window.z < whole(0) || window.z > one {
        return Ok(None);
    }
    let snapped = viewport.project(vertex).ok_or_else(|| Failure::new("an ordinary vertex is refused"))?;

    let unit = Rational::new(BigInt::from(1), BigInt::from(1) << 24);
    let tiny = Rational::new(BigInt::from(1), BigInt::from(1) << 137);
    let half_step = from_steps(1, F::SUBPIXEL_BITS + 1);
    let mut distance = Distance::default();
    for (axis, given, exact, center) in [
        ("x", snapped.x(), x, Rational::new((x0 + x1).into(), 2.into())),
        ("y", snapped.y(), y, Rational::new((y0 + y1).into(), 2.into())),
    ] {
        let product = (&whole(2) * &unit + &unit * &unit) * (exact - &center).abs();
        let bound = &half_step + product * (&one + &unit) + &unit * exact.abs() + &tiny;
        let error = (from_steps(given.into(), F::SUBPIXEL_BITS) - exact).abs();
        ensure!(error <= bound, "{axis} of {vertex:?} is {given} steps, exact {exact} px");
        let steps = (error * whole(i64::from(Bounds::<F>::STEPS_PER_PIXEL))).to_f64();
        distance.steps = distance.steps.max(steps.unwrap_or(f64::INFINITY));
    }
    // Kept within [2, 2^32 - 3] afterwards: two units more at the ends.
    let scaled = &window.z * whole(i64::from(u32::MAX));
    let kept = scaled.clone().clamp(whole(2), whole(i64::from(u32::MAX - 2)));
    let error = (Rational::from_integer(snapped.z().into()) - kept).abs();
    let bound = Rational::new(1.into(), 2.into()) + scaled * unit + tiny;
    ensure!(error <= bound, "depth of {vertex:?} is {}, exact {}", snapped.z(), window.z);
    distance.depth = error.to_f64().unwrap_or(f64::INFINITY);
    Ok(Some(distance))
}

/// Conversion never panics, and NaN positions are refused.
pub fn any_bits_are_safe<F: Format>(vertex: [f32; 4], [x0, y0, x1, y1]: [u32; 4]) -> Verdict {
    let viewport = Viewport::new(Region::<F>::new(x0, y0, x1, y1)?);
    let limit = Bounds::<F>::GUARD_BAND;
    if let Some(projected) = viewport.project(vertex) {
        ensure!(!vertex.iter().any(|v| v.is_nan()), "a NaN became {projected:?}");
        ensure!(
            projected.x().abs() <= limit && projected.y().abs() <= limit,
            "beyond the guard band: {projected:?}"
        );
    }
    Ok(())
}

/// Object-space vertices through a matrix are the clip-space vertices of the definition, x m0 + y m1 + z m2 + m3
/// from left to right, and become the same window triangles in the same viewport.
pub fn model_is_its_clip_space<F: Format>(
    vertices: &[[f32; 3]],
    matrix: [[f32; 4]; 4],
    [x0, y0, x1, y1]: [u32; 4],
) -> Verdict {
    let viewport = Viewport::new(Region::<F>::new(x0, y0, x1, y1)?);
    let model = ModelPositions::new(vertices, matrix, viewport);
    let [m0, m1, m2, m3] = matrix;
    let clip: Vec<[f32; 4]> = vertices
        .iter()
        .map(|[x, y, z]| std::array::from_fn(|k| ((x * m0[k] + y * m1[k]) + z * m2[k]) + m3[k]))
        .collect();
    // A NaN is one, whatever its bits.
    let bits = |v: f32| if v.is_nan() { u32::MAX } else { v.to_bits() };
    for (at, expected) in clip.iter().enumerate() {
        ensure_eq!(model.clip(at).map(|v| v.map(bits)), Some(expected.map(bits)), "vertex {at}");
    }
    ensure!(model.clip(vertices.len()).is_none(), "a vertex after the last");
    let positions = ClipPositions::new(&clip, viewport);
    ensure_eq!(model.count(), positions.count(), "vertices");
    ensure_eq!(model.window(), positions.window(), "the window");
    ensure_eq!(model.window(), Some(viewport.region()), "the viewport");
    for first in 0..vertices.len() {
        let corners = [first, (first + 1) % vertices.len(), (first + 2) % vertices.len()];
        let (given, expected) = (assembled(&model, corners), assembled(&positions, corners));
        ensure_eq!(given, expected, "the triangle of {corners:?}");
    }
    Ok(())
}

/// What becomes of a triangle, and its pieces.
fn assembled<F: Format>(
    positions: &impl Positions<F>,
    corners: [usize; 3],
) -> (Assembly, Vec<[Vertex<F>; 3]>) {
    let mut pieces = Vec::new();
    (positions.assemble(corners, |piece| pieces.push(piece)), pieces)
}

fn whole(value: i64) -> Rational {
    Rational::from_integer(value.into())
}
