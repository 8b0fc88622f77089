//! Batches of meshlets.

use super::super::{
    batch::{Batch, make_batches, max_batches},
    meshlet::{Meshlet, MeshletError},
};
use crate::proof::{assume, cover, prove};

/// Meshlets whose box begins at their number.
fn numbered<const N: usize>() -> [Meshlet; N] {
    let mut meshlets = [Meshlet::EMPTY; N];
    for (meshlet, number) in meshlets.iter_mut().zip([0.0, 1.0, 2.0]) {
        meshlet.low = [number; 3];
    }
    meshlets
}

prove! {
    /// A batch has its meshlets from the first on, as far as they are there: any numbers.
    #[kani::unwind(4)]
    [Batch::meshlets]
    fn slow_batches_have_their_meshlets(first: u32, count: u32, given: usize = 0..=3) {
        let meshlets = numbered::<3>();
        let batch = Batch { first, count, ..Batch::EMPTY };
        let found = batch.meshlets(&meshlets[..given]);
        assert!(found.len() as u64 == (given as u64).saturating_sub(first.into()).min(count.into()));
        assert!(found.first().is_none_or(|meshlet| meshlet.low[0] == first as f32));
        cover!(first == 1 && found.len() == 2);
    }

    /// Nine meshlets make a batch of eight and one of one, each with a box that holds its meshlets': any boxes.
    #[kani::unwind(10)]
    [make_batches, max_batches]
    fn slow_batches_hold_their_meshlets(low: [u32; 9], high: [u32; 9], given: usize = 0..=2) {
        let mut meshlets = [Meshlet::EMPTY; 9];
        for (meshlet, (low, high)) in meshlets.iter_mut().zip(low.into_iter().zip(high)) {
            (meshlet.low[1], meshlet.high[1]) = (f32::from_bits(low), f32::from_bits(high));
        }
        let mut memory = [Batch::EMPTY; 2];
        match make_batches(&meshlets, &mut memory[..given]) {
            Err(error) => assert!(given < 2 && error == MeshletError::TooFew { needed: 2, given }),
            Ok(batches) => {
                assert!(given == 2 && batches.len() == max_batches(9));
                assert!((batches[0].first, batches[0].count) == (0, 8));
                assert!((batches[1].first, batches[1].count) == (8, 1));
                for at in [0, 5, 7, 8] {
                    let [low, high] = batches[at / 8].corners();
                    assert!(!(meshlets[at].low[1] < low[1] || high[1] < meshlets[at].high[1]));
                }
            }
        }
        cover!(given == 1);
    }

    /// The distance is the smallest w of the box's corners, and no vertex in the box has a smaller one, as rounded: for any
    /// places along one axis.
    [Batch::distance]
    fn no_vertex_is_nearer(low: u32, high: u32, place: u32) {
        let [low, high, place] = [low, high, place].map(f32::from_bits);
        assume!(low <= place && place <= high && low.is_finite() && high.is_finite());
        let [m0, m1, m2, m3] = [2.0, -1.0, 0.5, 3.0];
        let matrix = [[0., 0., 0., m0], [0., 0., 0., m1], [0., 0., 0., m2], [0., 0., 0., m3]];
        let corners = [[1.0, low, 6.0], [2.0, high, 8.0]];
        let distance = Batch { corners, ..Batch::EMPTY }.distance(&matrix);
        let w = m3 + 1.0 * m0 + place * m1 + 7.0 * m2;
        assert!(distance <= w && distance == m3 + 1.0 * m0 + high * m1 + 6.0 * m2);
        cover!(distance == w - 0.5 && distance == 9.0);
    }
}
