//! Depth as unsigned normalised integers.

/// Smallest depth a vertex carries, in units of 2^-32: interpolation stays above 0.
pub const DEPTH32_MIN: u32 = 2;
/// Largest depth a vertex carries, in units of 2^-32: interpolation stays below 2^32 - 1, the
/// clear value, which no covered sample ever has.
pub const DEPTH32_MAX: u32 = u32::MAX - 2;
/// [`DEPTH32_MIN`] for 16-bit depth.
pub const DEPTH16_MIN: u32 = 2;
/// [`DEPTH32_MAX`] for 16-bit depth.
pub const DEPTH16_MAX: u32 = 0xFFFF - 2;

/// The unorm32 nearest to `depth`, ties upwards: z (2^32 - 1) + 1/2, truncated (Direct3D 11.3,
/// 17.11). Values below 0 and NaN give 0, values above 1 give 2^32 - 1. Integer arithmetic, exact
/// for every bit pattern.
#[must_use]
pub fn unorm32(depth: f32) -> u32 {
    if depth >= 1.0 {
        return u32::MAX;
    }
    if depth.is_nan() || depth <= 0.0 {
        return 0;
    }
    let bits = depth.to_bits();
    let exponent = bits >> 23;
    let significand = u64::from(bits & 0x7F_FFFF) + if exponent == 0 { 0 } else { 1 << 23 };
    // depth = significand 2^-shift, with 24 <= shift <= 149.
    let shift = 150 - if exponent == 0 { 1 } else { exponent };
    let product = (significand << 32) - significand;
    if shift > 57 {
        return 0; // product < 2^56, less than half of 2^shift
    }
    ((product + (1 << (shift - 1))) >> shift) as u32
}

/// The unorm16 nearest to a unorm32: z / 65537, as 65537 = (2^32 - 1) / (2^16 - 1) is odd there are
/// no ties. No division: 65537 = 2^16 + 1.
#[must_use]
pub const fn unorm16(depth: u32) -> u32 {
    let (high, low) = (depth >> 16, depth & 0xFFFF);
    // depth = 65537 high + (low - high); a negative remainder borrows one 65537.
    let (quotient, remainder) = if low >= high { (high, low - high) } else { (high - 1, low + 65537 - high) };
    if remainder > 65537 / 2 { quotient + 1 } else { quotient }
}
