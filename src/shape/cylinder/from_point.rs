//! Values that all rays from one point share in their tests against a cylinder.

use super::PreparedCylinder;
use crate::number::{square_root, unsigned_wide, wide};
use crate::vector::{Direction, Point, Vector};

/// Values that all rays from one point share in their tests against a cylinder.
#[derive(Clone, Copy, Debug)]
pub struct CylinderFromPoint {
    /// Vector from the point to the cylinder's centre, in steps.
    pub(super) way: Vector,
    /// Cross product axis × `way`, in steps. Its dot product with a ray's direction is the distance
    /// between the lines of ray and axis, times the sine of the angle between them.
    pub(super) across: Vector,
    /// Dot product `way` · axis: height of the cylinder's centre above the point along the axis, in
    /// steps.
    pub(super) rise: i32,
}

/// Values that all rays from one light share in their tests against a cylinder.
#[derive(Clone, Copy, Debug)]
pub struct CylinderFromLight {
    pub(super) from: CylinderFromPoint,
    /// Lower bound of the distance from the light to the cylinder, in steps.
    pub(super) nearest: i32,
}

impl CylinderFromPoint {
    /// Prepares the tests from the vector to the cylinder's centre.
    pub(super) const fn new(way: Vector, axis: Direction) -> Self {
        Self {
            way,
            across: axis.crossed_with(way),
            rise: way.dot(axis),
        }
    }

    /// Returns the distance between the lines of a ray and of the cylinder's axis, in steps, times the
    /// sine of the angle between them. The sign says on which side of the axis the ray passes.
    #[inline(always)]
    pub(crate) const fn sideways(&self, direction: Direction) -> i32 {
        self.across.dot(direction)
    }
}

impl PreparedCylinder {
    /// Prepares the tests of rays from a near point against the cylinder.
    pub(crate) const fn seen_from(&self, origin: Point) -> CylinderFromPoint {
        CylinderFromPoint::new(origin.to(self.center), self.axis)
    }

    /// Prepares the tests of rays from a light at a near point against the cylinder.
    pub(crate) const fn seen_from_light(&self, light: Point) -> CylinderFromLight {
        let seen = self.seen_from(light);
        // Upper bound of the squared rise: the axis is within 2⁻²⁶ of length one, and the rise is
        // rounded.
        let rise = unsigned_wide(wide(seen.rise, seen.rise));
        let most = rise + (rise >> 24) + 4 * seen.rise.unsigned_abs() as u64 + 16;
        let aside = square_root(seen.way.square().saturating_sub(most)) - self.radius;
        let above = seen.rise.saturating_abs() - self.half_height - 16;
        let outside = Vector::new(
            if aside > 0 { aside } else { 0 },
            if above > 0 { above } else { 0 },
            0,
        );
        let distance = square_root(outside.square());
        // A root and a height are known to a few steps, large ones to some more.
        let nearest = distance - (distance >> 20) - 64;
        CylinderFromLight {
            from: seen,
            nearest,
        }
    }
}
