//! Proofs of the lanes in arrays: each operation against what it says of one lane.

use super::{ArrayLanes, Lanes};
use crate::proof::{cover, prove};

fn load(values: [u32; 16]) -> ArrayLanes {
    ArrayLanes::load((), &values)
}

fn store(lanes: ArrayLanes) -> [u32; 16] {
    let mut values = [0; 16];
    lanes.store(&mut values);
    values
}

/// Whether the bit of a lane is set.
fn bit(bits: u16, lane: usize) -> bool {
    bits & 1 << lane != 0
}

prove! {
    /// Lane 4 j + i of a ramp is `origin + i a + j b` modulo 2^32, for all three.
    #[kani::unwind(17)]
    [ramp, ArrayLanes::ramp, ArrayLanes::store]
    fn a_ramp_steps_by_columns_and_rows(origin: i32, a: i32, b: i32, column: usize = 0..=3, row: usize = 0..=3) {
        let lanes = store(ArrayLanes::ramp((), origin, a, b));
        let exact = i64::from(origin) + column as i64 * i64::from(a) + row as i64 * i64::from(b);
        assert!(lanes[4 * row + column] == exact as u32);
        cover!(exact > i64::from(i32::MAX) && row == 3 && column == 3);
    }

    /// Sums modulo 2^32, "or" and "and", lane by lane; nothing goes to another lane.
    #[kani::unwind(17)]
    [ArrayLanes::zip, ArrayLanes::add, ArrayLanes::or, ArrayLanes::and, ArrayLanes::load, ArrayLanes::store]
    fn sums_and_bits_are_lane_wise(values: [u32; 16], others: [u32; 16], lane: usize = 0..=15) {
        let (a, b) = (values[lane], others[lane]);
        assert!(store(load(values).add(load(others)))[lane] == (u64::from(a) + u64::from(b)) as u32);
        assert!(store(load(values).or(load(others)))[lane] == a | b);
        assert!(store(load(values).and(load(others)))[lane] == a & b);
        cover!(u64::from(a) + u64::from(b) > u64::from(u32::MAX));
    }

    /// Bit k of the signs is the sign of lane k, whatever the other lanes are; splatted lanes are equal.
    #[kani::unwind(17)]
    [ArrayLanes::signs, gather, ArrayLanes::splat]
    fn signs_are_the_negative_lanes(values: [u32; 16], lane: usize = 0..=15) {
        assert!(bit(load(values).signs(), lane) == ((values[lane] as i32) < 0));
        assert!(store(ArrayLanes::splat((), values[0]))[lane] == values[0]);
    }

    /// `less` compares as unsigned integers, lane by lane.
    #[kani::unwind(17)]
    [ArrayLanes::less, ArrayLanes::bits, all_or_none, ArrayLanes::zip]
    fn less_is_unsigned(values: [u32; 16], others: [u32; 16], lane: usize = 0..=15) {
        let less = ArrayLanes::bits(load(values).less(load(others)));
        assert!(bit(less, lane) == (values[lane] < others[lane]));
        cover!(values[lane] < others[lane] && values[lane] as i32 > others[lane] as i32);
    }

    /// A mask has the lanes of its bits, and gives the bits back.
    #[kani::unwind(17)]
    [ArrayLanes::mask, ArrayLanes::bits, spread, all_or_none, gather]
    fn masks_keep_their_bits(bits: u16) {
        assert!(ArrayLanes::bits(ArrayLanes::mask((), bits)) == bits);
    }

    /// `select` takes whole lanes: all bits from one side.
    #[kani::unwind(17)]
    [ArrayLanes::select, ArrayLanes::mask, spread, all_or_none]
    fn select_takes_whole_lanes(values: [u32; 16], others: [u32; 16], bits: u16, lane: usize = 0..=15) {
        let selected = store(load(values).select(load(others), ArrayLanes::mask((), bits)));
        assert!(selected[lane] == if bit(bits, lane) { values[lane] } else { others[lane] });
    }

    /// Intersection and complement of masks are those of their bits.
    #[kani::unwind(17)]
    [ArrayLanes::both, ArrayLanes::not, ArrayLanes::bits, ArrayLanes::mask]
    fn masks_combine_as_bits(bits: u16, others: u16) {
        let (mask, other) = (ArrayLanes::mask((), bits), ArrayLanes::mask((), others));
        assert!(ArrayLanes::bits(ArrayLanes::both(mask, other)) == bits & others);
        assert!(ArrayLanes::bits(ArrayLanes::not(mask)) == !bits);
    }
}
