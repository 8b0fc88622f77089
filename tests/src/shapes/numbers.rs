//! A small generator of numbers, for shapes with more numbers than an engine should choose.

/// SplitMix64 (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014).
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number from `low` to `high`, both included; `low` where there is none.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        let count = (high - low).max(0) as u64 + 1;
        low + (self.bits() % count) as i64
    }

    /// A number below `count`, which is not 0.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }

    /// Sixteen numbers of 32 bits.
    pub fn words<const N: usize>(&mut self) -> [u32; N] {
        std::array::from_fn(|_| self.bits() as u32)
    }
}

/// A number from `low` to `high`, both included, chosen by `number`; 0 chooses the one nearest to 0.
pub(super) fn pick(number: u32, low: i64, high: i64) -> i64 {
    let start = 0.clamp(low, high);
    let count = high - low + 1;
    low + (start - low + i64::from(number)).rem_euclid(count)
}
