//! Single triangles by kind.

use super::{
    Corners, bezout,
    numbers::{Random, pick},
};
use crate::Frame;
use halfplane::{Bounds, Format};

/// What is special about a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Within about a pixel.
    Tiny,
    /// About the size of a block.
    Small,
    /// About the size of the frame.
    Medium,
    /// Long, and a few steps thin.
    Sliver,
    /// Doubled area 1 or 2 square steps, a sample exactly on the outline.
    Bezout,
    /// A horizontal and a vertical edge, often through samples.
    AxisAligned,
    /// All corners on samples.
    OnSamples,
    /// Every edge through two samples, corners beyond.
    ThroughSamples,
    /// Corners on the lines between pixels.
    OnPixelEdges,
    /// An edge passes near the frame, its ends are as far away as they can be.
    GuardBand,
    /// Corners from the extremes of the guard band, the target and the frame.
    Extremes,
    /// Corners on one line.
    Collinear,
    /// Two or three equal corners.
    Duplicate,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 13] = [
        Self::Tiny,
        Self::Small,
        Self::Medium,
        Self::Sliver,
        Self::Bezout,
        Self::AxisAligned,
        Self::OnSamples,
        Self::ThroughSamples,
        Self::OnPixelEdges,
        Self::GuardBand,
        Self::Extremes,
        Self::Collinear,
        Self::Duplicate,
    ];
}

/// A triangle of that kind near a frame, chosen by any numbers; inside the guard band.
pub fn triangle<F: Format>(kind: Kind, frame: &Frame, numbers: [u32; 8]) -> Corners {
    let step = i64::from(Bounds::<F>::STEPS_PER_PIXEL);
    let guard = i64::from(Bounds::<F>::GUARD_BAND);
    let [a, b, c, d, e, f, g, h] = numbers;
    let scissor = frame.scissor;
    // A pixel in the scissor or one beside it; shapes are laid round its sample.
    let pixel =
        [pick(g, -1, i64::from(scissor[2] - scissor[0])), pick(h, -1, i64::from(scissor[3] - scissor[1]))];
    let corner = [0, 1].map(|axis| (i64::from(scissor[axis]) + pixel[axis]) * step);
    let sample = [0, 1].map(|axis| corner[axis] + i64::from(frame.sample[axis]));
    let add = |p: [i64; 2], q: [i64; 2]| [p[0] + q[0], p[1] + q[1]];
    let scaled = |p: [i64; 2], k: i64| p.map(|v| v * k);
    let around = |reach: i64| {
        [[a, b], [c, d], [e, f]].map(|[x, y]| add(sample, [pick(x, -reach, reach), pick(y, -reach, reach)]))
    };
    let on_grid = |origin: [i64; 2], pixels: i64| {
        [[a, b], [c, d], [e, f]]
            .map(|[x, y]| add(origin, [pick(x, -pixels, pixels) * step, pick(y, -pixels, pixels) * step]))
    };
    let corners = match kind {
        Kind::Tiny => around(step),
        Kind::Small => around(5 * step),
        Kind::Medium => around(i64::from(frame.width().max(frame.height())) * step),
        Kind::Sliver => {
            // The line passes within a few steps of a sample, or hardly any would cover one.
            let reach = 100 * step;
            let direction = [pick(a, -reach, reach), pick(b, -reach, reach)];
            let behind = direction.map(|v| -v * pick(c, 0, 1024) / 1024);
            let start = add(add(sample, behind), [pick(d, -2, 2), pick(d / 5, -2, 2)]);
            let along = direction.map(|v| v * pick(e, 0, 1024) / 1024);
            let thin = [pick(f, -3, 3), pick(f / 7, -3, 3)];
            [start, add(start, direction), add(add(start, along), thin)]
        }
        Kind::Bezout => bezout::from_numbers(sample, guard / 4, [a, b, c, d, e, f]),
        Kind::AxisAligned => {
            let reach = 12 * step;
            let snapped = |number: u32, to: i64| {
                let free = pick(number / 4, -reach, reach);
                // Often on the sample's line, in this pixel or in another.
                if number % 4 < 2 { to + free / step * step } else { to + free }
            };
            let (x0, x1) = (snapped(a, sample[0]), snapped(b, sample[0]));
            let (y0, y1) = (snapped(c, sample[1]), snapped(d, sample[1]));
            match e % 4 {
                0 => [[x0, y0], [x1, y0], [x0, y1]],
                1 => [[x0, y0], [x1, y0], [(x0 + x1) / 2, y1]],
                2 => [[x0, y0], [x0, y1], [x1, (y0 + y1) / 2]],
                _ => [[x0, y0], [x1, y0], [snapped(f, sample[0]), y1]],
            }
        }
        Kind::OnSamples => on_grid(sample, 12),
        Kind::OnPixelEdges => on_grid(corner, 12),
        Kind::ThroughSamples => {
            // Three samples, and a triangle whose edges pass through two of them each and go on.
            let [p, q, r] = on_grid(sample, 6);
            let beyond = |from: [i64; 2], to: [i64; 2], k: i64| add(to, scaled(add(to, scaled(from, -1)), k));
            [beyond(q, p, pick(f, 0, 3)), beyond(p, q, pick(f / 5, 0, 3)), beyond(p, r, pick(f / 25, 0, 3))]
        }
        Kind::GuardBand => {
            let direction = [pick(a, -guard, guard), pick(b, -guard, guard)];
            let through = add(sample, [pick(c, -2 * step, 2 * step), pick(d, -2 * step, 2 * step)]);
            [
                add(through, direction),
                add(through, scaled(direction, -1)),
                [pick(e, -guard, guard), pick(f, -guard, guard)],
            ]
        }
        Kind::Extremes => {
            let end = i64::from(F::MAX_TARGET) * step;
            let [x0, y0, x1, y1] = scissor.map(|v| i64::from(v) * step);
            let table = [
                sample,
                corner,
                [x0, y0],
                [x1, y1],
                [0; 2],
                [guard; 2],
                [-guard; 2],
                [guard - 1; 2],
                [1 - guard; 2],
                [end; 2],
                [end - 1; 2],
                [end + 1; 2],
                [1; 2],
                [-1; 2],
                [x1 - 1, y1 - 1],
                [x0 + 1, y0 + 1],
            ];
            let extreme = |number: u32, axis: usize| table[number as usize % table.len()][axis];
            [[extreme(a, 0), extreme(b, 1)], [extreme(c, 0), extreme(d, 1)], [extreme(e, 0), extreme(f, 1)]]
        }
        Kind::Collinear => {
            let direction = [pick(a, -step, step), pick(b, -step, step)];
            let [i, j, k] = [c, d, e].map(|number| scaled(direction, pick(number, -9, 9)));
            [add(sample, i), add(sample, j), add(sample, k)]
        }
        Kind::Duplicate => {
            let [p, q, _] = around(12 * step);
            match e % 4 {
                0 => [p, p, q],
                1 => [p, q, p],
                2 => [q, p, p],
                _ => [p, p, p],
            }
        }
    };
    bezout::clamped::<F>(corners)
}

impl Random {
    /// A triangle of any kind.
    pub fn triangle<F: Format>(&mut self, frame: &Frame) -> (Kind, Corners) {
        let kind = Kind::ALL[self.below(Kind::ALL.len())];
        (kind, triangle::<F>(kind, frame, self.words()))
    }
}
