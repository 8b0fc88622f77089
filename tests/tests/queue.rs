//! More triangles than the vector code queues, all of them to be drawn.

use halfplane::{
    Ids, ModelPositions, NO_ID, Region, Standard, State, Viewport, draw,
    simd::{self, Snapped, Triangles},
    texels,
};
use halfplane_tests::properties::simd::levels;

/// A triangle for each pixel, and for each another over it: the order shows in the ids.
#[test]
fn ids_of_a_full_queue_are_the_scalar_ones() {
    const SIDE: u32 = 16;
    let region = Region::<Standard>::of_size(SIDE, SIDE).unwrap();
    let at = |pixel: u32| pixel as f32 / (SIDE / 2) as f32 - 1.0;
    let mut vertices = Vec::new();
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let (x, y, width) = (at(x), at(y), 2.0 / SIDE as f32);
        vertices.extend([[x, y, 0.5], [x + 2.0 * width, y, 0.5], [x, y + 2.0 * width, 0.5]]);
    }
    let count = vertices.len() as u16;
    let indices: Vec<u16> = (0..count).chain((0..count).rev()).collect();
    let identity =
        std::array::from_fn(|row| std::array::from_fn(|column| f32::from(u8::from(row == column))));
    let positions = ModelPositions::new(&vertices, identity, Viewport::new(region));
    let state = State::new(region);

    let mut expected = [NO_ID; texels(SIDE, SIDE)];
    let mut ids = Ids::new(region, &mut expected).unwrap();
    let wanted = draw(&positions, &indices, 0, &state, &mut ids).unwrap();
    assert_eq!(wanted.drawn, 2 * SIDE * SIDE);
    assert!(expected.iter().all(|&id| id != NO_ID));
    for level in levels() {
        let mut given = [NO_ID; texels(SIDE, SIDE)];
        let mut ids = Ids::new(region, &mut given).unwrap();
        let mut records = vec![Snapped::default(); vertices.len()];
        let list = Triangles::new(&indices, vertices.len()).unwrap();
        let statistics = simd::draw(level, &positions, &mut records, list, 0, &state, &mut ids).unwrap();
        assert_eq!(statistics, wanted, "{}", level.name());
        assert_eq!(given, expected, "{}", level.name());
    }
}
