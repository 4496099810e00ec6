//! The trait of bounded shapes as a stretch of pixels needs them: where a shape begins and ends in a row,
//! and what it surely does, or surely does not, between two traced pixels.

use core::fmt::Debug;

use super::bounded::{Bounded, LightRay};
use crate::number::{Unit, ratio, scaled_by_unit, unsigned, unsigned_wide, wide};
use crate::ray::{RowPlane, Span};
use crate::vector::{Direction, Point, Vector};

/// Ball in steps: centre and radius.
pub(crate) type Ball = (Point, i32);

/// Bounded shape whose borders are known. The solid of a shape is the smallest convex body that holds it:
/// an open cylinder with its ends closed.
pub trait Bordered: Bounded {
    /// Further borders of a [`Span`]: as many columns as the kind of shape has.
    type Rims: AsRef<[u16]> + Copy + Debug;

    /// Returns the columns of a row in which rays from the eye can hit the shape, `None` if there are
    /// none. `screen` holds the first and the last column of the shape's rectangle.
    fn span(
        &self,
        from: &Self::FromPoint,
        row: &RowPlane,
        screen: [u16; 2],
    ) -> Option<Span<Self::Rims>>;

    /// Returns a lower bound of the distance from the eye to the shape's outline, in steps.
    fn outline_distance(&self, from: &Self::FromPoint) -> i32;

    /// Returns a ball around the shape.
    fn bounding_ball(&self) -> Ball;

    /// Tests whether the solid surely has no point in a ball.
    fn is_apart_from(&self, ball: Ball) -> bool;

    /// Tests whether the shape surely hides no end of a beam from the light.
    fn spares(&self, from: &Self::FromLight, beam: &Beam) -> bool;

    /// Tests whether the shape surely hides all ends of a beam from the light. It hides the two ends in
    /// `ends`. If `is_flat`, all ends lie on the straight line between the two.
    fn hides(
        &self,
        from: &Self::FromLight,
        beam: &Beam,
        ends: &[LightRay; 2],
        is_flat: bool,
    ) -> bool;
}

/// All rays from a light to points in a ball.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Direction from the light to the middle of the ball.
    pub(crate) direction: Direction,
    /// Distance from the light to the middle of the ball, in steps.
    pub(crate) length: i32,
    /// Radius of the ball, in steps.
    pub(crate) radius: i32,
    /// Upper bound of the sine of the angle between a ray and the direction. At most 1/4.
    pub(crate) spread: Unit,
}

/// What a distance is enlarged by, in steps, because products are rounded.
pub(super) const SLACK: i32 = 32;

impl Beam {
    /// Returns the beam from a light to a ball, `None` if it is too wide.
    pub(crate) fn new(light: Point, (middle, radius): Ball) -> Option<Self> {
        let (direction, length) = light.to(middle).direction_and_length();
        let (length, radius) = (length.to_bits(), radius + SLACK);
        (length > 8 * radius).then(|| Self {
            direction,
            length,
            radius,
            // The tangent is larger than the sine by less than 1/64 of it.
            spread: Unit::from_bits(ratio(unsigned(radius + (radius >> 5)), unsigned(length)) + 4),
        })
    }

    /// Returns the largest distance of the beam's rays from its middle ray, at a distance from the light.
    pub(super) fn width(&self, distance: i32) -> i32 {
        match distance > 0 {
            true => scaled_by_unit(distance, self.spread) + SLACK,
            false => SLACK,
        }
    }

    /// Tests whether a ball surely hides no end of the beam. `way` is the vector from the light to the
    /// ball's centre.
    ///
    /// The beam is a cone. At a right angle to its middle ray, the distance of the ball's centre is p.
    /// The distance to the cone is at least p cos β - s sin β. The cosine of β is above 31/32.
    pub(crate) fn passes(&self, way: Vector, radius: i32) -> bool {
        let along = way.dot(self.direction);
        let beyond = along - self.length;
        if along < -radius - SLACK || beyond > radius + self.radius {
            return true;
        }
        let aside = way.without(self.direction, along).square();
        if beyond > 0 {
            // The nearest ray ends in the beam's ball.
            return aside + square(beyond) > square(radius + self.radius);
        }
        let reach = radius + self.width(along);
        aside > square(reach + (reach >> 4))
    }
}

/// Returns the square of a length.
pub(super) fn square(length: i32) -> u64 {
    unsigned_wide(wide(length, length))
}
