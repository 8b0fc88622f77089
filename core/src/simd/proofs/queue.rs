//! The queue between culling and set-up.

use super::{
    super::{cull::padded, queue::Queue},
    Mask, simd,
};
use crate::proof::{cover, prove};
use fearless_simd::prelude::*;

/// A queue of the numbers from 0 on, `count` of them, up to sixteen.
#[inline(always)]
fn counted(count: u32) -> Queue {
    let mut queue = Queue::EMPTY;
    queue.push(simd(), 0, Mask::from_bitmask(simd(), (1 << count) - 1));
    queue
}

prove! {
    /// The set bits are queued in order behind what is there: the number at a place is a set bit's, and there
    /// are as many set bits below it as numbers before it.
    #[kani::unwind(18)]
    [Queue::push, Queue::batch, Queue::len]
    fn set_bits_are_queued_in_order(mask: u32 = 0..=0xFFFF) {
        let (first, before) = (1000, 3);
        let mut queue = counted(3);
        queue.push(simd(), first, Mask::from_bitmask(simd(), u64::from(mask)));
        assert!(queue.len() == before + mask.count_ones() as usize);
        assert!(queue.batch(0).0[..3] == [0, 1, 2]);
        let (numbers, count) = queue.batch(before);
        for place in [0, 1, 7, 14, 15] {
            let lane = numbers[place].wrapping_sub(first);
            let is_its_place = lane < 16 && mask >> (lane & 15) & 1 != 0 && (mask & ((1 << (lane & 15)) - 1)).count_ones() == place as u32;
            assert!(place >= count || is_its_place);
        }
        cover!(count == 15);
    }

    /// Forgetting leaves the rest in front.
    #[kani::unwind(18)]
    [Queue::forget, Queue::batch, Queue::has_room]
    fn the_rest_moves_to_the_front(count: usize = 0..=14, at: usize = 0..=15) {
        let mut queue = counted(14);
        queue.forget(count);
        let (numbers, left) = queue.batch(0);
        assert!(left == 14 - count && queue.len() == left && queue.has_room());
        assert!(at >= left || numbers[at] == (count + at) as u32);
        cover!(left == 0);
        cover!(left == 13 && at == 12);
    }

    /// There is room for sixteen more up to a number, and a queue without room is not asked for more.
    #[kani::unwind(18)]
    [Queue::has_room, Queue::push]
    fn queues_fill_up(mask: u32 = 0..=0xFFFF) {
        let mut queue = Queue::EMPTY;
        let mut pushed = 0;
        for _ in 0..15 {
            assert!(queue.has_room());
            queue.push(simd(), 0, Mask::from_bitmask(simd(), 0xFFFF));
            pushed += 16;
        }
        assert!(queue.len() == pushed && !queue.has_room());
        queue.push(simd(), 7, Mask::from_bitmask(simd(), u64::from(mask)));
        assert!(queue.len() <= pushed + 16);
    }

    /// Places beyond the queue hold nothing.
    [Queue::batch]
    fn no_place_is_beyond_the_queue(at: usize) {
        let (_, count) = Queue::EMPTY.batch(at);
        assert!(count == 0);
    }

    /// The triangles that are there, and others after them. Of up to three; more are moved alike.
    #[kani::unwind(18)]
    [padded]
    fn the_last_are_padded(triangles: [[u8; 3]; 3], count: usize = 0..=3, at: usize = 0..=2) {
        let Some(rest) = triangles.get(..count) else { return };
        let sixteen = padded(rest);
        assert!(rest.get(at).is_none_or(|triangle| sixteen[at] == *triangle));
        cover!(count == 3 && at == 2);
    }
}
