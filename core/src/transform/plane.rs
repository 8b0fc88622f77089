//! The planes that clip-space vertices are tested against.

/// The smallest w that is divided by; smaller ones are clipped.
const MIN_W: f32 = f32::MIN_POSITIVE;

/// A half-space of clip space. Whether a vertex is outside is decided in `f32`, the same way wherever
/// the vertex occurs, so that two triangles agree about the vertices they share.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Plane {
    /// z >= 0.
    Near,
    /// z <= w.
    Far,
    /// w >= the smallest normal float.
    Eye,
    /// x >= k w.
    Left(f32),
    /// x <= k w.
    Right(f32),
    /// y <= k w.
    Top(f32),
    /// y >= k w.
    Bottom(f32),
}

impl Plane {
    /// The planes to clip at, `guard_band` as from [`Viewport`](super::Viewport), in the order that
    /// they are applied.
    #[inline]
    pub(crate) const fn clipping([left, right, top, bottom]: [f32; 4]) -> [Self; 7] {
        [
            Self::Near,
            Self::Far,
            Self::Eye,
            Self::Left(left),
            Self::Right(right),
            Self::Top(top),
            Self::Bottom(bottom),
        ]
    }

    /// The planes of the view frustum: a triangle wholly outside one of them is not visible.
    #[cfg(feature = "simd")]
    pub(crate) const FRUSTUM: [Self; 7] = [
        Self::Near,
        Self::Far,
        Self::Eye,
        Self::Left(-1.0),
        Self::Right(1.0),
        Self::Top(1.0),
        Self::Bottom(-1.0),
    ];

    /// Whether a vertex is finite and no plane of [`FRUSTUM`](Self::FRUSTUM) excludes it.
    #[inline]
    pub(crate) fn frustum_has([x, y, z, w]: [f32; 4]) -> bool {
        // No branch but at the end. A NaN makes one of these false, and so does an infinity.
        (x.abs() <= w) & (y.abs() <= w) & (z >= 0.0) & (z <= w) & (MIN_W..=f32::MAX).contains(&w)
    }

    /// Where a vertex is beside the view frustum: a bit for each plane of [`FRUSTUM`](Self::FRUSTUM) that
    /// [excludes](Self::excludes) it, two to a component.
    #[inline]
    pub(crate) fn beside_frustum(vertex: [f32; 4]) -> [u32; 4] {
        let [_, _, _, w] = vertex;
        let (lowest, highest) = ([-w, -w, 0.0, MIN_W], [w, w, w, f32::INFINITY]);
        let mut beside = [0; 4];
        for (beside, (v, (lowest, highest))) in
            beside.iter_mut().zip(vertex.into_iter().zip(lowest.into_iter().zip(highest)))
        {
            *beside = u32::from(v < lowest) | u32::from(v > highest) << 1;
        }
        beside
    }

    /// Whether a finite vertex is outside.
    #[inline]
    pub(crate) fn excludes(self, [x, y, z, w]: [f32; 4]) -> bool {
        match self {
            Self::Near => z < 0.0,
            Self::Far => z > w,
            Self::Eye => w < MIN_W,
            Self::Left(k) => x < k * w,
            Self::Right(k) => x > k * w,
            Self::Top(k) => y > k * w,
            Self::Bottom(k) => y < k * w,
        }
    }

    /// A vertex's distance from the plane, to scale, positive inside. Products of two floats are
    /// exact in `f64`.
    fn distance(self, [x, y, z, w]: [f64; 4]) -> f64 {
        match self {
            Self::Near => z,
            Self::Far => w - z,
            Self::Eye => w - f64::from(MIN_W),
            Self::Left(k) => x - f64::from(k) * w,
            Self::Right(k) => f64::from(k) * w - x,
            Self::Top(k) => f64::from(k) * w - y,
            Self::Bottom(k) => y - f64::from(k) * w,
        }
    }

    /// Where the plane cuts the edge from a vertex inside to one outside. Always computed in this
    /// direction, so the triangles on both sides of an edge get the same vertex.
    pub(crate) fn cut(self, inside: [f32; 4], outside: [f32; 4]) -> [f32; 4] {
        let (a, b) = (inside.map(f64::from), outside.map(f64::from));
        // Both weights are positive: rounding in `excludes` can disagree with `distance` on a vertex at
        // the plane. So components of one sign keep it, w above all.
        let (near, far) = (self.distance(a).max(0.0), (-self.distance(b)).max(0.0));
        let sum = near + far;
        if sum <= 0.0 {
            return inside;
        }
        let mut cut = [0.0; 4];
        for (cut, (a, b)) in cut.iter_mut().zip(a.into_iter().zip(b)) {
            *cut = ((near * b + far * a) / sum) as f32;
        }
        let [x, y, z, w] = cut;
        match self {
            Self::Near => [x, y, 0.0, w],
            Self::Far => [x, y, w, w],
            Self::Eye => [x, y, z, MIN_W],
            Self::Left(k) | Self::Right(k) => [k * w, y, z, w],
            Self::Top(k) | Self::Bottom(k) => [x, k * w, z, w],
        }
    }
}
