//! The parts of cases: small, so that a mutation of a few bytes changes one thing.

use crate::{
    Frame,
    frame::into_guard_band,
    shapes::{Corners, Kind, depths, triangle},
    strategies::Shot,
};
use arbitrary::Arbitrary;
use halfplane::{Cull, Format, Winding};

/// Region, scissor and sample: [`Frame::from_numbers`].
#[derive(Clone, Copy, Debug, Arbitrary)]
pub(super) struct Place(pub(super) [u16; 12]);

impl Place {
    /// A frame of up to 100 pixels on a side.
    pub(super) fn frame<F: Format>(self) -> Frame {
        Frame::from_numbers::<F>(self.0.map(u32::from))
    }

    /// A frame of up to `side` pixels on a side.
    pub(super) fn small<F: Format>(mut self, side: u16) -> Frame {
        let [_, width, height, ..] = &mut self.0;
        (*width, *height) = (*width % side, *height % side);
        self.frame::<F>()
    }

    /// A viewport: the whole region, sampled where the frame is.
    pub(super) fn viewport<F: Format>(self, side: u16) -> Frame {
        let frame = self.small::<F>(side);
        Frame { scissor: frame.region, ..frame }
    }
}

/// A triangle about a frame.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub(super) enum Shape {
    /// Of a kind that has something special about it.
    OfKind(u8, [u32; 8]),
    /// Corners in steps from the scissor's first pixel.
    Near([[i16; 2]; 3]),
    /// Corners anywhere in the guard band.
    Anywhere([[i32; 2]; 3]),
}

impl Shape {
    pub(super) fn corners<F: Format>(self, frame: &Frame) -> Corners {
        match self {
            Self::OfKind(kind, numbers) => {
                triangle::<F>(Kind::ALL[usize::from(kind) % Kind::ALL.len()], frame, numbers)
            }
            Self::Near(corners) => corners.map(|corner| near::<F>(frame, corner)),
            Self::Anywhere(corners) => corners.map(|corner| corner.map(|v| into_guard_band::<F>(v.into()))),
        }
    }

    /// The triangle with depths: [`depths`].
    pub(super) fn shot<F: Format>(self, frame: &Frame, z: [u32; 4]) -> Shot {
        Shot { frame: *frame, kind: Kind::Medium, corners: self.corners::<F>(frame), z: depths(z) }
    }
}

/// A point in steps from the scissor's first pixel.
pub(super) fn near<F: Format>(frame: &Frame, point: [i16; 2]) -> [i32; 2] {
    [0, 1].map(|axis| {
        let corner = i64::from(frame.scissor[axis]) << F::SUBPIXEL_BITS;
        into_guard_band::<F>(corner + i64::from(point[axis]))
    })
}

/// Which faces are drawn.
#[derive(Clone, Copy, Debug, Arbitrary)]
pub(super) struct Faces(u8);

impl Faces {
    pub(super) fn cull(self) -> Cull {
        [Cull::None, Cull::None, Cull::Back, Cull::Front][usize::from(self.0 % 4)]
    }

    pub(super) fn front(self) -> Winding {
        [Winding::Clockwise, Winding::CounterClockwise][usize::from(self.0 / 4 % 2)]
    }
}
