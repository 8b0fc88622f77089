//! Ids of several draws, and back to the draw and its triangle.

use halfplane::{NO_ID, draw::instance_of};

/// The last draw that begins at the id or before, looked for one by one.
fn found(first_ids: &[u32], id: u32) -> Option<(usize, u32)> {
    let at = first_ids.iter().rposition(|&first| first <= id)?;
    (id != NO_ID).then(|| (at, id - first_ids[at]))
}

#[test]
fn ids_tell_the_draw_and_its_triangle() {
    for draws in
        [&[][..], &[0], &[5], &[0, 1, 2, 3], &[0, 100, 100], &[3, 3, 4, 9, 9, 9, 12], &[7, NO_ID - 1]]
    {
        for id in (0..130).chain(NO_ID - 3..=NO_ID) {
            assert_eq!(instance_of(draws, id), found(draws, id), "{id} of {draws:?}");
        }
    }
}
