//! Properties that no prover finished: for tests alone.

use super::{
    super::{
        meshlet::{Builder, Meshlet, MeshletError, VERTICES, make_meshlets},
        setup::gradient,
        sort::{select, sort},
    },
    longs,
    setup::gradient_is_nearest,
    simd,
};
use crate::proof::{cover, prove};
use fearless_simd::{f64x8, prelude::*};

prove! {
    /// The gradient for areas of 2^k: the quotient's digits come out exact.
    []
    fn gradients_by_a_power_of_two(numerator: i64 = -(1 << 28)..=1 << 28) {
        gradient_is_nearest(numerator, 1 << 12);
    }

    /// The gradient for an area of 3.
    []
    fn gradients_by_3(numerator: i64 = -(1 << 20)..=1 << 20) {
        gradient_is_nearest(numerator, 3);
    }

    /// The gradient where the quotient is so close to a half that a digit before the last one must be whole: four of
    /// 3 * 10^8 numerators and areas.
    []
    fn gradients_next_to_a_half(number: usize = 0..=3) {
        let (numerator, area) = [
            (1_193_920_669_865_i64, 38_179_023),
            (-94_691_119_642, 15_521_964),
            (87_598_422, 19_506_775),
            (-9_169_268_515, 19_774_175),
        ][number];
        let divisor = f64::from(area);
        let [numerators, divisors, inverses] =
            [numerator as f64, divisor, 1.0 / divisor].map(|v| f64x8::splat(simd(), v));
        let word = longs(gradient(simd(), numerators, divisors, inverses))[0];
        let area = i128::from(area);
        let nearest = ((i128::from(numerator) << 33) + area).div_euclid(2 * area);
        assert!(i128::from(word as i64) == nearest);
        cover!(number == 3);
    }

    /// A triangle is added with new vertices at the end, its corners naming them.
    []
    fn triangles_find_their_vertices(first: [u32; 3] = [0; 3]..=[3; 3], second: [u32; 3] = [0; 3]..=[3; 3], corner: usize = 0..=2) {
        let positions = [0.0, 1.0, 2.0, 3.0].map(|x| [x, 0.0, 0.0]);
        let mut builder = Builder::new(7);
        let added = [builder.add(first, &positions), builder.add(second, &positions)];
        assert!(added == [true; 2]);
        let meshlet = &builder.meshlet;
        assert!(meshlet.corners().len() == 2 && meshlet.first() == 7);
        for (triangle, at) in [first, second].into_iter().zip(0..2) {
            let place = usize::from(meshlet.corners()[at][corner]);
            assert!(meshlet.position(place) == Some(positions[triangle[corner] as usize]));
        }
        let distinct = (0..4).filter(|v| first.contains(v) || second.contains(v)).count();
        assert!(meshlet.vertices() == distinct);
        cover!(distinct == 4);
        cover!(distinct == 1);
    }

    /// A triangle becomes a meshlet where there is room for one, the places left holding its last vertex.
    []
    fn slow_meshlets_are_made_where_there_is_room(bits: [u32; 3], given: usize = 0..=1) {
        let positions = bits.map(|bits| [f32::from_bits(bits); 3]);
        let mut memory = [Meshlet::EMPTY];
        match make_meshlets(&positions, &[0_u8, 1, 2], &mut memory[..given]) {
            Err(error) => assert!(given == 0 && error == MeshletError::TooFew { needed: 1, given }),
            Ok(made) => {
                assert!(given == 1 && made.len() == 1 && made[0].triangles() == (0..1));
                let [x, ..] = made[0].positions.map(|axis| axis.map(f32::to_bits));
                assert!(x[0] == bits[0] && x[1] == bits[1] && x[2] == bits[2] && x[VERTICES - 1] == bits[2]);
            }
        }
        cover!(given == 1);
    }

    /// More elements, many of them equal, come out in order, and are the same.
    []
    fn many_are_sorted(keys: [u32; 32], few: u32 = 1..=40, count: usize = 0..=32) {
        let mut sorted = keys.map(|key| u64::from(key % few));
        let elements = &mut sorted[..count];
        sort(elements, |&key| key);
        assert!(elements.is_sorted());
        let sum: u64 = elements.iter().sum();
        assert!(sum == keys[..count].iter().map(|key| u64::from(key % few)).sum());
    }

    /// Of more elements, none before the chosen rank is greater, and none behind it smaller.
    []
    fn many_are_parted(keys: [u32; 32], few: u32 = 1..=40, count: usize = 1..=32, nth: usize = 0..=31) {
        let mut parted = keys.map(|key| (key % few) as f32);
        let elements = &mut parted[..count];
        let nth = nth % count;
        select(elements, nth, |&value| value);
        let mut sorted = keys.map(|key| (key % few) as f32);
        sorted[..count].sort_unstable_by(f32::total_cmp);
        assert!(elements[nth] == sorted[nth]);
        assert!(elements[..nth].iter().all(|&v| v <= elements[nth]));
        assert!(elements[nth..].iter().all(|&v| v >= elements[nth]));
        assert!(elements.iter().sum::<f32>() == sorted[..count].iter().sum::<f32>());
    }
}
