//! A cylinder as rays from one point meet it.

use super::PreparedCylinder;
use crate::number::{square_root, unsigned_wide, wide};
use crate::vector::{Direction, Point, Vector};

/// A cylinder as the rays from one point see it.
#[derive(Clone, Copy, Debug)]
pub struct CylinderFromPoint {
    /// From the point to the middle of the cylinder.
    pub(super) way: Vector,
    /// axis × way: its length along a ray is how far the ray's line passes from the axis's, times
    /// the sine of the angle between them.
    pub(super) across: Vector,
    /// way · axis
    pub(super) rise: i32,
}

/// A cylinder as rays from a light meet it.
#[derive(Clone, Copy, Debug)]
pub struct CylinderFromLight {
    pub(super) from: CylinderFromPoint,
    /// Nothing of it is nearer to the light than this.
    pub(super) nearest: i32,
}

impl CylinderFromPoint {
    /// How far from the axis the line of a ray passes, times the sine of the angle between them;
    /// below zero on one side of it.
    #[inline(always)]
    pub(crate) const fn sideways(&self, direction: Direction) -> i32 {
        self.across.dot(direction)
    }
}

impl PreparedCylinder {
    /// As seen from a near point.
    pub(crate) const fn seen_from(&self, origin: Point) -> CylinderFromPoint {
        let way = origin.to(self.center);
        CylinderFromPoint {
            way,
            across: self.axis.crossed_with(way),
            rise: way.dot(self.axis),
        }
    }

    /// As seen from a light at a near point.
    pub(crate) const fn seen_from_light(&self, light: Point) -> CylinderFromLight {
        let seen = self.seen_from(light);
        // The axis is within 2⁻²⁶ of length one, and the rise is rounded: it may be that much more.
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
        // A root and a height are known to a few steps, a large one to some more.
        let nearest = distance - (distance >> 20) - 64;
        CylinderFromLight {
            from: seen,
            nearest,
        }
    }
}
