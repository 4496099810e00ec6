//! A small deterministic source of random numbers. Knows no scene.

use reflet::host::reference::Vector;

/// Random numbers by SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014).
pub struct Random(u64);

impl Random {
    /// Starts a sequence that depends on every word.
    pub fn new(words: &[u64]) -> Self {
        let mut random = Self(0);
        for word in words {
            random.0 ^= word;
            random.0 = random.bits();
        }
        random
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number from `low` to `high`, evenly distributed.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 * f64::exp2(-53.0);
        low + (high - low) * unit
    }

    /// Returns a number from `low` to `high`, whose logarithm is evenly distributed.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        // Not by `ln` and `exp`: their last digits differ between machines.
        let mut number = low;
        let ratio = high / low;
        let mut root = ratio.sqrt();
        for _ in 0..24 {
            if self.chance(0.5) {
                number *= root;
            }
            root = root.sqrt();
        }
        number
    }

    /// Returns a count from `least` to `most`.
    pub fn count(&mut self, least: usize, most: usize) -> usize {
        least + (self.bits() % (most - least + 1) as u64) as usize
    }

    /// Returns `true` with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    /// Returns one of the items.
    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.count(0, items.len() - 1)]
    }

    /// Returns a point in the cube of ±1, evenly distributed.
    pub fn cube(&mut self) -> Vector {
        Vector([0; 3].map(|_| self.between(-1.0, 1.0)))
    }

    /// Returns a point in the unit ball, evenly distributed, not too near to its middle.
    pub fn point(&mut self) -> Vector {
        loop {
            let point = self.cube();
            if (0.01..=1.0).contains(&point.length()) {
                return point;
            }
        }
    }

    /// Returns a direction of length one, evenly distributed.
    pub fn direction(&mut self) -> Vector {
        self.point().unit()
    }

    /// Returns a direction of length one, perpendicular to the unit vector `axis`.
    pub fn across(&mut self, axis: Vector) -> Vector {
        loop {
            let across = self.direction().across(axis);
            if across.length() > 0.1 {
                return across.unit();
            }
        }
    }

    /// Returns a colour with every channel from 0.1 to 1.
    pub fn color(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.between(0.1, 1.0))
    }

    /// Returns a colour with every channel from 0 to 1.
    pub fn channels(&mut self) -> [f64; 3] {
        [0; 3].map(|_| self.between(0.0, 1.0))
    }
}
