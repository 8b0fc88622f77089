//! Meshlets in the making.

use super::super::{
    meshlet::{Builder, Made, Meshlet, TRIANGLES, VERTICES, max_meshlets},
    window::MeshletScratch,
};
use crate::proof::{cover, prove};

prove! {
    /// Enough room: each meshlet but the last is full of triangles, or of vertices, three new ones to a
    /// triangle at most.
    [max_meshlets]
    fn meshlets_hold_all_triangles(triangles: usize) {
        let most = max_meshlets(triangles);
        assert!(most as u128 * (VERTICES as u128 / 3) >= triangles as u128);
        assert!(most == 0 || (most as u128 - 1) * (VERTICES as u128 / 3) < triangles as u128);
        cover!(triangles == usize::MAX);
    }

    /// A meshlet that is finished has the next place, if there is one, and is counted in any case.
    #[kani::unwind(97)]
    [Made::push]
    fn slow_finished_meshlets_are_counted(first: u32, count: usize = 0..=2) {
        let mut memory = [Meshlet::EMPTY; 2];
        let mut made = Made { meshlets: &mut memory, count };
        made.push(&Builder::new(first));
        assert!(made.count == count + 1);
        for (place, meshlet) in memory.iter().enumerate() {
            assert!(meshlet.first() == if place == count { first } else { 0 });
        }
        cover!(count == 2 && first > 0);
        cover!(count == 1 && first > 0);
    }

    /// The number after the last triangle's, and how many there are; nothing overflows.
    [Meshlet::end, Meshlet::count]
    fn meshlets_end_behind_their_triangles(first: u32, triangles: u8) {
        let mut meshlet = Meshlet::EMPTY;
        (meshlet.first, meshlet.triangles) = (first, triangles);
        assert!(meshlet.count() == u32::from(triangles));
        assert!(meshlet.end() as u64 == (u64::from(first) + u64::from(triangles)).min(u64::from(u32::MAX)));
        cover!(meshlet.end() == u32::MAX as usize);
    }

    /// A vertex widens the box to itself, or without end where it is not finite.
    #[kani::unwind(4)]
    [Meshlet::place]
    fn boxes_hold_their_vertices(bits: [u32; 3], low: u32, high: u32) {
        let position = bits.map(f32::from_bits);
        let (low, high) = (f32::from_bits(low), f32::from_bits(high));
        if low.is_nan() || high.is_nan() {
            return;
        }
        let mut meshlet = Meshlet::EMPTY;
        (meshlet.low, meshlet.high) = ([low; 3], [high; 3]);
        meshlet.place(VERTICES - 1, position);
        let finite = position.iter().all(|v| v.is_finite());
        for axis in 0..3 {
            let (new_low, new_high) = (meshlet.low[axis], meshlet.high[axis]);
            if finite {
                assert!(new_low <= position[axis] && position[axis] <= new_high);
                assert!(new_low == low || new_low == position[axis]);
                assert!(new_high == high || new_high == position[axis]);
            } else {
                assert!(new_low == f32::NEG_INFINITY && new_high == f32::INFINITY);
            }
            assert!(new_low <= low && high <= new_high);
            assert!(meshlet.positions[axis][VERTICES - 1].to_bits() == bits[axis]);
        }
        meshlet.place(VERTICES, [0.0; 3]);
        cover!(!finite);
        cover!(finite && meshlet.low[0] == low);
    }

    /// There is room for what [`MeshletScratch::add`] may add, and sums do not overflow.
    [MeshletScratch::has_room]
    fn rooms_are_large_enough(vertices: usize = 0..=2048, count: usize = 0..=2048, member: u8) {
        let mut scratch = MeshletScratch::NEW;
        (scratch.vertices, scratch.count, scratch.member) = (vertices, count, member);
        let room = scratch.has_room();
        assert!(!room || (vertices + VERTICES <= 2048 && count + TRIANGLES <= 2048 && member < 255));
        cover!(room && vertices == 2048 - VERTICES);
    }

    /// A triangle's vertices are put in, in their order, and its corners name them.
    #[kani::unwind(97)]
    [Builder::new, Builder::add, Meshlet::corners, Meshlet::first]
    fn slow_triangles_name_their_vertices(first: u32) {
        let mut builder = Builder::new(first);
        assert!(builder.add([2, 0, 2], &[[1.0; 3], [2.0; 3], [3.0; 3]]));
        assert!(builder.meshlet.first() == first && builder.meshlet.vertices() == 2);
        assert!(builder.meshlet.corners() == [[0, 1, 0]]);
        assert!(builder.meshlet.positions[1][0] == 3.0 && builder.meshlet.positions[1][1] == 1.0);
    }
}
