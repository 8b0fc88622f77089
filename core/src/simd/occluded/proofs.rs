//! Batches from front to back.

use super::{BatchOrder, Worth, front_to_back, triangles_of};
use crate::{
    proof::{assume, cover, prove},
    simd::{
        batch::Batch,
        meshlet::{Builder, Meshlet},
    },
};

/// A meshlet of so many triangles.
#[inline(always)]
fn meshlet(triangles: u32) -> Meshlet {
    let mut builder = Builder::new(7);
    for _ in 0..triangles {
        builder.add([0, 0, 0], &[]);
    }
    builder.meshlet
}

prove! {
    /// Batches are ordered by their distances first, NaN and what is below 0 being 0, then by their places, which come
    /// out again.
    [BatchOrder::of, BatchOrder::place]
    fn orders_are_by_distance(first: u32, second: u32, places: [u32; 2]) {
        let [near, far] = [first, second].map(f32::from_bits);
        let keys = [BatchOrder::of(near, places[0]), BatchOrder::of(far, places[1])];
        assert!(keys[0].place() == places[0] as usize);
        let [near, far] = [near, far].map(|distance| if distance > 0.0 { distance } else { 0.0 });
        let by_place = near == far && places[0] < places[1];
        assert!((keys[0].0 < keys[1].0) == (near < far || by_place));
        cover!(near < far && places[0] > places[1]);
        cover!(by_place && second & 0x7FFF_FFFF == 0 && second > 0);
    }

    /// Questions go on for as long as there are answers "hidden" now and then: each pays for some, up to a limit.
    [Worth::asking, Worth::hidden]
    fn questions_stop_where_nothing_is_hidden(left: u32 = 0..=96, hidden: bool) {
        let mut worth = Worth(left);
        if hidden {
            worth.hidden();
        }
        assert!(worth.0 == if hidden { Worth::NEW.0.min(left + 32) } else { left });
        let before = worth.0;
        assert!(worth.asking() == (before > 0));
        assert!(worth.0 == before.saturating_sub(1));
        cover!(left == 0 && hidden);
        cover!(left == 0 && !hidden);
    }

    /// As many triangles as all meshlets have.
    #[kani::unwind(17)]
    [triangles_of]
    fn slow_triangles_are_added_up(given: usize = 0..=3) {
        let meshlets = [meshlet(2), meshlet(0), meshlet(3)];
        assert!(triangles_of(&meshlets[..given]) == [0, 2, 2, 5][given]);
        cover!(given == 3);
    }

    /// The batches that are kept come in the order of their distances, behind the eye at 0, then of their places.
    #[kani::unwind(5)]
    [front_to_back, Batch::distance, sort]
    fn batches_come_from_front_to_back(near: [u32; 2], keep: [bool; 2]) {
        let near = near.map(f32::from_bits);
        assume!(near[0].abs() < 1e9 && near[1].abs() < 1e9);
        // w is z.
        let matrix = [[0.; 4], [0.; 4], [0., 0., 0., 1.], [0.; 4]];
        let [a, b] = near.map(|z| Batch { corners: [[0., 0., z], [0., 0., 1e9]], ..Batch::EMPTY });
        let batches = [a, Batch { first: 1, ..b }];
        let mut memory = [BatchOrder::NEW; 2];
        let order = front_to_back(&batches, &matrix, &mut memory, |batch| keep[batch.first() as usize & 1]);
        let places = |at: usize| order.get(at).map(|key| key.0 as u32);
        let second_is_nearer = near[1].max(0.0) < near[0].max(0.0);
        let expected = match keep {
            [true, true] if second_is_nearer => [Some(1), Some(0)],
            [true, true] => [Some(0), Some(1)],
            [true, false] => [Some(0), None],
            [false, true] => [Some(1), None],
            [false, false] => [None, None],
        };
        assert!([places(0), places(1)] == expected);
        cover!(keep == [true; 2] && second_is_nearer && near[1] < 0.0);
    }
}
