//! All depth planes at once, judged by the exact one.

use halfplane::{
    Attachment, Block, Compare, D16, D32, Depth, DepthFormat, DepthTest, Mask, Region, Standard, State,
    Triangle, texels,
};
use halfplane_reference::ExactPlane;

use crate::statistics::Errors;
use crate::textbook::{Barycentric32, ExactRational, Gradient32, Gradient64, Plane, exact_plane};

/// Every plane at every covered sample, against the exact depth.
#[derive(Debug)]
pub struct Judge {
    depth32: Vec<u32>,
    depth16: Vec<u16>,
    region: Region<Standard>,
    exact: Option<ExactPlane>,
    planes: Option<(Barycentric32, Gradient32, Gradient64, ExactRational)>,
    errors: [Errors; 6],
}

impl Judge {
    /// Errors in units of 2^-32, of this crate's 32 and 16 bits and of the textbooks' planes: `f32` barycentric, `f32`
    /// gradient, `f64` gradient, exact rational.
    #[must_use]
    pub fn errors(&self) -> [Errors; 6] {
        self.errors
    }

    /// For a picture that is the state's scissor.
    #[must_use]
    pub fn new(state: State<Standard>) -> Self {
        let region = state.scissor;
        let texels = texels(region.width(), region.height());
        Self {
            depth32: vec![0; texels],
            depth16: vec![0; texels],
            region,
            exact: None,
            planes: None,
            errors: [Errors::default(); 6],
        }
    }

    /// What the rasterizer stores for a block: by drawing it.
    fn ours<D: DepthFormat<Standard>>(
        region: Region<Standard>,
        storage: &mut [D::Texel],
        block: &Block<'_, Standard>,
    ) -> [u32; 16] {
        let mut depths = [0; 16];
        let test = DepthTest { compare: Compare::Always, write: true };
        if let Ok(mut depth) = Depth::<Standard, D>::new(region, storage, test) {
            depth.begin(block.triangle);
            depth.block(block);
            for (column, row) in block.mask.cells() {
                let stored = depth.get(block.x + column, block.y + row).map_or(0, Into::into);
                depths[(row * 4 + column) as usize] = stored;
            }
        }
        depths
    }
}

impl Attachment<Standard> for Judge {
    fn begin(&mut self, triangle: &Triangle<Standard>) {
        self.exact = exact_plane(triangle);
        self.planes = Some((
            Barycentric32::new(triangle),
            Gradient32::new(triangle),
            Gradient64::new(triangle),
            ExactRational::new(triangle),
        ));
    }

    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        let (Some(exact), Some((bary, grad32, grad64, rational))) = (&self.exact, &self.planes) else {
            return Mask::EMPTY;
        };
        let (x, y) = (block.x, block.y);
        let ours32 = Self::ours::<D32>(self.region, &mut self.depth32, block);
        let ours16 = Self::ours::<D16>(self.region, &mut self.depth16, block);
        let all = [
            ours32.map(f64::from),
            // 65535 units of 16 bits are 2^32 - 1 units of 32.
            ours16.map(|depth| f64::from(depth) * 65_537.0),
            bary.block(x, y).map(Barycentric32::units),
            grad32.block(x, y).map(Gradient32::units),
            grad64.block(x, y).map(Gradient64::units),
            rational.block(x, y).map(ExactRational::units),
        ];
        for (column, row) in block.mask.cells() {
            let depth = exact.at(x + column, y + row);
            let whole = depth.floor();
            let rest = (depth.numerator() - whole * depth.denominator()) as f64 / depth.denominator() as f64;
            for (errors, depths) in self.errors.iter_mut().zip(&all) {
                // Whole parts first: they are exact in f64, and what is left is small.
                let given = depths[(row * 4 + column) as usize];
                // What is no depth at all counts as the whole range.
                let error = if given.is_nan() { 4_294_967_296.0 } else { given - whole as f64 - rest };
                errors.add(error);
            }
        }
        block.mask
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfplane::Vertex;

    /// A needle over the whole guard band: what `f32` cannot hold.
    #[test]
    fn the_judge_sees_what_textbooks_lose() {
        let region = Region::<Standard>::of_size(64, 64).unwrap();
        let vertex = |x, y, z| Vertex::<Standard>::new(x, y, z).unwrap();
        let corners =
            [vertex(-8_000_000, 128, 2), vertex(8_000_000, 120, 4_000_000_000), vertex(8_000_000, 136, 9)];
        let mut judge = Judge::new(State::new(region));
        halfplane::draw(&corners[..], &[0u16, 1, 2], 0, &State::new(region), &mut judge).unwrap();
        let [ours, _, bary, grad32, _, rational] = judge.errors();
        assert!(ours.count > 10 && ours.count == rational.count);
        assert!(ours.largest <= 1.01 && rational.largest <= 0.5, "{ours:?} {rational:?}");
        assert!(bary.largest > 100.0 && grad32.largest > 100.0, "{bary:?} {grad32:?}");
    }
}
