//! Where the rays of a stretch of pixels come from: the camera, or its image in flat mirrors.

use crate::number::Length;
use crate::scene::access::ShapeId;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

/// Where the rays of a stretch come from.
#[derive(Clone, Copy)]
pub(super) struct Origin<'a> {
    /// The camera, or its image in one plane after another.
    pub(super) eye: Point,
    /// Normal of the plane in which the rays lie.
    pub(super) row: Direction,
    /// Number of reflections.
    pub(super) level: usize,
    /// The plane that mirrored the rays last.
    pub(super) mirror: Option<(ShapeId, &'a PreparedPlane)>,
}

impl<'a> Origin<'a> {
    /// Returns the origin of the rays of a row, from the camera and the normal of the plane in which they lie.
    pub(super) fn camera((eye, row): (Point, Direction)) -> Self {
        Self {
            eye,
            row,
            level: 0,
            mirror: None,
        }
    }

    /// Returns where the rays come from after a plane mirrored them, `None` if that is far.
    pub(super) fn mirrored(
        &self,
        mirror: (ShapeId, &'a PreparedPlane),
        epsilon: Length,
    ) -> Option<Self> {
        let (_, plane) = mirror;
        let across = self.row.dot(plane.normal);
        Some(Self {
            eye: plane.mirrored(self.eye, epsilon)?,
            row: self.row.reflected(plane.normal, across),
            level: self.level + 1,
            mirror: Some(mirror),
        })
    }
}
