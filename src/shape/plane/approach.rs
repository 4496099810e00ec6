//! How a near ray comes down on a plane, as a fraction: no division until the nearest plane is known.

use crate::number::{Length, magnitude, ratio, unsigned, wide_unsigned};

/// How a ray comes down on a plane: the distance is the height over the descent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach {
    height: u32,
    /// How much height is lost a step, Q4.28.
    descent: u32,
}

impl Approach {
    /// Of what is met at a distance.
    #[inline(always)]
    pub(crate) const fn at(distance: Length) -> Self {
        Self {
            height: unsigned(distance.to_bits()),
            descent: 1 << 28,
        }
    }

    /// Whether this meets its plane before another; no division.
    #[inline(always)]
    pub(crate) const fn is_before(&self, other: &Self) -> bool {
        wide_unsigned(self.height, other.descent) < wide_unsigned(other.height, self.descent)
    }

    /// The distance, which is below 2³⁰.
    #[inline(always)]
    pub(crate) const fn distance(&self) -> Length {
        let distance = ratio(self.height, self.descent << 2);
        // Rounding may reach beyond.
        const MOST: i32 = (1 << 30) - 1;
        Length::from_bits(if distance < MOST { distance } else { MOST })
    }
}

/// Where a ray begins as a plane sees it, and where it goes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bearing {
    /// The height over the plane, within ±2³², so that only the sign may be lost.
    pub(super) steps: i32,
    /// All bits the sign of the height.
    pub(super) sign: i32,
    /// A quarter of the cosine to the normal, rounded down: how much height is gained a step, Q4.28.
    pub(super) climb: i32,
}

impl Bearing {
    /// Of nothing.
    pub(crate) const NONE: Self = Self {
        steps: 0,
        sign: 0,
        climb: 0,
    };

    /// How the ray comes down on the plane, if it does.
    #[inline(always)]
    pub(crate) fn approach(&self) -> Option<Approach> {
        let steps = magnitude(self.steps, self.sign);
        (self.climb ^ self.sign < 0 && steps != 0).then_some(Approach {
            height: steps,
            descent: self.climb.unsigned_abs(),
        })
    }
}
