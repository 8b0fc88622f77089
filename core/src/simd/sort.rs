//! Sorting that cannot panic: the standard library's would, told an order that is none.

/// Puts elements into the order of their keys: by a heap, so in n log n steps whatever they are.
pub(super) fn sort<T>(elements: &mut [T], key: impl Fn(&T) -> u64) {
    let count = elements.len();
    for root in (0..count / 2).rev() {
        sift(elements, root, count, &key);
    }
    for last in (1..count).rev() {
        swap(elements, 0, last);
        sift(elements, 0, last, &key);
    }
}

/// Moves an element down the heap of the first `count` until none below it is greater.
fn sift<T>(elements: &mut [T], mut root: usize, count: usize, key: &impl Fn(&T) -> u64) {
    let at = |elements: &[T], place: usize| elements.get(place).filter(|_| place < count).map(key);
    loop {
        let (left, right) = (2 * root + 1, 2 * root + 2);
        let larger = if at(elements, right) > at(elements, left) { right } else { left };
        if at(elements, larger).is_none() || at(elements, larger) <= at(elements, root) {
            return;
        }
        swap(elements, root, larger);
        root = larger;
    }
}

/// Puts the element whose key has the rank `nth` there, no greater ones before it and no smaller ones behind: Hoare's
/// selection, by the middle of three.
pub(super) fn select<T>(elements: &mut [T], nth: usize, key: impl Fn(&T) -> f32) {
    // Floats as integers of the same order, NaN at the ends.
    let key = |element: &T| {
        let bits = key(element).to_bits() as i32;
        bits ^ (((bits >> 31) as u32) >> 1) as i32
    };
    let at = |elements: &[T], place: usize| elements.get(place).map(&key);
    let (mut low, mut high) = (0, elements.len().saturating_sub(1));
    while low < high {
        let [a, b, c] = [low, low + (high - low) / 2, high].map(|place| at(elements, place));
        let pivot = a.min(b).max(a.max(b).min(c));
        let (mut left, mut right) = (low, high);
        while left <= right {
            while at(elements, left).is_some() && at(elements, left) < pivot {
                left += 1;
            }
            while right > 0 && at(elements, right) > pivot {
                right -= 1;
            }
            if left <= right {
                swap(elements, left, right);
                left += 1;
                let Some(next) = right.checked_sub(1) else { break };
                right = next;
            }
        }
        if nth <= right && right < high {
            high = right;
        } else if nth >= left {
            low = left;
        } else {
            return;
        }
    }
}

fn swap<T>(elements: &mut [T], a: usize, b: usize) {
    if let Ok([a, b]) = elements.get_disjoint_mut([a, b]) {
        core::mem::swap(a, b);
    }
}
