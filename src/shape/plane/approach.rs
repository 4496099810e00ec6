//! Distances from near rays to planes as fractions. They are compared without a division; only the
//! distance to the nearest plane takes one.

use crate::number::{Length, magnitude, ratio, unsigned, wide_unsigned};

/// Distance from a ray's origin to a plane, as the fraction height / descent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach {
    /// Height of the ray's origin above the plane, in steps.
    height: u32,
    /// Height that the ray loses per step, Q4.28.
    descent: u32,
}

impl Approach {
    /// Creates the fraction for a hit at a known distance.
    #[inline(always)]
    pub(crate) const fn at(distance: Length) -> Self {
        Self {
            height: unsigned(distance.to_bits()),
            descent: 1 << 28,
        }
    }

    /// Tests whether this distance is smaller than another one. Takes no division.
    #[inline(always)]
    pub(crate) const fn is_before(&self, other: &Self) -> bool {
        wide_unsigned(self.height, other.descent) < wide_unsigned(other.height, self.descent)
    }

    /// Returns the distance to the plane in steps, which is below 2³⁰. Takes the division.
    #[inline(always)]
    pub(crate) const fn distance(&self) -> Length {
        let distance = ratio(self.height, self.descent << 2);
        // Rounding may give a little more.
        const MOST: i32 = (1 << 30) - 1;
        Length::from_bits(if distance < MOST { distance } else { MOST })
    }
}

/// Height of a ray's origin above a plane, and the height that the ray gains per step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bearing {
    /// Low 32 bits of the height above the plane, in steps. The height is within ±2³², so at most the
    /// sign is missing.
    pub(super) steps: i32,
    /// Sign of the height, in every bit: 0 or -1.
    pub(super) sign: i32,
    /// Height that the ray gains per step, Q4.28: the raw cosine between ray and normal, Q2.30, divided
    /// by 4 and rounded down.
    pub(super) climb: i32,
}

impl Bearing {
    /// Bearing of a ray that approaches no plane.
    pub(crate) const NONE: Self = Self {
        steps: 0,
        sign: 0,
        climb: 0,
    };

    /// Returns the distance to the plane as a fraction, or `None` if the ray does not approach the
    /// plane.
    #[inline(always)]
    pub(crate) fn approach(&self) -> Option<Approach> {
        let steps = magnitude(self.steps, self.sign);
        (self.climb ^ self.sign < 0 && steps != 0).then_some(Approach {
            height: steps,
            descent: self.climb.unsigned_abs(),
        })
    }
}
