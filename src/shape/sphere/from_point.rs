//! A sphere as rays from one point meet it: what its tangents tell.

use crate::number::Length;
use crate::vector::{Direction, Vector};

/// A sphere as the rays from one point see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereFromPoint {
    /// From the point to the centre.
    pub(super) way: Vector,
    /// The length of the tangents from the point; the least number where the point lies inside.
    pub(super) tangent: i32,
}

impl SphereFromPoint {
    /// A quarter of the way along a ray at which it comes nearest to the centre.
    #[inline(always)]
    pub(crate) const fn nearest_approach(&self, direction: Direction) -> i32 {
        self.way.quarter_dot(direction)
    }

    /// Whether a ray may meet the sphere, by its nearest approach: a ray that touches it comes
    /// nearest where the tangent does, and one that goes through later.
    #[inline(always)]
    pub(crate) const fn may_be_met(&self, nearest_approach: i32) -> bool {
        nearest_approach >= self.tangent >> 2
    }

    /// Whether its tangents are shorter than another's: it is in front of it, or about as far.
    #[inline(always)]
    pub(crate) const fn is_in_front_of(&self, other: &Self) -> bool {
        self.tangent < other.tangent
    }

    /// Whether its tangents are shorter than a distance.
    #[inline(always)]
    pub(crate) const fn is_nearer_than(&self, distance: Length) -> bool {
        self.tangent < distance.to_bits()
    }

    /// From the point to the centre.
    #[inline(always)]
    pub(crate) const fn way(&self) -> Vector {
        self.way
    }

    /// Whether the point lies inside the sphere.
    pub(crate) const fn is_around(&self) -> bool {
        self.tangent == i32::MIN
    }

    /// Whether the sphere, which the point is outside of, lies on the ray before `reach`, where
    /// something else that is not inside the sphere ends the ray.
    ///
    /// No root: the sphere is entered before its tangents' length and left after it.
    #[inline(always)]
    pub(crate) const fn is_before(&self, direction: Direction, reach: Length) -> bool {
        self.tangent < reach.to_bits() && self.way.dot(direction) >= self.tangent
    }

    /// Whether a distance is shorter than the tangents, but long enough to end inside of the sphere,
    /// whose radius is given.
    #[inline(always)]
    pub(crate) const fn may_hold_the_end(&self, radius: i32, distance: Length) -> bool {
        let rest = self.tangent - distance.to_bits();
        0 <= rest && rest <= radius
    }
}
