//! The depth of samples.

use super::{
    super::{
        attachment::{Gradients, offsets},
        fetch::Corner,
        ops::splat,
        setup::{Batch, DepthSetup, Plane},
    },
    LANES, Words, simd, words,
};
use crate::proof::{cover, prove};
use fearless_simd::{prelude::*, u64x8};

prove! {
    /// A plane's value at a sample, modulo 2^64: the depth of its anchor, half a unit, and a gradient for
    /// each step. Pixels are 256 steps.
    #[kani::unwind(17)]
    [Plane::store, store_words, sign_extend]
    fn planes_reach_the_origin(depth: u32, gradients: [u64; 2], from: [i32; 2] = [-(1 << 16); 2]..=[1 << 16; 2]) {
        let [x, y] = gradients.map(|gradient| [u64x8::splat(simd(), gradient); 2]);
        let anchor = Corner { x: splat(simd(), 0), y: splat(simd(), 0) };
        let plane = Plane { anchor, depth: Words::splat(simd(), depth), x, y };
        let mut batch = Batch::EMPTY;
        plane.store(simd(), splat(simd(), from[0]), splat(simd(), from[1]), DepthSetup::D32, &mut batch);
        let steps = from.map(|v| i64::from(v) as u64);
        let expected = (u64::from(depth) << 32)
            .wrapping_add(1 << 31)
            .wrapping_add(gradients[0].wrapping_mul(steps[0]))
            .wrapping_add(gradients[1].wrapping_mul(steps[1]));
        assert!(batch.origin[9] == expected);
        assert!(batch.gradients[0][9] == gradients[0] << 8 && batch.gradients[1][1] == gradients[1] << 8);
        cover!(expected == 1 << 31);
    }

    /// The depths of a block's samples above the first, rounded down after a half: as in one word of 64
    /// bits, whose low 8 bits are 0 in gradients per pixel.
    [offsets]
    fn offsets_lose_nothing(x: u64, y: u64, half: bool) {
        let gradients = Gradients { x: x << 8, y: y << 8 };
        let units = if half { 1 << 23 } else { 0 };
        let found = words(offsets(simd(), gradients, units));
        for lane in LANES {
            let mut word = u64::from(units) << 8;
            for _ in 0..lane % 4 {
                word = word.wrapping_add(gradients.x);
            }
            for _ in 0..lane / 4 {
                word = word.wrapping_add(gradients.y);
            }
            assert!(u64::from(found[lane]) == word >> 32);
        }
        cover!(half && found[15] == u32::MAX);
    }
}
