//! What errors and statistics say, and the refusals that are no errors.

#[cfg(feature = "simd")]
use halfplane::simd::{Meshlet, make_meshlets};
use halfplane::{
    Assembly, Attachment, Block, ClipPositions, Coverage, CulledCounts, Depth, DepthTest, DrawError, Mask,
    ModelPositions, OutsideAttachment, Positions, Region, RejectedCounts, Sample, Small, Standard, State,
    Statistics, Triangle, Vertex, Viewport, draw, texels,
};
use std::error::Error;

fn say<T: std::fmt::Debug, E: Error>(outcome: Result<T, E>) -> String {
    outcome.unwrap_err().to_string()
}

#[test]
fn constructors_say_what_was_wrong_and_what_would_be_right() {
    assert_eq!(
        say(Region::<Small>::of_size(0, 7)),
        "a region of 0 x 7 pixels is empty: both must be at least 1"
    );
    let large = say(Region::<Small>::new(8, 4, 961, 12));
    assert_eq!(large, "a region up to (961, 12) exceeds the largest target, 960 x 960 pixels");
    let outside = say(Vertex::<Small>::new(-16385, 3, 0));
    let expected = "vertex (-16385, 3) lies outside the guard band: coordinates from -16384 to 16384 steps";
    assert_eq!(outside, expected);
    let region = Region::<Small>::new(4, 6, 20, 18).unwrap();
    let aligned = say(Coverage::new(region, &mut [0; 99]));
    assert_eq!(aligned, "an attachment's region begins at (4, 6): both must be multiples of 4");
    let region = Region::<Small>::of_size(8, 5).unwrap();
    assert_eq!(say(Coverage::new(region, &mut [0; 3])), "the buffer has 3 elements, the region needs 4");
}

#[test]
fn draws_say_what_was_wrong() {
    let vertices = [Vertex::<Small>::new(0, 0, 9).unwrap(); 3];
    let region = Region::of_size(8, 8).unwrap();
    let mut masks = [0; 4];
    let mut coverage = Coverage::new(region, &mut masks).unwrap();
    let state = State::new(region);
    let mut refused = |indices: &[u16], first_id, state: &State<Small>| {
        draw(&vertices[..], indices, first_id, state, &mut coverage).unwrap_err()
    };
    let count = refused(&[0, 1, 2, 0], 0, &state);
    assert_eq!(count.to_string(), "4 indices: a triangle list has a multiple of 3");
    let range = refused(&[0, 1, 2, 0, 3, 1], 0, &state);
    assert_eq!(range.to_string(), "index 3 at place 4 is out of range: there are 3 vertices");
    let ids = refused(&[0, 1, 2, 0, 1, 2], u32::MAX - 1, &state);
    assert_eq!(ids.to_string(), "2 triangles from id 4294967294 on need ids above 4294967294, the largest");
    let outside = refused(&[0, 1, 2], 0, &State::new(Region::of_size(8, 9).unwrap()));
    let source = OutsideAttachment { area: [0, 0, 8, 9], attachment: [0, 0, 8, 8] };
    assert_eq!(outside.to_string(), source.to_string());
    assert_eq!(outside.source().map(ToString::to_string), Some(source.to_string()));
    assert!(count.source().is_none());
    let scratch = DrawError::ScratchTooSmall { needed: 5, given: 4 };
    assert_eq!(scratch.to_string(), "4 records of scratch memory: one for each of 5 vertices is needed");
}

#[cfg(feature = "simd")]
#[test]
fn meshlets_say_what_was_wrong() {
    let positions = [[0.0; 3]; 3];
    assert_eq!(
        say(make_meshlets(&positions, &[0u16, 1, 2], &mut [])),
        "room for 0 meshlets: the mesh needs 1"
    );
    let wrong = say(make_meshlets(&positions, &[0u16, 1], &mut [Meshlet::EMPTY]));
    assert_eq!(wrong, "2 indices: a triangle list has a multiple of 3");
}

/// Few vertices and more triangles than a meshlet has places for.
#[cfg(feature = "simd")]
#[test]
fn meshlets_are_full_of_triangles_before_vertices() {
    let indices = [0u16, 1, 2].repeat(300);
    let mut meshlets = [Meshlet::EMPTY; 20];
    assert_eq!(make_meshlets(&[[0.0; 3]; 3], &indices, &mut meshlets).unwrap().len(), 300usize.div_ceil(128));
}

#[test]
fn statistics_say_everything() {
    let statistics = Statistics {
        submitted: 29,
        drawn: 1,
        culled: CulledCounts { facing: 2, zero_area: 3, no_sample: 4, outside: 5, hidden: 8 },
        rejected: RejectedCounts { non_finite: 6, ..RejectedCounts::default() },
        clipped: 7,
    };
    let expected = "submitted 29, drawn 1 (clipped 7)\n\
                    culled 22: facing 2, zero area 3, no sample 4, outside 5, hidden 8\n\
                    rejected 6: non-finite 6, no vertex 0";
    assert_eq!(statistics.to_string(), expected);
}

#[test]
fn samples_lie_in_their_pixel() {
    for outside in [[-1, 0], [0, -1], [256, 0], [0, 256]] {
        assert_eq!(Sample::<Standard>::new(outside[0], outside[1]), None, "{outside:?}");
    }
    assert!(Sample::<Standard>::new(0, 255).is_some());
}

#[test]
fn corners_that_are_no_vertices_are_nothing() {
    let viewport = Viewport::<Standard>::new(Region::of_size(8, 8).unwrap());
    let clip = [[0.0, 0.0, 0.5, 1.0]; 3];
    let model = [[0.0, 0.0, 0.5]; 3];
    let identity =
        std::array::from_fn(|row| std::array::from_fn(|column| f32::from(u8::from(row == column))));
    for corners in [[3, 0, 1], [0, 3, 1], [0, 1, 3]] {
        let emit = |_| panic!("{corners:?}: a triangle of too few vertices");
        assert_eq!(ClipPositions::new(&clip, viewport).assemble(corners, emit), Assembly::NoVertex);
        assert_eq!(
            ModelPositions::new(&model, identity, viewport).assemble(corners, emit),
            Assembly::NoVertex
        );
    }
}

/// A walk of one's own may offer blocks that an attachment does not have.
#[test]
fn blocks_beside_an_attachment_write_nothing() {
    let at = |x, y| Vertex::<Standard>::new(x, y, 1 << 30).unwrap();
    let triangle = Triangle::new([at(0, 0), at(9999, 0), at(0, 9999)], Sample::CENTER).unwrap();
    let region = Region::new(4, 4, 12, 12).unwrap();
    let (mut masks, mut depths) = ([0; 4], [7; texels(8, 8)]);
    let mut coverage = Coverage::new(region, &mut masks).unwrap();
    let mut depth: Depth<'_, Standard> = Depth::new(region, &mut depths, DepthTest::LESS).unwrap();
    depth.begin(&triangle);
    for (x, y) in [(0, 4), (4, 0), (12, 4), (4, 12)] {
        let block = Block { x, y, mask: Mask::FULL, triangle: &triangle, id: 0 };
        assert_eq!(coverage.block(&block), Mask::EMPTY);
        assert_eq!(depth.block(&block), Mask::EMPTY);
    }
    assert_eq!((masks, depths), ([0; 4], [7; texels(8, 8)]));
}
