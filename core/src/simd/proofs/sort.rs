//! Sorting and selecting.

use super::super::sort::{select, sort};
use crate::proof::{cover, prove};

prove! {
    /// Four elements come out in the order of their keys, and are the same.
    #[kani::unwind(8)]
    [sort, sift, swap]
    fn four_are_sorted(keys: [u64; 4], key: u64) {
        let mut sorted = keys;
        sort(&mut sorted, |&key| key);
        assert!(sorted[0] <= sorted[1] && sorted[1] <= sorted[2] && sorted[2] <= sorted[3]);
        let count = |keys: [u64; 4]| keys.iter().filter(|&&k| k == key).count();
        assert!(count(sorted) == count(keys));
        cover!(keys[0] > keys[1] && keys[1] > keys[2] && keys[2] > keys[3]);
    }

    /// Of three floats, any bits, none before the chosen rank is greater than one behind.
    #[kani::unwind(8)]
    [select, swap]
    fn three_are_parted(bits: [u32; 3], nth: usize = 0..=2) {
        let mut parted = bits.map(f32::from_bits);
        select(&mut parted, nth, |&value| value);
        for before in 0..nth {
            assert!(parted[before].total_cmp(&parted[nth]).is_le());
        }
        for behind in nth..3 {
            assert!(parted[nth].total_cmp(&parted[behind]).is_le());
        }
        let sum = |bits: [u32; 3]| bits.iter().fold(0, |sum: u32, b| sum.wrapping_add(*b));
        assert!(sum(parted.map(f32::to_bits)) == sum(bits));
    }
}
