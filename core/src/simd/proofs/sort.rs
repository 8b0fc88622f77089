//! Sorting.

use super::super::sort::sort;
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
}
