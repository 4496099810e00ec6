//! The trait of bounded shapes: tests of rays against a shape, and its normal. Code that is
//! generic over the trait is compiled once for each kind of shape.

use core::fmt::Debug;

use crate::number::Length;
use crate::ray::{REACH, Ray};
use crate::vector::{Direction, Point, Vector};

/// Bounded shape as the kernels read it: hit, occlusion and normal.
pub trait Bounded: Copy + Debug + 'static {
    /// Values that all rays from one fixed point share in their tests against the shape, such as the
    /// vector from the point to the shape's centre.
    type FromPoint: Copy + Debug;

    /// Values that all rays from one light share in their tests against the shape.
    type FromLight: Copy + Debug;

    /// Whether shapes of this kind are balls. The screen bounds of balls are exact, and a row of pixels
    /// tests them from front to back.
    const IS_BALL: bool;

    /// Whether shapes of this kind are flat. A ray that leaves a flat shape does not hit it again, and a
    /// flat mirror does not distort what it reflects. Defaults to `false`.
    const IS_FLAT: bool = false;

    /// Returns a capsule around the shape: its centre, the vector from the centre to one end, and its
    /// radius, in steps. Without length it is a ball.
    fn outline(&self) -> (Point, Vector, i32);

    /// Prepares the tests of rays that start at the camera or at its mirror image. The result is
    /// conservative: rounding never turns a hit into a miss.
    fn seen_from_eye(&self, eye: Point) -> Self::FromPoint;

    /// Tests whether shape `_one` is nearer to the common point than shape `_other`, or about as near.
    /// Called for balls only; the default is `false`.
    #[inline(always)]
    fn is_in_front_of(_one: &Self::FromPoint, _other: &Self::FromPoint) -> bool {
        false
    }

    /// Tests whether a near point lies inside the shape. The shape is closed, so every ray from such a
    /// point hits it. Defaults to `false`, for shapes that enclose no space.
    fn holds(&self, _point: Point) -> bool {
        false
    }

    /// Returns the distance from the ray's origin to the first hit within `range`.
    ///
    /// The distance does not depend on `range`. A hit is found if it lies at least [`SURE`] steps before
    /// the end of the range.
    fn intersect(&self, ray: &Ray, range: Range) -> Option<Length>;

    /// Returns the distance to the first hit within `range` of a ray that starts at the point for which
    /// `from` was prepared.
    fn intersect_from(
        &self,
        from: &Self::FromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length>;

    /// Tests whether the ray hits the shape at a distance above 0 and below `reach`.
    fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        let start = Length::from_bits(0);
        self.intersect(ray, Range { start, reach }).is_some()
    }

    /// Tests whether the ray hits the shape at any distance above 0.
    #[inline(always)]
    fn is_ahead(&self, ray: &Ray) -> bool {
        self.blocks(ray, REACH)
    }

    /// Tests whether the shape hides the end of `ray` from the light for which `from` was prepared.
    /// `own` says whether the end lies on the surface of this shape.
    fn occludes<const PRECISE: bool>(
        &self,
        from: &Self::FromLight,
        ray: &LightRay,
        own: Own,
    ) -> bool;

    /// Returns the outward normal at a point on the shape.
    fn normal(&self, at: Point) -> Direction;

    /// Returns the normal with which a point of a flat shape is shaded, if that is another one than its own.
    /// `flat` is the shape's own normal on the viewer's side, and the viewer looks along `view`. Defaults to `None`.
    #[inline(always)]
    fn bent(&self, _at: Point, _flat: Direction, _view: Direction) -> Option<Direction> {
        None
    }

    /// Tests whether a flat shape is shaded with other normals than its own. Defaults to `false`.
    #[inline(always)]
    fn is_smooth(&self) -> bool {
        false
    }
}

/// A hit may be missed if it lies fewer steps than this before the end of a range. A sphere is skipped by its
/// distance minus its radius, a disc by an exact fraction. Both may differ from the hit's distance by 16 steps
/// and its rounding.
pub const SURE: i32 = 64;

/// Interval of distances along a ray, in steps: above `start` and below `reach`.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    pub(crate) start: Length,
    pub(crate) reach: Length,
}

impl Range {
    /// Tests whether a distance lies within the range.
    #[inline(always)]
    pub(super) fn holds(&self, distance: Length) -> bool {
        self.start < distance && distance < self.reach
    }
}

/// Shadow ray that starts at a light and ends just above a point on a surface.
pub struct LightRay {
    pub(crate) direction: Direction,
    /// Distance from the light to the end of the ray, in steps.
    pub(crate) reach: Length,
    /// Distance from the light, in steps, up to which hits do not count.
    pub(crate) epsilon: Length,
    /// End of the ray: the point that lies epsilon above the surface.
    pub(crate) end: Point,
}

impl LightRay {
    /// Returns the distances at which hits count.
    #[inline(always)]
    pub(super) fn range(&self) -> Range {
        Range {
            start: self.epsilon,
            reach: self.reach,
        }
    }
}

/// Whether the end of a shadow ray lies on the surface of the shape under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Own {
    /// The end of the light's ray lies on the surface of another shape.
    No,
    /// The end lies on the outer side of this shape's surface.
    Outside,
    /// The end lies on the inner side of this shape's surface.
    Inside,
}
