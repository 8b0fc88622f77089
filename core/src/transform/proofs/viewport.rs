//! Projection and the guard band.

use crate::{
    geometry::Region,
    numbers::{Bounds, DEPTH32_MAX, DEPTH32_MIN, Format, Small, Standard},
    proof::{assume, cover, prove},
    transform::{plane::Plane, viewport::Viewport},
};

/// The clip-space vertex with these bits.
fn vertex(bits: [u32; 4]) -> [f32; 4] {
    bits.map(f32::from_bits)
}

/// Any vertex in any viewport.
fn projects<F: Format>(bits: [u32; 4], [x0, y0, x1, y1]: [u32; 4]) {
    let Ok(region) = Region::<F>::new(x0, y0, x1, y1) else { return };
    let viewport = Viewport::new(region);
    let [x, y, z, w] = vertex(bits);
    let projected = viewport.project([x, y, z, w]);
    assert!(projected.is_none() == ((x / w).is_nan() | (y / w).is_nan() | (z / w).is_nan()));
    if let Some(vertex) = projected {
        let band = -Bounds::<F>::GUARD_BAND..=Bounds::<F>::GUARD_BAND;
        assert!(band.contains(&vertex.x()) && band.contains(&vertex.y()));
        assert!((DEPTH32_MIN..=DEPTH32_MAX).contains(&vertex.z()));
        cover!(vertex.x() == Bounds::<F>::GUARD_BAND && vertex.y() == -Bounds::<F>::GUARD_BAND);
    }
    cover!(projected.is_none());
}

/// A column of pixels, and a quotient from -1 to 1.
pub(super) fn stays_in_the_columns<F: Format>(x: u32, [x0, x1]: [u32; 2]) {
    let Ok(region) = Region::<F>::new(x0, 0, x1, 2) else { return };
    let x = f32::from_bits(x);
    assume!(Plane::frustum_has([x, 0.0, 0.0, 1.0]));
    let projected = Viewport::new(region).project([x, 0.0, 0.0, 1.0]);
    let steps = |pixels: u32| (pixels as i32) << F::SUBPIXEL_BITS;
    assert!(projected.is_some_and(|v| steps(x0) <= v.x() && v.x() <= steps(x1)));
    cover!(projected.is_some_and(|v| v.x() == steps(x1) && x < 1.0));
}

/// A row of pixels, and a quotient from -1 to 1.
pub(super) fn stays_in_the_rows<F: Format>(y: u32, [y0, y1]: [u32; 2]) {
    let Ok(region) = Region::<F>::new(0, y0, 2, y1) else { return };
    let y = f32::from_bits(y);
    assume!(Plane::frustum_has([0.0, y, 0.0, 1.0]));
    let projected = Viewport::new(region).project([0.0, y, 0.0, 1.0]);
    let steps = |pixels: u32| (pixels as i32) << F::SUBPIXEL_BITS;
    assert!(projected.is_some_and(|v| steps(y0) <= v.y() && v.y() <= steps(y1)));
    cover!(projected.is_some_and(|v| v.y() == steps(y1) && y > -1.0));
}

/// The planes of the guard band lie around the frustum, and are finite.
fn guard_band_is_around_the_frustum<F: Format>([x0, y0, x1, y1]: [u32; 4]) {
    let Ok(region) = Region::<F>::new(x0, y0, x1, y1) else { return };
    let [left, right, top, bottom] = Viewport::new(region).guard_band();
    // The farthest are those of a viewport one pixel wide, at the target's far end.
    let (near, far) = (
        2.0 * Bounds::<F>::CLIP_PIXELS as f32,
        2.0 * (Bounds::<F>::CLIP_PIXELS + F::MAX_TARGET as i32) as f32,
    );
    assert!((-far..=-1.0).contains(&left) && (1.0..=near).contains(&right));
    assert!((-near..=-1.0).contains(&bottom) && (1.0..=far).contains(&top));
    cover!(2.0 * right < top);
    cover!(right > 3.0 * Bounds::<F>::CLIP_PIXELS as f32 / 2.0);
}

prove! {
    /// No vertex makes the projection panic or leaves the guard band: it is `None` where a quotient is NaN,
    /// and nowhere else. For every bit pattern and every region.
    [Viewport::new, Viewport::project, Coordinate::snap, unorm32, Region::width, Region::height]
    fn projection_ends_in_the_guard_band(bits: [u32; 4], region: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4]) {
        projects::<Standard>(bits, region);
    }

    /// The same for the small format.
    [Viewport::new, Viewport::project, Coordinate::snap, unorm32, Region::width, Region::height]
    fn small_projection_ends_in_the_guard_band(bits: [u32; 4], region: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4]) {
        projects::<Small>(bits, region);
    }

    /// What the frustum has lies in the viewport's columns, ends included, where w is 1, in the small format.
    /// For other w see [`quotients_in_the_frustum`]; the standard format is left to tests.
    #[kani::solver(cadical)]
    [Plane::frustum_has, Viewport::new, Viewport::project]
    fn frustum_projects_into_the_small_columns(x: u32, columns: [u32; 2] = [0; 2]..=[Small::MAX_TARGET; 2]) {
        stays_in_the_columns::<Small>(x, columns);
    }

    /// The same for the rows.
    #[kani::solver(cadical)]
    [Plane::frustum_has, Viewport::new, Viewport::project]
    fn frustum_projects_into_the_small_rows(y: u32, rows: [u32; 2] = [0; 2]..=[Small::MAX_TARGET; 2]) {
        stays_in_the_rows::<Small>(y, rows);
    }

    /// What the frustum has divides to what the frustum has with w = 1, so that
    /// [`frustum_projects_into_the_small_columns`] and its like speak for every w.
    [Plane::frustum_has]
    fn quotients_in_the_frustum(v: u32, z: u32, w: u32) {
        let (v, z, w) = (f32::from_bits(v), f32::from_bits(z), f32::from_bits(w));
        assume!(Plane::frustum_has([v, v, z, w]));
        assert!(Plane::frustum_has([v / w, v / w, z / w, 1.0]));
        cover!(v / w == 1.0);
        cover!(v / w == -0.5 && z / w == 0.25);
    }

    /// Planes that clip at the guard band leave the whole frustum inside, and their factors are below 2^18.
    [Viewport::new, Viewport::guard_band]
    fn guard_band_holds_the_frustum(region: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4]) {
        guard_band_is_around_the_frustum::<Standard>(region);
    }

    /// The same for the small format.
    [Viewport::new, Viewport::guard_band]
    fn small_guard_band_holds_the_frustum(region: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4]) {
        guard_band_is_around_the_frustum::<Small>(region);
    }
}
