//! Proofs of a draw's checks, of its classification of triangles, and of its statistics.

use super::{
    CulledCounts, DrawError, Index, RejectedCounts, State, Statistics, bounds, check_draw, check_indices,
    draw, instance_of, statistics::add,
};
use crate::{
    attachments::{Count, Coverage, NO_ID, OutsideAttachment},
    geometry::{Assembly, Cull, Culled, Region, Vertex, Winding},
    numbers::{Bounds, Format, Small, Standard},
    proof::{cover, prove},
};

const ASSEMBLIES: [Assembly; 5] =
    [Assembly::Whole, Assembly::Clipped, Assembly::Outside, Assembly::NonFinite, Assembly::NoVertex];

const OUTCOMES: [Option<Result<(), Culled>>; 6] = [
    None,
    Some(Ok(())),
    Some(Err(Culled::Facing)),
    Some(Err(Culled::ZeroArea)),
    Some(Err(Culled::NoSample)),
    Some(Err(Culled::Outside)),
];

/// Statistics with these counts: submitted, drawn, culled, rejected, clipped.
fn statistics(counts: [u32; 10]) -> Statistics {
    let [submitted, drawn, facing, zero_area, no_sample, outside, hidden, non_finite, no_vertex, clipped] =
        counts;
    let culled = CulledCounts { facing, zero_area, no_sample, outside, hidden };
    Statistics { submitted, drawn, culled, rejected: RejectedCounts { non_finite, no_vertex }, clipped }
}

/// The counts of statistics, in the same order.
fn counts(statistics: Statistics) -> [u32; 10] {
    let Statistics { submitted, drawn, culled, rejected, clipped } = statistics;
    let CulledCounts { facing, zero_area, no_sample, outside, hidden } = culled;
    let RejectedCounts { non_finite, no_vertex } = rejected;
    [submitted, drawn, facing, zero_area, no_sample, outside, hidden, non_finite, no_vertex, clipped]
}

/// How much each count has grown.
fn growth(after: [u32; 10], before: [u32; 10]) -> [u32; 10] {
    core::array::from_fn(|at| after[at] - before[at])
}

/// What the checks say of the first `count` indices: the first fault, or all triangles.
fn names_the_first_fault<I: Index + PartialEq>(indices: [I; 7], count: usize, vertices: usize) {
    let indices = &indices[..count];
    let valid = |index: &I| u64::from(index.to_u32()) < vertices as u64;
    match check_indices(indices, vertices) {
        Err(DrawError::IndexCount { count: told }) => assert!(told == count && count % 3 != 0),
        Err(DrawError::IndexOutOfRange { at, index, vertices: told }) => {
            assert!(count % 3 == 0 && told == vertices);
            assert!(index == indices[at].to_u32() && !valid(&indices[at]));
            assert!(indices[..at].iter().all(valid));
        }
        Err(_) => unreachable!("nothing else is checked"),
        Ok(triangles) => {
            assert!(count % 3 == 0 && triangles.len() * 3 == count && indices.iter().all(valid));
            assert!(triangles.as_flattened() == indices);
        }
    }
    cover!(count == 6 && !valid(&indices[5]) && valid(&indices[4]));
}

/// A whole target and a state that draws all of it.
fn everything<F: Format>() -> (Region<F>, State<F>) {
    let region =
        Region::of_size(F::MAX_TARGET, F::MAX_TARGET).unwrap_or_else(|_| unreachable!("it has pixels"));
    (region, State::new(region))
}

/// Why three vertices cannot be drawn, by the definitions, in the order in which causes are looked for;
/// `None` where they have an area, face the right way, and their extent meets the area.
fn cause<F: Format>([ax, ay, bx, by, cx, cy]: [i32; 6], area: [u32; 4], state: &State<F>) -> Option<Culled> {
    let wide = i64::from;
    let (low, high) = ([ax.min(bx).min(cx), ay.min(by).min(cy)], [ax.max(bx).max(cx), ay.max(by).max(cy)]);
    let [x0, y0, x1, y1] = area.map(|pixels| wide(Bounds::<F>::STEPS_PER_PIXEL) * i64::from(pixels));
    let meets = wide(low[0]) < x1 && wide(high[0]) > x0 && wide(low[1]) < y1 && wide(high[1]) > y0;
    let doubled =
        (wide(bx) - wide(ax)) * (wide(cy) - wide(ay)) - (wide(cx) - wide(ax)) * (wide(by) - wide(ay));
    let winding = if doubled > 0 { Winding::Clockwise } else { Winding::CounterClockwise };
    if !meets {
        Some(Culled::Outside)
    } else if doubled == 0 {
        Some(Culled::ZeroArea)
    } else {
        state.cull.culls(winding, state.front).then_some(Culled::Facing)
    }
}

fn causes_are_found_in_order<F: Format>(corners: [i32; 6], area: [u32; 4], cull: usize) {
    let [ax, ay, bx, by, cx, cy] = corners;
    let vertex = |x, y| Vertex::<F>::new(x, y, 0);
    let (Ok(a), Ok(b), Ok(c)) = (vertex(ax, ay), vertex(bx, by), vertex(cx, cy)) else { return };
    let [x0, y0, x1, y1] = area;
    let Ok(region) = Region::new(x0, y0, x1, y1) else { return };
    let cull = [Cull::None, Cull::Back, Cull::Front][cull];
    let state = State { cull, ..State::new(region) };
    let expected = cause(corners, area, &state);
    match bounds([a, b, c], region, &state) {
        Ok(found) => assert!(expected.is_none() && region.contains(found)),
        Err(Culled::NoSample) => assert!(expected.is_none()),
        Err(found) => assert!(expected == Some(found)),
    }
    cover!(expected == Some(Culled::Facing));
    cover!(expected.is_none() && ax < 0);
}

prove! {
    /// Of at most 7 indices: a list of whole triangles, or the first thing that is wrong with it.
    #[kani::unwind(9)]
    [check_indices, u8::to_u32, Index::to_usize]
    fn indices_of_8_bits_are_checked(indices: [u8; 7], count: usize = 0..=7, vertices: usize) {
        names_the_first_fault(indices, count, vertices);
    }

    /// The same for 16 bits.
    #[kani::unwind(9)]
    [check_indices, u16::to_u32, Index::to_usize]
    fn indices_of_16_bits_are_checked(indices: [u16; 7], count: usize = 0..=7, vertices: usize) {
        names_the_first_fault(indices, count, vertices);
    }

    /// The same for 32 bits.
    #[kani::unwind(9)]
    [check_indices, u32::to_u32, Index::to_usize]
    fn indices_of_32_bits_are_checked(indices: [u32; 7], count: usize = 0..=7, vertices: usize) {
        names_the_first_fault(indices, count, vertices);
    }

    /// A draw is let through exactly where its ids end before `NO_ID`: the first one plus the number of
    /// triangles fits, so no id is handed out twice and `NO_ID` never.
    [check_draw]
    fn ids_end_before_the_free_one(triangles: usize, first_id: u32) {
        let (region, state) = everything::<Standard>();
        let vertices: [Vertex<Standard>; 0] = [];
        let end = u128::from(first_id) + triangles as u128;
        match check_draw(&vertices[..], triangles, first_id, &state, &()) {
            Ok((submitted, area)) => {
                assert!(submitted as usize == triangles && area == Some(region));
                assert!(end <= u128::from(NO_ID));
            }
            Err(error) => {
                assert!(end > u128::from(NO_ID));
                assert!(error == DrawError::TooManyIds { first_id, triangles });
            }
        }
        cover!(end == u128::from(NO_ID));
        cover!(end == u128::from(NO_ID) + 1);
    }

    /// A draw to an attachment that does not have all of the scissor is refused.
    [check_draw]
    fn scissors_outside_are_refused(
        scissor: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        width: u32 = 1..=4,
        height: u32 = 1..=4,
    ) {
        let [x0, y0, x1, y1] = scissor;
        let (Ok(area), Ok(region)) = (Region::new(x0, y0, x1, y1), Region::of_size(width, height)) else { return };
        let mut masks = [0];
        let Ok(coverage) = Coverage::<Small>::new(region, &mut masks) else { unreachable!("it fits") };
        let vertices: [Vertex<Small>; 0] = [];
        let result = check_draw(&vertices[..], 1, 0, &State::new(area), &coverage);
        let outside = OutsideAttachment { area: scissor, attachment: [0, 0, width, height] };
        let expected = if x1 <= width && y1 <= height { Ok((1, Some(area))) } else { Err(outside.into()) };
        assert!(result == expected);
        cover!(result.is_ok() && x0 > 0);
    }

    /// Each triangle goes into one count, and clipped ones into theirs besides: one more in, one more out,
    /// so by induction drawn, culled and rejected add up to what was submitted, until a count saturates.
    #[kani::unwind(11)]
    [Statistics::count, add]
    fn each_triangle_is_counted_once(before: [u32; 10] = [0; 10]..=[u32::MAX - 1; 10]) {
        for assembly in ASSEMBLIES {
            for outcome in OUTCOMES {
                let mut after = statistics(before);
                after.count(assembly, outcome);
                let [submitted, drawn, facing, zero_area, no_sample, outside, hidden, non_finite, no_vertex, clipped] =
                    growth(counts(after), before);
                let culled = facing + zero_area + no_sample + outside + hidden;
                let rejected = non_finite + no_vertex;
                assert!(submitted == 0 && hidden == 0 && clipped == u32::from(assembly == Assembly::Clipped));
                assert!(drawn + culled + rejected == 1);
                assert!((drawn == 1) == (outcome == Some(Ok(()))));
                assert!((facing == 1) == (outcome == Some(Err(Culled::Facing))));
                assert!((no_sample == 1) == (outcome == Some(Err(Culled::NoSample))));
                let cannot_be_drawn = matches!(assembly, Assembly::NonFinite | Assembly::NoVertex);
                assert!((rejected == 1) == (outcome.is_none() && cannot_be_drawn));
            }
        }
    }

    /// A count that cannot grow stays at its end; totals do.
    [add, Statistics::count, CulledCounts::total, RejectedCounts::total]
    fn counts_saturate(count: u32, more: u32, parts: [u32; 10]) {
        let exact = |sum: u64| sum.min(u64::from(u32::MAX));
        let mut grown = count;
        add(&mut grown, more);
        assert!(u64::from(grown) == exact(u64::from(count) + u64::from(more)));
        let Statistics { culled, rejected, .. } = statistics(parts);
        let wide = parts.map(u64::from);
        assert!(u64::from(culled.total()) == exact(wide[2] + wide[3] + wide[4] + wide[5] + wide[6]));
        assert!(u64::from(rejected.total()) == exact(wide[7] + wide[8]));
        cover!(wide[2] + wide[3] + wide[4] + wide[5] + wide[6] > 3 << 32);
    }

    /// Statistics of two draws add up count by count.
    [Statistics::add_assign, add]
    fn statistics_add_up(first: [u32; 10], second: [u32; 10], at: usize = 0..=9) {
        let mut sum = statistics(first);
        sum += statistics(second);
        let exact = u64::from(first[at]) + u64::from(second[at]);
        assert!(u64::from(counts(sum)[at]) == exact.min(u64::from(u32::MAX)));
    }

    /// Causes are found in their order: outside, without area, facing away, and what is left lies between
    /// samples or has bounds inside the area.
    [bounds]
    fn causes_of_standard_are_found_in_order(
        corners: [i32; 6] = [-Bounds::<Standard>::GUARD_BAND; 6]..=[Bounds::<Standard>::GUARD_BAND; 6],
        area: [u32; 4] = [0; 4]..=[Standard::MAX_TARGET; 4],
        cull: usize = 0..=2,
    ) {
        causes_are_found_in_order::<Standard>(corners, area, cull);
    }

    /// The same for the small format.
    [bounds]
    fn causes_of_small_are_found_in_order(
        corners: [i32; 6] = [-Bounds::<Small>::GUARD_BAND; 6]..=[Bounds::<Small>::GUARD_BAND; 6],
        area: [u32; 4] = [0; 4]..=[Small::MAX_TARGET; 4],
        cull: usize = 0..=2,
    ) {
        causes_are_found_in_order::<Small>(corners, area, cull);
    }

    /// A whole draw of two triangles, one with a corner at 64 places, one a line: both are accounted for,
    /// and what is counted as drawn has samples.
    #[kani::unwind(18)]
    [draw, draw_with, draw_one]
    fn a_draw_accounts_for_its_triangles(corner: i32 = 0..=63, first_id: u32 = 0..=u32::MAX - 2) {
        let vertex = |x, y| Vertex::<Small>::new(x, y, 0);
        let (Ok(a), Ok(b), Ok(c)) = (vertex(3, 2), vertex(2 * corner - 40, 40), vertex(20, 60)) else { return };
        let Ok(region) = Region::of_size(4, 4) else { return };
        let mut count = Count::default();
        let result = draw(&[a, b, c][..], &[0_u8, 1, 2, 2, 1, 2], first_id, &State::new(region), &mut count);
        let Ok(statistics) = result else { unreachable!("nothing is wrong with it") };
        let Statistics { submitted, drawn, culled, rejected, .. } = statistics;
        assert!(submitted == 2 && drawn + culled.total() + rejected.total() == 2 && culled.zero_area >= 1);
        assert!((drawn == 0) == (count.samples == 0) && count.samples <= 16);
        cover!(drawn == 1);
        cover!(drawn == 0);
    }

    /// An id is of the last draw that begins at it or before, and of its triangle that far on.
    #[kani::unwind(5)]
    [instance_of]
    fn ids_are_of_the_last_draw_before(ids: [u32; 4], count: usize = 0..=4, id: u32) {
        if ids[0] > ids[1] || ids[1] > ids[2] || ids[2] > ids[3] {
            return;
        }
        let ids = &ids[..count];
        match instance_of(ids, id) {
            Some((instance, triangle)) => {
                assert!(ids[instance] <= id && triangle == id - ids[instance]);
                assert!(instance + 1 == count || ids[instance + 1] > id);
            }
            None => assert!(id == NO_ID || count == 0 || ids[0] > id),
        }
        cover!(count == 4 && ids[1] == ids[2] && ids[2] < id);
    }
}
