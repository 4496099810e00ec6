//! Colours as a pixel with smooth edges mixes them.

use super::{HALF, Sum};
use crate::number::{narrowed, signed, to_u16, unsigned, wide};

/// A colour as a display shows it: red, green and blue, clamped to 0 to 255 levels, in steps of 1/256 of a level. Half a level
/// is added to each, as in a [`Sum`], so the upper byte is the rounded level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels([u16; 3]);

impl Levels {
    /// All zeros, for what is not computed yet. No colour has this value: even black is stored as half a level.
    pub const DARK: Self = Self([0; 3]);

    /// Clamps a sum, and rounds it down.
    #[inline(always)]
    pub fn of(Sum(sum): Sum) -> Self {
        let level = |part: i32| unsigned((part - HALF).clamp(0, 255 << 16) + HALF);
        Self(sum.map(|part| to_u16(level(part) >> 8)))
    }

    /// Returns the mean of two colours.
    #[inline(always)]
    pub fn half_way(self, Self(other): Self) -> Self {
        let ([r, g, b], [red, green, blue]) = (self.0, other);
        Self([(r, red), (g, green), (b, blue)].map(|(one, other)| one.midpoint(other)))
    }

    /// Returns the sum that shows the colour.
    #[inline(always)]
    pub fn sum(self) -> Sum {
        Sum(self.0.map(|part| i32::from(part) << 8))
    }

    /// Returns the largest difference of a component from that of another colour, in 8-bit levels, rounded down.
    #[inline(never)]
    pub fn contrast(self, Self(other): Self) -> u32 {
        let parts = self.0.iter().zip(other);
        let largest = parts.fold(0, |most, (&one, other)| one.abs_diff(other).max(most));
        u32::from(largest >> 8)
    }

    /// Returns the sum of the components and of the half levels added to them, in steps of 1/256 of an 8-bit level.
    #[inline(always)]
    pub fn brightness(self) -> i32 {
        let [red, green, blue] = self.0.map(i32::from);
        red + green + blue
    }
}

/// Colours of one pixel, added up with their weights.
#[derive(Clone, Copy, Debug)]
pub struct Mixture([i32; 3]);

impl Mixture {
    /// No colour.
    pub const NONE: Self = Self([0; 3]);

    /// Returns the sum of the components.
    #[inline(always)]
    pub fn brightness(self) -> i32 {
        let [red, green, blue] = self.0;
        red + green + blue
    }

    /// Adds another mixture, weight by weight.
    #[inline(always)]
    pub fn with(self, Self([r, g, b]): Self) -> Self {
        let [red, green, blue] = self.0;
        Self([red + r, green + g, blue + b])
    }

    /// Adds a colour. All weights of a mixture are at most 2¹¹ in sum.
    #[inline(always)]
    pub fn add(&mut self, color: Levels, weight: i32) {
        for (total, part) in self.0.iter_mut().zip(color.0.map(i32::from)) {
            *total += weight * part;
        }
    }

    /// Returns the mean, rounded down. `total` is the sum of all weights. The mean may be one step less if it is no power of
    /// two.
    #[inline(always)]
    pub fn mean(self, total: u32) -> Levels {
        let shift = total.trailing_zeros();
        let mean = if 1 << shift == total {
            self.0.map(|part| part >> shift)
        } else {
            self.0.map(|part| share(part, total))
        };
        Levels(mean.map(|part| to_u16(unsigned(part))))
    }
}

/// Returns `part` / `total`, off by at most one.
#[inline(never)]
fn share(part: i32, total: u32) -> i32 {
    let reciprocal = signed((1_u32 << 31).checked_div(total).unwrap_or(0));
    narrowed(wide(part, reciprocal) >> 31)
}
