//! Several draws into one id buffer, and back from an id.

/// The draw that an id is of, and the number of the triangle in its list: of draws whose first ids are `first_ids`, in
/// rising order. `None` for an id before the first, [`NO_ID`](crate::NO_ID) and lists without draws.
///
/// Give each instance of a mesh the ids that follow those of the one before: a visibility buffer then tells instance and
/// triangle. Of two draws with the same first id, the first has no triangles.
///
/// ```
/// use halfplane::draw::instance_of;
///
/// // Three instances: of 100, of no and of 20 triangles.
/// let first_ids = [0, 100, 100];
/// assert_eq!(instance_of(&first_ids, 99), Some((0, 99)));
/// assert_eq!(instance_of(&first_ids, 119), Some((2, 19)));
/// assert_eq!(instance_of(&first_ids, halfplane::NO_ID), None);
/// ```
#[must_use]
pub fn instance_of(first_ids: &[u32], id: u32) -> Option<(usize, u32)> {
    if id == crate::NO_ID {
        return None;
    }
    // The draws that begin at the id or before; halved, so that only the order of those is relied on.
    let (mut low, mut high) = (0, first_ids.len());
    while low < high {
        let middle = low + (high - low) / 2;
        if first_ids.get(middle).is_some_and(|&first| first <= id) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    let instance = low.checked_sub(1)?;
    Some((instance, id.checked_sub(*first_ids.get(instance)?)?))
}
