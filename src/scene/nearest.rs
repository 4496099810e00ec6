//! The bounded shapes on a near ray: finds the nearest hit, or whether any shape blocks the ray. Tests
//! all shapes or a set of candidates.

use super::access::{SceneAccess, ShapeId};
use super::shape_set::ShapeSet;
use crate::number::Length;
use crate::ray::{PathSignature, REACH, Ray};
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

macro_rules! questions {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Returns the nearest hit of a ray among the candidates, beyond `start`. The distance counts
        /// from there.
        ///
        /// Skips the shape `skip`, which the ray leaves from outside. Notes in the path's signature on
        /// which side the ray certainly passes a shape.
        #[inline(never)]
        pub(crate) fn nearest_of<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            (ray, start): (&Ray, Length),
            skip: ShapeId,
            signature: &mut PathSignature,
        ) -> Hit {
            let mut nearest = Nearest::beyond(start);
            let parts = world.parts();
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                candidates.any(W::CHOOSES_HITS, (kind, lengths), parts.$list, |index, shape| {
                    nearest.ask(shape, ray, ShapeId::at(first + index), skip)
                });
                let (kind, first) = (kind + 1, first + lengths[kind]);
            )*
            let _ = (kind, first);
            nearest.hit(signature)
        }

        /// Tests whether a ray hits a candidate before `reach`. Skips the shape `skip`, which the ray
        /// leaves from outside.
        #[inline(never)]
        pub(super) fn any_blocks<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            ray: &Ray,
            skip: ShapeId,
            reach: Length,
        ) -> bool {
            let parts = world.parts();
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                if candidates.any(W::NEEDS.sets, (kind, lengths), parts.$list, |index, shape| {
                    ShapeId::at(first + index) != skip && shape.blocks(ray, reach)
                }) {
                    return true;
                }
                let (kind, first) = (kind + 1, first + lengths[kind]);
            )*
            let _ = (kind, first);
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
    /// XOR of the notes of all shapes that the ray passes on their noted side.
    passed: u32,
}

impl Nearest {
    /// Starts without a hit. Hits before `start` do not count.
    #[inline(always)]
    pub(crate) fn beyond(start: Length) -> Self {
        Self {
            start,
            hit: Hit::NONE,
            passed: 0,
        }
    }

    /// Intersects a ray with a shape, unless the shape is `skip`. Always returns `false`, so that the
    /// caller's loop goes on.
    #[inline(always)]
    fn ask<K: Bounded>(&mut self, shape: &K, ray: &Ray, id: ShapeId, skip: ShapeId) -> bool {
        if id != skip {
            let mut is_passed = false;
            if let Some(distance) = shape.intersect(ray, self.range(), &mut is_passed) {
                self.hit = Hit {
                    distance,
                    shape: id,
                };
            }
            if is_passed {
                self.pass(id.passed());
            }
        }
        false
    }

    /// Intersects a ray with a shape that is prepared for rays from one point. Returns whether it is
    /// the nearest hit so far.
    ///
    /// Notes the side on which the ray passes the shape if `is_thin`.
    #[inline(always)]
    pub(crate) fn ask_from<K: Bounded>(
        &mut self,
        shape: &K,
        from: &K::FromPoint,
        direction: &Direction,
        (id, is_thin): (ShapeId, bool),
    ) -> bool {
        let mut is_passed = false;
        let distance = shape.intersect_from(from, direction, self.range(), &mut is_passed);
        if is_passed && is_thin {
            self.pass(id.passed());
        }
        self.take(distance, id)
    }

    /// Returns the range of distances in which a hit is nearer than the one so far.
    #[inline(always)]
    fn range(&self) -> Range {
        Range {
            start: self.start,
            reach: self.hit.distance,
        }
    }

    /// Stores a hit of a shape. Returns whether there is one.
    #[inline(always)]
    fn take(&mut self, distance: Option<Length>, shape: ShapeId) -> bool {
        if let Some(distance) = distance {
            self.hit = Hit { distance, shape };
        }
        distance.is_some()
    }

    /// Tests whether part of a shape may be nearer than the hit so far.
    #[inline(always)]
    pub(crate) fn may_see<K: Bounded>(&self, from: &K::FromPoint) -> bool {
        K::may_be_nearer(from, self.hit.distance)
    }

    /// Adds to the notes that the ray passes a shape on one side.
    #[inline(always)]
    pub(crate) fn pass(&mut self, passed: u32) {
        self.passed ^= passed;
    }

    /// Returns the nearest hit, with its distance from `start`. Adds the notes to the path's signature.
    #[inline(always)]
    pub(crate) fn hit(self, signature: &mut PathSignature) -> Hit {
        signature.note(self.passed);
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
