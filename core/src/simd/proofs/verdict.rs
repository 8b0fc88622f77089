//! What culling decides.

use super::{
    super::{cull::Culling, extent::SMALL_EXTENT, fetch::Records, ops::bits, vertex::SPECIAL},
    simd,
};
use crate::{
    draw::{self, State},
    geometry::{Cull, Culled, Region, Vertex},
    numbers::{Bounds, Standard},
    proof::{cover, prove},
};

/// Steps in the guard band.
const BAND: i32 = Bounds::<Standard>::GUARD_BAND;

prove! {
    /// Triangles with a vertex that has no place in the window: outside where the vertices' planes have one
    /// in common, else left to the scalar path. None of them is culled or drawn here.
    #[kani::unwind(18)]
    [Culling::new, Culling::sixteen, Extent::new]
    fn special_triangles_are_left(
        codes: [i32; 3] = [0; 3]..=[127; 3],
        special: [bool; 3],
        x: i32 = -BAND..=BAND,
        present: u32 = 1..=0xFFFF,
    ) {
        if special == [false; 3] {
            return;
        }
        let Ok(region) = Region::<Standard>::new(0, 0, 64, 64) else { return };
        let mut places = [[x as u32, 0]; 3];
        for ((place, code), special) in places.iter_mut().zip(codes).zip(special) {
            if special {
                *place = [(SPECIAL | code) as u32, 0];
            }
        }
        let records = Records { places: &places, depths: &[9; 3] };
        let state = State::new(region);
        let verdict = Culling::new(simd(), region, &state).sixteen(records, &[[0_u16, 1, 2]; 16], present);
        let [a, b, c] = codes;
        let outside = special == [true; 3] && a & b & c != 0;
        assert!(verdict.outside == if outside { present } else { 0 });
        assert!(verdict.slow == if outside { 0 } else { present });
        assert!(bits(verdict.fast) | verdict.zero_area | verdict.facing | verdict.no_sample == 0);
        cover!(outside);
    }
}

/// What no prover finished: for tests alone.
#[cfg(test)]
mod tested {
    use super::*;

    /// The place of the verdict on sixteen such triangles among [fast, slow, outside, zero area, facing, no sample], which
    /// is that of the scalar set-up; `None` where there are none.
    fn verdict(places: [[i32; 2]; 3], region: Region<Standard>, cull: u8, present: u32) -> Option<usize> {
        let [Ok(a), Ok(b), Ok(c)] = places.map(|[x, y]| Vertex::new(x, y, 9)) else { return None };
        let cull = [Cull::None, Cull::Back, Cull::Front][usize::from(cull)];
        let state = State { cull, ..State::new(region) };
        let records = Records { places: &places.map(|place| place.map(|v| v as u32)), depths: &[9; 3] };
        let verdict = Culling::new(simd(), region, &state).sixteen(records, &[[0_u16, 1, 2]; 16], present);
        let fast = bits(verdict.fast);
        let found =
            [fast, verdict.slow, verdict.outside, verdict.zero_area, verdict.facing, verdict.no_sample];
        let ([xa, ya], [xb, yb], [xc, yc]) = (places[0], places[1], places[2]);
        let extent = (xa.max(xb).max(xc) - xa.min(xb).min(xc)).max(ya.max(yb).max(yc) - ya.min(yb).min(yc));
        let at = match draw::prepare([a, b, c], region, &state) {
            Err(Culled::Outside) => 2,
            _ if extent >= SMALL_EXTENT => 1,
            Ok(_) => 0,
            Err(Culled::ZeroArea) => 3,
            Err(Culled::Facing) => 4,
            Err(Culled::NoSample) => 5,
        };
        for (k, found) in found.into_iter().enumerate() {
            assert!(found == if k == at { present } else { 0 });
        }
        assert!(bits(verdict.small) & !fast == 0 && bits(verdict.medium) & !fast == 0);
        assert!(bits(verdict.small) & bits(verdict.medium) == 0);
        Some(at)
    }

    prove! {
        /// Each of the triangles that are there has one verdict, the one of the scalar set-up: for vertices
        /// that have a place in the window. (Sixteen of the same; lanes know nothing of each other.)
        []
        fn verdicts_are_those_of_one_triangle(
            places: [[i32; 2]; 3] = [[-BAND; 2]; 3]..=[[BAND; 2]; 3],
            region: [u32; 4] = [0; 4]..=[16384; 4],
            cull: u8 = 0..=2,
            present: u32 = 1..=0xFFFF,
        ) {
            let [x0, y0, x1, y1] = region;
            let Ok(region) = Region::<Standard>::new(x0, y0, x1, y1) else { return };
            let Some(at) = verdict(places, region, cull, present) else { return };
            cover!(at == 0);
            cover!(at == 4);
        }

        /// The same for triangles that are in a region or beside it, near the target's origin.
        []
        fn verdicts_beside_a_region_are_those_of_one_triangle(
            places: [[i32; 2]; 3] = [[-(160 << 8); 2]; 3]..=[[160 << 8; 2]; 3],
            origin: [u32; 2] = [0; 2]..=[64; 2],
            sides: [u32; 2] = [1; 2]..=[100; 2],
            cull: u8 = 0..=2,
            present: u32 = 1..=0xFFFF,
        ) {
            let ([x, y], [width, height]) = (origin, sides);
            let Ok(region) = Region::<Standard>::new(x, y, x + width, y + height) else { return };
            let Some(at) = verdict(places, region, cull, present) else { return };
            cover!(at == 1);
            cover!(at == 2);
            cover!(at == 5);
        }
    }
}
