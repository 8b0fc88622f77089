//! Object space to clip space.

use crate::{
    geometry::Region,
    numbers::Standard,
    proof::{assume, cover, prove},
    transform::{ModelPositions, Viewport},
};

prove! {
    /// Through the identity a vertex is itself, with w = 1.
    [ModelPositions::clip_point]
    fn the_identity_keeps_vertices(bits: [u32; 3]) {
        const IDENTITY: [[f32; 4]; 4] =
            [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        let position = bits.map(f32::from_bits);
        assume!(position.iter().all(|v| v.is_finite()));
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let model = ModelPositions::new(&[], IDENTITY, Viewport::new(region));
        let [x, y, z] = position;
        assert!(model.clip_point(position) == [x, y, z, 1.0]);
        cover!(x == f32::MAX && y == -1.0);
    }
}
