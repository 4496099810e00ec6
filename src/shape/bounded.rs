//! What every kind of bounded shape does for a ray: one trait, compiled once for each kind.

use core::fmt::Debug;

use super::MaterialId;
use crate::number::Length;
use crate::ray::Ray;
use crate::vector::{Direction, Point, Vector};

/// A bounded shape as the kernels read it.
pub trait Bounded: Copy + Debug + 'static {
    /// The shape as rays from one fixed point meet it.
    type FromPoint: Copy + Debug;

    /// The shape as rays from a light meet it.
    type FromLight: Copy + Debug;

    /// Whether shapes of this kind are balls: their screen bounds are exact, and rows ask them front to
    /// back.
    const IS_BALL: bool;

    /// Whether shapes of this kind are flat: a ray that leaves one does not hit it again, and one that is
    /// a mirror bends nothing.
    const IS_FLAT: bool = false;

    /// A capsule around the shape: its middle, the way from there to one end, and its radius. Of a flat
    /// one, the way is its normal, as long as its radius.
    fn outline(&self) -> (Point, Vector, i32);

    /// The shape as rays from the camera, or its mirror image, meet it; no ray that hits the shape
    /// is told otherwise by rounding.
    fn seen_from_eye(&self, eye: Point) -> Self::FromPoint;

    /// Whether one shape is in front of another, or about as far; asked of balls.
    #[inline(always)]
    fn is_in_front_of(_one: &Self::FromPoint, _other: &Self::FromPoint) -> bool {
        false
    }

    /// Whether part of the shape may be nearer than a distance; asked of balls.
    #[inline(always)]
    fn may_be_nearer(_from: &Self::FromPoint, _distance: Length) -> bool {
        true
    }

    /// Whether a near point lies inside of the shape, so that all rays from it stay inside.
    fn holds(&self, _point: Point) -> bool {
        false
    }

    /// Distance of the first hit of a ray, within `range`. Sets `side` if the ray
    /// misses the shape on the negative side of its axis.
    fn intersect(&self, ray: &Ray, range: Range, side: &mut bool) -> Option<Length>;

    /// The same for a ray from the point that the shape is seen from.
    fn intersect_from(
        &self,
        from: &Self::FromPoint,
        direction: &Direction,
        range: Range,
        side: &mut bool,
    ) -> Option<Length>;

    /// Whether the ray hits the shape above 0 and below `reach`.
    fn blocks(&self, ray: &Ray, reach: Length) -> bool;

    /// Whether the shape, as a light sees it, hides the end of a ray from the light.
    fn occludes<const PRECISE: bool>(
        &self,
        from: &Self::FromLight,
        ray: &LightRay,
        own: Own,
    ) -> bool;

    /// The outward normal at a point of the shape.
    fn normal(&self, at: Point) -> Direction;

    /// What it is made of.
    fn material(&self) -> MaterialId;
}

/// Distances along a ray: above `start` and below `reach`.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    pub(crate) start: Length,
    pub(crate) reach: Length,
}

/// A ray from a light to a point on a surface.
pub struct LightRay {
    pub(crate) direction: Direction,
    /// How far the point is from the light.
    pub(crate) reach: Length,
    /// Hits nearer to the light than this do not count.
    pub(crate) epsilon: Length,
    /// The point, epsilon above the surface.
    pub(crate) end: Point,
}

/// Whose surface the end of a light's ray lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Own {
    /// Another shape's.
    No,
    /// This shape's, seen from outside.
    Outside,
    /// This shape's, seen from inside.
    Inside,
}
