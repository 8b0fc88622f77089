//! The snapped corners of sixteen triangles, from the vertex stage's records to lanes.

use crate::{draw::Index, geometry::Vertex, numbers::Standard};
use fearless_simd::{Simd, i32x16, mask32x16, prelude::*, u32x4, u32x16, u64x2};

/// The vertex stage's output: x and y in steps, and z as unorm32, apart.
#[derive(Clone, Copy)]
pub(super) struct Records<'a> {
    pub(super) places: &'a [[u32; 2]],
    pub(super) depths: &'a [u32],
}

/// One corner of sixteen triangles: x and y in steps.
#[derive(Clone, Copy)]
pub(super) struct Corner<S: Simd> {
    pub(super) x: i32x16<S>,
    pub(super) y: i32x16<S>,
}

impl<S: Simd> Corner<S> {
    #[inline(always)]
    pub(super) fn select(mask: mask32x16<S>, yes: Self, no: Self) -> Self {
        Self { x: mask.select(yes.x, no.x), y: mask.select(yes.y, no.y) }
    }
}

/// Where the first, second or third corners of sixteen triangles are.
#[inline(always)]
fn places<const K: usize, I: Index>(triangles: &[[I; 3]; 16]) -> [usize; 16] {
    let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = triangles;
    [
        a[K].to_usize(),
        b[K].to_usize(),
        c[K].to_usize(),
        d[K].to_usize(),
        e[K].to_usize(),
        f[K].to_usize(),
        g[K].to_usize(),
        h[K].to_usize(),
        i[K].to_usize(),
        j[K].to_usize(),
        k[K].to_usize(),
        l[K].to_usize(),
        m[K].to_usize(),
        n[K].to_usize(),
        o[K].to_usize(),
        p[K].to_usize(),
    ]
}

impl Records<'_> {
    /// The corners of sixteen triangles; `None` where an index names no vertex.
    #[inline(always)]
    pub(super) fn corners<S: Simd, I: Index>(
        &self,
        simd: S,
        triangles: &[[I; 3]; 16],
    ) -> Option<[Corner<S>; 3]> {
        Some([
            self.corner(simd, places::<0, I>(triangles))?,
            self.corner(simd, places::<1, I>(triangles))?,
            self.corner(simd, places::<2, I>(triangles))?,
        ])
    }

    /// Their depths.
    #[inline(always)]
    pub(super) fn corner_depths<S: Simd, I: Index>(
        &self,
        simd: S,
        triangles: &[[I; 3]; 16],
    ) -> Option<[u32x16<S>; 3]> {
        Some([
            self.depths(simd, places::<0, I>(triangles))?,
            self.depths(simd, places::<1, I>(triangles))?,
            self.depths(simd, places::<2, I>(triangles))?,
        ])
    }

    /// The corners of one triangle; `None` where one has no place in the window, or there is none.
    #[inline]
    pub(super) fn vertices(&self, [a, b, c]: [usize; 3]) -> Option<[Vertex<Standard>; 3]> {
        Some([self.vertex(a)?, self.vertex(b)?, self.vertex(c)?])
    }

    #[inline]
    fn vertex(&self, at: usize) -> Option<Vertex<Standard>> {
        let &[x, y] = self.places.get(at)?;
        Vertex::new(x as i32, y as i32, *self.depths.get(at)?).ok()
    }

    #[inline(always)]
    fn corner<S: Simd>(&self, simd: S, at: [usize; 16]) -> Option<Corner<S>> {
        let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = at;
        let (x0, y0) = self.four(simd, [a, b, c, d])?;
        let (x1, y1) = self.four(simd, [e, f, g, h])?;
        let (x2, y2) = self.four(simd, [i, j, k, l])?;
        let (x3, y3) = self.four(simd, [m, n, o, p])?;
        Some(Corner { x: join(simd, [x0, x1, x2, x3]), y: join(simd, [y0, y1, y2, y3]) })
    }

    /// x and y of four vertices.
    #[inline(always)]
    fn four<S: Simd>(&self, simd: S, [a, b, c, d]: [usize; 4]) -> Option<(u32x4<S>, u32x4<S>)> {
        let low: u32x4<S> = u64x2::simd_from(simd, [self.place(a)?, self.place(b)?]).bitcast();
        let high: u32x4<S> = u64x2::simd_from(simd, [self.place(c)?, self.place(d)?]).bitcast();
        Some((low.unzip_low(high), low.unzip_high(high)))
    }

    /// x in the lower half, y in the upper one.
    #[inline(always)]
    fn place(&self, at: usize) -> Option<u64> {
        let &[x, y] = self.places.get(at)?;
        Some(u64::from(x) | u64::from(y) << 32)
    }

    #[inline(always)]
    fn depths<S: Simd>(&self, simd: S, at: [usize; 16]) -> Option<u32x16<S>> {
        let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = at;
        let z = self.depths;
        Some(u32x16::simd_from(
            simd,
            [
                *z.get(a)?,
                *z.get(b)?,
                *z.get(c)?,
                *z.get(d)?,
                *z.get(e)?,
                *z.get(f)?,
                *z.get(g)?,
                *z.get(h)?,
                *z.get(i)?,
                *z.get(j)?,
                *z.get(k)?,
                *z.get(l)?,
                *z.get(m)?,
                *z.get(n)?,
                *z.get(o)?,
                *z.get(p)?,
            ],
        ))
    }
}

#[inline(always)]
fn join<S: Simd>(simd: S, [a, b, c, d]: [u32x4<S>; 4]) -> i32x16<S> {
    simd.combine_u32x8(simd.combine_u32x4(a, b), simd.combine_u32x4(c, d)).bitcast()
}
