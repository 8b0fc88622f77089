//! What a set-up triangle and a mask say of themselves, against the definitions.

use crate::{Frame, ensure, ensure_eq, failure::Verdict, frame::window_vertices, shapes::Corners};
use halfplane::{Format, Mask, Region, Triangle, Winding, geometry::is_outside, traverse};

/// Twice the signed area of three points in steps.
fn doubled_area([[ax, ay], [bx, by], [cx, cy]]: [[i64; 2]; 3]) -> i64 {
    (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
}

/// Order, winding, area, edges and weights of a triangle; a walk says whether it visited anything.
pub fn of_triangle<F: Format>(frame: &Frame, corners: &Corners, z: [u32; 3]) -> Verdict {
    let submitted = window_vertices::<F>(corners, z)?;
    let corners = corners.map(|corner| corner.map(i64::from));
    let area = doubled_area(corners);
    let [x0, y0, x1, y1] = frame.scissor;
    let scissor = Region::new(x0, y0, x1, y1)?;
    let apart = |axis: usize, first: u32, end: u32| {
        let [first, end] = [first, end].map(|pixel| i64::from(pixel) << F::SUBPIXEL_BITS);
        corners.iter().all(|corner| corner[axis] <= first) || corners.iter().all(|corner| corner[axis] >= end)
    };
    ensure_eq!(is_outside(submitted, scissor), apart(0, x0, x1) || apart(1, y0, y1), "outside the scissor");
    let Some(triangle) = Triangle::new(submitted, frame.core_sample()?) else {
        ensure_eq!(area, 0, "the area of a triangle that is none");
        return Ok(());
    };
    let winding = if area > 0 { Winding::Clockwise } else { Winding::CounterClockwise };
    ensure_eq!(
        (triangle.winding(), triangle.doubled_area().into()),
        (winding, area.abs()),
        "winding and area"
    );
    ensure_eq!(triangle.sample(), frame.core_sample()?, "sample");

    let (vertices, order) = (triangle.vertices(), triangle.order().map(usize::from));
    let mut sorted = order;
    sorted.sort_unstable();
    ensure_eq!(sorted, [0, 1, 2], "the order has each vertex once");
    ensure_eq!(vertices, order.map(|k| submitted[k]), "vertices in canonical order");
    let key = |k: usize| (vertices[k].y(), vertices[k].x());
    ensure!(key(0) <= key(1) && key(0) <= key(2), "the first vertex is not the topmost: {vertices:?}");
    let canonical = vertices.map(|v| [v.x().into(), v.y().into()]);
    ensure_eq!(doubled_area(canonical), area.abs(), "the canonical order is clockwise");

    for (k, edge) in triangle.edges().into_iter().enumerate() {
        let [[ax, ay], [bx, by]] = [canonical[(k + 1) % 3], canonical[(k + 2) % 3]];
        ensure_eq!((i64::from(edge.a()), i64::from(edge.b())), (ay - by, bx - ax), "edge {k}");
        // A left edge goes up, a top edge to the right, with the inside on its right hand.
        ensure_eq!(edge.is_top_left(), by < ay || by == ay && bx > ax, "the kind of edge {k}");
    }

    let [x0, y0, x1, y1] = frame.region;
    for (column, row) in [(x0, y0), (x1 - 1, y0), (x0, y1 - 1), ((x0 + x1) / 2, (y0 + y1) / 2)] {
        let sample = frame.sample_at::<F>((column, row));
        let expected = [0, 1, 2].map(|k| {
            let mut with_sample = corners;
            with_sample[k] = sample;
            doubled_area(with_sample) * area.signum()
        });
        let given = triangle.weights(column, row).map(|weights| weights.map(Into::into));
        ensure_eq!(given, Some(expected), "weights at ({column}, {row})");
    }
    let last = F::MAX_TARGET - 1;
    ensure!(triangle.weights(last, last).is_some(), "no weights at the last pixel");
    ensure_eq!(triangle.weights(last + 1, 0), None, "weights right of the largest target");
    ensure_eq!(triangle.weights(0, last + 1), None, "weights below the largest target");

    let mut blocks = Vec::new();
    let any = traverse(&triangle, scissor, |x, y, mask| blocks.push((x, y, mask)));
    ensure_eq!(any, !blocks.is_empty(), "whether a block was visited");
    ensure!(blocks.iter().all(|(_, _, mask)| !mask.is_empty()), "a block without a sample");
    let mut places: Vec<(u32, u32)> = blocks.iter().map(|&(x, y, _)| (x, y)).collect();
    places.sort_unstable();
    places.dedup();
    ensure_eq!(places.len(), blocks.len(), "each block once");
    ensure!(places.iter().all(|&(x, y)| x % 4 == 0 && y % 4 == 0), "a block beside the grid");
    Ok(())
}

/// What two regions have in common, and whether one is in the other.
pub fn of_regions<F: Format>([a, b]: [[u32; 4]; 2]) -> Verdict {
    let region = |[x0, y0, x1, y1]: [u32; 4]| Region::<F>::new(x0, y0, x1, y1);
    let common = [a[0].max(b[0]), a[1].max(b[1]), a[2].min(b[2]), a[3].min(b[3])];
    let (one, other) = (region(a)?, region(b)?);
    ensure_eq!((one.width(), one.height()), (a[2] - a[0], a[3] - a[1]), "size of {a:?}");
    ensure_eq!(one.intersect(other), region(common).ok(), "what {a:?} and {b:?} have in common");
    ensure_eq!(one.contains(other), common == b, "whether {a:?} contains {b:?}");
    Ok(())
}

/// A mask's cells, one by one and together.
pub fn of_mask(bits: u16, other: u16) -> Verdict {
    let mask = Mask(bits);
    let set = |column: u32, row: u32| column < 4 && row < 4 && bits >> (4 * row + column) & 1 == 1;
    let cells: Vec<(u32, u32)> =
        (0..4).flat_map(|row| (0..4).map(move |column| (column, row))).filter(|&(x, y)| set(x, y)).collect();
    ensure_eq!(mask.cells().collect::<Vec<_>>(), cells, "cells of {mask:?}");
    ensure_eq!(
        (mask.count() as usize, mask.is_empty()),
        (cells.len(), cells.is_empty()),
        "count of {mask:?}"
    );
    for (column, row) in (0..6).flat_map(|row| (0..6).map(move |column| (column, row))) {
        ensure_eq!(mask.has(column, row), set(column, row), "({column}, {row}) of {mask:?}");
    }
    ensure_eq!(mask.and(Mask(other)), Mask(bits & other), "{mask:?} and {other:#x}");
    Ok(())
}
