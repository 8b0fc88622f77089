//! One triangle in `f64`, with bounds of the errors: what decides nearly everything.
//!
//! Of a number that is computed, `f64` holds the result and the sum of the magnitudes of what was added up.
//! With u = 2^-53, a clip coordinate (four exact products, three sums) is off by at most 3 u of its magnitude,
//! a minor of two of them by 10 u of its, the product of minors with a sample (whole numbers, exact) by
//! 14 u, the determinant by 18 u, and the sum of three minors with depths by 20 u. Everywhere below the
//! bound is twice or more what it needs to be.

/// What is known of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sides {
    /// Covered, for certain.
    Inside,
    /// Not covered, for certain.
    Outside,
    /// Too near to say.
    Unknown,
}

const U: f64 = f64::EPSILON / 2.0;

/// A value, and the sum of the magnitudes of its terms.
#[derive(Clone, Copy, Debug)]
struct Sum {
    value: f64,
    size: f64,
}

impl Sum {
    fn product(self, other: Self) -> Self {
        Self { value: self.value * other.value, size: self.size * other.size }
    }

    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }

    fn minus(self, other: Self) -> Self {
        Self { value: self.value - other.value, size: self.size + other.size }
    }

    /// The sign where the error cannot change it.
    fn sign(self, bound: f64) -> Option<i32> {
        if self.value > bound * self.size {
            Some(1)
        } else if self.value < -bound * self.size {
            Some(-1)
        } else {
            None
        }
    }
}

/// A linear function of (x, y, w), and how far it may be off anywhere on the target.
#[derive(Clone, Copy, Debug)]
struct Linear {
    factors: [f64; 3],
    error: f64,
}

impl Linear {
    fn new(factors: [Sum; 3], largest: [f64; 3], bound: f64) -> Self {
        let size: f64 = factors.iter().zip(largest).map(|(factor, at)| factor.size * at).sum();
        Self { factors: factors.map(|factor| factor.value), error: bound * U * size }
    }

    #[inline]
    fn at(&self, [x, y, w]: [f64; 3]) -> f64 {
        self.factors[0] * x + self.factors[1] * y + self.factors[2] * w
    }

    fn turned(self) -> Self {
        Self { factors: self.factors.map(|factor| -factor), ..self }
    }
}

/// A triangle that may be seen.
#[derive(Clone, Debug)]
pub(super) struct Filter {
    /// `[x0, y0, x1, y1]`: no other pixel can be covered.
    pub(super) bounds: [u32; 4],
    edges: [Linear; 3],
    depth: Linear,
    sum: [f64; 3],
    determinant: Sum,
    /// The determinant times the sample's w.
    scale: f64,
    /// Bound of the error of a depth.
    depth_error: f64,
}

impl Filter {
    /// `None` where the corners are certainly all on one outer side of the view frustum.
    pub(super) fn new(
        corners: [[f32; 3]; 3],
        matrix: &[f32; 16],
        (width, height): (u32, u32),
    ) -> Option<Self> {
        let clip = corners.map(|corner| clip(corner, matrix));
        if is_outside(&clip) {
            return None;
        }
        let [a, b, c] = clip;
        let minors = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
        let [wide, high] = [width, height].map(f64::from);
        let largest = [wide * high; 3];
        let edges = minors.map(|minor| Linear::new(minor, largest, 32.0));
        let with = |v: [Sum; 3]| {
            minors[0][0].product(v[0]).plus(minors[0][1].product(v[1])).plus(minors[0][2].product(v[2]))
        };
        let determinant = with([a[0], a[1], a[3]]);
        let depths = [0, 1, 2].map(|k| {
            let part = |corner: usize| minors[corner][k].product(clip[corner][2]);
            part(0).plus(part(1)).plus(part(2))
        });
        let sum = [0, 1, 2].map(|k| minors[0][k].value + minors[1][k].value + minors[2][k].value);
        let depth = Linear::new(depths, largest, 48.0);
        let bounds = bounds(&clip, [wide, high]).map(|v| v as u32);
        let scale = determinant.value * wide * high;
        (bounds[0] < bounds[2] && bounds[1] < bounds[3]).then_some(Self {
            bounds,
            edges,
            depth,
            sum,
            determinant,
            scale,
            // Depths are at most 1, so the determinant's relative error is the depth's.
            depth_error: depth.error / scale.abs()
                + 40.0 * U * (1.0 + determinant.size / determinant.value.abs()),
        })
    }

    /// The determinant's sign, if it is certain.
    pub(super) fn orientation(&self) -> Option<i32> {
        self.determinant.sign(40.0 * U)
    }

    /// Makes all values positive inside, given the determinant's sign.
    pub(super) fn turn(&mut self, orientation: i32) {
        if orientation < 0 {
            self.edges = self.edges.map(Linear::turned);
            self.depth = self.depth.turned();
            self.sum = self.sum.map(|v| -v);
            self.scale = -self.scale;
        }
        if self.orientation().is_none() {
            // The value itself says nothing.
            self.depth_error = f64::INFINITY;
        }
    }

    #[inline]
    pub(super) fn covers(&self, at: [f64; 3]) -> Sides {
        let mut known = true;
        for edge in &self.edges {
            let value = edge.at(at);
            if value < -edge.error {
                return Sides::Outside;
            }
            known &= value > edge.error;
        }
        let (depth, error) = self.depth(at);
        if depth < -error || depth > 1.0 + error {
            return Sides::Outside;
        }
        known &= depth > error && depth < 1.0 - error;
        if known { Sides::Inside } else { Sides::Unknown }
    }

    /// z/w, and how far it may be off; a covered sample's is 0 to 1.
    #[inline]
    pub(super) fn depth(&self, at: [f64; 3]) -> (f64, f64) {
        (self.depth.at(at) / self.scale, self.depth_error)
    }

    /// 1/w.
    pub(super) fn inverse_w(&self, [x, y, w]: [f64; 3]) -> f64 {
        (self.sum[0] * x + self.sum[1] * y + self.sum[2] * w) / self.scale
    }
}

fn clip([x, y, z]: [f32; 3], m: &[f32; 16]) -> [Sum; 4] {
    [0, 1, 2, 3].map(|k| {
        let terms = [(x, m[k]), (y, m[4 + k]), (z, m[8 + k]), (1.0, m[12 + k])]
            .map(|(a, b)| f64::from(a) * f64::from(b));
        Sum { value: terms.iter().sum(), size: terms.iter().map(|term| term.abs()).sum() }
    })
}

/// Of the components x, y and w.
fn cross([ax, ay, _, aw]: &[Sum; 4], [bx, by, _, bw]: &[Sum; 4]) -> [Sum; 3] {
    let minor = |a: &Sum, b: &Sum, c: &Sum, d: &Sum| a.product(*b).minus(c.product(*d));
    [minor(ay, bw, aw, by), minor(aw, bx, ax, bw), minor(ax, by, ay, bx)]
}

/// Whether all corners are certainly outside one plane of the frustum.
fn is_outside(clip: &[[Sum; 4]; 3]) -> bool {
    let all =
        |beyond: &dyn Fn(&[Sum; 4]) -> Sum| clip.iter().all(|corner| beyond(corner).sign(8.0 * U) == Some(1));
    let zero = Sum { value: 0.0, size: 0.0 };
    all(&|[x, _, _, w]| x.minus(*w))
        || all(&|[x, _, _, w]| zero.minus(x.plus(*w)))
        || all(&|[_, y, _, w]| y.minus(*w))
        || all(&|[_, y, _, w]| zero.minus(y.plus(*w)))
        || all(&|[_, _, z, _]| zero.minus(*z))
        || all(&|[_, _, z, w]| z.minus(*w))
}

/// The pixels that can be covered: those of the corners' box and one more each way where all are in front of
/// the eye, else all.
fn bounds(clip: &[[Sum; 4]; 3], [width, height]: [f64; 2]) -> [f64; 4] {
    // In front by so much that a quotient is off by far less than a pixel.
    if !clip.iter().all(|[_, _, _, w]| w.value > w.size * 1e-9) {
        return [0.0, 0.0, width, height];
    }
    let mut bounds = [width, height, 0.0, 0.0];
    for [x, y, _, w] in clip {
        let at = [(x.value / w.value + 1.0) * 0.5 * width, (1.0 - y.value / w.value) * 0.5 * height];
        for axis in 0..2 {
            // w is off by less than 10^-6 of itself; the other coordinate counts in units of w.
            let off = 16.0 * U * [x, y][axis].size / w.value * f64::max(width, height);
            let slack = 2.0 + at[axis].abs() * 1e-6 + off;
            bounds[axis] = f64::min(bounds[axis], (at[axis] - slack).floor());
            bounds[axis + 2] = f64::max(bounds[axis + 2], (at[axis] + slack).ceil());
        }
    }
    [bounds[0].max(0.0), bounds[1].max(0.0), bounds[2].min(width), bounds[3].min(height)]
}
