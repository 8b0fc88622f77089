//! What becomes of triangles that are not drawn by the fast path.

use super::{Drawing, Scratch};
use crate::{
    attachments::{Coverage, Ids, NO_ID},
    draw::{State, Statistics},
    geometry::{Assembly, Cull, Region, Vertex},
    numbers::Standard,
    proof::{cover, prove},
    simd::{
        attachment::RowAttachment, cull::Culling, fetch::Records, proofs::simd, source::Source,
        vertex::SPECIAL,
    },
};
use core::cell::Cell;

/// Triangles that are asked for one after the other, each of them not finite.
#[derive(Clone, Copy)]
struct Asked<'a> {
    first_id: u32,
    /// The one before, and the ids so far, added up.
    last: &'a Cell<u32>,
    sum: &'a Cell<u32>,
}

impl Source for Asked<'_> {
    fn id(&self, triangle: u32) -> u32 {
        let id = self.first_id.wrapping_add(triangle);
        self.sum.set(self.sum.get().wrapping_add(id));
        id
    }

    fn assemble(&self, triangle: u32, _: impl FnMut([Vertex<Standard>; 3])) -> Assembly {
        assert!(triangle == self.last.get().wrapping_add(1));
        self.last.set(triangle);
        Assembly::NonFinite
    }
}

/// A draw of eighteen triangles: four are culled, and the others have a vertex without a place.
fn run<A: RowAttachment>(first_id: u32, attachments: &mut A) -> (Statistics, u32) {
    let Ok(region) = Region::<Standard>::of_size(4, 4) else { unreachable!("it has pixels") };
    let special = [(SPECIAL | 3) as u32, 0];
    let places = [[0, 512], [1024, 0], [0, 1024], special, [2048, 0], [2048, 1024], [4096, 9]];
    let records = Records { places: &places, depths: &[9; 7] };
    let mut triangles = [[0_u16, 1, 3]; 18];
    // Facing the culled way, without area, outside by its vertices' planes and by its place.
    (triangles[0], triangles[1]) = ([0, 2, 1], [0, 1, 0]);
    (triangles[2], triangles[3]) = ([3, 3, 3], [4, 5, 6]);
    let state = State { cull: Cull::Back, ..State::new(region) };
    let (last, sum) = (Cell::new(3), Cell::new(0));
    let source = Asked { first_id, last: &last, sum: &sum };
    let drawing =
        Drawing { simd: simd(), records, triangles: &triangles, source, area: region, state: &state };
    let mut statistics = Statistics::default();
    let culling = Culling::new(simd(), region, &state);
    drawing.run(&culling, &mut Scratch::EMPTY.clone(), attachments, &mut statistics);
    assert!(last.get() == 17);
    (statistics, sum.get())
}

/// Each triangle is counted once, by what becomes of it, and the ids are those of the fourteen that are left.
fn are_counted((statistics, sum): (Statistics, u32), first_id: u32) {
    let Statistics { drawn, culled, rejected, .. } = statistics;
    assert!((culled.facing, culled.zero_area, culled.outside, culled.no_sample) == (1, 1, 2, 0));
    assert!(drawn == 0 && rejected.non_finite == 14);
    let numbers = 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11 + 12 + 13 + 14 + 15 + 16 + 17;
    assert!(sum == first_id.wrapping_mul(14).wrapping_add(numbers));
}

prove! {
    /// Triangles whose vertices have no place are asked for in order, with their ids; culled ones are counted. Where
    /// the order matters: into ids, of which none is written.
    #[kani::unwind(20)]
    [Drawing::run, Drawing::in_order, Drawing::one]
    fn slow_special_ones_are_asked_for_in_order(first_id: u32) {
        let Ok(region) = Region::of_size(4, 4) else { return };
        let mut texels = [NO_ID; 16];
        let Ok(mut ids) = Ids::new(region, &mut texels) else { unreachable!("there are enough") };
        are_counted(run(first_id, &mut ids), first_id);
        assert!(texels == [NO_ID; 16]);
        cover!(first_id == u32::MAX);
    }

    /// The same where it does not matter: into coverage.
    #[kani::unwind(20)]
    [Drawing::run, Drawing::one]
    fn slow_special_ones_are_asked_for(first_id: u32) {
        let Ok(region) = Region::of_size(4, 4) else { return };
        let mut masks = [0];
        let Ok(mut coverage) = Coverage::new(region, &mut masks) else { unreachable!("there are enough") };
        are_counted(run(first_id, &mut coverage), first_id);
        assert!(masks == [0]);
    }

    /// Triangles come to the lanes by their numbers, and some triangle where there is none.
    #[kani::unwind(17)]
    [Drawing::sixteen]
    fn slow_triangles_come_by_their_numbers(numbers: [u32; 16], lane: usize = 0..=15) {
        let Ok(region) = Region::<Standard>::of_size(4, 4) else { return };
        let (last, sum, state) = (Cell::new(0), Cell::new(0), State::new(region));
        let triangles = [[1_u16, 2, 3], [4, 5, 6], [7, 8, 9]];
        let drawing = Drawing {
            simd: simd(),
            records: Records { places: &[], depths: &[] },
            triangles: &triangles,
            source: Asked { first_id: 0, last: &last, sum: &sum },
            area: region,
            state: &state,
        };
        let found = drawing.sixteen(&numbers)[lane];
        let number = numbers[lane];
        assert!(found == if number < 3 { triangles[number as usize] } else { [0; 3] });
        cover!(number == 2 && lane == 15);
    }
}
