//! Triangle ids as colours: always the same for the same id, and distinct for different ones.

use halfplane::NO_ID;

/// The colour of a triangle id; black for [`NO_ID`] only.
///
/// A one-to-one mix of 24 bits, so that no two ids below 2^24 - 1 share a colour.
#[must_use]
pub fn colour_of(id: u32) -> [u8; 3] {
    if id == NO_ID {
        return [0; 3];
    }
    // Multiplying by an odd number and folding the high half down are both one-to-one on 24 bits.
    const MASK: u32 = 0xFF_FFFF;
    // Zero stays zero: id 2^24 - 1 gets there, and of the ids above those that fold on to it.
    let mut h = (id.wrapping_add(1) ^ (id >> 24).wrapping_mul(0x9E_3779)) & MASK;
    for multiplier in [0x5B_D1E9, 0x2F_0B45, 0x91_E10D] {
        h = h.wrapping_mul(multiplier) & MASK;
        h ^= h >> 12;
    }
    let [red, green, blue, _] = h.to_le_bytes();
    if h == 0 { [1, 1, 1] } else { [red, green, blue] }
}

/// One colour per pixel.
#[must_use]
pub fn colours(ids: &[u32]) -> Vec<[u8; 3]> {
    ids.iter().map(|&id| colour_of(id)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_distinct_and_never_the_background() {
        let mut seen = std::collections::HashSet::new();
        for id in 0..300_000 {
            assert!(seen.insert(colour_of(id)), "{id}");
            assert_ne!(colour_of(id), [0; 3], "{id}");
        }
        assert_eq!(colour_of(NO_ID), [0; 3]);
        // And the same in every release.
        assert_eq!([colour_of(0), colour_of(1)], [[239, 174, 170], [222, 77, 85]]);
    }
}
