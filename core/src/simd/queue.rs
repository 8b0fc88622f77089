//! Survivors of culling on their way to set-up.

use super::ops::bits;
use fearless_simd::{Simd, mask32x16, prelude::*, u32x16};

/// How many triangles are collected before they are drawn.
const CAPACITY: usize = 240;

/// Numbers of triangles, in submitted order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Queue {
    /// Sixteen more places than are used, for writing and reading sixteen at a time.
    numbers: [u32; CAPACITY + 16],
    len: usize,
}

impl Queue {
    pub(super) const EMPTY: Self = Self { numbers: [0; CAPACITY + 16], len: 0 };

    #[inline(always)]
    pub(super) const fn len(&self) -> usize {
        self.len
    }

    /// Whether sixteen more triangles fit.
    #[inline(always)]
    pub(super) const fn has_room(&self) -> bool {
        self.len + 16 <= CAPACITY
    }

    /// Adds those of the sixteen triangles from number `first` on that are in the mask; there is room.
    #[inline(always)]
    pub(super) fn push<S: Simd>(&mut self, simd: S, first: u32, mask: mask32x16<S>) {
        let Some(to) = self.numbers.get_mut(self.len..).and_then(<[u32]>::first_chunk_mut::<16>) else {
            return;
        };
        let mut left = bits(mask);
        self.len += left.count_ones() as usize;
        if <S::u32s as SimdBase<S>>::LEN >= 8 {
            let lanes = u32x16::simd_from(simd, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]);
            (lanes + u32x16::splat(simd, first)).compress(mask).store_slice(to);
        } else {
            // Narrower registers have no instruction for it.
            for to in to {
                if left == 0 {
                    break;
                }
                *to = first.wrapping_add(left.trailing_zeros());
                left &= left - 1;
            }
        }
    }

    /// The sixteen numbers from place `at` on, and how many of them are there.
    #[inline(always)]
    pub(super) fn batch(&self, at: usize) -> (&[u32; 16], usize) {
        match self.numbers.get(at..).and_then(<[u32]>::first_chunk) {
            Some(numbers) => (numbers, self.len.saturating_sub(at).min(16)),
            None => (&[0; 16], 0),
        }
    }

    /// Forgets the first `count` triangles, all but fewer than sixteen.
    #[inline(always)]
    pub(super) fn forget(&mut self, count: usize) {
        let (rest, left) = self.batch(count);
        let rest = *rest;
        if let Some(to) = self.numbers.first_chunk_mut() {
            *to = rest;
        }
        self.len = left;
    }
}
