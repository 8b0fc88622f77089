//! One lane of sixteen, for proofs about what is written over [`Lanes`]: each operation does in every lane
//! what it does in this one (`lanes::proofs` shows it of arrays), so one stands for all.

use crate::lanes::Lanes;

/// Lane `LANE` of sixteen; the others are not there, and stay as they are in memory.
#[derive(Clone, Copy)]
pub(super) struct OneLane<const LANE: usize>(u32);

impl<const LANE: usize> OneLane<LANE> {
    /// The lane with a value.
    pub(super) const fn of(value: u32) -> Self {
        Self(value)
    }
}

impl<const LANE: usize> Lanes for OneLane<LANE> {
    type Token = ();
    type Mask = bool;

    fn vectorize<R>((): (), f: impl FnOnce() -> R) -> R {
        f()
    }

    fn splat((): (), value: u32) -> Self {
        Self(value)
    }

    fn ramp((): (), origin: i32, a: i32, b: i32) -> Self {
        let (column, row) = ((LANE % 4) as i32, (LANE / 4) as i32);
        Self(origin.wrapping_add(column.wrapping_mul(a)).wrapping_add(row.wrapping_mul(b)) as u32)
    }

    fn load((): (), values: &[u32; 16]) -> Self {
        Self(values[LANE])
    }

    fn store(self, values: &mut [u32; 16]) {
        values[LANE] = self.0;
    }

    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }

    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    fn signs(self) -> u16 {
        ((self.0 >> 31) as u16) << LANE
    }

    fn less(self, other: Self) -> bool {
        self.0 < other.0
    }

    fn select(self, other: Self, mask: bool) -> Self {
        if mask { self } else { other }
    }

    fn mask((): (), bits: u16) -> bool {
        bits >> LANE & 1 != 0
    }

    fn bits(mask: bool) -> u16 {
        u16::from(mask) << LANE
    }

    fn both(mask: bool, other: bool) -> bool {
        mask & other
    }

    fn not(mask: bool) -> bool {
        !mask
    }
}
