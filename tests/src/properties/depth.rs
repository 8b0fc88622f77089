//! Depth is the specified integer, and within the promised distance of the exact rational.

use crate::{
    Failure, Frame, ensure, ensure_eq,
    failure::Verdict,
    frame::window_vertices,
    oracle,
    shapes::{Corners, ORDERS},
};
use halfplane::{Bounds, Compare, Depth, DepthFormat, DepthTest, Format, draw, texels};
use halfplane_reference::{DepthSpec, ExactPlane, Fraction, SpecifiedPlane, specified_depth};

/// The core's depths of one triangle over a cleared buffer: a row-major picture of the region, `None`
/// where it wrote nothing.
pub fn drawn<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    corners: &Corners,
    z: [u32; 3],
) -> Result<Vec<Option<u32>>, Failure> {
    let mut storage = vec![D::FAR; texels(frame.width(), frame.height())];
    let test = DepthTest { compare: Compare::Less, write: true };
    let mut depth = Depth::<F, D>::new(frame.core_region()?, &mut storage, test)?;
    let vertices = window_vertices::<F>(corners, z)?;
    draw(&vertices[..], &[0u16, 1, 2], 0, &frame.state()?, &mut depth)?;
    let far: u32 = D::FAR.into();
    let get = |(x, y)| depth.get(x, y).map(Into::into).filter(|&depth| depth != far);
    Ok(frame.pixels().map(get).collect())
}

/// At every covered sample the depth is the reference's specified one, bit for bit, and within the
/// bound of the exact rational. Returns the largest error, in units of the format.
pub fn is_specified_and_bounded<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    corners: &Corners,
    z: [u32; 3],
    spec: DepthSpec,
) -> Result<Fraction, Failure> {
    let grid = frame.grid::<F>()?;
    let covered = oracle::coverage::<F>(frame, corners)?;
    let z_spec = oracle::vertex_depths(z, spec);
    let planes =
        ExactPlane::new(corners, &z_spec, grid).zip(SpecifiedPlane::new(corners, &z_spec, grid, spec));
    let mut largest = fraction(0, 1)?;
    let (numerator, denominator) = spec.bound();
    // 16 fractional bits: the core's own statement about the format.
    let stated = fraction(i128::from(Bounds::<F>::MAX_DEPTH_ERROR_2_16), 1 << 16)?;
    let bound = fraction(numerator, denominator)?.min(stated);
    for ((pixel, given), covered) in frame.pixels().zip(drawn::<F, D>(frame, corners, z)?).zip(covered) {
        if !covered {
            ensure!(given.is_none(), "pixel {pixel:?} is not covered, but has a depth: {given:?}");
            continue;
        }
        let Some((exact, specified)) = &planes else {
            return Err(Failure::new("the reference covers a triangle without area"));
        };
        let expected = specified.at(pixel.0, pixel.1);
        ensure_eq!(given, Some(expected), "depth at pixel {pixel:?}");
        let error = exact
            .at(pixel.0, pixel.1)
            .distance_to(i128::from(expected))
            .ok_or_else(|| Failure::new("the error does not fit 128 bits"))?;
        ensure!(error <= bound, "pixel {pixel:?}: {expected} is {} units off", error.approximate());
        largest = largest.max(error);
    }
    Ok(largest)
}

/// [`is_specified_and_bounded`] of a triangle whose doubled area is 2^(`width` + `height`) square steps: each way to
/// divide by an area meets its ends.
pub fn of_a_power_of_two<F: Format, D: DepthFormat<F>>(
    [width, height]: [u32; 2],
    z: [u32; 3],
    spec: DepthSpec,
) -> Verdict {
    let frame = Frame::whole::<F>(8, 8);
    let corners = [[0, 0], [1 << width, 0], [0, 1 << height]];
    is_specified_and_bounded::<F, D>(&frame, &corners, z, spec)?;
    is_specified_and_bounded::<F, D>(&frame, &corners.map(|[x, y]| [y, x]), z, spec).map(|_| ())
}

/// The depth at covered samples is the definition's, evaluated word for word in unbounded integers.
pub fn equals_definition<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    corners: &Corners,
    z: [u32; 3],
    spec: DepthSpec,
) -> Verdict {
    let grid = frame.grid::<F>()?;
    let z_spec = oracle::vertex_depths(z, spec);
    let given = drawn::<F, D>(frame, corners, z)?;
    let covered: Vec<_> = frame.pixels().zip(given).filter(|(_, depth)| depth.is_some()).collect();
    // At most 64 samples, spread over all: unbounded integers are slow.
    for (pixel, depth) in covered.iter().step_by(covered.len() / 64 + 1) {
        let expected = specified_depth(corners, &z_spec, grid, spec, *pixel);
        ensure_eq!(*depth, expected, "depth at pixel {pixel:?}");
    }
    Ok(())
}

/// No order of the vertices changes a bit of the depth, or a covered sample.
pub fn does_not_depend_on_the_order<F: Format, D: DepthFormat<F>>(
    frame: &Frame,
    corners: &Corners,
    z: [u32; 3],
) -> Verdict {
    let first = drawn::<F, D>(frame, corners, z)?;
    for order in ORDERS {
        let other = drawn::<F, D>(frame, &order.map(|k| corners[k]), order.map(|k| z[k]))?;
        for ((pixel, a), b) in frame.pixels().zip(&first).zip(&other) {
            ensure_eq!(a, b, "pixel {pixel:?}, order {order:?}");
        }
    }
    Ok(())
}

fn fraction(numerator: i128, denominator: i128) -> Result<Fraction, Failure> {
    Fraction::new(numerator, denominator).ok_or_else(|| Failure::new("a denominator is not positive"))
}
