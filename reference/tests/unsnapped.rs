//! The unsnapped picture is what the definitions say, in rationals, pixel by pixel.

mod common;

use common::cases;
use halfplane_reference::{
    Model, ModelError, NO_ID, Planes, Point, Rational, Viewport, WindowPoint, clip, covers, depth_at,
    from_f32, to_window, unsnapped,
};
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

const SIZE: (u32, u32) = (13, 9);

/// Positions are clip coordinates but for w, which is z + 1/2.
const MATRIX: [f32; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5];

fn model<'m>(positions: &'m [[f32; 3]], indices: &'m [u32], clockwise_only: bool) -> Model<'m> {
    Model { positions, indices, matrix: MATRIX, width: SIZE.0, height: SIZE.1, clockwise_only }
}

/// The window triangles of a triangle after exact clipping.
fn pieces(corners: [[f32; 3]; 3]) -> Vec<[WindowPoint; 3]> {
    let viewport = Viewport { x: 0, y: 0, width: SIZE.0, height: SIZE.1 };
    let polygon = clip(corners.map(|[x, y, z]| [x, y, z, z + 0.5]), Planes::BOTH).unwrap();
    let points: Vec<_> = polygon.iter().filter_map(|vertex| to_window(vertex, viewport)).collect();
    assert_eq!(points.len(), polygon.len(), "w is at least 1/2 where z is at least 0");
    (2..points.len()).map(|k| [points[0].clone(), points[k - 1].clone(), points[k].clone()]).collect()
}

fn is_clockwise(piece: &[WindowPoint; 3]) -> bool {
    let [a, b, c] = [0, 1, 2].map(|k| &piece[k].position);
    let area = (&b.x - &a.x) * (&c.y - &a.y) - (&c.x - &a.x) * (&b.y - &a.y);
    area.is_positive()
}

/// The nearest triangle and its depth, from the definitions.
fn expected(model: &Model<'_>, pixel: (u32, u32)) -> Option<(u32, Rational)> {
    let half = Rational::new(1.into(), 2.into());
    let at = |v: u32| Rational::from_integer(v.into()) + &half;
    let sample = Point::new(at(pixel.0), at(pixel.1));
    let mut best: Option<(u32, Rational)> = None;
    for (id, indices) in (0..).zip(model.indices.chunks_exact(3)) {
        let corners = [0, 1, 2].map(|k| model.positions[indices[k] as usize]);
        for piece in pieces(corners) {
            if model.clockwise_only && !is_clockwise(&piece) {
                continue;
            }
            let corners = piece.clone().map(|point| point.position);
            if covers(&corners, &sample) {
                let depth = depth_at(&corners, &piece.map(|point| point.z), &sample).unwrap();
                if best.as_ref().is_none_or(|(_, nearest)| depth < *nearest) {
                    best = Some((id, depth));
                }
            }
        }
    }
    best
}

fn check(positions: &[[f32; 3]], clockwise_only: bool) -> Result<u64, TestCaseError> {
    let indices: Vec<u32> = (0..positions.len() as u32).collect();
    let model = model(positions, &indices, clockwise_only);
    let picture = unsnapped(&model, &|_| ()).unwrap();
    for y in 0..SIZE.1 {
        for x in 0..SIZE.0 {
            let place = (y * SIZE.0 + x) as usize;
            let expected = expected(&model, (x, y));
            let id = expected.as_ref().map_or(NO_ID, |(id, _)| *id);
            prop_assert_eq!(picture.ids[place], id, "pixel ({}, {}) of {:?}", x, y, positions);
            let depth = expected.map_or(1.0, |(_, depth)| depth.to_f64().unwrap());
            prop_assert!((picture.depth[place] - depth).abs() <= 1e-9, "{} {depth}", picture.depth[place]);
            // w is z + 1/2, so 1/w is 2 - 2 z/w.
            let inverse = if id == NO_ID { 0.0 } else { 2.0 - 2.0 * depth };
            prop_assert!((picture.inverse_w[place] - inverse).abs() <= 1e-8);
        }
    }
    Ok(picture.decided_in_integers)
}

/// Corners with every bit in use, some behind the near plane and the eye.
fn anywhere() -> impl Strategy<Value = [f32; 3]> {
    // z so that z + 1/2 is a float, as the definitions are asked in clip space.
    (-1.5f32..1.5, -1.5f32..1.5, -52_000..130_000i32).prop_map(|(x, y, z)| [x, y, z as f32 / 65_536.0])
}

/// On pixel centres, their middles and pixel edges, at few depths, none outside near and far.
fn on_samples() -> impl Strategy<Value = [f32; 3]> {
    (-14..=14i8, -10..=10i8, 1..4u8).prop_map(|(x, y, z)| {
        let w = f32::from(z) * 0.25 + 0.5;
        // Not exact in floats for 13 columns, yet near enough that only integers decide.
        [f32::from(x) / 13.0 * w, f32::from(y) / 9.0 * w, w - 0.5]
    })
}

proptest! {
    #![proptest_config(cases(128))]

    #[test]
    fn is_the_definition_anywhere(positions in prop::collection::vec(anywhere(), 9), cull in any::<bool>()) {
        check(&positions, cull)?;
    }

    #[test]
    fn is_the_definition_on_samples(positions in prop::collection::vec(on_samples(), 9), cull in any::<bool>()) {
        check(&positions, cull)?;
    }
}

/// w = 1 and a size of powers of two: edges go exactly through samples, and equal depths are ties.
#[test]
fn ties_are_decided_by_the_rule() {
    let corner = |x: i8, y: i8| [f32::from(x) / 8.0, f32::from(y) / 8.0, 0.25];
    // Two triangles that share the diagonal through samples, one more on top of the first, and a sliver whose
    // corners lie on one line.
    let positions = [
        corner(-8, 8),
        corner(8, 8),
        corner(-8, -8),
        corner(8, 8),
        corner(8, -8),
        corner(-8, -8),
        corner(-8, 8),
        corner(8, 8),
        corner(-8, -8),
        corner(-8, -8),
        corner(0, 0),
        corner(8, 8),
    ];
    let indices: Vec<u32> = (0..12).collect();
    let mut matrix = [0.0; 16];
    (0..4).for_each(|k| matrix[5 * k] = 1.0);
    let model = Model {
        positions: &positions,
        indices: &indices,
        matrix,
        width: 8,
        height: 8,
        clockwise_only: false,
    };
    let picture = unsnapped(&model, &|_| ()).unwrap();
    for (place, &id) in picture.ids.iter().enumerate() {
        let (x, y) = (place % 8, place / 8);
        // On the diagonal from the lower left to the upper right, the lower triangle has its left edge.
        assert_eq!(id, u32::from(x + y >= 7), "({x}, {y})");
    }
    assert!(picture.decided_in_integers > 8);
    assert!(picture.depth.iter().all(|depth| (depth - 0.25).abs() < 1e-12));
}

#[test]
fn what_is_wrong_is_named() {
    let positions = [[0.0; 3], [1.0; 3], [f32::NAN, 0.0, 0.0]];
    let of =
        |indices: &'static [u32]| unsnapped(&model(&positions[..2], indices, false), &|_| ()).unwrap_err();
    assert_eq!(of(&[0, 1]), ModelError::IndexCount { given: 2 });
    assert_eq!(of(&[0, 1, 2]), ModelError::Index { at: 2, given: 2 });
    let all = unsnapped(&model(&positions, &[], false), &|_| ());
    assert_eq!(all, Err(ModelError::Position { vertex: 2 }));
    let wide = Model { width: 0, ..model(&[], &[], false) };
    assert_eq!(unsnapped(&wide, &|_| ()), Err(ModelError::Size { width: 0, height: 9 }));
    let mut bent = model(&[], &[], false);
    bent.matrix[5] = f32::INFINITY;
    assert_eq!(unsnapped(&bent, &|_| ()), Err(ModelError::Matrix { at: 5 }));
    assert!(from_f32(f32::NAN).is_none());
}
