//! The generators make what they say: a test whose cases are all empty would hold for anything.

use halfplane::{Bounds, Format, Small, Standard};
use halfplane_tests::{
    Frame, oracle,
    properties::clipping::counted,
    shapes::{Corners, Kind, Random, clip_triangle, doubled_area, fan, grid, triangle, triangulation},
    toy::Toy,
};

/// Triangles of a kind, with the frames they were made for.
fn made<F: Format>(kind: Kind) -> impl Iterator<Item = (Frame, Corners)> {
    let mut random = Random(kind as u64);
    (0..2000).map(move |_| {
        let frame = Frame::from_numbers::<F>(random.words());
        (frame, triangle::<F>(kind, &frame, random.words()))
    })
}

/// How many samples on the outline of a triangle there are in the frame's scissor.
fn on_outline<F: Format>(frame: &Frame, corners: &Corners) -> usize {
    let on_edge = |p: [i64; 2], q: [i64; 2], s: [i64; 2]| {
        let cross = (q[0] - p[0]) * (s[1] - p[1]) - (s[0] - p[0]) * (q[1] - p[1]);
        cross == 0 && (0..2).all(|k| p[k].min(q[k]) <= s[k] && s[k] <= p[k].max(q[k]))
    };
    let [a, b, c] = corners.map(|corner| corner.map(i64::from));
    let touches = |pixel: &(u32, u32)| {
        let sample = frame.sample_at::<F>(*pixel);
        frame.scissor_has(*pixel) && [(a, b), (b, c), (c, a)].iter().any(|&(p, q)| on_edge(p, q, sample))
    };
    frame.pixels().filter(touches).count()
}

fn kinds<F: Format>() {
    for kind in Kind::ALL {
        let (mut covering, mut touching, mut minimal) = (0, 0, 0);
        for (frame, corners) in made::<F>(kind) {
            let guard = Bounds::<F>::GUARD_BAND;
            assert!(corners.as_flattened().iter().all(|v| v.abs() <= guard));
            let area = doubled_area(&corners).abs();
            match kind {
                Kind::Collinear | Kind::Duplicate => assert_eq!(area, 0, "{corners:?}"),
                _ => {}
            }
            minimal += usize::from(area == 1 || area == 2);
            covering += usize::from(oracle::coverage::<F>(&frame, &corners).unwrap().contains(&true));
            touching += usize::from(on_outline::<F>(&frame, &corners) > 0);
        }
        println!("{kind:?}: {covering} cover, {touching} touch a sample, {minimal} of doubled area 1 or 2");
        match kind {
            Kind::Collinear | Kind::Duplicate => assert_eq!(covering, 0),
            Kind::Bezout => assert!(minimal > 1500 && touching > 1000 && covering > 300),
            Kind::OnSamples | Kind::ThroughSamples => assert!(touching > 1000 && covering > 1000),
            _ => assert!(covering > 200),
        }
    }
}

#[test]
fn kinds_are_what_they_say_standard() {
    kinds::<Standard>();
}

#[test]
fn kinds_are_what_they_say_small() {
    kinds::<Small>();
}

#[test]
fn kinds_are_what_they_say_toy() {
    kinds::<Toy>();
}

/// Meshes fill their outline: no triangle is turned over, and the areas sum to the rectangle's.
#[test]
fn meshes_fill_their_outline() {
    let mut random = Random(1);
    for round in 0..60 {
        let outline = [-300, -200, 900, 1000];
        let points: Vec<_> =
            (0..60).map(|_| [random.between(-300, 900) as i32, random.between(-200, 1000) as i32]).collect();
        let meshes = [
            triangulation(outline, &points),
            grid(outline, 1 + round % 13, 1 + round % 7, &mut random),
            fan([5, 6], 1500, 1000, &mut random),
        ];
        for mesh in &meshes {
            let areas: Vec<_> = mesh.triangles.iter().map(|&t| doubled_area(&mesh.corners(t))).collect();
            assert!(areas.iter().all(|&area| area >= 0), "a triangle is turned over");
            let [x0, y0, x1, y1] = mesh.outline.map(i64::from);
            assert_eq!(areas.iter().sum::<i64>(), 2 * (x1 - x0) * (y1 - y0));
        }
        assert_eq!(meshes[2].triangles.len(), 1000);
    }
}

/// Clipping properties look at triangles that are clipped and seen, at each plane.
#[test]
fn clipped_shapes_are_clipped_and_seen() {
    let mut random = Random(3);
    let (mut seen, mut at_near, mut at_far, mut at_sides) = (0, 0, 0, 0);
    for _ in 0..2000 {
        let frame = Frame::whole::<Standard>(64, 48);
        let triangle = clip_triangle(random.words());
        let counts = counted::<Standard>(&frame, &triangle, &[[0, 1, 2]]).unwrap();
        if frame.pixels().any(|pixel| counts.count(pixel) > 0) {
            seen += 1;
            at_near += usize::from(triangle.iter().any(|[_, _, z, _]| *z < 0.0));
            at_far += usize::from(triangle.iter().any(|[_, _, z, w]| z > w));
            at_sides += usize::from(
                triangle.iter().any(|[x, y, _, w]| *w > 0.0 && x.abs().max(y.abs()) > 1000.0 * w),
            );
        }
    }
    println!("of 2000: {seen} seen, {at_near} cross near, {at_far} far, {at_sides} the guard band");
    assert!(at_near > 200 && at_far > 20 && at_sides > 20);
}
