//! Which triangle is seen where several overlap.

use halfplane::{Compare, D32, Standard};
use halfplane_reference::DepthSpec;
use halfplane_tests::{
    Frame,
    properties::scene::{drawn, equals_reference},
    shapes::{Corners, Kind},
    strategies::Shot,
};

const SIZE: u32 = 48;

fn shot(corners: Corners, z: [u32; 3]) -> Shot {
    Shot { frame: Frame::whole::<Standard>(SIZE, SIZE), kind: Kind::Medium, corners, z }
}

/// All orders of so many things.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let insert = |shorter: Vec<usize>| {
        (0..count).map(move |at| {
            let mut order = shorter.clone();
            order.insert(at, count - 1);
            order
        })
    };
    permutations(count - 1).into_iter().flat_map(insert).collect()
}

/// Four overlapping triangles at different depths, drawn in all 24 orders: the picture is the same, but
/// for the ids, which name the same triangles.
#[test]
fn depth_order_in_all_permutations() {
    let px = 256;
    let shots = [
        shot([[0, 0], [40 * px, 5 * px], [10 * px, 45 * px]], [1 << 28, 3 << 28, 2 << 28]),
        shot([[45 * px, 0], [2 * px, 9 * px], [30 * px, 47 * px]], [2 << 28, 2 << 28, 2 << 28]),
        shot([[0, 40 * px], [48 * px, 48 * px], [20 * px, 0]], [4 << 28, 1 << 28, 9 << 28]),
        shot([[0, 30 * px], [48 * px, 20 * px], [0, 48 * px]], [10 << 28; 3]),
    ];
    let frame = shots[0].frame;
    for compare in [Compare::Less, Compare::Greater] {
        let seen = |order: &[usize]| {
            let shuffled: Vec<Shot> = order.iter().map(|&k| shots[k]).collect();
            equals_reference::<Standard, D32>(&frame, &shuffled, compare, DepthSpec::D32).unwrap();
            let (_, picture) = drawn::<Standard, D32>(&frame, &shuffled, compare).unwrap();
            let name = |&id: &u32| order.get(id as usize).copied();
            (picture.depth.clone(), picture.ids.iter().map(name).collect::<Vec<_>>())
        };
        let expected = seen(&[0, 1, 2, 3]);
        assert!((0..4).filter(|k| expected.1.contains(&Some(*k))).count() > 1);
        let orders = permutations(4);
        assert_eq!(orders.len(), 24);
        for order in orders {
            assert!(seen(&order) == expected, "order {order:?}, {compare:?}");
        }
    }
}

/// Two triangles that go through each other: along the line where they meet the winner changes, and
/// both are seen.
#[test]
fn intersecting_triangles() {
    let px = 256;
    let full = [[0, 0], [96 * px, 0], [0, 96 * px]];
    let mirrored = [[48 * px, 48 * px], [-48 * px, 48 * px], [48 * px, -48 * px]];
    let (near, far) = (1 << 29, 7 << 29);
    let shots = [shot(full, [near, far, near]), shot(mirrored, [near, far, near])];
    for compare in [Compare::Less, Compare::LessEqual, Compare::Greater, Compare::GreaterEqual] {
        equals_reference::<Standard, D32>(&shots[0].frame, &shots, compare, DepthSpec::D32).unwrap();
        let (_, picture) = drawn::<Standard, D32>(&shots[0].frame, &shots, compare).unwrap();
        for id in 0..2 {
            assert!(
                picture.ids.iter().filter(|&&seen| seen == id).count() > 200,
                "triangle {id}, {compare:?}"
            );
        }
    }
}

/// Equal depths: the earlier or the later wins, as the comparison says, at every sample.
#[test]
fn coplanar_triangles() {
    let px = 256;
    let one = shot([[0, 0], [96 * px, 0], [0, 96 * px]], [1 << 30, 3 << 30, 2 << 30]);
    let again = Shot {
        corners: [one.corners[1], one.corners[2], one.corners[0]],
        z: [3 << 30, 2 << 30, 1 << 30],
        ..one
    };
    for (compare, winner) in [
        (Compare::Less, 0),
        (Compare::LessEqual, 1),
        (Compare::Greater, 0),
        (Compare::GreaterEqual, 1),
        (Compare::Always, 1),
    ] {
        let (_, picture) = drawn::<Standard, D32>(&one.frame, &[one, again], compare).unwrap();
        assert!(picture.ids.iter().all(|&id| id == winner), "{compare:?}");
    }
}
