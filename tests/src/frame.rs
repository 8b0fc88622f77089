//! Where a case is drawn: the attachment's region, the scissor in it, the sample position.

use crate::{Failure, shapes::Random};
use halfplane::{Bounds, Format, Region, Sample, State, Vertex};
use halfplane_reference::{Grid, Rect};

/// Largest width and height of a frame: more than a tile, so that tiles meet in it.
const MAX_SIDE: u32 = 100;

/// A region of a target, a scissor inside it and a sample position, in plain numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// `[x0, y0, x1, y1]` of the attachments; the first two are multiples of 4.
    pub region: [u32; 4],
    /// `[x0, y0, x1, y1]` of the scissor, within the region, at any pixel.
    pub scissor: [u32; 4],
    /// The sample, in steps from the pixel's top-left corner.
    pub sample: [u32; 2],
}

impl Frame {
    /// A frame from any numbers: anywhere in the largest target, of any size up to 100 pixels, with
    /// any scissor; half of the sample positions are the centre.
    pub fn from_numbers<F: Format>(numbers: [u32; 12]) -> Self {
        let limit = MAX_SIDE.min(F::MAX_TARGET);
        let [place, w, h, x, y, cut, left, right, top, bottom, sx, sy] = numbers;
        let (width, height) = (1 + w % limit, 1 + h % limit);
        let origin = |kind: u32, free: u32, size: u32| {
            let last = F::MAX_TARGET - size;
            // The origin, the far end, or anywhere: multiples of 4.
            match kind % 4 {
                0 | 1 => 0,
                2 => last & !3,
                _ => (free % (last + 1)) & !3,
            }
        };
        let (x0, y0) = (origin(place, x, width), origin(place / 4, y, height));
        let (x1, y1) = (x0 + width, y0 + height);
        let scissor = if cut % 2 == 0 {
            [x0, y0, x1, y1]
        } else {
            let (left, top) = (left % width, top % height);
            let (columns, rows) = (1 + right % (width - left), 1 + bottom % (height - top));
            [x0 + left, y0 + top, x0 + left + columns, y0 + top + rows]
        };
        let steps = 1 << F::SUBPIXEL_BITS;
        let sample = if sx % 2 == 0 { [steps / 2; 2] } else { [sx / 2 % steps, sy % steps] };
        Self { region: [x0, y0, x1, y1], scissor, sample }
    }

    /// A target of that size, sampled at pixel centres, without a scissor.
    pub fn whole<F: Format>(width: u32, height: u32) -> Self {
        let region = [0, 0, width, height];
        Self { region, scissor: region, sample: [1 << (F::SUBPIXEL_BITS - 1); 2] }
    }

    /// A target of 2048 x 5 pixels, or 5 x 2048, with a scissor that is moved by a few.
    pub fn long<F: Format>(random: &mut Random, tall: bool) -> Self {
        let long = 2048.min(F::MAX_TARGET);
        let mut region = [0, 0, long, 5];
        let mut scissor =
            [random.below(40) as u32, random.below(3) as u32, long - random.below(40) as u32, 5];
        if tall {
            region.swap(2, 3);
            scissor = [scissor[1], scissor[0], scissor[3], scissor[2]];
        }
        Frame { region, scissor, ..Self::whole::<F>(1, 1) }
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.region[2] - self.region[0]
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.region[3] - self.region[1]
    }

    /// All pixels of the region, row by row.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let [x0, y0, x1, y1] = self.region;
        (y0..y1).flat_map(move |y| (x0..x1).map(move |x| (x, y)))
    }

    /// Whether the scissor has the pixel.
    pub fn scissor_has(&self, (x, y): (u32, u32)) -> bool {
        let [x0, y0, x1, y1] = self.scissor;
        x0 <= x && x < x1 && y0 <= y && y < y1
    }

    /// The core's region of the attachments.
    pub fn core_region<F: Format>(&self) -> Result<Region<F>, Failure> {
        let [x0, y0, x1, y1] = self.region;
        Ok(Region::new(x0, y0, x1, y1)?)
    }

    /// The core's sample position.
    pub fn core_sample<F: Format>(&self) -> Result<Sample<F>, Failure> {
        let [x, y] = self.sample.map(|v| v as i32);
        Sample::new(x, y).ok_or_else(|| Failure::new(format_args!("no sample at ({x}, {y})")))
    }

    /// The core's state: this scissor and this sample, nothing culled.
    pub fn state<F: Format>(&self) -> Result<State<F>, Failure> {
        let [x0, y0, x1, y1] = self.scissor;
        Ok(State { sample: self.core_sample()?, ..State::new(Region::new(x0, y0, x1, y1)?) })
    }

    /// The oracle's grid.
    pub fn grid<F: Format>(&self) -> Result<Grid, Failure> {
        let [x, y] = self.sample;
        Ok(Grid::new(F::SUBPIXEL_BITS, (x, y))?)
    }

    /// The oracle's rectangle of the scissor.
    pub fn scissor_rect(&self) -> Rect {
        let [x0, y0, x1, y1] = self.scissor;
        Rect { x0, y0, x1, y1 }
    }

    /// The place of a pixel of the region in a row-major picture of it.
    pub fn place(&self, (x, y): (u32, u32)) -> usize {
        ((y - self.region[1]) * self.width() + (x - self.region[0])) as usize
    }

    /// The sample of a pixel of the region, in steps.
    pub fn sample_at<F: Format>(&self, (x, y): (u32, u32)) -> [i64; 2] {
        let at = |pixel: u32, offset: u32| (i64::from(pixel) << F::SUBPIXEL_BITS) + i64::from(offset);
        [at(x, self.sample[0]), at(y, self.sample[1])]
    }
}

/// Window vertices of these corners and depths.
pub fn window_vertices<F: Format>(xy: &[[i32; 2]; 3], z: [u32; 3]) -> Result<[Vertex<F>; 3], Failure> {
    let [[ax, ay], [bx, by], [cx, cy]] = *xy;
    Ok([Vertex::new(ax, ay, z[0])?, Vertex::new(bx, by, z[1])?, Vertex::new(cx, cy, z[2])?])
}

/// The nearest coordinate inside the guard band.
pub fn into_guard_band<F: Format>(steps: i64) -> i32 {
    let limit = i64::from(Bounds::<F>::GUARD_BAND);
    steps.clamp(-limit, limit) as i32
}
