//! The shapes as proptest strategies: proptest chooses and shrinks plain numbers, the shapes follow.

use crate::{
    Frame,
    case::{Case, Numbers},
    frame::into_guard_band,
    shapes::{Corners, Kind, depths, triangle},
};
use halfplane::Format;
use proptest::{array, prelude::*, sample::select};
use std::ops::RangeInclusive;

/// One triangle and where it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// Where.
    pub frame: Frame,
    /// What is special about it.
    pub kind: Kind,
    /// Corners in steps.
    pub corners: Corners,
    /// Depths in units of 2^-32.
    pub z: [u32; 3],
}

/// `N` numbers, each uniform.
pub fn numbers<const N: usize>() -> impl Strategy<Value = [u32; N]>
where
    [u32; N]: std::fmt::Debug,
{
    proptest::collection::vec(any::<u32>(), N).prop_map(|v| std::array::from_fn(|k| v[k]))
}

/// Frames anywhere in the largest target.
pub fn frame<F: Format>() -> impl Strategy<Value = Frame> {
    numbers::<12>().prop_map(Frame::from_numbers::<F>)
}

/// A triangle of any kind in any frame.
pub fn shot<F: Format>() -> impl Strategy<Value = Shot> {
    (frame::<F>(), select(Kind::ALL.to_vec()), array::uniform8(any::<u32>()), array::uniform4(any::<u32>()))
        .prop_map(|(frame, kind, numbers, z)| Shot {
            frame,
            kind,
            corners: triangle::<F>(kind, &frame, numbers),
            z: depths(z),
        })
}

/// Several triangles in a small target at the origin.
pub fn scene<F: Format>(side: u32, most: usize) -> impl Strategy<Value = (Frame, Vec<Shot>)> {
    let one = (select(Kind::ALL.to_vec()), array::uniform8(any::<u32>()), array::uniform4(any::<u32>()));
    (1..=side, 1..=side, proptest::collection::vec(one, 1..=most)).prop_map(|(width, height, shapes)| {
        let frame = Frame::whole::<F>(width, height);
        let shots = shapes.into_iter().map(|(kind, numbers, z)| Shot {
            frame,
            kind,
            corners: triangle::<F>(kind, &frame, numbers),
            z: depths(z),
        });
        (frame, shots.collect())
    })
}

/// The same beside a region's corner that is a multiple of 4.
pub fn scene_anywhere<F: Format>(side: u32, most: usize) -> impl Strategy<Value = (Frame, Vec<Shot>)> {
    (scene::<F>(side, most), numbers::<2>()).prop_map(|((mut frame, mut shots), place)| {
        let [_, _, width, height] = frame.region;
        // At the origin, half of the time.
        let [x, y] = [(place[0], width), (place[1], height)]
            .map(|(at, size)| if at % 2 == 0 { 0 } else { (at / 2 % (F::MAX_TARGET - size + 1)) & !3 });
        frame.region = [x, y, x + width, y + height];
        frame.scissor = frame.region;
        for shot in &mut shots {
            shot.frame = frame;
            shot.corners = shot.corners.map(|[cx, cy]| {
                [(cx, x), (cy, y)].map(|(v, moved)| {
                    into_guard_band::<F>(i64::from(v) + (i64::from(moved) << F::SUBPIXEL_BITS))
                })
            });
        }
        (frame, shots)
    })
}

/// The numbers of so many triangles.
pub fn triangles(count: RangeInclusive<usize>) -> impl Strategy<Value = Vec<Numbers>> {
    let one = (any::<u32>(), array::uniform8(any::<u32>()), array::uniform4(any::<u32>()));
    proptest::collection::vec(one, count)
}

/// A mesh of so many triangles of these kinds, and a few at the guard band's limit.
pub fn case(count: RangeInclusive<usize>, kinds: &'static [Kind]) -> impl Strategy<Value = Case> {
    (numbers::<12>(), numbers::<10>(), triangles(count))
        .prop_map(|(place, how, triangles)| Case::from_numbers(place, how, &triangles, kinds))
}
