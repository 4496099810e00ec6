//! The mean of samples.

use super::{HALF, Sum};
use crate::number::narrowed;

/// Samples of one pixel, added up.
#[derive(Clone, Copy, Debug)]
pub struct Mean {
    /// Red, green and blue of all samples, in steps of 2⁻²⁴.
    total: [i32; 3],
    count: i32,
}

impl Mean {
    /// No sample.
    pub const NONE: Self = Self {
        total: [0; 3],
        count: 0,
    };

    /// Adds a sample, clamped to 0 to 1. There are at most 64.
    pub fn add(&mut self, sample: Sum) {
        let Sum(sample) = sample;
        for (total, part) in self.total.iter_mut().zip(sample) {
            *total += (part - HALF).clamp(0, 255 << 16);
        }
        self.count += 1;
    }

    /// Returns the mean, rounded down to 2⁻²⁴; black if there is no sample.
    pub fn sum(self) -> Sum {
        // A reciprocal in Q30: exact to 2⁻²⁶ of white.
        let share = (1 << 30) / self.count.max(1);
        let mean = |total: i32| narrowed((i64::from(total) * i64::from(share)) >> 30) + HALF;
        Sum(self.total.map(mean))
    }
}
