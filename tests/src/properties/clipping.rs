//! Clipped triangles: watertight against their neighbours, and where the exact ones are.

use super::outline::{Outline, Side, tolerance};
use crate::{
    Failure, Frame,
    double::Overdraw,
    ensure, ensure_eq,
    failure::Verdict,
    shapes::{Corners, Ground, doubled_area},
};
use halfplane::{Assembly, ClipPositions, Format, Positions, Region, Viewport, draw};

/// The window pieces that the core makes of a clip-space triangle.
pub fn pieces<F: Format>(triangle: &[[f32; 4]; 3], viewport: Viewport<F>) -> (Assembly, Vec<Corners>) {
    let mut pieces = Vec::new();
    let positions = ClipPositions::new(triangle, viewport);
    let assembly = positions.assemble([0, 1, 2], |piece| pieces.push(piece.map(|v| [v.x(), v.y()])));
    (assembly, pieces)
}

/// The core's and the reference's viewport of a frame.
pub fn viewports<F: Format>(frame: &Frame) -> Result<(Viewport<F>, halfplane_reference::Viewport), Failure> {
    let [x0, y0, x1, y1] = frame.region;
    let exact = halfplane_reference::Viewport { x: x0.into(), y: y0.into(), width: x1 - x0, height: y1 - y0 };
    Ok((Viewport::new(Region::new(x0, y0, x1, y1)?), exact))
}

/// Counts how often clip-space triangles cover each sample of a frame.
pub fn counted<F: Format>(
    frame: &Frame,
    vertices: &[[f32; 4]],
    triangles: &[[u32; 3]],
) -> Result<Overdraw, Failure> {
    let (viewport, _) = viewports::<F>(frame)?;
    let mut counts = Overdraw::new(*frame);
    let positions = ClipPositions::new(vertices, viewport);
    draw(&positions, triangles.as_flattened(), 0, &frame.state()?, &mut counts)?;
    Ok(counts)
}

/// A mesh in a plane that crosses near plane and guard band has no seam: samples inside the exact
/// clipped outline are covered once, those outside never.
///
/// Snapping can turn a triangle that is thinner than a step over, and then it covers what its
/// neighbours cover: so triangles count by their winding, clockwise less counter-clockwise, and that sum
/// is exactly 1 (or -1, seen from behind) at every sample inside, whatever was turned over.
pub fn mesh_has_no_seam<F: Format>(frame: &Frame, ground: &Ground) -> Verdict {
    let (_, exact) = viewports::<F>(frame)?;
    let [a, b, c, d] = ground.corners;
    let Some(outline) = Outline::of(&[[a, b, c], [a, c, d]], exact)? else { return Ok(()) };
    let counts = counted::<F>(frame, &ground.vertices, &ground.triangles)?;
    let mut facing = 0;
    for pixel in frame.pixels() {
        let signed = counts.signed(pixel);
        match outline.side(in_pixels::<F>(frame, pixel), tolerance::<F>()) {
            Side::Inside => {
                facing = if facing == 0 { signed } else { facing };
                ensure!(
                    signed.abs() == 1 && signed == facing,
                    "pixel {pixel:?} inside is covered {signed} times, others {facing}\n{}",
                    counts.picture()
                );
            }
            Side::Outside => {
                ensure!(
                    signed == 0,
                    "pixel {pixel:?} outside is covered {signed} times\n{}",
                    counts.picture()
                );
            }
            Side::Close => {}
        }
    }
    Ok(())
}

/// A triangle is drawn where its exactly clipped form is, each sample once.
pub fn triangle_is_where_the_exact_one_is<F: Format>(frame: &Frame, triangle: &[[f32; 4]; 3]) -> Verdict {
    let (viewport, exact) = viewports::<F>(frame)?;
    let Some(outline) = Outline::of(&[*triangle], exact)? else { return Ok(()) };
    let counts = counted::<F>(frame, triangle, &[[0, 1, 2]])?;
    for pixel in frame.pixels() {
        let count = counts.count(pixel);
        match outline.side(in_pixels::<F>(frame, pixel), tolerance::<F>()) {
            Side::Inside => ensure_eq!(count, 1, "pixel {pixel:?} inside\n{}", counts.picture()),
            Side::Outside => ensure_eq!(count, 0, "pixel {pixel:?} outside\n{}", counts.picture()),
            Side::Close => {}
        }
    }
    let (_, pieces) = pieces(triangle, viewport);
    if pieces.iter().all(|piece| doubled_area(piece) > 0)
        || pieces.iter().all(|piece| doubled_area(piece) < 0)
    {
        counts.verdict()?;
    }
    Ok(())
}

/// The pieces of one clipped triangle have one winding, unless its snapped outline crosses itself.
///
/// For two pieces with a common side, a quadrilateral, that is decided exactly: a piece of the other
/// winding with a corner strictly inside the other piece means that it was cut along the wrong diagonal.
pub fn pieces_have_one_winding<F: Format>(frame: &Frame, triangle: &[[f32; 4]; 3]) -> Verdict {
    let (viewport, _) = viewports::<F>(frame)?;
    let (assembly, pieces) = pieces(triangle, viewport);
    if assembly == Assembly::Whole {
        ensure_eq!(pieces.len(), 1, "pieces of a triangle that is not clipped");
    }
    ensure!(pieces.len() <= 8, "{} pieces: ten corners are the most there are", pieces.len());
    if let [first, second] = &pieces[..] {
        let (a, b) = (doubled_area(first), doubled_area(second));
        ensure!(a != 0 && b != 0, "a piece without area among {pieces:?}");
        let shared = first.iter().filter(|corner| second.contains(corner)).count();
        if (a < 0) != (b < 0) && shared == 2 {
            for (one, other) in [(first, second), (second, first)] {
                let inside = other.iter().any(|&corner| strictly_inside(one, corner));
                ensure!(!inside, "cut along the wrong diagonal: {pieces:?}");
            }
        }
    }
    Ok(())
}

/// Two triangles (a, b, c) and (b, a, d) of which only a is in front of the near plane meet in the
/// same two window vertices: a, and the point where the plane cuts their common edge.
pub fn neighbours_share_their_cut<F: Format>(frame: &Frame, [a, b, c, d]: [[f32; 4]; 4]) -> Verdict {
    let (viewport, _) = viewports::<F>(frame)?;
    let (_, first) = pieces(&[a, b, c], viewport);
    let (_, second) = pieces(&[b, a, d], viewport);
    if let ([first], [second]) = (&first[..], &second[..]) {
        let shared = first.iter().filter(|corner| second.contains(corner)).count();
        ensure!(shared >= 2, "neighbours do not share an edge: {first:?} and {second:?}");
    }
    Ok(())
}

fn strictly_inside(triangle: &Corners, point: [i32; 2]) -> bool {
    let [a, b, c] = *triangle;
    let sign = doubled_area(triangle).signum();
    [[a, b, point], [b, c, point], [c, a, point]].iter().all(|t| doubled_area(t).signum() == sign)
}

fn in_pixels<F: Format>(frame: &Frame, pixel: (u32, u32)) -> [f64; 2] {
    frame.sample_at::<F>(pixel).map(|v| v as f64 / f64::from(1u32 << F::SUBPIXEL_BITS))
}
