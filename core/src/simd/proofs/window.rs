//! Where the fast path's triangles come from.

use super::{
    super::{
        meshlet::{Meshlet, TRIANGLES, VERTICES},
        source::{InView, Listed, Source},
        vertex::VertexLanes,
        window::MeshletScratch,
    },
    simd,
};
use crate::{
    geometry::{Assembly, Region},
    numbers::Standard,
    proof::{cover, prove},
    transform::{ModelPositions, Viewport},
};

const IDENTITY: [[f32; 4]; 4] = [[1., 0., 0., 0.], [0., 1., 0., 0.], [0., 0., 1., 0.], [0., 0., 0., 1.]];

prove! {
    /// A meshlet without vertices is added, and the next triangle is found to be its, whatever the numbers.
    #[kani::unwind(17)]
    [MeshletScratch::add, MeshletScratch::origin, VertexLanes::new, InView::id]
    fn meshlets_are_added_where_there_is_room(first_id: u32, number: u32, first: u32) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let camera = ModelPositions::new(&[], IDENTITY, Viewport::new(region));
        let mut scratch = MeshletScratch::NEW;
        (scratch.vertices, scratch.count) = (2048 - VERTICES, 2048 - TRIANGLES);
        scratch.add(simd(), &VertexLanes::new(simd(), &camera), &Meshlet::EMPTY, number);
        assert!((scratch.vertices, scratch.count, scratch.member) == (2048 - VERTICES, 2048 - TRIANGLES, 1));
        assert!(scratch.origin(2048 - TRIANGLES as u32) == (number as usize, 0));
        let view = InView { scratch: &scratch, meshlets: &[Meshlet::EMPTY], camera: &camera, first_id };
        assert!(view.id(2048 - TRIANGLES as u32 + first % 4) == first_id.wrapping_add(first % 4));
    }

    /// A triangle of a list has its own id, and none where its vertices are not there or it is not.
    #[kani::unwind(8)]
    [Listed::id, Listed::assemble]
    fn listed_triangles_without_vertices_are_none(first_id: u32, triangle: u32) {
        let Ok(region) = Region::<Standard>::of_size(64, 64) else { return };
        let positions = ModelPositions::new(&[], IDENTITY, Viewport::new(region));
        let source = Listed { positions: &positions, triangles: &[[0_u16, 1, 2], [3, 4, 5]], first_id };
        assert!(source.id(triangle) == first_id.wrapping_add(triangle));
        assert!(source.assemble(triangle, |_| unreachable!("there is none")) == Assembly::NoVertex);
        cover!(triangle == 1);
    }
}
