//! Lanes in a plain array: no processor feature, no float; what microcontrollers run.
//!
//! The loops have no branch and no shift by a variable: compilers turn them into whatever vectors the
//! target always has.

use super::Lanes;

/// [`Lanes`] as `[u32; 16]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArrayLanes([u32; 16]);

/// The mask bit of each lane.
const BITS: [u32; 16] = {
    let mut bits = [0; 16];
    let mut lane = 0;
    while lane < 16 {
        bits[lane] = 1 << lane;
        lane += 1;
    }
    bits
};

/// A mask of [`ArrayLanes`]: all bits of a lane or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArrayMask([u32; 16]);

// Three small functions that are not inlined on purpose. Compilers vectorise sixteen lanes that are loaded
// from memory or stored to it; what reaches them as sixteen values in registers they treat lane by lane,
// which costs several times as much as the calls.

/// `origin + column a + row b` in each lane.
#[inline(never)]
fn ramp(origin: i32, a: i32, b: i32) -> [u32; 16] {
    let mut lanes = [0; 16];
    let mut row =
        [0, a, a.wrapping_add(a), a.wrapping_add(a).wrapping_add(a)].map(|v| origin.wrapping_add(v));
    for lanes in lanes.as_chunks_mut::<4>().0 {
        *lanes = row.map(|v| v as u32);
        row = row.map(|v| v.wrapping_add(b));
    }
    lanes
}

/// The bits of rows of bytes that are 0 or 1.
#[inline(never)]
fn gather<const ROWS: usize>(rows: &[[u8; 4]; ROWS]) -> u16 {
    let mut bits = 0;
    for row in rows.iter().rev() {
        // Each factor moves one byte's bit to its place in the uppermost byte; no two products meet.
        let moved = u32::from_le_bytes(*row).wrapping_mul(1 << 24 | 1 << 17 | 1 << 10 | 1 << 3);
        bits = bits << 4 | moved >> 24;
    }
    bits as u16
}

/// All bits of the lanes whose bits are set.
#[inline(never)]
fn spread(bits: u32) -> [u32; 16] {
    let mut lanes = BITS;
    for lane in &mut lanes {
        *lane = all_or_none(bits & *lane != 0);
    }
    lanes
}

#[inline(always)]
const fn all_or_none(condition: bool) -> u32 {
    if condition { u32::MAX } else { 0 }
}

impl ArrayLanes {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(u32, u32) -> u32) -> Self {
        let mut lanes = self.0;
        for (lane, value) in lanes.iter_mut().zip(&other.0) {
            *lane = f(*lane, *value);
        }
        Self(lanes)
    }
}

impl Lanes for ArrayLanes {
    type Token = ();
    type Mask = ArrayMask;

    #[inline(always)]
    fn vectorize<R>((): (), f: impl FnOnce() -> R) -> R {
        f()
    }

    #[inline(always)]
    fn splat((): (), value: u32) -> Self {
        Self([value; 16])
    }

    #[inline(always)]
    fn ramp((): (), origin: i32, a: i32, b: i32) -> Self {
        Self(ramp(origin, a, b))
    }

    #[inline(always)]
    fn load((): (), values: &[u32; 16]) -> Self {
        Self(*values)
    }

    #[inline(always)]
    fn store(self, values: &mut [u32; 16]) {
        *values = self.0;
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, u32::wrapping_add)
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }

    #[inline(always)]
    fn signs(self) -> u16 {
        let mut rows = [[0; 4]; 4];
        for (flag, lane) in rows.as_flattened_mut().iter_mut().zip(&self.0) {
            *flag = (*lane >> 31) as u8;
        }
        gather(&rows)
    }

    #[inline(always)]
    fn less(self, other: Self) -> ArrayMask {
        ArrayMask(self.zip(other, |a, b| all_or_none(a < b)).0)
    }

    #[inline(always)]
    fn select(self, other: Self, mask: ArrayMask) -> Self {
        let mut lanes = self.0;
        for ((lane, other), mask) in lanes.iter_mut().zip(&other.0).zip(&mask.0) {
            *lane = *lane & *mask | *other & !*mask;
        }
        Self(lanes)
    }

    #[inline(always)]
    fn mask((): (), bits: u16) -> ArrayMask {
        ArrayMask(spread(u32::from(bits)))
    }

    #[inline(always)]
    fn bits(mask: ArrayMask) -> u16 {
        Self(mask.0).signs()
    }

    #[inline(always)]
    fn both(mask: ArrayMask, other: ArrayMask) -> ArrayMask {
        ArrayMask(Self(mask.0).and(Self(other.0)).0)
    }

    #[inline(always)]
    fn not(mut mask: ArrayMask) -> ArrayMask {
        for lane in &mut mask.0 {
            *lane = !*lane;
        }
        mask
    }
}
