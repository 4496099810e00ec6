//! Tests of rays from one point against a sphere. They compare with the length of the tangents from the
//! point to the sphere and take no root.

use crate::number::Length;
use crate::vector::{Direction, Vector};

/// Values that all rays from one point share in their tests against a sphere.
#[derive(Clone, Copy, Debug)]
pub struct SphereFromPoint {
    /// Vector from the point to the sphere's centre, in steps.
    pub(super) way: Vector,
    /// Length of the tangents from the point to the sphere, in steps; `i32::MIN` if the point lies
    /// inside.
    pub(super) tangent: i32,
}

impl SphereFromPoint {
    /// Tests whether a ray may hit the sphere. A ray that touches the sphere is nearest to the centre at
    /// the tangents' length. A ray that goes through the sphere is nearest further on.
    #[inline(always)]
    pub(crate) const fn may_be_met(&self, direction: Direction) -> bool {
        self.way.quarter_dot(direction) >= self.tangent >> 2
    }

    /// Tests whether the point lies inside the sphere.
    pub(crate) const fn is_around(&self) -> bool {
        self.tangent == i32::MIN
    }

    /// Tests whether a ray hits the sphere before `reach`. The ray starts outside of the sphere and ends
    /// at `reach` on a surface that is not inside the sphere.
    ///
    /// Takes no root: a ray enters the sphere before the length of the tangents and leaves it after.
    #[inline(always)]
    pub(crate) const fn is_before(&self, direction: Direction, reach: Length) -> bool {
        self.tangent < reach.to_bits() && self.way.dot(direction) >= self.tangent
    }

    /// Tests whether a ray of length `distance` may end inside the sphere although it is not longer than
    /// the tangents. `radius` is the sphere's radius, in steps.
    #[inline(always)]
    pub(crate) const fn may_hold_the_end(&self, radius: i32, distance: Length) -> bool {
        let rest = self.tangent - distance.to_bits();
        0 <= rest && rest <= radius
    }
}
