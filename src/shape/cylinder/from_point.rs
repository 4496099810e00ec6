//! A cylinder as rays from one point meet it.

use crate::vector::{Direction, Vector};

/// A cylinder as the rays from one point see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CylinderFromPoint {
    /// From the point to the middle of the cylinder.
    pub(super) way: Vector,
    /// axis × way: its length along a ray is how far the ray's line passes from the axis's, times
    /// the sine of the angle between them.
    pub(super) across: Vector,
    /// way · axis
    pub(super) rise: i32,
}

impl CylinderFromPoint {
    /// How far from the axis the line of a ray passes, times the sine of the angle between them;
    /// below zero on one side of it.
    #[inline(always)]
    pub(crate) const fn sideways(&self, direction: Direction) -> i32 {
        self.across.dot(direction)
    }
}
