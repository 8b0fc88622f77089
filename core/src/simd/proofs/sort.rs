//! Sorting.

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

    /// Of two floats, whatever their bits, either rank is put in its place; both are still there.
    #[kani::unwind(5)]
    [select, swap]
    fn slow_two_are_parted(keys: [u32; 2], nth: usize = 0..=1) {
        let mut parted = keys;
        select(&mut parted, nth, |&key| f32::from_bits(key));
        let [first, second] = parted;
        assert!(f32::from_bits(first).total_cmp(&f32::from_bits(second)).is_le());
        assert!(parted == keys || [second, first] == keys);
        cover!(nth == 1 && parted != keys);
    }
}
