//! The bounded shapes on a near ray: finds the nearest hit, or whether any shape blocks the ray. Tests
//! all shapes or a set of candidates.

use super::access::{Parts, SceneAccess, ShapeId};
use super::shape_set::ShapeSet;
use crate::number::Length;
use crate::ray::{REACH, Ray};
use crate::shape::bounded::{Bounded, Range};
use crate::vector::Direction;

/// Distance zero: the start of a ray.
pub(crate) const NOWHERE: Length = Length::from_bits(0);

/// The first hit of a near ray: distance and shape. The shape is [`ShapeId::NONE`] if nothing is hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Hit {
    pub(crate) distance: Length,
    pub(crate) shape: ShapeId,
}

impl Hit {
    /// No hit up to [`REACH`], as far as a near ray is followed.
    pub(crate) const NONE: Self = Self {
        distance: REACH,
        shape: ShapeId::NONE,
    };

    /// The near ray cannot tell: the first hit, if any, is beyond the near region.
    pub(crate) const BEYOND: Self = Self {
        distance: REACH,
        shape: ShapeId::BEYOND,
    };
}

impl Parts<'_> {
    /// Returns the distance at which a ray hits the bounded shape `id`, within `range`.
    #[inline(always)]
    pub(crate) fn intersect(&self, id: ShapeId, ray: &Ray, range: Range) -> Option<Length> {
        of_kind!(self, id, |shape| shape.intersect(ray, range)).flatten()
    }

    /// Tests whether a ray hits the bounded shape `id` before `reach`.
    #[inline(always)]
    pub(crate) fn blocks(&self, id: ShapeId, ray: &Ray, reach: Length) -> bool {
        of_kind!(self, id, |shape| shape.blocks(ray, reach)).unwrap_or(false)
    }
}

macro_rules! questions {
    ($header:tt $({ $list:ident $($more:tt)* })*) => {
        /// Returns the nearest hit of a ray among all bounded shapes, beyond `start`. The distance counts
        /// from there.
        ///
        /// Skips the shape `skip`, which the ray leaves from outside.
        #[inline(never)]
        pub(crate) fn nearest_of<W: SceneAccess>(
            world: &W,
            (ray, start): (&Ray, Length),
            skip: ShapeId,
        ) -> Hit {
            let mut nearest = Nearest::beyond(start);
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                for (index, shape) in parts.$list.iter().enumerate() {
                    nearest.ask(shape, ray, $list.id(index), skip);
                }
            )*
            nearest.hit()
        }

        /// Returns the nearest hit of a ray among the candidates, as [`nearest_of`] does among all.
        #[inline(never)]
        pub(crate) fn nearest_listed<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            ray: &Ray,
            skip: ShapeId,
        ) -> Hit {
            let mut nearest = Nearest::beyond(NOWHERE);
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                candidates.each($list, parts.$list, |index, shape| {
                    nearest.ask(shape, ray, $list.id(index), skip);
                });
            )*
            nearest.hit()
        }

        /// Tests whether a ray hits a candidate before `reach`. Skips the shape `skip`, which the ray
        /// leaves from outside.
        #[inline(never)]
        pub(crate) fn any_blocks<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            ray: &Ray,
            skip: ShapeId,
            reach: Length,
        ) -> bool {
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                if candidates.any(W::NEEDS.sets, $list, parts.$list, |index, shape| {
                    $list.id(index) != skip && shape.blocks(ray, reach)
                }) {
                    return true;
                }
            )*
            false
        }

        /// Tests whether a ray hits any bounded shape. Skips the shape `skip`, which the ray leaves from
        /// outside.
        #[inline(always)]
        pub(crate) fn any_ahead<W: SceneAccess>(world: &W, ray: &Ray, skip: ShapeId) -> bool {
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                if parts.$list.iter().enumerate().any(|(index, shape)| {
                    $list.id(index) != skip && shape.is_ahead(ray)
                }) {
                    return true;
                }
            )*
            false
        }
    };
}
kinds!(questions);

/// The nearest hit among the shapes that a ray has been tested against so far.
pub(crate) struct Nearest {
    /// Hits up to this distance do not count.
    start: Length,
    /// The nearest hit so far; its distance counts from the ray's origin.
    hit: Hit,
}

impl Nearest {
    /// Starts without a hit. Hits before `start` do not count.
    #[inline(always)]
    pub(crate) fn beyond(start: Length) -> Self {
        Self {
            start,
            hit: Hit::NONE,
        }
    }

    /// Intersects a ray with a shape, unless the shape is `skip`.
    #[inline(always)]
    pub(crate) fn ask<K: Bounded>(&mut self, shape: &K, ray: &Ray, id: ShapeId, skip: ShapeId) {
        if id != skip {
            self.take(shape.intersect(ray, self.range()), id);
        }
    }

    /// Intersects a ray with a shape that is prepared for rays from one point.
    #[inline(always)]
    pub(crate) fn ask_from<K: Bounded>(
        &mut self,
        shape: &K,
        from: &K::FromPoint,
        direction: &Direction,
        id: ShapeId,
    ) {
        self.take(shape.intersect_from(from, direction, self.range()), id);
    }

    /// Returns the range of distances in which a hit is nearer than the one so far.
    #[inline(always)]
    fn range(&self) -> Range {
        Range {
            start: self.start,
            reach: self.hit.distance,
        }
    }

    /// Stores a hit of a shape, if there is one.
    #[inline(always)]
    fn take(&mut self, distance: Option<Length>, shape: ShapeId) {
        if let Some(distance) = distance {
            self.hit = Hit { distance, shape };
        }
    }

    /// Returns the nearest hit, with its distance from `start`.
    #[inline(always)]
    pub(crate) fn hit(self) -> Hit {
        let distance = self.hit.distance.to_bits() - self.start.to_bits();
        Hit {
            distance: if self.hit.shape == ShapeId::NONE {
                REACH
            } else {
                Length::from_bits(distance)
            },
            shape: self.hit.shape,
        }
    }
}
