//! The bricks of the built-in scene: quads, boxes, turned solids and grids, placed in a local frame.
//!
//! Left-handed, y up. Corners run clockwise as seen from outside, so `(b - a) x (c - a)` points out.
//! Everything is computed in `f64` with operations whose results are the same on every machine, and
//! rounded once to the `f32` of a vertex.

use glam::DVec3;

use crate::mesh::Mesh;

/// Where and which way round a part stands: an origin and a turn about the vertical.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    origin: DVec3,
    cos: f64,
    sin: f64,
}

impl Frame {
    /// The scene's own axes.
    pub(super) const WORLD: Self = Self { origin: DVec3::ZERO, cos: 1.0, sin: 0.0 };

    /// At `origin`, with the local x axis along `(direction.x, direction.z)`.
    pub(super) fn new(origin: DVec3, along: (f64, f64)) -> Self {
        let length = (along.0 * along.0 + along.1 * along.1).sqrt();
        Self { origin, cos: along.0 / length, sin: along.1 / length }
    }

    fn place(&self, p: DVec3) -> DVec3 {
        let x = p.x * self.cos - p.z * self.sin;
        let z = p.x * self.sin + p.z * self.cos;
        self.origin + DVec3::new(x, p.y, z)
    }
}

/// A mesh that grows part by part.
#[derive(Debug)]
pub(super) struct Builder {
    mesh: Mesh,
    frame: Frame,
}

impl Builder {
    pub(super) fn new() -> Self {
        Self { mesh: Mesh::default(), frame: Frame::WORLD }
    }

    pub(super) fn finish(self) -> Mesh {
        self.mesh
    }

    /// Places everything that follows.
    pub(super) fn at(&mut self, frame: Frame) -> &mut Self {
        self.frame = frame;
        self
    }

    fn vertex(&mut self, p: DVec3) -> u32 {
        let index = self.mesh.positions.len() as u32;
        self.mesh.positions.push(self.frame.place(p).as_vec3().to_array());
        index
    }

    fn face(&mut self, corners: [u32; 3], surface: u8) {
        self.mesh.indices.extend(corners);
        self.mesh.surface_of.push(surface);
    }

    pub(super) fn triangle(&mut self, corners: [DVec3; 3], surface: u8) {
        let corners = corners.map(|p| self.vertex(p));
        self.face(corners, surface);
    }

    pub(super) fn quad(&mut self, corners: [DVec3; 4], surface: u8) {
        let [a, b, c, d] = corners.map(|p| self.vertex(p));
        self.face([a, b, c], surface);
        self.face([a, c, d], surface);
    }

    /// An axis-aligned box.
    pub(super) fn block(&mut self, min: DVec3, max: DVec3, surface: u8) {
        let p = |x: usize, y: usize, z: usize| {
            let ends = [min, max];
            DVec3::new(ends[x].x, ends[y].y, ends[z].z)
        };
        self.quad([p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0)], surface);
        self.quad([p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)], surface);
        self.quad([p(1, 0, 1), p(1, 1, 1), p(0, 1, 1), p(0, 0, 1)], surface);
        self.quad([p(0, 0, 1), p(0, 1, 1), p(0, 1, 0), p(0, 0, 0)], surface);
        self.quad([p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)], surface);
        self.quad([p(0, 0, 1), p(0, 0, 0), p(1, 0, 0), p(1, 0, 1)], surface);
    }

    /// A solid turned about the vertical through `base`: `profile` lists radius and height from the
    /// bottom up, `groove` scales the radius of every second edge (a column's flutes).
    pub(super) fn turned(
        &mut self,
        base: DVec3,
        profile: &[(f64, f64)],
        sides: u32,
        groove: f64,
        surface: u8,
    ) {
        let circle = circle(sides);
        let mut below: Option<Vec<u32>> = None;
        for &(radius, height) in profile {
            let ring: Vec<u32> = circle
                .iter()
                .enumerate()
                .map(|(k, &(cos, sin))| {
                    let r = if k % 2 == 1 { radius * groove } else { radius };
                    self.vertex(base + DVec3::new(r * cos, height, r * sin))
                })
                .collect();
            if let Some(below) = &below {
                for k in 0..ring.len() {
                    let next = (k + 1) % ring.len();
                    self.face([below[k], ring[next], below[next]], surface);
                    self.face([below[k], ring[k], ring[next]], surface);
                }
            }
            below = Some(ring);
        }
        if let (Some(ring), Some(&(radius, height))) = (below, profile.last())
            && radius > 0.0
        {
            let hub = self.vertex(base + DVec3::new(0.0, height, 0.0));
            for k in 0..ring.len() {
                self.face([hub, ring[(k + 1) % ring.len()], ring[k]], surface);
            }
        }
    }

    /// A sheet of `columns` x `rows` cells with shared vertices; `surface` is asked with each
    /// triangle's corners.
    pub(super) fn sheet(
        &mut self,
        (columns, rows): (u32, u32),
        point: impl Fn(u32, u32) -> DVec3,
        surface: impl Fn([DVec3; 3]) -> u8,
    ) {
        let mut grid = Vec::new();
        for j in 0..=rows {
            for i in 0..=columns {
                let p = point(i, j);
                grid.push((p, self.vertex(p)));
            }
        }
        let at = |i: u32, j: u32| grid[(j * (columns + 1) + i) as usize];
        for j in 0..rows {
            for i in 0..columns {
                let (a, b) = (at(i, j), at(i, j + 1));
                let (d, c) = (at(i + 1, j), at(i + 1, j + 1));
                for [p, q, r] in [[a, b, c], [a, c, d]] {
                    self.face([p.1, q.1, r.1], surface([p.0, q.0, r.0]));
                }
            }
        }
    }

    /// A round arch seen from -z: a ring from radius `inner` to `outer` about `(centre.x, centre.y)`,
    /// `depth` thick from `centre.z` on, over the part of the half circle from `from` to `to`, where
    /// 0 is its right foot and 1 its left.
    pub(super) fn arch(
        &mut self,
        centre: DVec3,
        (inner, outer): (f64, f64),
        depth: f64,
        (from, to, stones): (f64, f64, u32),
        surface: impl Fn(u32) -> u8,
    ) {
        let at = |k: u32, r: f64, z: f64| {
            let part = from + (to - from) * f64::from(k) / f64::from(stones);
            let (sin, cos) = libm::sincos(core::f64::consts::PI * part);
            centre + DVec3::new(r * cos, r * sin, z)
        };
        for k in 0..stones {
            let s = surface(k);
            let corner = |end: u32, r: f64, z: f64| at(k + end, r, z);
            self.quad(
                [corner(0, inner, 0.0), corner(1, inner, 0.0), corner(1, outer, 0.0), corner(0, outer, 0.0)],
                s,
            );
            self.quad(
                [
                    corner(0, outer, depth),
                    corner(1, outer, depth),
                    corner(1, inner, depth),
                    corner(0, inner, depth),
                ],
                s,
            );
            self.quad(
                [
                    corner(0, inner, depth),
                    corner(1, inner, depth),
                    corner(1, inner, 0.0),
                    corner(0, inner, 0.0),
                ],
                s,
            );
            self.quad(
                [
                    corner(0, outer, 0.0),
                    corner(1, outer, 0.0),
                    corner(1, outer, depth),
                    corner(0, outer, depth),
                ],
                s,
            );
        }
        for (k, flip) in [(0, false), (stones, true)] {
            let mut end = [at(k, inner, 0.0), at(k, outer, 0.0), at(k, outer, depth), at(k, inner, depth)];
            if flip {
                end.reverse();
            }
            self.quad(end, surface(k.min(stones - 1)));
        }
    }
}

/// The unit circle in `sides` steps.
pub(super) fn circle(sides: u32) -> Vec<(f64, f64)> {
    let step = core::f64::consts::TAU / f64::from(sides);
    (0..sides)
        .map(|k| {
            let (sin, cos) = libm::sincos(step * f64::from(k));
            (cos, sin)
        })
        .collect()
}
