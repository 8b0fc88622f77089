//! Closed triangles and rectangles: their pixels, and how they and a rectangle of pixels lie.

use super::{SMALL, STANDARD, rule::uncertainty, vertex};
use crate::{
    Coordinate, Format, Rectangle, Region, Small, Standard, Vertex,
    geometry::{
        Edge, Extent, Footprint, Overlap, doubled_area,
        footprint::accepts,
        rule::{Inside, Rule, Touched},
    },
    numbers::Bounds,
    proof::{assume, cover, prove},
};

/// Pixels in the guard band on each side of the origin.
const PIXELS_STANDARD: i32 = STANDARD / Bounds::<Standard>::STEPS_PER_PIXEL;
const PIXELS_SMALL: i32 = SMALL / Bounds::<Small>::STEPS_PER_PIXEL;

#[inline(always)]
fn rectangle<F: Format>([[x0, y0], [x1, y1]]: [[i32; 2]; 2]) -> Option<Rectangle<F>> {
    let at = Coordinate::from_steps;
    Some(Rectangle::new([at(x0)?, at(y0)?], [at(x1)?, at(y1)?]))
}

/// The columns and the rows that the closed extent, grown, has a point of, and those that it, shrunk, has all of:
/// as inequalities of half steps.
#[inline(always)]
fn pixels<F: Format>(corners: [[i32; 2]; 2], pixel: i32, half: bool) {
    let [p, q] = corners;
    let (Some(a), Some(b)) = (vertex::<F>(p, 0), vertex::<F>(q, 0)) else { return };
    let extent = Extent::of([a, b, b]);
    let margin = i64::from(half);
    let (touched, inside) = (extent.touched::<F>(uncertainty(half)), extent.inside::<F>(uncertainty(half)));
    let within = |first, end| first <= pixel && pixel < end;
    let side = 2 * i64::from(Bounds::<F>::STEPS_PER_PIXEL);
    let (start, end) = (i64::from(pixel) * side, (i64::from(pixel) + 1) * side);
    for (axis, touched, inside) in [
        (0, within(touched.x0, touched.x1), within(inside.x0, inside.x1)),
        (1, within(touched.y0, touched.y1), within(inside.y0, inside.y1)),
    ] {
        let (low, high) = (2 * i64::from(p[axis].min(q[axis])), 2 * i64::from(p[axis].max(q[axis])));
        assert!(touched == (low - margin < end && high + margin >= start));
        assert!(inside == (low + margin <= start && end <= high - margin));
    }
    cover!(within(touched.x0, touched.x1) && 2 * i64::from(p[0].max(q[0])) == start);
    cover!(within(inside.y0, inside.y1) && 2 * i64::from(p[1].max(q[1])) == end + margin);
}

/// A rectangle's pixels in a region are those of its extent; none is said of no pixels.
#[inline(always)]
fn rectangles<F: Format>(corners: [[i32; 2]; 2], given: [u32; 4], [x, y]: [u32; 2], half: bool) {
    let [x0, y0, x1, y1] = given;
    let (Some(rectangle), Ok(region)) = (rectangle::<F>(corners), Region::new(x0, y0, x1, y1)) else {
        return;
    };
    let [p, q] = corners;
    let (Some(a), Some(b)) = (vertex::<F>(p, 0), vertex::<F>(q, 0)) else { return };
    let extent = Extent::of([a, b, b]);
    assume!(x < F::MAX_TARGET && y < F::MAX_TARGET);
    let in_region = x0 <= x && x < x1 && y0 <= y && y < y1;
    let (column, row) = (x as i32, y as i32);
    let has = |region: Region<F>| region.x0() <= x && x < region.x1() && region.y0() <= y && y < region.y1();
    for (pixels, found) in [
        (extent.touched::<F>(uncertainty(half)), rectangle.touched(region, uncertainty(half))),
        (extent.inside::<F>(uncertainty(half)), rectangle.inside(region, uncertainty(half))),
    ] {
        let is_one = pixels.x0 <= column && column < pixels.x1 && pixels.y0 <= row && row < pixels.y1;
        assert!(found.is_some_and(has) == (in_region && is_one));
        // Of what is all in the region nothing is lost.
        if pixels.are_all_in(region) {
            assert!(!is_one || in_region);
        }
        cover!(found.is_some() && !pixels.are_all_in(region));
        cover!(found.is_none());
    }
}

#[inline(always)]
fn corners<F: Format>([a, b, c]: [[i32; 2]; 3]) -> Option<[Vertex<F>; 3]> {
    Some([vertex(a, 0)?, vertex(b, 0)?, vertex(c, 0)?])
}

/// Of a triangle of either winding each edge is 0 at its ends and the doubled area, positive, at the vertex opposite.
#[inline(always)]
fn set_up<F: Format>(given: [[i32; 2]; 3], clockwise: bool, half: bool) {
    let Some(vertices) = corners::<F>(given) else { return };
    let signed: i64 = doubled_area(vertices).into();
    assume!((signed >= 0) == clockwise);
    let footprint = Footprint::new(vertices, uncertainty(half));
    assert!(footprint.uncertainty() == uncertainty(half));
    assert!(footprint.inside().is_some() == (signed != 0));
    let at = |edge: Edge<F>, vertex: Vertex<F>| -> i64 { edge.at((vertex.x(), vertex.y())).into() };
    let ([e0, e1, e2], [a, b, c]) = (footprint.touched().edges, vertices);
    let (b, c) = if clockwise { (b, c) } else { (c, b) };
    let area = if clockwise { signed } else { -signed };
    assert!(at(e0, a) == area && at(e1, b) == area && at(e2, c) == area);
    assert!(at(e0, b) == 0 && at(e1, c) == 0 && at(e2, a) == 0);
    cover!(signed == if clockwise { 1 } else { -1 });
}

/// An edge and a rectangle of pixels.
#[inline(always)]
fn edge_and_region<F: Format>(
    ends: [[i32; 2]; 2],
    [x0, y0, x1, y1]: [u32; 4],
) -> Option<(Edge<F>, Region<F>)> {
    Some((Edge::new(vertex(ends[0], 0)?, vertex(ends[1], 0)?), Region::new(x0, y0, x1, y1).ok()?))
}

/// An edge accepts a rectangle as the rule accepts one of its pixels, whose point is the rectangle's corner that it would
/// be of one large pixel: where E is largest for what is touched, smallest for what is inside.
#[inline(always)]
fn accepting<F: Format>(ends: [[i32; 2]; 2], given: [u32; 4], half: bool, largest: bool) {
    let [x0, y0, x1, y1] = given;
    let Some((edge, region)) = edge_and_region::<F>(ends, given) else { return };
    let (right, down) = ((edge.a() > 0) == largest, (edge.b() > 0) == largest);
    let (column, row) = (if right { x1 - 1 } else { x0 }, if down { y1 - 1 } else { y0 });
    let (touched, inside) = (Touched(uncertainty(half)), Inside(uncertainty(half)));
    let (x, y) = if largest { touched.point(edge, column, row) } else { inside.point(edge, column, row) };
    let side = Bounds::<F>::STEPS_PER_PIXEL;
    let corner = |is_far, first: u32, end: u32| if is_far { end as i32 * side } else { first as i32 * side };
    // Where E does not depend on a column, or a row, any will do.
    assert!(edge.a() == 0 || x == corner(right, x0, x1));
    assert!(edge.b() == 0 || y == corner(down, y0, y1));
    if largest {
        let reduced: i64 = edge.reduced(touched, column, row).into();
        assert!(accepts(edge, touched, region, true) == (reduced >= 0));
        cover!(reduced >= 0);
    } else {
        let reduced: i64 = edge.reduced(inside, column, row).into();
        assert!(accepts(edge, inside, region, false) == (reduced >= 0));
        cover!(reduced >= 0);
    }
}

/// What is decided by the bounds alone: outside where they have no pixel of the region, within where the region has
/// all of theirs, neither elsewhere, but that edges may show it to be outside.
#[inline(always)]
fn overlaps_by_bounds<F: Format>(given: [[i32; 2]; 3], ends: [u32; 4], half: bool) {
    let [x0, y0, x1, y1] = ends;
    let (Some(vertices), Ok(region)) = (corners::<F>(given), Region::<F>::new(x0, y0, x1, y1)) else {
        return;
    };
    let footprint = Footprint::new(vertices, uncertainty(half));
    let bounds = footprint.bounds(region);
    let overlap = footprint.overlap(region);
    let pixels = Extent::of(vertices).touched::<F>(uncertainty(half));
    assert!(bounds == pixels.within(region));
    assert!(bounds.is_some() || overlap == Overlap::Outside);
    let ends = ends.map(i64::from);
    let all = [pixels.x0, pixels.y0].into_iter().zip(ends).all(|(pixel, end)| i64::from(pixel) >= end)
        && i64::from(pixels.x1) <= ends[2]
        && i64::from(pixels.y1) <= ends[3];
    assert!((overlap == Overlap::Within) == (bounds.is_some() && all));
    cover!(overlap == Overlap::Within);
    cover!(bounds.is_none());
}

prove! {
    /// Which columns and rows an extent touches and contains, for all pixels of the guard band.
    #[kani::unwind(4)]
    [Extent::touched, Extent::inside, Uncertainty::doubled]
    fn extents_of_standard_have_their_pixels(
        corners: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        pixel: i32 = -PIXELS_STANDARD..=PIXELS_STANDARD,
        half: bool,
    ) {
        pixels::<Standard>(corners, pixel, half);
    }

    /// The same for the small format.
    #[kani::unwind(4)]
    [Extent::touched, Extent::inside, Uncertainty::doubled]
    fn extents_of_small_have_their_pixels(
        corners: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        pixel: i32 = -PIXELS_SMALL..=PIXELS_SMALL,
        half: bool,
    ) {
        pixels::<Small>(corners, pixel, half);
    }

    /// A rectangle's pixels, in any region.
    #[kani::unwind(4)]
    [Rectangle::new, Rectangle::touched, Rectangle::inside, Pixels::within, Pixels::are_all_in]
    fn rectangles_of_standard_are_cut_to_the_region(
        corners: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        given: [u32; 4],
        pixel: [u32; 2],
        half: bool,
    ) {
        rectangles::<Standard>(corners, given, pixel, half);
    }

    /// The same for the small format.
    #[kani::unwind(4)]
    [Rectangle::new, Rectangle::touched, Rectangle::inside, Pixels::within, Pixels::are_all_in]
    fn rectangles_of_small_are_cut_to_the_region(
        corners: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        given: [u32; 4],
        pixel: [u32; 2],
        half: bool,
    ) {
        rectangles::<Small>(corners, given, pixel, half);
    }

    /// Edges look inwards, whatever the winding; a triangle without area has no inside.
    [Footprint::new, Footprint::inside]
    fn clockwise_footprints_of_standard_look_inwards(
        given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3],
        half: bool,
    ) {
        set_up::<Standard>(given, true, half);
    }

    /// The same for the other winding.
    [Footprint::new, Footprint::inside]
    fn counter_clockwise_footprints_of_standard_look_inwards(
        given: [[i32; 2]; 3] = [[-STANDARD; 2]; 3]..=[[STANDARD; 2]; 3],
        half: bool,
    ) {
        set_up::<Standard>(given, false, half);
    }

    /// The same for the small format.
    [Footprint::new, Footprint::inside]
    fn clockwise_footprints_of_small_look_inwards(
        given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3],
        half: bool,
    ) {
        set_up::<Small>(given, true, half);
    }

    /// The same for the other winding.
    [Footprint::new, Footprint::inside]
    fn counter_clockwise_footprints_of_small_look_inwards(
        given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3],
        half: bool,
    ) {
        set_up::<Small>(given, false, half);
    }

    /// An edge touches a rectangle of pixels by its largest E, as it does a pixel.
    [accepts]
    fn slow_rectangles_of_standard_are_touched_by_an_edge(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        given: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        half: bool,
    ) {
        accepting::<Standard>(ends, given, half, true);
    }

    /// The same for the small format.
    [accepts]
    fn rectangles_of_small_are_touched_by_an_edge(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        given: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        half: bool,
    ) {
        accepting::<Small>(ends, given, half, true);
    }

    /// It contains one by its smallest E.
    [accepts]
    fn rectangles_of_standard_are_inside_an_edge(
        ends: [[i32; 2]; 2] = [[-STANDARD; 2]; 2]..=[[STANDARD; 2]; 2],
        given: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        half: bool,
    ) {
        accepting::<Standard>(ends, given, half, false);
    }

    /// The same for the small format.
    [accepts]
    fn rectangles_of_small_are_inside_an_edge(
        ends: [[i32; 2]; 2] = [[-SMALL; 2]; 2]..=[[SMALL; 2]; 2],
        given: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        half: bool,
    ) {
        accepting::<Small>(ends, given, half, false);
    }

    /// The answers that need no edge.
    [Footprint::overlap, Footprint::bounds]
    fn bounds_decide_what_is_within(
        given: [[i32; 2]; 3] = [[-SMALL; 2]; 3]..=[[SMALL; 2]; 3],
        ends: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        half: bool,
    ) {
        overlaps_by_bounds::<Small>(given, ends, half);
    }
}
