//! Lanes in a plain array: no processor feature, no float; what microcontrollers run.

use super::Lanes;
use core::array;

/// [`Lanes`] as `[u32; 16]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArrayLanes([u32; 16]);

impl ArrayLanes {
    #[inline]
    fn zip(self, other: Self, f: impl Fn(u32, u32) -> u32) -> Self {
        let mut lanes = self.0;
        for (lane, value) in lanes.iter_mut().zip(other.0) {
            *lane = f(*lane, value);
        }
        Self(lanes)
    }

    #[inline]
    fn mask(bits: impl Iterator<Item = bool>) -> u16 {
        bits.enumerate().fold(0, |mask, (lane, bit)| mask | u16::from(bit) << (lane & 15))
    }
}

impl Lanes for ArrayLanes {
    #[inline]
    fn splat(value: u32) -> Self {
        Self([value; 16])
    }

    #[inline]
    fn ramp(origin: i32, a: i32, b: i32) -> Self {
        Self(array::from_fn(|lane| {
            let (column, row) = ((lane & 3) as i32, (lane >> 2) as i32);
            origin.wrapping_add(column.wrapping_mul(a)).wrapping_add(row.wrapping_mul(b)) as u32
        }))
    }

    #[inline]
    fn load(values: &[u32; 16]) -> Self {
        Self(*values)
    }

    #[inline]
    fn store(self, values: &mut [u32; 16]) {
        *values = self.0;
    }

    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, u32::wrapping_add)
    }

    #[inline]
    fn or(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }

    #[inline]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }

    #[inline]
    fn signs(self) -> u16 {
        Self::mask(self.0.into_iter().map(|lane| lane >> 31 != 0))
    }

    #[inline]
    fn less(self, other: Self) -> u16 {
        Self::mask(self.0.into_iter().zip(other.0).map(|(a, b)| a < b))
    }

    #[inline]
    fn select(self, other: Self, mask: u16) -> Self {
        Self(array::from_fn(|lane| {
            let source = if mask >> (lane & 15) & 1 != 0 { &self.0 } else { &other.0 };
            source[lane & 15]
        }))
    }
}
