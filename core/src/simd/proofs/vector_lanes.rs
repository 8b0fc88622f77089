//! Sixteen lanes in vector registers against the definition.

use super::{LANES, Vectors, simd};
use crate::{
    lanes::{Lanes, VectorLanes},
    proof::{cover, prove},
};

#[inline(always)]
fn load(values: [u32; 16]) -> VectorLanes<Vectors> {
    VectorLanes::load(simd(), &values)
}

#[inline(always)]
fn store(lanes: VectorLanes<Vectors>) -> [u32; 16] {
    let mut values = [0; 16];
    lanes.store(&mut values);
    values
}

prove! {
    /// A ramp grows by A to the right and by B downwards, modulo 2^32.
    #[kani::unwind(17)]
    [VectorLanes::ramp]
    fn a_ramp_of_vectors_steps_by_columns_and_rows(origin: i32, a: i32, b: i32) {
        let values = store(VectorLanes::ramp(simd(), origin, a, b));
        for lane in LANES {
            let (column, row) = ((lane & 3) as i32, (lane >> 2) as i32);
            let expected = origin.wrapping_add(column.wrapping_mul(a)).wrapping_add(row.wrapping_mul(b));
            assert!(values[lane] == expected as u32);
        }
        cover!(values[6] < values[1]);
    }

    /// Sums, and bitwise operations.
    #[kani::unwind(17)]
    [VectorLanes::add, VectorLanes::or, VectorLanes::and]
    fn sums_and_bits_of_vectors_are_lane_wise(values: [u32; 16], others: [u32; 16]) {
        let (a, b) = (load(values), load(others));
        let (sums, either, both) = (store(a.add(b)), store(a.or(b)), store(a.and(b)));
        for lane in LANES {
            assert!(sums[lane] == values[lane].wrapping_add(others[lane]));
            assert!(either[lane] == values[lane] | others[lane] && both[lane] == values[lane] & others[lane]);
        }
    }

    /// A bit for each negative lane, and a mask's bits for the lanes that are less.
    #[kani::unwind(17)]
    [VectorLanes::signs, VectorLanes::bits, VectorLanes::less]
    fn signs_of_vectors_are_the_negative_lanes(values: [u32; 16], others: [u32; 16]) {
        let signs = load(values).signs();
        let less = VectorLanes::bits(load(values).less(load(others)));
        for lane in LANES {
            assert!((signs >> lane & 1 != 0) == ((values[lane] as i32) < 0));
            assert!((less >> lane & 1 != 0) == (values[lane] < others[lane]));
        }
    }

    /// Masks keep their bits, and select lanes.
    #[kani::unwind(17)]
    [VectorLanes::mask, VectorLanes::bits, VectorLanes::both, VectorLanes::not, VectorLanes::select]
    fn masks_of_vectors_are_their_bits(bits: u16, others: u16, one: u32, another: u32) {
        type Masks = VectorLanes<Vectors>;
        let (mask, other) = (Masks::mask(simd(), bits), Masks::mask(simd(), others));
        assert!(Masks::bits(mask) == bits && Masks::bits(Masks::not(mask)) == !bits);
        assert!(Masks::bits(Masks::both(mask, other)) == bits & others);
        let chosen = store(load([one; 16]).select(load([another; 16]), mask));
        for lane in LANES {
            assert!(chosen[lane] == if bits >> lane & 1 != 0 { one } else { another });
        }
    }
}
