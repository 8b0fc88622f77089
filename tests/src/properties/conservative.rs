//! Conservative coverage equals the reference, pixel by pixel, and stands to ordinary coverage as it should.

use super::coverage;
use crate::{
    Failure, Frame, ensure, ensure_eq,
    failure::Verdict,
    frame::window_vertices,
    shapes::{Corners, Kind, ORDERS, Random, doubled_area, triangle},
};
use halfplane::{
    Coordinate, Footprint, Format, Overlap, Rectangle, Region, Uncertainty, traverse_conservative,
};
use halfplane_reference::{HalfOpen, Point, Rational, inside_rows, touch_rows};
use std::collections::BTreeSet;

/// Both.
pub const UNCERTAINTIES: [Uncertainty; 2] = [Uncertainty::None, Uncertainty::HalfStep];

/// What a triangle touches and what is inside, row-major pictures of the frame's region.
pub type Pictures = [Vec<bool>; 2];

fn half_steps(uncertainty: Uncertainty) -> u32 {
    match uncertainty {
        Uncertainty::None => 0,
        Uncertainty::HalfStep => 1,
    }
}

/// Half a step or nothing, in steps.
fn size(uncertainty: Uncertainty) -> Rational {
    Rational::new(half_steps(uncertainty).into(), 2.into())
}

fn scissor<F: Format>(frame: &Frame) -> Result<Region<F>, Failure> {
    let [x0, y0, x1, y1] = frame.scissor;
    Ok(Region::new(x0, y0, x1, y1)?)
}

/// The core's masks in the frame's scissor, each block at most once, none without a pixel.
pub fn drawn<F: Format>(
    frame: &Frame,
    corners: &Corners,
    uncertainty: Uncertainty,
) -> Result<Pictures, Failure> {
    let footprint = Footprint::new(window_vertices::<F>(corners, [9; 3])?, uncertainty);
    ensure_eq!(footprint.uncertainty(), uncertainty, "as set up");
    let mut pictures = [0, 1].map(|_| vec![false; (frame.width() * frame.height()) as usize]);
    let mut wrong = None;
    let mut visited = BTreeSet::new();
    let any = traverse_conservative(&footprint, scissor(frame)?, |x, y, touched, inside| {
        if touched.is_empty()
            || inside.and(touched) != inside
            || x % 4 != 0
            || y % 4 != 0
            || !visited.insert((x, y))
        {
            wrong = Some((x, y, touched, inside));
        }
        for (picture, mask) in pictures.iter_mut().zip([touched, inside]) {
            for (column, row) in mask.cells() {
                let pixel = (x + column, y + row);
                if frame.scissor_has(pixel) {
                    picture[frame.place(pixel)] = true;
                } else {
                    wrong = Some((x, y, touched, inside));
                }
            }
        }
    });
    ensure!(wrong.is_none(), "block {wrong:?} is wrong by itself");
    ensure_eq!(any, !visited.is_empty(), "whether there was any");
    Ok(pictures)
}

/// The reference's pictures, by its strips.
fn expected<F: Format>(frame: &Frame, corners: &Corners, uncertainty: Uncertainty) -> Pictures {
    let (bits, half_steps, rect) = (F::SUBPIXEL_BITS, half_steps(uncertainty), frame.scissor_rect());
    let mut pictures = [0, 1].map(|_| vec![false; (frame.width() * frame.height()) as usize]);
    let [touched, inside] = &mut pictures;
    touch_rows(corners, bits, half_steps, rect, |y, columns| {
        columns.for_each(|x| touched[frame.place((x, y))] = true);
    });
    inside_rows(corners, bits, half_steps, rect, |y, columns| {
        columns.for_each(|x| inside[frame.place((x, y))] = true);
    });
    pictures
}

/// The same by its definitions.
fn expected_by_definition<F: Format>(frame: &Frame, corners: &Corners, uncertainty: Uncertainty) -> Pictures {
    let triangle = points(corners);
    [HalfOpen::meets, HalfOpen::is_inside].map(|rule: fn(&HalfOpen, &[Point; 3]) -> bool| {
        let holds = |pixel: (u32, u32)| {
            let grown = pixels::<F>([pixel.0, pixel.1, pixel.0 + 1, pixel.1 + 1]).grown(&size(uncertainty));
            frame.scissor_has(pixel) && rule(&grown, &triangle)
        };
        frame.pixels().map(holds).collect()
    })
}

fn points(corners: &Corners) -> [Point; 3] {
    corners.map(|[x, y]| Point::from_integers(x.into(), y.into()))
}

/// Pixels as a rectangle in steps.
fn pixels<F: Format>(ends: [u32; 4]) -> HalfOpen {
    HalfOpen::pixels(ends.map(|end| i64::from(end) << F::SUBPIXEL_BITS))
}

fn same(frame: &Frame, uncertainty: Uncertainty, given: &Pictures, expected: &Pictures) -> Verdict {
    for ((what, given), expected) in ["touched", "inside"].iter().zip(given).zip(expected) {
        for ((pixel, given), expected) in frame.pixels().zip(given).zip(expected) {
            ensure!(given == expected, "{uncertainty:?}, {pixel:?}: {what} {given}, expected {expected}");
        }
    }
    Ok(())
}

/// The core's masks are the reference's strips, in the scissor and nowhere else.
pub fn equals_reference<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    UNCERTAINTIES.into_iter().try_for_each(|uncertainty| {
        let given = drawn::<F>(frame, corners, uncertainty)?;
        same(frame, uncertainty, &given, &expected::<F>(frame, corners, uncertainty))
    })
}

/// The same against the definitions in rationals.
pub fn equals_definition<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    UNCERTAINTIES.into_iter().try_for_each(|uncertainty| {
        let given = drawn::<F>(frame, corners, uncertainty)?;
        same(frame, uncertainty, &given, &expected_by_definition::<F>(frame, corners, uncertainty))
    })
}

/// Inside is covered at every sample position, covered is touched, more uncertainty touches more and has less
/// inside, nothing is inside without area; and the order of the vertices does not matter.
pub fn is_nested<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    let [[touched, inside], [grown, shrunk]] =
        [drawn::<F>(frame, corners, UNCERTAINTIES[0])?, drawn::<F>(frame, corners, UNCERTAINTIES[1])?];
    let within = |name: &str, some: &[bool], all: &[bool]| -> Verdict {
        for ((pixel, some), all) in frame.pixels().zip(some).zip(all) {
            ensure!(!some || *all, "{name}: {pixel:?}");
        }
        Ok(())
    };
    within("inside is inside when less certain", &shrunk, &inside)?;
    within("touched is touched when less certain", &touched, &grown)?;
    let last = (1 << F::SUBPIXEL_BITS) - 1;
    for sample in [frame.sample, [0, 0], [0, last], [last, 0], [last, last]] {
        let covered = coverage::drawn::<F>(&Frame { sample, ..*frame }, corners)?.1;
        within("covered is touched", &covered, &touched)?;
        within("inside is covered", &inside, &covered)?;
    }
    let is_flat = doubled_area(corners) == 0;
    ensure!(!is_flat || !inside.contains(&true), "inside of nothing");
    for [i, j, k] in ORDERS {
        let turned = [corners[i], corners[j], corners[k]];
        ensure_eq!(
            drawn::<F>(frame, &turned, UNCERTAINTIES[1])?,
            [grown.clone(), shrunk.clone()],
            "in another order"
        );
    }
    Ok(())
}

/// [`equals_reference`] in a region of 2048 x 5 pixels, or 5 x 2048, and in one that is moved by a few.
pub fn equals_reference_in_a_long_scissor<F: Format>(random: &mut Random, tall: bool, kind: Kind) -> Verdict {
    let frame = Frame::long::<F>(random, tall);
    equals_reference::<F>(&frame, &triangle::<F>(kind, &frame, random.words()))
}

/// How a triangle and the frame's region and its scissor lie is what the definitions say, and what the
/// masks say of the scissor; the bounds hold the touched pixels, and are as small as the triangle's extent.
pub fn overlaps<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    let exact = points(corners);
    for uncertainty in UNCERTAINTIES {
        let footprint = Footprint::new(window_vertices::<F>(corners, [9; 3])?, uncertainty);
        for ends in [frame.region, frame.scissor] {
            let [x0, y0, x1, y1] = ends;
            let (given, rectangle) = (footprint.overlap(Region::new(x0, y0, x1, y1)?), pixels::<F>(ends));
            let (grown, less) = (rectangle.grown(&size(uncertainty)), rectangle.grown(&-size(uncertainty)));
            let expected = match (grown.meets(&exact), grown.is_inside(&exact), less.holds(&exact)) {
                (false, false, false) => Overlap::Outside,
                (true, true, false) => Overlap::Covers,
                (true, false, true) => Overlap::Within,
                (true, false, false) => Overlap::Partial,
                all => return Err(Failure::new(format_args!("the reference contradicts itself: {all:?}"))),
            };
            ensure_eq!(given, expected, "{uncertainty:?}, {ends:?}");
        }
        let masks = drawn::<F>(frame, corners, uncertainty)?;
        let [touched, inside] = masks.each_ref().map(|mask| mask.iter().filter(|&&set| set).count());
        let all = ((frame.scissor[2] - frame.scissor[0]) * (frame.scissor[3] - frame.scissor[1])) as usize;
        let overlap = footprint.overlap(scissor(frame)?);
        ensure_eq!(overlap == Overlap::Outside, touched == 0, "{uncertainty:?}: {overlap:?} of the scissor");
        ensure_eq!(overlap == Overlap::Covers, inside == all, "{uncertainty:?}: {overlap:?} of the scissor");
        let bounds = footprint.bounds(scissor(frame)?);
        let [left, top] =
            [0, 1].map(|axis| corners.map(|corner| corner[axis]).into_iter().min().unwrap_or(0));
        let [right, bottom] =
            [0, 1].map(|axis| corners.map(|corner| corner[axis]).into_iter().max().unwrap_or(0));
        ensure_eq!(
            bounds,
            rectangle::<F>([left, top, right, bottom])?.touched(scissor(frame)?, uncertainty),
            "bounds"
        );
    }
    Ok(())
}

fn rectangle<F: Format>([x0, y0, x1, y1]: [i32; 4]) -> Result<Rectangle<F>, Failure> {
    let at = |steps| {
        Coordinate::from_steps(steps)
            .ok_or_else(|| Failure::new(format_args!("{steps} is beyond the guard band")))
    };
    Ok(Rectangle::new([at(x0)?, at(y0)?], [at(x1)?, at(y1)?]))
}

/// A rectangle between two corners touches and contains what its definition says, column by column and row by row;
/// it touches what its two triangles touch.
pub fn rectangles<F: Format>(frame: &Frame, [p, q]: [[i32; 2]; 2]) -> Verdict {
    let rectangle = rectangle::<F>([p[0], p[1], q[0], q[1]])?;
    for uncertainty in UNCERTAINTIES {
        // In half steps, as everything here.
        let half_steps = i64::from(half_steps(uncertainty));
        let of = |axis: usize| {
            let [p, q] = [p, q].map(|corner| 2 * i64::from(corner[axis]));
            let (low, high, pixel) = (p.min(q), p.max(q), 2i64 << F::SUBPIXEL_BITS);
            move |at: u32| {
                let (first, end) = (i64::from(at) * pixel, (i64::from(at) + 1) * pixel);
                let touched = low - half_steps < end && high + half_steps >= first;
                [touched, low + half_steps <= first && end <= high - half_steps]
            }
        };
        let (columns, rows) = (of(0), of(1));
        let region = scissor::<F>(frame)?;
        let given = [rectangle.touched(region, uncertainty), rectangle.inside(region, uncertainty)];
        let mut any = [false; 2];
        for pixel in frame.pixels().filter(|&pixel| frame.scissor_has(pixel)) {
            for (which, given) in given.iter().enumerate() {
                let (x, y) = pixel;
                let has = given.is_some_and(|r| r.x0() <= x && x < r.x1() && r.y0() <= y && y < r.y1());
                let expected = columns(x)[which] && rows(y)[which];
                ensure_eq!(has, expected, "{uncertainty:?}: {pixel:?} touched (0) or inside (1): {which}");
                any[which] |= expected;
            }
        }
        ensure_eq!(given.map(|given| given.is_some()), any, "{uncertainty:?}: whether there are any");
        let halves = [[p, [q[0], p[1]], q], [p, [p[0], q[1]], q]];
        let [one, other] = halves.map(|corners| drawn::<F>(frame, &corners, uncertainty));
        for ((pixel, one), other) in frame.pixels().zip(&one?[0]).zip(&other?[0]) {
            let expected = frame.scissor_has(pixel) && columns(pixel.0)[0] && rows(pixel.1)[0];
            ensure_eq!(*one || *other, expected, "{uncertainty:?}: two triangles at {pixel:?}");
        }
    }
    Ok(())
}

/// Of an edge and triangles on both sides of it, every pixel that it passes is touched by both.
pub fn an_edge_is_touched_from_both_sides<F: Format>(
    frame: &Frame,
    corners: &Corners,
    other: [i32; 2],
) -> Verdict {
    let [p, q, one] = *corners;
    for uncertainty in UNCERTAINTIES {
        let [edge, _] = drawn::<F>(frame, &[p, q, q], uncertainty)?;
        for opposite in [one, other] {
            let [touched, _] = drawn::<F>(frame, &[q, p, opposite], uncertainty)?;
            for ((pixel, edge), touched) in frame.pixels().zip(&edge).zip(&touched) {
                ensure!(
                    !edge || *touched,
                    "{uncertainty:?}: {pixel:?} has the edge and not the triangle to {opposite:?}"
                );
            }
        }
    }
    Ok(())
}

/// Half a step holds for every triangle whose vertices are moved by up to that much, here in units of 2^-7 of a step:
/// what it touches is touched, and what is inside is inside it.
pub fn holds_before_snapping<F: Format>(frame: &Frame, corners: &Corners, moved: [[i8; 2]; 3]) -> Verdict {
    let exact = [0, 1, 2].map(|k| {
        let [x, y] = [0, 1].map(|axis| {
            let by = i64::from((moved[k][axis] / 2).clamp(-64, 64));
            Rational::new((128 * i64::from(corners[k][axis]) + by).into(), 128.into())
        });
        Point::new(x, y)
    });
    let [touched, inside] = drawn::<F>(frame, corners, Uncertainty::HalfStep)?;
    for ((pixel, touched), inside) in frame.pixels().zip(&touched).zip(&inside) {
        if frame.scissor_has(pixel) {
            let square = pixels::<F>([pixel.0, pixel.1, pixel.0 + 1, pixel.1 + 1]);
            ensure!(*touched || !square.meets(&exact), "{pixel:?} is touched before snapping");
            ensure!(!inside || square.is_inside(&exact), "{pixel:?} is not inside before snapping");
        }
    }
    Ok(())
}
