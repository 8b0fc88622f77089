//! Coverage equals the reference, sample by sample.

use crate::{
    Failure, Frame, ensure, ensure_eq,
    failure::Verdict,
    frame::window_vertices,
    oracle,
    shapes::{Corners, Kind, Random, triangle},
};
use halfplane::{Coverage, Culled, Format, Region, Statistics, Triangle, blocks, draw};

/// The core's coverage of one triangle, a row-major picture of the frame's region.
pub fn drawn<F: Format>(frame: &Frame, corners: &Corners) -> Result<(Statistics, Vec<bool>), Failure> {
    let mut masks = vec![0; blocks(frame.width(), frame.height())];
    let mut coverage = Coverage::<F>::new(frame.core_region()?, &mut masks)?;
    let vertices = window_vertices::<F>(corners, [1 << 30; 3])?;
    let statistics = draw(&vertices[..], &[0u16, 1, 2], 0, &frame.state()?, &mut coverage)?;
    let covered =
        |(x, y)| coverage.get(x, y).ok_or_else(|| Failure::new(format_args!("no pixel ({x}, {y})")));
    Ok((statistics, frame.pixels().map(covered).collect::<Result<_, _>>()?))
}

/// The core covers what the reference's scanlines cover, in the scissor and nowhere else, and counts
/// the triangle as drawn exactly where it covers something.
pub fn equals_reference<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    same(frame, &drawn::<F>(frame, corners)?, &oracle::coverage::<F>(frame, corners)?)
}

/// [`equals_reference`] in a region of 2048 x 5 pixels, or 5 x 2048, and in one that is moved by a few.
pub fn equals_reference_in_a_long_scissor<F: Format>(random: &mut Random, tall: bool, kind: Kind) -> Verdict {
    let frame = Frame::long::<F>(random, tall);
    equals_reference::<F>(&frame, &triangle::<F>(kind, &frame, random.words()))
}

/// The same against the definition in rationals.
pub fn equals_definition<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    same(frame, &drawn::<F>(frame, corners)?, &oracle::coverage_by_definition::<F>(frame, corners))
}

fn same(frame: &Frame, (statistics, given): &(Statistics, Vec<bool>), expected: &[bool]) -> Verdict {
    for ((pixel, given), expected) in frame.pixels().zip(given).zip(expected) {
        ensure!(given == expected, "pixel {pixel:?}: covered {given}, expected {expected}");
    }
    let any = expected.iter().any(|&covered| covered);
    ensure!((statistics.drawn == 1) == any, "something is covered: {any}, but {statistics}");
    Ok(())
}

/// The bounds of a set-up triangle are the pixels of the scissor whose samples lie in its extent, left
/// and top ends included, right and bottom ends excluded; or the cause why there is none.
pub fn bounds_are_half_open<F: Format>(frame: &Frame, corners: &Corners) -> Verdict {
    let Some(triangle) = Triangle::new(window_vertices::<F>(corners, [9; 3])?, frame.core_sample()?) else {
        return Ok(());
    };
    let [x0, y0, x1, y1] = frame.scissor;
    let given = triangle.bounds(Region::new(x0, y0, x1, y1)?).map(|r| [r.x0(), r.y0(), r.x1(), r.y1()]);
    let within = |axis: usize, first: u32, end: u32| {
        let values = corners.map(|corner| i64::from(corner[axis]));
        let low = values.iter().min().copied().unwrap_or(0);
        let high = values.iter().max().copied().unwrap_or(0);
        let sample = |pixel: u32| (i64::from(pixel) << F::SUBPIXEL_BITS) + i64::from(frame.sample[axis]);
        let pixels: Vec<u32> = (first..end).filter(|&p| low <= sample(p) && sample(p) < high).collect();
        let corner = |pixel: u32| i64::from(pixel) << F::SUBPIXEL_BITS;
        (pixels.first().copied().zip(pixels.last().map(|p| p + 1)), high > corner(first) && low < corner(end))
    };
    let ((columns, meets_x), (rows, meets_y)) = (within(0, x0, x1), within(1, y0, y1));
    let expected = match (columns, rows) {
        (Some((left, right)), Some((top, bottom))) => Ok([left, top, right, bottom]),
        _ if meets_x && meets_y => Err(Culled::NoSample),
        _ => Err(Culled::Outside),
    };
    ensure_eq!(given, expected, "bounds");
    Ok(())
}
