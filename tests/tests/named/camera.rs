//! Where triangles are relative to the camera and its frustum.

use halfplane::{
    Bounds, ClipPositions, Cull, Depth, DepthTest, Region, Standard, State, Statistics, Viewport, draw,
    texels,
};
use halfplane_tests::{
    Frame,
    double::Overdraw,
    properties::clipping::{counted, triangle_is_where_the_exact_one_is, viewports},
};

type Clip = [f32; 4];

const WIDTH: u32 = 96;
const HEIGHT: u32 = 64;

/// Distances of the near and the far plane.
const NEAR: f32 = 0.5;
const FAR: f32 = 64.0;

fn frame() -> Frame {
    Frame::whole::<Standard>(WIDTH, HEIGHT)
}

/// Clip space of a point seen by a camera at the origin that looks along +z, x right, y up, 90 degrees
/// in both directions.
fn seen([x, y, z]: [f32; 3]) -> Clip {
    [x, y, (z - NEAR) * FAR / (FAR - NEAR), z]
}

fn statistics(triangle: [Clip; 3], cull: Cull) -> Statistics {
    let region = Region::<Standard>::of_size(WIDTH, HEIGHT).unwrap();
    let positions = ClipPositions::new(&triangle, Viewport::new(region));
    draw(&positions, &[0u16, 1, 2], 0, &State { cull, ..State::new(region) }, &mut ()).unwrap()
}

/// The triangle crosses the plane: it is drawn where the exactly clipped one is.
fn crosses(triangle: [Clip; 3], clipped: bool) {
    triangle_is_where_the_exact_one_is::<Standard>(&frame(), &triangle).unwrap();
    let statistics = statistics(triangle, Cull::None);
    assert_eq!((statistics.drawn, statistics.clipped), (1, u32::from(clipped)), "{statistics}");
}

#[test]
fn crossing_the_left_plane() {
    crosses([[-5.0, 0.1, 1.0, 2.0], [0.5, 1.5, 1.0, 2.0], [0.4, -1.2, 1.0, 2.0]], false);
}

#[test]
fn crossing_the_right_plane() {
    crosses([[5.0, 0.1, 1.0, 2.0], [-0.5, 1.5, 1.0, 2.0], [-0.4, -1.2, 1.0, 2.0]], false);
}

#[test]
fn crossing_the_top_plane() {
    crosses([[0.1, 9.0, 1.0, 2.0], [-1.5, 0.5, 1.0, 2.0], [1.2, 0.4, 1.0, 2.0]], false);
}

#[test]
fn crossing_the_bottom_plane() {
    crosses([[0.1, -9.0, 1.0, 2.0], [-1.5, 0.5, 1.0, 2.0], [1.2, 0.4, 1.0, 2.0]], false);
}

#[test]
fn crossing_the_near_plane() {
    crosses([seen([0.0, -1.0, -3.0]), seen([-1.0, 1.0, 4.0]), seen([1.5, 0.9, 4.0])], true);
    crosses([seen([0.0, -1.0, 3.0]), seen([-1.0, 1.0, -4.0]), seen([1.5, 0.9, -4.0])], true);
}

#[test]
fn crossing_the_far_plane() {
    crosses([seen([0.0, -1.0, 3.0]), seen([-9.0, 8.0, 100.0]), seen([15.0, 9.0, 90.0])], true);
    crosses([seen([0.0, -1.0, 100.0]), seen([-9.0, 8.0, 30.0]), seen([15.0, 9.0, 20.0])], true);
}

/// All planes of the frustum and the guard band at once.
#[test]
fn crossing_every_plane() {
    crosses([seen([-400.0, -300.0, -20.0]), seen([500.0, -200.0, 90.0]), seen([3.0, 700.0, 80.0])], true);
}

/// A triangle whose plane has the camera's axis in it, and one that the axis goes through from front
/// to back: x and y change sign, and so does w.
#[test]
fn crossing_the_view_direction_plane() {
    crosses([seen([-0.7, 0.0, -2.0]), seen([0.8, 0.5, 5.0]), seen([0.9, -0.6, 6.0])], true);
    crosses([seen([0.3, 0.0, -1.0]), seen([-0.3, 0.4, 2.0]), seen([-0.2, -0.5, 2.5])], true);
}

/// A ground plane under the camera, its normal exactly vertical: it crosses the near plane and goes
/// to the far plane, in one quad and as a mesh. Each sample below the horizon once, none above.
#[test]
fn ground_planes_with_perfectly_vertical_normals() {
    let far = 60.0;
    let corner = |x: f32, z: f32| seen([x, -1.0, z]);
    for cells in [1u16, 7, 30] {
        let side = cells + 1;
        let mut vertices = Vec::new();
        for j in 0..side {
            for i in 0..side {
                let along = |k: u16| f32::from(k) / f32::from(cells);
                vertices.push(corner(-500.0 + 1000.0 * along(i), -10.0 + (far + 10.0) * along(j)));
            }
        }
        let cell = |i: u16, j: u16| {
            let a = u32::from(j * side + i);
            let [b, c, d] = [a + 1, a + u32::from(side) + 1, a + u32::from(side)];
            [[a, b, c], [a, c, d]]
        };
        let triangles: Vec<[u32; 3]> =
            (0..cells).flat_map(|j| (0..cells).flat_map(move |i| cell(i, j))).collect();
        let counts = counted::<Standard>(&frame(), &vertices, &triangles).unwrap();
        // The far edge, at y/w = -1/60: 32.53 px. The row of centres at 32.5 is just above.
        counts.verdict().unwrap();
        counts.matches(|(_, y)| u16::from(y >= 33)).unwrap();
    }
}

/// Six walls round the camera: every pixel is covered, whichever way it looks.
#[test]
fn trapped_in_a_box() {
    let corner = |k: u32| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { 10.0f32 } else { -10.0 });
    let walls: [[u32; 4]; 6] =
        [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> = walls.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let frame = frame();
    for step in 0..24u8 {
        // A turn about the vertical axis and one about the horizontal one.
        let (turn, tilt) = (f32::from(step) * 0.61, f32::from(step) * 0.37 - 1.0);
        let rotated = |k: u32| {
            let [x, y, z] = corner(k);
            let (x, z) = (x * turn.cos() - z * turn.sin(), x * turn.sin() + z * turn.cos());
            let (y, z) = (y * tilt.cos() - z * tilt.sin(), y * tilt.sin() + z * tilt.cos());
            seen([x, y, z])
        };
        let vertices: Vec<Clip> = (0..8).map(rotated).collect();
        // Every pixel sees the wall in front of it, once: the box is convex and the camera inside.
        counted::<Standard>(&frame, &vertices, &triangles).unwrap().matches(|_| 1).unwrap();

        let (viewport, _) = viewports::<Standard>(&frame).unwrap();
        let region = frame.core_region().unwrap();
        let mut storage = vec![0; texels(WIDTH, HEIGHT)];
        let mut depth: Depth<'_, Standard> = Depth::new(region, &mut storage, DepthTest::LESS).unwrap();
        depth.clear(u32::MAX);
        let positions = ClipPositions::new(&vertices, viewport);
        draw(&positions, triangles.as_flattened(), 0, &State::new(region), &mut depth).unwrap();
        assert!(frame.pixels().all(|(x, y)| depth.get(x, y).is_some_and(|depth| depth != u32::MAX)));
    }
}

/// All corners on the near or on the far plane, which are inside, and some beside the frustum.
#[test]
fn on_the_near_and_on_the_far_plane() {
    for z in [0.0, 2.0] {
        crosses([[-5.0, 0.1, z, 2.0], [0.5, 1.5, z, 2.0], [0.4, -1.2, z, 2.0]], false);
        crosses([[0.1, 9.0, z, 2.0], [-1.5, 0.5, z, 2.0], [1.2, 0.4, z, 2.0]], false);
    }
}

/// Every corner far beyond the left or the right plane, or the top or the bottom one, and beyond the guard band.
#[test]
fn corners_beyond_the_guard_band_on_both_sides() {
    let wide = [[-2e5, -0.9, 0.5, 1.0], [1e4, 0.9, 0.5, 1.0], [2e5, -0.9, 0.5, 1.0]];
    for scale in [1.0, 4.0, 0.125] {
        let wide = wide.map(|corner| corner.map(|v| v * scale));
        crosses(wide, true);
        crosses(wide.map(|[x, y, z, w]| [y, x, z, w]), true);
        crosses(wide.map(|[x, y, z, w]| [-x, -y, z, w]), true);
        crosses(wide.map(|[x, y, z, w]| [-y, -x, z, w]), true);
    }
}

/// A corner exactly on the guard band is inside it: the triangle is drawn as it is, and clipped with the next
/// float outwards.
#[test]
fn a_corner_on_the_guard_band() {
    let limit = Bounds::<Standard>::CLIP_PIXELS as f32;
    let (x, y) = (WIDTH as f32 / 2.0, HEIGHT as f32 / 2.0);
    let (left, right) = ((-limit - x) / x, (limit - x) / x);
    let (bottom, top) = ((y - limit) / y, (y + limit) / y);
    let clipped = |corner| {
        let triangle = [corner, [0.2, 1.5, 0.5, 1.0], [-0.1, -0.8, 0.5, 1.0]];
        statistics(triangle, Cull::None).clipped
    };
    for (end, beyond) in [(left, left.next_down()), (right, right.next_up())] {
        let corner = |x| [x, 0.1, 0.5, 1.0];
        assert_eq!((clipped(corner(end)), clipped(corner(beyond))), (0, 1), "x {end}");
    }
    for (end, beyond) in [(bottom, bottom.next_down()), (top, top.next_up())] {
        let corner = |y| [0.1, y, 0.5, 1.0];
        assert_eq!((clipped(corner(end)), clipped(corner(beyond))), (0, 1), "y {end}");
    }
}

/// The smallest w that is divided by, and the next one.
#[test]
fn a_corner_at_the_eye() {
    let clipped = |w| {
        let triangle = [[0.0, 0.0, 0.0, w], [2.0, 0.5, 0.5, 1.0], [0.0, 1.0, 0.5, 1.0]];
        statistics(triangle, Cull::None)
    };
    assert_eq!(clipped(f32::MIN_POSITIVE).clipped, 0);
    assert_eq!(clipped(f32::MIN_POSITIVE.next_down()).clipped, 1);
    // At the eye itself it is seen in the direction of the others: nothing but their edge is left.
    let at_the_eye = clipped(0.0);
    assert_eq!((at_the_eye.clipped, at_the_eye.culled.zero_area), (1, 1), "{at_the_eye}");
}

#[test]
fn behind_the_camera() {
    let triangle = [seen([-1.0, -1.0, -5.0]), seen([0.0, 1.0, -5.0]), seen([1.0, -1.0, -4.0])];
    let statistics = statistics(triangle, Cull::None);
    assert_eq!((statistics.drawn, statistics.culled.outside), (0, 1), "{statistics}");
    counted::<Standard>(&frame(), &triangle, &[[0, 1, 2]]).unwrap().matches(|_| 0).unwrap();
}

/// In front of the camera, between it and the near plane.
#[test]
fn behind_the_near_plane() {
    let triangle = [seen([-1.0, -1.0, 0.4]), seen([0.0, 1.0, 0.1]), seen([1.0, -1.0, 0.3])];
    let statistics = statistics(triangle, Cull::None);
    assert_eq!((statistics.drawn, statistics.culled.outside), (0, 1), "{statistics}");
    counted::<Standard>(&frame(), &triangle, &[[0, 1, 2]]).unwrap().matches(|_| 0).unwrap();
}

/// Clockwise on the screen is front: y is up in clip space. Clipping does not change it.
#[test]
fn back_facing() {
    let whole = [seen([-1.0, -1.0, 3.0]), seen([0.0, 1.0, 3.0]), seen([1.0, -1.0, 3.0])];
    let clipped = [seen([-1.0, -1.0, -3.0]), seen([0.0, 1.0, 3.0]), seen([1.0, -1.0, 3.0])];
    for [a, b, c] in [whole, clipped] {
        for (cull, drawn_front, drawn_back) in [(Cull::None, 1, 1), (Cull::Back, 1, 0), (Cull::Front, 0, 1)] {
            let (front, back) = (statistics([a, b, c], cull), statistics([a, c, b], cull));
            assert_eq!((front.drawn, front.culled.facing), (drawn_front, 1 - drawn_front), "{front}");
            assert_eq!((back.drawn, back.culled.facing), (drawn_back, 1 - drawn_back), "{back}");
        }
    }
}

/// Seen exactly along its plane a triangle has no area, and covers nothing.
#[test]
fn edge_on() {
    let horizontal = [seen([-1.0, 0.0, 2.0]), seen([1.0, 0.0, 2.0]), seen([0.0, 0.0, 5.0])];
    let vertical = [seen([0.0, -1.0, 2.0]), seen([0.0, 1.0, 2.0]), seen([0.0, 0.0, 5.0])];
    let oblique = [seen([-1.0, -1.0, 2.0]), seen([3.0, 3.0, 4.0]), seen([0.5, 0.5, 4.0])];
    let clipped = [seen([-1.0, 0.0, -2.0]), seen([1.0, 0.0, 2.0]), seen([0.0, 0.0, 5.0])];
    for triangle in [horizontal, vertical, oblique, clipped] {
        let statistics = statistics(triangle, Cull::None);
        assert_eq!((statistics.drawn, statistics.culled.zero_area), (0, 1), "{statistics}");
    }
}

/// The double itself: it fails on overdraw and shows it.
#[test]
fn the_double_tells_of_overdraw() {
    let frame = Frame::whole::<Standard>(8, 4);
    let full = [[-1.0, 3.0, 0.5, 1.0], [3.0, -1.0, 0.5, 1.0], [-1.0, -1.0, 0.5, 1.0]];
    let twice: Overdraw = counted::<Standard>(&frame, &full, &[[0, 1, 2], [1, 2, 0]]).unwrap();
    assert!(twice.verdict().is_err());
    assert_eq!(twice.picture(), "from pixel (0, 0):\n22222222\n22222222\n22222222\n22222222\n");
    let once = counted::<Standard>(&frame, &full, &[[0, 1, 2]]).unwrap();
    once.verdict().unwrap();
    assert_eq!(once.picture(), "from pixel (0, 0):\n########\n########\n########\n########\n");
    assert_eq!(counted::<Standard>(&frame, &full, &[[0, 2, 1]]).unwrap().signed((3, 3)), -1);
}
