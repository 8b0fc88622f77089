//! Depth planes as textbooks have them, as attachments of the rasterizer: the same triangles, the same
//! samples, another depth. Written for the comparison only; do not use them.

mod barycentric;
mod gradient;
mod rational;

use halfplane::{Attachment, Block, Mask, Region, Standard, Triangle, blocks};

pub use barycentric::Barycentric32;
pub use gradient::{Gradient32, Gradient64};
pub use rational::ExactRational;
pub(crate) use rational::exact_plane;

/// A way of finding the depth of a triangle at a sample.
pub trait Plane: Copy {
    /// What a pixel stores.
    type Depth: Copy + PartialOrd;
    /// What tables call it.
    const NAME: &'static str;
    /// The farthest depth.
    const FAR: Self::Depth;

    /// Sets a triangle up.
    fn new(triangle: &Triangle<Standard>) -> Self;

    /// The depths at the sixteen pixels' centres of the block at (`x`, `y`), row by row.
    fn block(&self, x: u32, y: u32) -> [Self::Depth; 16];

    /// A stored depth in units of 2^-32.
    fn units(depth: Self::Depth) -> f64;
}

/// A depth buffer of such depths; the nearer one wins, the earlier one a tie.
#[derive(Debug)]
pub struct PlaneDepth<P: Plane> {
    region: Region<Standard>,
    across: usize,
    texels: Vec<[P::Depth; 16]>,
    plane: Option<P>,
}

impl<P: Plane> PlaneDepth<P> {
    /// Of a region that begins at the target's origin, cleared.
    #[must_use]
    pub fn new(region: Region<Standard>) -> Self {
        let count = blocks(region.width(), region.height());
        let across = region.width().div_ceil(4) as usize;
        Self { region, across, texels: vec![[P::FAR; 16]; count], plane: None }
    }

    /// Sets every depth to the farthest.
    pub fn clear(&mut self) {
        self.texels.fill([P::FAR; 16]);
    }
}

impl<P: Plane> Attachment<Standard> for PlaneDepth<P> {
    #[inline]
    fn begin(&mut self, triangle: &Triangle<Standard>) {
        self.plane = Some(P::new(triangle));
    }

    #[inline]
    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        let place = (block.y / 4) as usize * self.across + (block.x / 4) as usize;
        let (Some(plane), Some(texels)) = (&self.plane, self.texels.get_mut(place)) else {
            return Mask::EMPTY;
        };
        let depths = plane.block(block.x, block.y);
        let mut passed = 0;
        for (lane, (texel, depth)) in texels.iter_mut().zip(depths).enumerate() {
            let pass = block.mask.0 >> lane & 1 == 1 && depth < *texel;
            *texel = if pass { depth } else { *texel };
            passed |= u16::from(pass) << lane;
        }
        Mask(passed)
    }

    fn check(&self, area: Region<Standard>) -> Result<(), halfplane::OutsideAttachment> {
        halfplane::OutsideAttachment::unless_contained(area, self.region)
    }
}

/// Window x, y in pixels and the depth as a part of its range, in `f32`.
fn corners32(triangle: &Triangle<Standard>) -> [[f32; 3]; 3] {
    triangle
        .vertices()
        .map(|v| [v.x() as f32 / 256.0, v.y() as f32 / 256.0, (f64::from(v.z()) / UNIT_SCALE) as f32])
}

/// 2^32.
const UNIT_SCALE: f64 = 4_294_967_296.0;

/// The sixteen pixels of a block.
fn pixels(x: u32, y: u32) -> impl Iterator<Item = (usize, u32, u32)> {
    (0..16).map(move |lane| (lane as usize, x + lane % 4, y + lane / 4))
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfplane::{Sample, Vertex};

    /// A slope that every method has exactly: 2^24 per pixel to the right, 2^25 down.
    fn slope() -> Triangle<Standard> {
        let vertex = |x: i32, y: i32| {
            let z = (1 << 30) + (x << 24) as u32 + (y << 25) as u32;
            Vertex::new(x * 256, y * 256, z).unwrap()
        };
        Triangle::new([vertex(0, 0), vertex(16, 0), vertex(0, 16)], Sample::CENTER).unwrap()
    }

    fn depths<P: Plane>() -> [f64; 16] {
        P::new(&slope()).block(4, 8).map(P::units)
    }

    #[test]
    fn all_agree_where_nothing_is_lost() {
        let expected: [f64; 16] = std::array::from_fn(|lane| {
            let (x, y) = (4.5 + (lane % 4) as f64, 8.5 + (lane / 4) as f64);
            f64::from(1 << 30) + x * f64::from(1 << 24) + y * f64::from(1 << 25)
        });
        assert_eq!(depths::<Gradient32>(), expected);
        assert_eq!(depths::<Gradient64>(), expected);
        assert_eq!(depths::<ExactRational>(), expected);
        for (given, expected) in depths::<Barycentric32>().into_iter().zip(expected) {
            // The quotient by the area is a power of two, too.
            assert_eq!(given, expected);
        }
    }

    #[test]
    fn the_nearer_wins_and_the_mask_tells() {
        let mut depth = PlaneDepth::<Gradient64>::new(Region::of_size(16, 16).unwrap());
        let triangle = slope();
        depth.begin(&triangle);
        let mut draw =
            |mask| depth.block(&Block { x: 4, y: 8, mask: Mask(mask), triangle: &triangle, id: 0 });
        assert_eq!(draw(0b101), Mask(0b101));
        // A tie is the earlier one's.
        assert_eq!(draw(0b111), Mask(0b010));
        depth.clear();
        assert_eq!(depth.block(&Block { x: 4, y: 8, mask: Mask(7), triangle: &triangle, id: 0 }), Mask(7));
    }
}
