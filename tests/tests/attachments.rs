//! Attachments of attachments: references, pairs, triples and none.

use halfplane::{
    Attachment, Block, Count, Coverage, Depth, DepthRange, DepthTest, HierarchicalDepth, Ids, Mask, NO_ID,
    OutsideAttachment, Region, Sample, Standard, Triangle, Vertex, draw,
};

/// Writes down what it is told, and lets some samples through.
struct Recorder {
    lets: Mask,
    begun: u32,
    seen: Vec<Mask>,
}

impl Recorder {
    fn new(lets: u16) -> Self {
        Self { lets: Mask(lets), begun: 0, seen: Vec::new() }
    }
}

impl Attachment<Standard> for Recorder {
    fn block(&mut self, block: &Block<'_, Standard>) -> Mask {
        self.seen.push(block.mask);
        self.lets
    }

    fn begin(&mut self, _: &Triangle<Standard>) {
        self.begun += 1;
    }
}

fn triangle() -> Triangle<Standard> {
    let at = |x, y| Vertex::new(x, y, 1 << 30).unwrap();
    Triangle::new([at(0, 0), at(9999, 0), at(0, 9999)], Sample::CENTER).unwrap()
}

/// What `attachment` lets through of these samples, once it has begun.
fn passed(attachment: &mut impl Attachment<Standard>, mask: u16) -> u16 {
    let triangle = triangle();
    attachment.begin(&triangle);
    attachment.block(&Block { x: 0, y: 0, mask: Mask(mask), triangle: &triangle, id: 7 }).0
}

#[test]
fn no_attachment_lets_everything_through() {
    assert_eq!(passed(&mut (), 0x1234), 0x1234);
    let mut last = Recorder::new(0xFFFF);
    // What was not covered stays so, whatever an attachment returns.
    assert_eq!(passed(&mut ((), &mut last), 0x1234), 0x1234);
    assert_eq!((last.begun, last.seen), (1, vec![Mask(0x1234)]));
}

#[test]
fn cleared_attachments_hold_what_they_are_cleared_to() {
    let region = Region::<Standard>::of_size(5, 3).unwrap();
    let (mut depths, mut ids) = ([7; 32], [7; 32]);
    let mut depth: Depth<'_, Standard> = Depth::new(region, &mut depths, DepthTest::LESS).unwrap();
    depth.clear(9);
    Ids::new(region, &mut ids).unwrap().clear();
    assert_eq!((depths, ids), ([9; 32], [NO_ID; 32]));
}

#[test]
fn rows_are_copied_from_every_attachment() {
    let region = Region::<Standard>::of_size(4, 3).unwrap();
    let mut texels: [u32; 16] = std::array::from_fn(|k| k as u32);
    let (mut depths, mut ids) = ([99; 12], [99; 12]);
    Depth::<Standard>::new(region, &mut texels, DepthTest::LESS).unwrap().to_linear(&mut depths).unwrap();
    Ids::new(region, &mut texels).unwrap().to_linear(&mut ids).unwrap();
    assert_eq!((depths.as_slice(), ids), (&texels[..12], depths));
}

/// The triangle's depth is 2^30 everywhere.
#[test]
fn depth_lets_through_what_is_nearer() {
    let region = Region::<Standard>::of_size(4, 4).unwrap();
    let mut texels = [(1 << 30) + 1; 16];
    texels[2] = 1 << 30;
    let mut depth: Depth<'_, Standard> = Depth::new(region, &mut texels, DepthTest::LESS).unwrap();
    assert_eq!(passed(&mut depth, 0x8006), 0x8002);
    assert_eq!(passed(&mut depth, 0x8007), 0x0001);
}

/// So does the one that can be asked, block by block: what is written then is known.
#[test]
fn hierarchical_depth_lets_through_what_is_nearer() {
    let region = Region::<Standard>::of_size(4, 4).unwrap();
    let (mut texels, mut ranges) = ([(1 << 30) + 1; 16], [DepthRange::UNKNOWN; 2]);
    texels[2] = 1 << 30;
    let mut depth: HierarchicalDepth<'_, Standard> =
        HierarchicalDepth::new(region, &mut texels, &mut ranges, DepthTest::LESS).unwrap();
    assert!(!depth.hides(region, (1 << 30) + 1));
    assert_eq!(passed(&mut depth, 0x8006), 0x8002);
    assert_eq!(passed(&mut depth, 0x8007), 0x0001);
    assert_eq!(depth.depth().get(3, 3), Some(1 << 30));
    assert_eq!(passed(&mut depth, 0xFFFF), 0x7FF8);
    assert!(depth.hides(region, (1 << 30) + 1));
}

/// Those that only write or count let every sample through.
#[test]
fn attachments_without_a_test_let_everything_through() {
    let region = Region::<Standard>::of_size(4, 4).unwrap();
    let (mut masks, mut texels) = ([0x8000], [NO_ID; 16]);
    let mut count = Count { samples: 9 };
    assert_eq!((passed(&mut count, 0x1234), count.samples), (0x1234, 9 + 5));
    let mut coverage = Coverage::new(region, &mut masks).unwrap();
    assert_eq!((passed(&mut coverage, 0x1234), coverage.get(3, 3)), (0x1234, Some(true)));
    coverage.clear();
    assert_eq!((coverage.get(3, 3), passed(&mut coverage, 0x0001)), (Some(false), 0x0001));
    let mut ids = Ids::new(region, &mut texels).unwrap();
    assert_eq!((passed(&mut ids, 0x8001), ids.get(0, 0), ids.get(1, 0)), (0x8001, Some(7), Some(NO_ID)));
    assert_eq!((masks, texels[15]), ([1], 7));
}

#[test]
fn later_attachments_see_what_earlier_ones_let_through() {
    let (mut a, mut b, mut c) = (Recorder::new(0x0FF7), Recorder::new(0x00F3), Recorder::new(0x0011));
    assert_eq!(passed(&mut (&mut a, &mut b), 0xFFFE), 0x00F2);
    assert_eq!((a.seen.as_slice(), b.seen.as_slice()), (&[Mask(0xFFFE)][..], &[Mask(0x0FF6)][..]));
    assert_eq!(passed(&mut (&mut a, &mut b, &mut c), 0xFFFE), 0x0010);
    assert_eq!(c.seen, [Mask(0x00F2)]);
    assert_eq!((a.begun, b.begun, c.begun), (2, 2, 1));
    let mut reference = &mut a;
    assert_eq!(passed(&mut reference, 0x8001), 0x0FF7);
    assert_eq!((a.begun, a.seen.last()), (3, Some(&Mask(0x8001))));
}

#[test]
fn later_attachments_do_not_see_nothing() {
    let (mut a, mut b) = (Recorder::new(0x00FF), Recorder::new(0xFFFF));
    assert_eq!(passed(&mut (&mut a, &mut b), 0xFF00), 0);
    assert_eq!((a.seen.len(), b.seen.len()), (1, 0));
}

/// Each member is asked, behind a reference too.
#[test]
fn every_member_is_asked_whether_the_area_fits() {
    let [large, small] = [16, 8].map(|side| Region::<Standard>::of_size(side, side).unwrap());
    let mut masks = [[0; 16]; 2];
    let [first, second] = &mut masks;
    let mut roomy = Coverage::new(large, first).unwrap();
    let mut narrow = Coverage::new(small, second).unwrap();
    let outside = OutsideAttachment { area: [0, 0, 16, 16], attachment: [0, 0, 8, 8] };
    fn check(attachment: impl Attachment<Standard>, area: Region<Standard>) -> Option<OutsideAttachment> {
        attachment.check(area).err()
    }
    assert_eq!(check(&mut narrow, large), Some(outside));
    assert_eq!(check(&mut roomy, large), None);
    let mut texels = [0; 64];
    assert_eq!(check(Ids::new(small, &mut texels).unwrap(), large), Some(outside));
    let depth: Depth<'_, Standard> = Depth::new(small, &mut texels, DepthTest::LESS).unwrap();
    assert_eq!(check(depth, large), Some(outside));
    assert_eq!(check((&mut narrow, &mut roomy), large), Some(outside));
    assert_eq!(check((&mut roomy, &mut narrow), large), Some(outside));
    assert_eq!(check((&mut narrow, (), &mut roomy), large), Some(outside));
    assert_eq!(check(((), &mut narrow, &mut roomy), large), Some(outside));
    assert_eq!(check((&mut roomy, (), &mut narrow), large), Some(outside));
    assert_eq!(check((&mut roomy, (), &mut narrow), small), None);
}

/// A draw begins each triangle that has a block once, and no other.
#[test]
fn triangles_begin_once() {
    let at = |x, y| Vertex::<Standard>::new(x, y, 1 << 30).unwrap();
    let vertices = [at(0, 0), at(9999, 0), at(0, 9999), at(1, 1)];
    let state = halfplane::State::new(Region::of_size(16, 16).unwrap());
    let mut recorder = Recorder::new(0xFFFF);
    draw(&vertices[..], &[0u8, 1, 2, 0, 3, 3, 2, 1, 0], 0, &state, &mut recorder).unwrap();
    assert_eq!((recorder.begun, recorder.seen.len()), (2, 32));
}
