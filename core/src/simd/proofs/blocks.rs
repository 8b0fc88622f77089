//! Where a triangle's blocks are.

use super::{
    super::{
        attachment::Gradients,
        blocks::{Placed, inside, upper},
        ops::bits,
        setup::{Batch, DepthSetup},
    },
    simd,
};
use crate::proof::{cover, prove};

prove! {
    /// The window of a lane: whole blocks, as many as hold the pixels. Bounds of the largest target, not
    /// empty.
    #[kani::unwind(17)]
    [Placed::from_batch]
    fn windows_are_whole_blocks(
        low: [i32; 2] = [0; 2]..=[16383; 2],
        size: [i32; 2] = [1; 2]..=[128; 2],
        words: [u64; 3],
        lane: usize = 0..=15,
    ) {
        let mut batch = Batch::EMPTY;
        let ([x0, y0], [width, height]) = (low, size);
        for (to, from) in batch.bounds.iter_mut().zip([x0, x0 + width, y0, y0 + height]) {
            to[lane] = from;
        }
        let [origin, gradient_x, gradient_y] = words;
        batch.origin[lane] = origin;
        (batch.gradients[0][lane], batch.gradients[1][lane]) = (gradient_x, gradient_y);
        let placed = Placed::from_batch(&batch, lane);
        let (x, y) = (placed.x as i32, placed.y as i32);
        let (columns, rows) = (placed.columns as i32, placed.rows as i32);
        assert!(x % 4 == 0 && y % 4 == 0);
        assert!(x <= x0 && x0 < x + 4 && y <= y0 && y0 < y + 4);
        assert!(x + 4 * (columns - 1) < x0 + width && x0 + width <= x + 4 * columns);
        assert!(y + 4 * (rows - 1) < y0 + height && y0 + height <= y + 4 * rows);
        assert!((placed.origin, placed.gradients.x, placed.gradients.y) == (origin, gradient_x, gradient_y));
        cover!(columns == 33);
    }

    /// What four pixels add is four times what one adds.
    [Placed::block_steps, upper]
    fn blocks_are_four_steps(gradients: [u64; 2]) {
        let [x, y] = gradients;
        let gradients = Gradients { x, y };
        let placed = Placed { x: 0, y: 0, columns: 1, rows: 1, origin: 0, gradients };
        let [right, down] = placed.block_steps();
        assert!(right == x.wrapping_add(x).wrapping_add(x).wrapping_add(x));
        assert!(down == y.wrapping_add(y).wrapping_add(y).wrapping_add(y));
        assert!(u64::from(upper(x)) == x / (1 << 32));
    }

    /// A lane for each of the low sixteen bits.
    [inside]
    fn masks_have_sixteen_bits(mask: u32) {
        assert!(bits(inside(simd(), mask)) == mask % (1 << 16));
    }

    /// Half a unit of the format's depth, in 32.32 fixed point.
    [DepthSetup::half]
    fn halves_are_halves(depth: bool) {
        let (setup, unit) = if depth { (DepthSetup::D32, 1_u64 << 32) } else { (DepthSetup::D16, 1 << 48) };
        assert!(setup.half() == unit / 2);
        cover!(depth);
    }
}
