//! Seeded random numbers for tests; they are the same on every machine.

/// Random number generator for tests: SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom
/// Number Generators", OOPSLA 2014).
pub(crate) struct Sweep(u64);

impl Sweep {
    /// Creates a generator with a seed.
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns the next 64 random bits.
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a random number from `low` to `high`, both included.
    pub(crate) fn within(&mut self, low: i32, high: i32) -> i32 {
        let span = u64::from(high.abs_diff(low)) + 1;
        (i64::from(low) + (self.next() % span) as i64) as i32
    }

    /// Returns a random number from 2^`low` to 2^`high`. Every octave is equally likely.
    pub(crate) fn octaves(&mut self, low: u32, high: u32) -> i32 {
        let octave = self.within(low as i32, high as i32 - 1);
        self.within(1 << octave, 2 << octave)
    }

    /// Returns a random number from -1 to 1.
    #[cfg(any(feature = "host", feature = "scenes"))]
    pub(crate) fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Returns three random numbers from -1 to 1.
    #[cfg(any(feature = "host", feature = "scenes"))]
    pub(crate) fn place(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.share())
    }

    /// Returns three random coordinates within ±`limit`.
    pub(crate) fn triple(&mut self, limit: i32) -> [i32; 3] {
        [0; 3].map(|_| self.within(-limit, limit))
    }
}
