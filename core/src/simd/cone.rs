//! Cones of normals: meshlets of which all triangles face the culled way are passed over unseen.
//!
//! With n = (b - a) x (c - a) a triangle's normal in object space, and E = (e, e') the point that the x, y and w columns
//! of the matrix take to 0, the determinant of the triangle's (x, y, w) in clip space is n . (e - e' a) (Cauchy and
//! Binet), whatever the matrix; (e - e' a) points to the eye. Divided by the three w, and times half the viewport's
//! width and height, it is the doubled area in the window. Facing is that of the snapped triangle, though: a sliver can
//! turn round when it is snapped. So a meshlet counts as culled only where no triangle's area can change its sign.

#[cfg(any(kani, test))]
mod proofs;

use super::meshlet::Meshlet;
use crate::{
    draw::State,
    geometry::Winding,
    numbers::{Bounds, Standard},
    transform::{Frustum, Viewport, root_above},
};

/// What a meshlet's triangles have in common. Lengths are those of object space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    /// In the middle of the triangles' unit normals.
    axis: [f32; 3],
    /// How far from it they are, at most.
    spread: f32,
    /// How far from the middle of the meshlet's box the triangles' planes are, at most.
    offset: f32,
    /// The least height of a triangle over its longest side.
    height: f32,
    /// The least doubled area.
    area: f32,
}

/// More than the error of a unit normal, of a triangle that is not too thin.
const NORMAL: f64 = 1.0 / (1u64 << 22) as f64;
/// Less than 1, by more than what is off in areas.
const LESS: f64 = 1.0 - 1.0 / (1u64 << 20) as f64;
/// More than 1, by more than what is off in lengths, and in their conversion to `f32`.
const MORE: f64 = 1.0 + 1.0 / (1u64 << 20) as f64;
/// Of sums of magnitudes: more than all rounding in `f64`.
const TINY: f64 = 1.0 / (1u64 << 40) as f64;

impl Cone {
    /// Of triangles whose box has this middle. `None` where there are none, one is not finite, one has next to no
    /// area, or their normals have too little in common.
    pub(super) fn new(
        middle: [f64; 3],
        triangles: impl Iterator<Item = [[f32; 3]; 3]> + Clone,
    ) -> Option<Self> {
        // Two corners at one place are at one place after snapping: such a triangle covers nothing.
        let triangles = triangles.filter(|[a, b, c]| a != b && b != c && c != a);
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for triangle in triangles.clone() {
            let Face { normal, .. } = Face::new(triangle)?;
            for (v, (low, high)) in normal.into_iter().zip(low.iter_mut().zip(&mut high)) {
                (*low, *high) = (low.min(v), high.max(v));
            }
        }
        let [x, y, z] = [0, 1, 2].map(|axis| (0.5 * (low[axis] + high[axis])) as f32);
        let axis = [x, y, z];
        let center = axis.map(f64::from);
        let (mut spread, mut offset) = (0.0f64, 0.0f64);
        let (mut height, mut area) = (f64::INFINITY, f64::INFINITY);
        for triangle in triangles {
            let face = Face::new(triangle)?;
            let aside = minus(face.normal, center);
            spread = spread.max(root_above(dot(aside, aside)));
            let from = minus(triangle[0].map(f64::from), middle);
            let reach = sum(from.map(f64::abs));
            offset = offset.max(dot(face.normal, from).abs() + NORMAL * reach + TINY * face.size);
            height = height.min(face.area / face.longest);
            area = area.min(face.area);
        }
        let (spread, offset) = ((spread + NORMAL) * MORE, offset * MORE);
        // Not for NaN: there are no triangles then.
        let together = spread * spread < dot(center, center);
        let less = |v: f64| (v * LESS).min(f64::from(f32::MAX)) as f32;
        together.then(|| Self {
            axis,
            spread: spread as f32,
            offset: offset as f32 + f32::MIN_POSITIVE,
            height: less(height),
            area: less(area),
        })
    }
}

/// A triangle's plane and size.
struct Face {
    /// Of unit length.
    normal: [f64; 3],
    /// The doubled area.
    area: f64,
    /// The longest side.
    longest: f64,
    /// The largest coordinate's magnitude.
    size: f64,
}

impl Face {
    /// `None` where rounding could turn the normal by more than [`NORMAL`]: it is off by less than 2^-48 of the
    /// longest side times the longest side and the largest coordinate.
    fn new(triangle: [[f32; 3]; 3]) -> Option<Self> {
        let [a, b, c] = triangle.map(|corner| corner.map(f64::from));
        let (ab, ac, bc) = (minus(b, a), minus(c, a), minus(c, b));
        let ([x, y, z], [u, v, w]) = (ab, ac);
        let normal = [y * w - z * v, z * u - x * w, x * v - y * u];
        let size = triangle.as_flattened().iter().fold(0.0, |size: f64, &v| size.max(f64::from(v).abs()));
        let area = root_above(dot(normal, normal));
        let longest = root_above(dot(ab, ab).max(dot(ac, ac)).max(dot(bc, bc)));
        let certain = area > longest * (longest + size) * (1.0 / (1u64 << 24) as f64);
        // Infinities and NaN compare to false.
        (certain && area < f64::INFINITY).then(|| Self {
            normal: normal.map(|v| v / area),
            area,
            longest,
            size,
        })
    }
}

/// A draw's eye and what it culls.
#[derive(Clone, Copy)]
pub(super) struct Facing {
    /// The columns of x, y and w.
    columns: [[f64; 4]; 3],
    /// The lengths of their first three entries.
    lengths: [f64; 3],
    /// What they take to 0, and the sums of the magnitudes that it is a sum of; times -1 where clockwise triangles are
    /// culled, so that what is culled has a positive determinant.
    eye: [f64; 4],
    sizes: [f64; 4],
    /// Half the viewport, and its centre.
    half: [f64; 2],
    center: [f64; 2],
    /// Of what is not clipped.
    unclipped: Frustum,
}

impl Facing {
    /// `None` where no face is culled.
    pub(super) fn new(
        matrix: &[[f32; 4]; 4],
        viewport: &Viewport<Standard>,
        state: &State<Standard>,
    ) -> Option<Self> {
        let culls = |winding| state.cull.culls(winding, state.front);
        // Turned over, y pointing down: clockwise triangles have a negative determinant.
        let sign = match (culls(Winding::Clockwise), culls(Winding::CounterClockwise)) {
            (true, _) => -1.0,
            (false, true) => 1.0,
            (false, false) => return None,
        };
        let columns = [0, 1, 3].map(|column| matrix.map(|row| f64::from(row[column])));
        let [a, b, c, d] = matrix.map(|[x, y, _, w]| [x, y, w].map(f64::from));
        let minors = [minor(b, c, d), minor(a, c, d), minor(a, b, d), minor(a, b, c)];
        let [(x, sx), (y, sy), (z, sz), (w, sw)] = minors;
        Some(Self {
            columns,
            lengths: columns.map(|[x, y, z, _]| root_above(dot([x, y, z], [x, y, z]))),
            eye: [sign * x, -sign * y, sign * z, -sign * w],
            sizes: [sx, sy, sz, sw],
            half: viewport.half_size().map(f64::from),
            center: viewport.center().map(f64::from),
            unclipped: Frustum::unclipped(matrix, viewport),
        })
    }

    /// Whether every triangle of a meshlet is certain to be culled for the way that it faces, after snapping.
    #[inline(always)]
    pub(super) fn culls(&self, meshlet: &Meshlet) -> bool {
        match meshlet.cone() {
            Some(cone) => self.culls_cone(cone, [meshlet.low, meshlet.high]),
            None => false,
        }
    }

    /// The same for what is in a box.
    #[inline(always)]
    fn culls_cone(&self, cone: &Cone, corners: [[f32; 3]; 2]) -> bool {
        let ([x, y, z, w], [sx, sy, sz, sw]) = (self.eye, self.sizes);
        let middle @ [mx, my, mz] = middle(corners);
        // To the eye from there. A triangle's determinant is at least its doubled area times what is left of it along
        // the axis.
        let eye = [x - w * mx, y - w * my, z - w * mz];
        let size = sx + sy + sz + sw * sum(middle.map(f64::abs));
        let along = dot(cone.axis.map(f64::from), eye) - (w.abs() * f64::from(cone.offset) + size * TINY);
        let (spread, square) = (f64::from(cone.spread), dot(eye, eye));
        along > 0.0
            && along * along > spread * spread * square
            && self.stays(cone, along - spread * root_above(square), corners)
    }

    /// Whether snapping cannot change the way that any triangle faces: determinants are at least doubled areas times
    /// `factor`.
    ///
    /// Where each vertex moves by up to d steps along both axes, the doubled area changes by up to
    /// 2 d (width + height) + 8 d² of the triangle's. What is compared is half of the area with each.
    #[inline(never)]
    fn stays(&self, cone: &Cone, factor: f64, corners: [[f32; 3]; 2]) -> bool {
        let [x, y, w] = self.columns.map(|column| Range::new(column, corners));
        let near = w.middle - w.reach - w.size * (1.0 / (1u64 << 18) as f64);
        let far = w.middle + w.reach;
        if !(near > 1e-20 && self.unclipped.contains_box(corners)) {
            return false;
        }
        let ([half_x, half_y], [length_x, length_y, length_w]) = (self.half, self.lengths);
        let [quotient_x, quotient_y] = [x, y].map(|v| (v.middle.abs() + v.reach) / near);
        // What a vertex is off by in pixels: a clip coordinate by 4.1 units of 2^-24 of its size, a quotient and the
        // window's coordinate by one more each.
        let off = |v: Range, quotient: f64, half: f64, center: f64| {
            let clip = (v.size + quotient * w.size) / near + quotient;
            (half * clip + 0.5 * (center + half * quotient)) * (1.0 / (1u64 << 21) as f64)
        };
        let [center_x, center_y] = self.center;
        let off = off(x, quotient_x, half_x, center_x).max(off(y, quotient_y, half_y, center_y));
        let steps = f64::from(Bounds::<Standard>::STEPS_PER_PIXEL);
        let moves = 0.5 * MORE + steps * off;
        // Steps² of window for area of object space, at least; steps of width and height for length, at most.
        let areas = steps * steps * half_x * half_y * factor / (far * far * far);
        let lengths = steps / near
            * (half_x * (length_x + quotient_x * length_w) + half_y * (length_y + quotient_y * length_w));
        areas * f64::from(cone.height) > 4.0 * moves * lengths * MORE
            && areas * f64::from(cone.area) > 16.0 * moves * moves * MORE
    }
}

/// A clip coordinate over a box: between `middle - reach` and `middle + reach`.
#[derive(Clone, Copy)]
struct Range {
    middle: f64,
    reach: f64,
    /// The largest sum of the magnitudes of its terms.
    size: f64,
}

impl Range {
    #[inline(always)]
    fn new([a, b, c, d]: [f64; 4], corners: [[f32; 3]; 2]) -> Self {
        let [x, y, z] = middle(corners);
        let [low, high] = corners.map(|corner| corner.map(f64::from));
        let [u, v, w] = [0, 1, 2].map(|axis| 0.5 * (high[axis] - low[axis]));
        let (ra, rb, rc) = (a.abs(), b.abs(), c.abs());
        let reach = ra * u + rb * v + rc * w;
        let size = ra * x.abs() + rb * y.abs() + rc * z.abs() + reach + d.abs();
        Self { middle: a * x + b * y + c * z + d, reach: reach + size * TINY, size }
    }
}

/// The middle of a box.
#[inline(always)]
pub(super) fn middle([low, high]: [[f32; 3]; 2]) -> [f64; 3] {
    [0, 1, 2].map(|axis| 0.5 * (f64::from(low[axis]) + f64::from(high[axis])))
}

/// A determinant of three rows, and the sum of the magnitudes of its terms.
fn minor([a, b, c]: [f64; 3], [d, e, f]: [f64; 3], [g, h, i]: [f64; 3]) -> (f64, f64) {
    let terms = [(a * e * i, c * e * g), (b * f * g, b * d * i), (c * d * h, a * f * h)];
    let value = terms.iter().map(|(plus, minus)| plus - minus).sum();
    (value, terms.iter().map(|(plus, minus)| plus.abs() + minus.abs()).sum())
}

#[inline(always)]
fn minus([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a - x, b - y, c - z]
}

#[inline(always)]
fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

#[inline(always)]
fn sum([a, b, c]: [f64; 3]) -> f64 {
    a + b + c
}
