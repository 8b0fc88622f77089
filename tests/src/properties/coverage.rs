//! Coverage equals the reference, sample by sample.

use crate::{Failure, Frame, ensure, failure::Verdict, frame::window_vertices, oracle, shapes::Corners};
use halfplane::{Coverage, Format, Statistics, blocks, draw};

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
