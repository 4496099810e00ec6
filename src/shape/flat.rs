//! What flat shapes share: their plane as seen from a point. Knows no outline.

use super::bordered::Fan;
use super::rays::SLACK;
use crate::number::scaled_by_unit;
use crate::vector::{Direction, Point, Vector};

/// Values that all rays from one point share in their tests against a flat shape.
#[derive(Clone, Copy, Debug)]
pub struct FlatFromPoint {
    /// Vector from the point to a disc's centre or to a triangle's first corner, in steps.
    pub(super) way: Vector,
    /// Signed distance from the point to the shape's plane along its normal, in steps.
    pub(super) height: i32,
}

impl FlatFromPoint {
    /// Placeholder for an unused slot in a light's list.
    pub(super) const NONE: Self = Self {
        way: Vector::ZERO,
        height: 0,
    };

    /// Prepares the tests of rays from `point` against a shape with this normal. `place` lies on the shape.
    pub(super) const fn new(point: Point, place: Point, normal: Direction) -> Self {
        let way = point.to(place);
        let height = way.dot(normal);
        Self { way, height }
    }

    /// Tests whether a fan surely stays on one side of the shape's plane.
    pub(super) fn is_beside(&self, normal: Direction, fan: &Fan) -> bool {
        // Heights of the apex and of the ends above the shape.
        let apex = -self.height;
        let is_above = fan.ends.iter().zip(fan.reaches).map(|(end, reach)| {
            let height = apex + scaled_by_unit(reach.to_bits(), end.dot(normal));
            let reach = fan.thickness + SLACK;
            i32::from(height > reach) - i32::from(height < -reach)
        });
        let sides = is_above.sum::<i32>() + i32::from(apex > SLACK) - i32::from(apex < -SLACK);
        sides.abs() == 3
    }
}
