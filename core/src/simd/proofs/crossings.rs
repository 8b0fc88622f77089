//! Whole triangles from their crossings: small, medium, and row by row.

use super::{
    super::{
        blocks::{draw_medium, draw_small},
        rows::{Solved, draw_double, draw_single},
        setup::{Batch, Crossing, DepthSetup},
        windows::Windows,
    },
    simd,
};
use crate::{
    attachments::{Coverage, Ids},
    geometry::{Region, Sample, Triangle, Vertex},
    numbers::Standard,
    proof::prove,
    traversal::traverse,
};

fn region() -> Region<Standard> {
    Region::of_size(16, 8).unwrap_or_else(|_| unreachable!("it has pixels"))
}

/// A batch whose triangles have these bounds.
fn within(bounds: [i32; 4]) -> Batch {
    Batch { bounds: bounds.map(|bound| [bound; 16]), ..Batch::EMPTY }
}

/// The masks of the region's blocks, first those of the first row.
fn masks(draw: impl FnOnce(&mut Coverage<'_, Standard>)) -> [u16; 8] {
    let mut masks = [0; 8];
    let Ok(mut coverage) = Coverage::new(region(), &mut masks) else { unreachable!("there are enough") };
    draw(&mut coverage);
    masks
}

prove! {
    /// A small triangle's masks come to its four blocks.
    #[kani::unwind(17)]
    [draw_small, Placed::from_batch, Placed::block_steps, inside, upper]
    fn small_masks_come_to_their_blocks(upper: u32, lower: u32, origin: u64, gradient: u64) {
        let mut batch = within([5, 9, 1, 7]);
        (batch.origin, batch.gradients) = ([origin; 16], [[gradient; 16]; 2]);
        let mut windows = Windows::EMPTY;
        (windows.0[0][0][6], windows.0[1][0][6]) = (upper, lower);
        let found = masks(|coverage| draw_small(simd(), &batch, &windows, 6, 0, coverage));
        let halves = |pair: u32| [pair as u16, (pair >> 16) as u16];
        let ([a, b], [c, d]) = (halves(upper), halves(lower));
        assert!(found == [0, a, b, 0, 0, c, d, 0]);
    }

    /// A medium triangle's masks come to its blocks, as many as its bounds have.
    #[kani::unwind(17)]
    [draw_medium, Placed::from_batch, Placed::block_steps, inside, upper]
    fn medium_masks_come_to_their_blocks(pairs: [u32; 3], origin: u64, gradient: u64) {
        let mut batch = within([1, 11, 2, 8]);
        (batch.origin, batch.gradients) = ([origin; 16], [[gradient; 16]; 2]);
        let mut windows = Windows::EMPTY;
        let [first, second, below] = pairs;
        windows.0[0][0][6] = first;
        windows.0[0][1][6] = second;
        windows.0[1][0][6] = below;
        let found = masks(|coverage| draw_medium(simd(), &batch, &windows, 6, 0, coverage));
        let halves = |pair: u32| [pair as u16, (pair >> 16) as u16];
        let ([a, b], [c, _], [d, e]) = (halves(first), halves(second), halves(below));
        assert!(found == [a, b, c, 0, d, e, 0, 0]);
    }

    /// A triangle drawn row by row has the samples of its edge: x <= 44 / 7 here, whatever its depths.
    #[kani::unwind(17)]
    [Solved::from_batch, Single::new, Single::sixteen, draw_rows]
    fn rows_have_the_samples_of_an_edge(origin: u64, gradient: u64) {
        let far = |factor| Crossing { value: 1_000_000.0, step: 0.0, factor };
        let edge = Crossing { value: 44.5, step: 0.0, factor: 1.0 / 7.0 };
        let mut batch = within([0, 16, 0, 8]);
        (batch.origin, batch.gradients) = ([origin; 16], [[gradient; 16]; 2]);
        for (to, from) in batch.crossings.edges.iter_mut().zip([far(-1.0), edge, far(1.0)]) {
            *to = Crossing { value: [from.value; 16], step: [from.step; 16], factor: [from.factor; 16] };
        }
        (batch.crossings.third, batch.crossings.end) = ([f32::NEG_INFINITY; 16], [16.0; 16]);
        let solved = Solved::from_batch(&batch, 6);
        let found = masks(|coverage| {
            assert!(draw_single(simd(), &solved, region(), 0, coverage));
        });
        assert!(found == [0xFFFF, 0x7777, 0, 0, 0xFFFF, 0x7777, 0, 0]);
    }

    /// A triangle of any size has the samples of the scalar walk, with its id: one of them, in doubles.
    #[kani::unwind(17)]
    [Solved::from_triangle, Double::new, Double::eight, Double::sixteen, draw_rows]
    fn doubles_have_the_samples_of_a_triangle(id: u32) {
        let vertex = |x, y| Vertex::<Standard>::new(x, y, 0);
        let [Ok(a), Ok(b), Ok(c)] = [vertex(-300, 100), vertex(4000, 1000), vertex(500, 2100)] else { return };
        let Some(triangle) = Triangle::new([a, b, c], Sample::CENTER) else { return };
        let Ok(bounds) = triangle.bounds(region()) else { return };
        let solved = Solved::from_triangle(&triangle, bounds, DepthSetup::None, None);
        let mut texels = [7; 128];
        let Ok(mut ids) = Ids::new(region(), &mut texels) else { unreachable!("there are enough") };
        assert!(draw_double(simd(), &solved, region(), id, &mut ids));
        traverse(&triangle, region(), |x, y, mask| {
            for lane in 0..16 {
                let place = (y / 4 * 64 + x / 4 * 16 + lane) as usize;
                assert!(texels[place] == if mask.0 >> lane & 1 != 0 { id } else { 7 });
            }
        });
    }
}
