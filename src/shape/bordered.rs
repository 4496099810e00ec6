//! The trait of bounded shapes as a stretch of pixels needs them: where a shape begins and ends in a row,
//! and what it surely does, or surely does not, between two traced pixels.

use core::fmt::Debug;

use super::bounded::Bounded;
use super::rays::{Rays, SLACK, Spread};
use crate::number::{Length, Unit, unsigned_wide, wide};
use crate::ray::{REACH, RowPlane, Span};
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

    /// Returns a ball around the shape. Defaults to that in the middle of the outline.
    #[inline(always)]
    fn bounding_ball(&self) -> Ball {
        let (center, _, radius) = self.outline();
        (center, radius)
    }

    /// Tests whether the solid surely has no point in a ball.
    fn is_apart_from(&self, ball: Ball) -> bool;

    /// Returns whether the shape hides all points of a curve from a light, or none; `None` if that is not sure yet. It is
    /// decided from the rays to the two ends alone, without a fan. `spread` bounds the light's rays to the curve.
    fn told(&self, _from: &Self::FromLight, _spread: &Spread) -> Option<bool> {
        None
    }

    /// Tests whether the shape surely hides no point of a fan from its apex.
    fn spares(&self, from: &Self::FromLight, fan: &Fan) -> bool;

    /// Tests whether the shape surely hides all points of a fan from its apex. It hides those at its two
    /// ends.
    fn hides(&self, from: &Self::FromLight, fan: &Fan) -> bool;
}

/// All rays from a point, the apex, to a curve on a surface. The curve is close to a straight line, so the
/// rays are close to a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Fan {
    /// Directions from the apex to the two ends of the curve.
    pub(crate) ends: [Direction; 2],
    /// Distances from the apex to the two ends, in steps; [`REACH`] if they are far.
    pub(crate) reaches: [Length; 2],
    /// Upper bound of the distance of the rays from the triangle, in steps.
    pub(crate) thickness: i32,
    /// Normal of the triangle.
    normal: Direction,
    /// Outward normals of the two sides in the plane of the triangle.
    sides: [Direction; 2],
    /// The third side, `None` if it is far.
    base: Option<Base>,
}

/// The side of a fan opposite to its apex.
#[derive(Clone, Copy, Debug)]
struct Base {
    /// Outward normal.
    outward: Direction,
    /// Distance from the apex, in steps.
    distance: i32,
    /// Vector from the apex to the middle.
    middle: Vector,
    /// Half of the length, in steps, rounded up.
    half: i32,
}

impl Fan {
    /// Returns the fan between two rays. The curve between them is at most `bulge` steps away from the
    /// straight line. `None` if the apex lies almost on that line.
    pub(crate) fn new(rays: &Rays, bulge: i32) -> Option<Self> {
        let Rays { apex, places, .. } = *rays;
        let [first, last] = rays.ends;
        let is_near = rays.reaches.iter().all(|&reach| reach < REACH);
        // The direction across the fan: from end to end, or, if they are far, between the directions.
        let along = if is_near {
            places[0].point.to(places[1].point)
        } else {
            last.raw().minus(first.raw())
        };
        let (along, length) = along.normalised();
        let across = first.crossed_with(along.raw());
        if across.square() < 1 << 50 {
            return None;
        }
        let (normal, _) = across.normalised();
        // From the first side, the other end lies in this direction.
        let inner = |side: Direction, other: Direction| {
            let outward = side.crossed(normal);
            outward.reversed_if(other.dot(outward) > Unit::ZERO)
        };
        let outward = along.crossed(normal);
        let base = is_near.then(|| {
            let [one, other] = places.map(|place| apex.point.to(place.point));
            let distance = one.dot(outward);
            Base {
                outward: outward.reversed_if(distance < 0),
                distance: distance.abs(),
                middle: one.plus(other).coarser(1),
                half: (length.to_bits() >> 1) + 2,
            }
        });
        Some(Self {
            ends: rays.ends,
            reaches: rays.reaches,
            thickness: bulge + SLACK,
            normal,
            sides: [inner(first, last), inner(last, first)],
            base,
        })
    }

    /// Tests whether an end of the fan is far.
    pub(super) fn is_far(&self) -> bool {
        self.reaches.iter().any(|&reach| reach >= REACH)
    }

    /// Tests whether no point of the fan lies in a body. `way` is the vector from the apex to the body's
    /// centre, `size` returns its extent along a direction.
    pub(super) fn avoids(&self, way: Vector, size: impl Fn(Direction) -> i32) -> bool {
        if way.dot(self.normal).abs() > size(self.normal) + self.thickness {
            return true;
        }
        let passes = |side: Direction| way.dot(side) > size(side) + self.thickness;
        if self.sides.into_iter().any(passes) {
            return true;
        }
        self.base.is_some_and(|base| {
            let size = size(base.outward) + self.thickness;
            let along = way.dot(base.outward);
            along > base.distance + size || along < -size
        })
    }

    /// Tests whether the fan surely avoids a ball. `way` is the vector from the apex to its centre.
    ///
    /// If the ball's centre lies beyond the third side, the nearest point of the fan is on that side, in the
    /// ball over its two ends, unless the centre lies beside a ray before that ray ends.
    pub(crate) fn avoids_ball(&self, way: Vector, radius: i32) -> bool {
        let Some(base) = self.base else {
            return self.avoids(way, |_| radius);
        };
        let apart = way.dot(self.normal).abs();
        let reach = radius + self.thickness;
        if apart >= reach {
            return true;
        }
        let beyond = way.dot(base.outward) - base.distance;
        if beyond < -base.distance - reach {
            return true;
        }
        let aside = self.sides.map(|side| way.dot(side));
        let is_beside =
            |end: usize| aside[end] > 0 && way.dot(self.ends[end]) < self.reaches[end].to_bits();
        if beyond > self.thickness
            && base.middle.minus(way).square() > square(reach + base.half)
            && !is_beside(0)
            && !is_beside(1)
        {
            return true;
        }
        let aside = beyond.max(aside[0]).max(aside[1]);
        aside > 0 && square(aside) + square(apart) > square(reach)
    }
}

/// Returns the square of a length.
pub(crate) fn square(length: i32) -> u64 {
    unsigned_wide(wide(length, length))
}
