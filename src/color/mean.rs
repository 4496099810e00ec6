//! The mean of samples.

use super::{HALF, Sum};
use crate::number::{narrowed, signed, wide};

/// Samples of one pixel, added up: red, green and blue in steps of 2⁻²⁴.
#[derive(Clone, Copy, Debug)]
pub struct Samples([i32; 3]);

impl Samples {
    /// No sample.
    pub const NONE: Self = Self([0; 3]);

    /// Adds a sample, clamped to 0 to 1. There are at most 64.
    #[inline(always)]
    pub fn add(&mut self, Sum(sample): Sum) {
        for (total, part) in self.0.iter_mut().zip(sample) {
            *total += (part - HALF).clamp(0, 255 << 16);
        }
    }

    /// Returns the mean of `count` samples, 1 to 64, rounded down to 2⁻²⁴. It may be one step less if `count` is no power
    /// of two.
    #[inline(always)]
    pub fn mean(self, count: u32) -> Sum {
        let shift = count.trailing_zeros();
        let mean = match 1 << shift == count {
            true => self.0.map(|total| total >> shift),
            false => self.0.map(|total| share(total, count)),
        };
        Sum(mean.map(|part| part + HALF))
    }
}

/// Returns `total` / `count`, off by at most one.
#[inline(never)]
fn share(total: i32, count: u32) -> i32 {
    let reciprocal = signed((1 << 31) / count);
    narrowed(wide(total, reciprocal) >> 31)
}
