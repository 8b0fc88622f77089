//! The queue between culling and set-up.

use super::{
    super::{cull::padded, queue::Queue},
    Mask, simd,
};
use crate::proof::{assume, cover, prove};
use fearless_simd::prelude::*;

/// A queue of the numbers from 0 on, `count` of them.
fn counted(count: usize) -> Queue {
    let mut queue = Queue::EMPTY;
    for at in 0..2 {
        let present = (count.saturating_sub(16 * at)).min(16);
        queue.push(simd(), 16 * at as u32, Mask::from_bitmask(simd(), (1 << present) - 1));
    }
    queue
}

prove! {
    /// The set bits are queued in order behind what is there.
    #[kani::unwind(18)]
    [Queue::push, Queue::batch, Queue::len]
    fn set_bits_are_queued_in_order(mask: u32 = 0..=0xFFFF, before: usize = 0..=17, lane: u32 = 0..=15) {
        let first = 1000;
        let mut queue = counted(before);
        queue.push(simd(), first, Mask::from_bitmask(simd(), u64::from(mask)));
        assert!(queue.len() == before + mask.count_ones() as usize);
        let place = before + (mask & ((1 << lane) - 1)).count_ones() as usize;
        assume!(mask >> lane & 1 != 0);
        let (numbers, count) = queue.batch(place);
        assert!(count >= 1 && numbers[0] == first + lane);
        let (numbers, _) = queue.batch(0);
        assert!(before == 0 || numbers[0] == 0);
        cover!(place == 32);
    }

    /// Forgetting leaves the rest in front, as far as it is fewer than sixteen.
    #[kani::unwind(18)]
    [Queue::forget, Queue::batch, Queue::has_room]
    fn the_rest_moves_to_the_front(before: usize = 0..=32, count: usize = 0..=32, at: usize = 0..=15) {
        assume!(count <= before && before - count < 16);
        let mut queue = counted(before);
        queue.forget(count);
        let (numbers, left) = queue.batch(0);
        assert!(left == before - count && queue.len() == left && queue.has_room());
        assert!(at >= left || numbers[at] == (count + at) as u32);
        cover!(left == 15 && count == 17);
    }

    /// Places beyond the queue hold nothing.
    [Queue::batch]
    fn no_place_is_beyond_the_queue(at: usize) {
        let (_, count) = Queue::EMPTY.batch(at);
        assert!(count == 0);
    }

    /// The triangles that are there, and others after them.
    #[kani::unwind(18)]
    [padded]
    fn the_last_are_padded(triangles: [[u16; 3]; 15], count: usize = 0..=15, at: usize = 0..=15) {
        let Some(rest) = triangles.get(..count) else { return };
        let sixteen = padded(rest);
        assert!(rest.get(at).is_none_or(|triangle| sixteen[at] == *triangle));
        cover!(count == 15 && at == 14);
    }
}
