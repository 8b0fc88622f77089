//! Depths of a triangle's corners.

use super::numbers::pick;

/// Three depths in units of 2^-32, chosen by any numbers: anything, extremes, all but equal, equal,
/// steep or shallow.
pub fn depths(numbers: [u32; 4]) -> [u32; 3] {
    let [a, b, c, kind] = numbers;
    let near = |center: u32, reach: i64| {
        [a, b, c].map(|n| (i64::from(center) + pick(n, -reach, reach)).clamp(0, i64::from(u32::MAX)) as u32)
    };
    let extremes =
        [0, 1, 2, 3, 0xFFFF, 0x1_0000, 0x7FFF_FFFF, 0x8000_0000, u32::MAX - 3, u32::MAX - 2, u32::MAX];
    match kind % 6 {
        0 => [a, b, c],
        1 => [a, b, c].map(|n| extremes[n as usize % extremes.len()]),
        2 => near(kind.wrapping_mul(0x9E37_79B9), 3),
        3 => [a; 3],
        4 => near(kind.wrapping_mul(0x9E37_79B9), 1 << 20),
        // Steep: from one end of the range to the other.
        _ => [a % 16, u32::MAX - b % 16, c],
    }
}
